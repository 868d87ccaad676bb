#!/usr/bin/python3
"""Is every complaint about the INIs of LinuxCNC's own sample configurations true?

usage: samples.py --owlint build/release/owlint

Reads each INI below the package's sample-configs with owlint, and asks `inivar` and the file system what is really there:
the mask of OW408 must be set, the folder of OW407 must be missing, the file of OW208 and OW402 must be in no folder of the
search path; and what inivar finds missing must be said.  No other finding is an error, as LinuxCNC starts with all of them
(of OW412 to OW424 machines.py judges the rest).  The home folder has the `nc_files` that LinuxCNC puts there.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter

SAMPLES = "/usr/share/doc/linuxcnc/examples/sample-configs"
PROGRAMS = "/usr/share/linuxcnc/ncfiles"
JUDGED = ("OW208", "OW402", "OW407", "OW408")


def inivar(ini, section, key, number=1):
    done = subprocess.run(["inivar", "-ini", ini, "-sec", section, "-var", key, "-num", str(number)], capture_output=True)
    return done.stdout.decode("utf-8", "replace").rstrip("\n") if done.returncode == 0 else ""


def every(ini, section, key):
    number = 1
    while value := inivar(ini, section, key, number):
        yield value
        number += 1


def resolved(ini, home, folder):
    folder = home + folder[1:] if folder == "~" or folder.startswith("~/") else folder
    return os.path.normpath(os.path.join(os.path.dirname(ini), folder))


def expanded(ini, folder):
    """The INI with its `#INCLUDE`s, as LinuxCNC's start script makes it."""
    with open(ini, encoding="utf-8", errors="replace") as f:
        text = f.read()
    if not re.search(r"(?m)^#INCLUDE", text):
        return ini
    def included(match):
        path = os.path.join(os.path.dirname(ini), match.group(1).strip())
        return open(path, encoding="utf-8", errors="replace").read() if os.path.isfile(path) else "#"
    path = os.path.join(folder, "expanded.ini")
    with open(path, "w", encoding="utf-8") as f:
        f.write(re.sub(r"(?m)^#INCLUDE(.*)$", included, text))
    return path


def expected(ini, home, scratch):
    """What is to be said of an INI: -> Counter of (code, what)"""
    said = Counter()
    values = expanded(ini, scratch)
    prefix = inivar(values, "DISPLAY", "PROGRAM_PREFIX")
    paths = [p for p in inivar(values, "RS274NGC", "SUBROUTINE_PATH").split(":") if p]
    folders = [os.path.dirname(ini)]
    for folder in ([prefix] if prefix else []) + paths:
        if os.path.isdir(resolved(ini, home, folder)):
            folders.append(resolved(ini, home, folder))
        elif not re.search(r"\s[#;]|,", folder):     # OW415
            said["OW407", folder] += 1
    mask = inivar(values, "RS274NGC", "FEATURE") or inivar(values, "RS274NGC", "FEATURES")
    if re.fullmatch(r"\d+|0[xX][0-9a-fA-F]+", mask) and int(mask, 0):
        said["OW408", mask] += 1
    if said.keys() & {("OW407", f) for f in [prefix] + paths} or inivar(values, "PYTHON", "TOPLEVEL"):
        return said, 0
    names = [m.group(1) for value in every(values, "RS274NGC", "REMAP") if (m := re.search(r"ngc=(\S+)", value))]
    names += [os.path.splitext(os.path.basename(f))[0] for f in every(values, "DISPLAY", "NGCGUI_SUBFILE") if f.endswith(".ngc")]
    names += [m.group(1) for command in every(values, "HALUI", "MDI_COMMAND")
              for m in re.finditer(r"[oO]\s*<([^>]*)>\s*call", command)]
    for name in names:
        if not any(os.path.exists(os.path.join(folder, name.lower() + ".ngc")) for folder in folders):
            said["OW208", name.lower()] += 1
    return said, len(names)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    options = parser.parse_args(argv)
    if not os.path.isdir(SAMPLES) or not shutil.which("inivar"):
        print("LinuxCNC's sample configurations are not installed")
        return 77
    problems, totals, subs = [], Counter(), 0
    inis = sorted(os.path.join(folder, name) for folder, _, names in os.walk(SAMPLES) for name in names if name.endswith(".ini"))
    with tempfile.TemporaryDirectory(prefix="owlint-samples-") as home:
        os.makedirs(os.path.join(home, "linuxcnc", "nc_files"))
        os.symlink(PROGRAMS, os.path.join(home, "linuxcnc", "nc_files", "examples"))
        for ini in inis:
            done = subprocess.run([options.owlint, "check", "--isolated", "--ini", ini, "--format", "json", "-"], input=b"M2\n",
                                  capture_output=True, env={**os.environ, "HOME": home})
            if done.returncode not in (0, 1):
                problems.append("%s: exit status %d: %s" % (ini, done.returncode, done.stderr.decode()))
                continue
            said = Counter()
            for file in json.loads(done.stdout)["files"]:
                for f in file["findings"]:
                    if f["code"] not in JUDGED:
                        if f["severity"] == "error":
                            problems.append("%s: %s %s" % (ini, f["code"], f["message"]))
                        continue
                    if f["code"] == "OW407":  # one finding for all folders
                        for words in [f["message"]] + [related["message"] for related in f["related"]]:
                            said["OW407", re.search(r"`([^`]*)` of", words).group(1)] += 1
                        continue
                    what = re.search(r"`([^`]*)`", f["message"]).group(1)
                    if f["code"] == "OW208":  # it may speak for others
                        what = re.search(r"no file `([^`]*)\.ngc`", f["message"]).group(1)
                        for related in f["related"]:
                            if missing := re.search(r"`([^`]*)\.ngc` is not here either", related["message"]):
                                said["OW208", missing.group(1)] += 1
                    if f["code"] == "OW408":
                        with open(file["path"], "rb") as source:
                            what = source.read()[f["start"]["offset"]:f["end"]["offset"]].decode()
                    said[f["code"], what] += 1
            wanted, called = expected(ini, home, home)
            subs += called
            totals.update(code for code, _ in said.elements())
            if said != wanted:
                problems.append("%s: owlint says %s, what is there asks for %s" % (ini, dict(said - wanted), dict(wanted - said)))
    print("\n".join(problems) if problems else "all complaints are true, and none is missing")
    print("%d INIs, %d subs that they call looked up, findings: %s" % (
        len(inis), subs, ", ".join("%s %d" % kind for kind in sorted(totals.items())) or "none"))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
