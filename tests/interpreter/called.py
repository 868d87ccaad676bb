#!/usr/bin/python3
"""Does owlint say of programs that call files what each LinuxCNC version does with them?

usage: called.py --owlint build/test/owlint

called/ holds programs that call subs in other files, with a machine's INI; called/outcomes.tsv what four versions of
LinuxCNC's interpreter did with each.  A run that stops must be claimed by a finding that stops and quotes the
interpreter's message; a run that ends must not be claimed to stop.  Where rs274 is installed, the outcomes are measured
again for its version.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

import rs274

HERE = os.path.dirname(os.path.abspath(__file__))
FOLDER = os.path.join(HERE, "called")
# A message that names a file which was never read, and bytes that depend on the moment.
UNCERTAIN = re.compile(r"file '\(uninitialised bytes\)' found")


def versions(said):
    """The owlint versions that a measured LinuxCNC version stands for."""
    major, minor = said.split(".")[:2]
    # Nothing that differs between 2.7 and 2.8 is in called files.
    return {"2.8": ("2.7", "2.8")}.get("%s.%s" % (major, minor), ("%s.%s" % (major, minor),))


def plain(message):
    message = UNCERTAIN.sub("file found", message)
    message = message.replace(" (%)", "").replace(" (M2)", "")      # as later versions word it
    return re.sub(r"\s+", "", re.sub(r"^\d+: ", "", message)).lower()


def findings(owlint, folder, program, version):
    command = [owlint, "check", "--isolated", "--ini", "machine.ini", "--linuxcnc", version, "--format", "json", program]
    done = subprocess.run(command, capture_output=True, cwd=folder, timeout=60)
    return [f for file in json.loads(done.stdout)["files"] for f in file["findings"]]


def judge(outcome, message, found):
    """What owlint says wrongly of this outcome, or None."""
    stops = [f for f in found if f["stops"] and f["reach"] != "never"]
    if outcome == "ok":
        sure = [f for f in stops if f["severity"] == "error"]
        return "it runs, owlint says %s" % [f["message"] for f in sure] if sure else None
    if not any(plain(f.get("interpreter", "")) == plain(message) for f in stops):
        return "it stops (%s), owlint says %s" % (message, [f.get("interpreter") for f in stops])
    return None


def measured(folder, program):
    """What the installed rs274 does: -> (outcome, message)"""
    done = subprocess.run(["rs274", "-i", "machine.ini", "-g", program], capture_output=True, cwd=folder, timeout=60,
                          stdin=subprocess.DEVNULL)
    said = done.stderr.decode("latin-1").replace("executing", "", 1).strip().split("\n")[0].replace(folder + "/", "")
    return ("ok" if done.returncode == 0 else "error"), said


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    options = parser.parse_args(argv)
    owlint = os.path.abspath(options.owlint)
    problems, count = [], 0
    with tempfile.TemporaryDirectory(prefix="owlint-called-") as scratch:
        folder = os.path.join(scratch, "called")
        shutil.copytree(FOLDER, folder)
        with open(os.path.join(FOLDER, "outcomes.tsv"), encoding="latin-1") as f:
            rows = [line.rstrip("\n").split("\t") for line in f][1:]
        for program, said, outcome, message, _ in rows:
            for version in versions(said):
                count += 1
                wrong = judge(outcome, message, findings(owlint, folder, program, version))
                if wrong:
                    problems.append("%s, LinuxCNC %s: %s" % (program, said, wrong))
            if rs274.available and said.startswith("2.9.0"):
                real = measured(folder, program)
                if real[0] != outcome or (outcome != "ok" and plain(real[1]) != plain(message)):
                    problems.append("%s: recorded %s %s, rs274 says %s %s" % (program, outcome, message, *real))
    print("\n".join(problems) if problems else "all as owlint says")
    print("%d outcomes of %d programs%s" % (count, len({r[0] for r in rows}), ", measured again with rs274" if rs274.available else ""))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
