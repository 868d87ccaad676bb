#!/usr/bin/python3
"""Holds owlint against the measured outcomes of machines: INIs, tool tables, files of parameters, and programs with them.

usage: machines.py --owlint build/release/owlint [--list] [FOLDER]

The probes lie beside the repository (../shared/interpreter/words/probes/machine), one folder for each question; without them there
is nothing to do.  A probe of `inivar` is as recorded if owlint finds the value where inivar does, or says in the INI why there is
none; one that refuses, crashes or hangs before the program's first line, if owlint reports an error in that file on that line; one
that runs, if owlint reports no error; one that stops in the program, if owlint reports an error there.  What owlint cannot know or
does not follow yet is in OPEN, with the reason.  Exit status 1 when a probe differs that is not listed, or a listed one does not.
"""
import argparse
import collections
import csv
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
PROBES = os.path.normpath(os.path.join(HERE, "..", "..", "..", "shared", "interpreter", "words", "probes", "machine"))
SKIPPED = 77                # what ctest takes for "not run"
BEFORE = ("refuses", "crash", "hang")

# By the beginning of a probe's name, or its whole name.
OPEN = {
    # Programs: limits, words and modes that the machine decides on are not followed there yet.
    "limit-arc-bulge-homed": "between its ends an arc is not held against the limits",
    "limit-arc-end": "the zero of the part is not known before the program runs",
    "limit-cycle": "the zero of the part is not known before the program runs",
    "limit-g0": "the zero of the part is not known before the program runs",
    "limit-g54-offset": "the zero of the part is not known before the program runs",
    "limit-g92-offset": "the zero of the part is not known before the program runs",
    "limit-inch-program": "the zero of the part is not known before the program runs",
    "limit-incremental": "the zero of the part is not known before the program runs",
    "limit-not-homed": "the zero of the part is not known before the program runs",
    "limit-probe": "the zero of the part is not known before the program runs",
    "limit-rigid-tap": "the zero of the part is not known before the program runs",
    "limit-tool-length": "the zero of the part is not known before the program runs",
    "limit-two-axes": "the zero of the part is not known before the program runs",
    "arc-tolerance-mm-tight": "the tolerance of the INI is not used",
    "axis-letter-u-in-rs274": "the INI has no axes, rs274 those that it always has",
    "coordinates-without-z": "check_config says that the axes differ, and the program is read with those of COORDINATES",
    "hal-vars-outside-linuxcnc": "pins exist in LinuxCNC only",
    "ini-vars-no-ini": "without an INI nothing is known of its entries",
    "locking-indexer-": "locking indexers are not followed",
    "wrapped-rotary-": "wrapped rotary axes are not followed",
    "m99-in-main-program-starts-again": "a limit stops the second pass",
    "tool-task-": "tools are not followed from T to M6 as task does it",
    "tool-no-table-rs274-default": "rs274 has tools of its own without a table",
    "tool-table-file-missing": "without a table nothing is known of the tools",
    "user-m-": "what user M codes do is not known, and rs274 has none",
    # Remapped codes: what is said in the INI only.
    "remap-builtin-": "what a remapped built-in code does to a program is said in the INI only (OW417)",
    "remap-epilog-missing-stops-behind-the-sub": "said in the INI only (OW423)",
    "remap-prolog-missing-stops-at-the-code": "said in the INI only (OW423)",
    # What is decided outside of the files, or at another line of the same mistake.
    "interpreter-missing": "libraries of the machine are not looked for",
    "mdi-command-error": "whether the feed is set is not known when the button is pressed",
    "mdi-m99-before-any-program-crashes": "what people type is not known",
    "remap-python-toplevel-missing": "reported where the INI names the file, not at the REMAP that needs it",
    "start-section-lower-case": "reported at the `[KINS]` that is there, and empty",
    "start-version-missing": "refused without a screen only: a warning",
}


def is_open(name):
    return OPEN.get(name) or next((reason for start, reason in OPEN.items() if start.endswith("-") and name.startswith(start)), None)


def sections(text):
    found = []
    for line in text.splitlines(True):
        head = re.match(r"\s*\[([^\]\n]*)\]", line)
        if head:
            found.append([head[1], ""])
        if found:
            found[-1][1] += line
    return found


def as_rs274_has_it(folder):
    """What rs274 is told by options, and its axes, in an INI."""
    path, text = os.path.join(folder, "machine.ini"), ""
    if os.path.exists(path):
        with open(path, encoding="latin-1", newline="") as f:
            text = f.read()
    elif not any(os.path.exists(os.path.join(folder, name)) for name in ("tool.tbl", "machine.var")):
        return
    have = {name for name, _ in sections(text)}
    parameters = "[RS274NGC]\nPARAMETER_FILE = machine.var\n"
    if os.path.exists(os.path.join(folder, "machine.var")) and "PARAMETER_FILE" not in text:
        body = next((body for name, body in sections(text) if name == "RS274NGC"), None)
        longer = body and body.rstrip("\n") + "\n" + parameters.split("\n")[1] + "\n"     # below, so that lines keep their numbers
        text = text.replace(body, longer, 1) if body else text + "\n" + parameters
    with open(path, "w", encoding="latin-1", newline="") as f:
        f.write(text + ("" if "TRAJ" in have else "\n[TRAJ]\nCOORDINATES = X Y Z A B C\n"))


def unpack(probe, folder, bench):
    """Copies the probe, with the INI that LinuxCNC got: sections that it lacks come from the bench."""
    shutil.copytree(probe, folder)
    with open(os.path.join(probe, "ask"), encoding="latin-1") as f:
        steps = [line.rstrip("\n") for line in f if line.strip()]
    if steps[0].split()[0] == "rs274":
        as_rs274_has_it(folder)
    if steps[0] == "linuxcnc":
        for name in ("tool.tbl", "bench.hal", "display.py"):
            if not os.path.exists(os.path.join(folder, name)):
                shutil.copy(os.path.join(bench, name), folder)
        if "whole" not in steps:
            with open(os.path.join(folder, "machine.ini"), encoding="latin-1", newline="") as f:
                text = f.read()
            with open(os.path.join(bench, "bench.ini"), encoding="latin-1") as f:
                have = {name for name, _ in sections(text)}
                text += "".join(body for name, body in sections(f.read()) if name not in have)
            with open(os.path.join(folder, "machine.ini"), "w", encoding="latin-1", newline="") as f:
                f.write(text)
    return steps


def findings_of(owlint, folder):
    """-> {file: findings}; the program is checked with block delete as the judge has it"""
    files = [name for name in ("program.ngc", "machine.ini") if os.path.exists(os.path.join(folder, name))]
    command = [os.path.abspath(owlint), "check", "--isolated", "--format", "json", *files]
    if "machine.ini" in files:
        command += ["--ini", "machine.ini"]
    done = subprocess.run(command, cwd=folder, capture_output=True, timeout=120)
    if done.returncode not in (0, 1):
        return {"machine.ini": [{"code": "", "severity": "error", "start": {"line": 1}, "message": done.stderr.decode("latin-1")}]}
    return {os.path.normpath(file["path"]): file["findings"] for file in json.loads(done.stdout)["files"]}


def reads_otherwise(values, query, outcome, folder):
    """What owlint's reader makes of the question that inivar was asked."""
    section, key, number = query[0], query[1], query[2] if len(query) > 2 else "1"
    if section == "-":
        return ""       # a search in all sections, which only `halcmd` makes
    done = subprocess.run([os.path.abspath(values), "machine.ini"], input=("%s\t%s\t%s\n" % (section, key, number)).encode(),
                          cwd=folder, capture_output=True)
    value = done.stdout.decode("latin-1").rstrip("\n")
    wanted = outcome["message"].split("; inifile: warning")[0] if outcome["outcome"] == "value" else ""
    return "" if value == wanted else "`%s`, owlint reads `%s`" % (wanted, value)


def differs(steps, outcome, found, folder, values):
    """What is not as recorded; empty if all is."""
    block_delete = "on" if "-b" in steps[0].split() or steps[0] == "linuxcnc" and "slash 0" not in steps else "off"
    errors = [(path, f["start"]["line"], f["code"]) for path, findings in found.items() for f in findings
              if f["severity"] == "error" and f.get("reach") != "never"
              and f.get("block_delete", block_delete) == block_delete]
    of_machine = [e for e in errors if not e[0].endswith(".ngc")]
    of_program = [e for e in errors if e[0].endswith(".ngc")]
    kind, path, line = outcome["outcome"], outcome["file"], int(outcome["line"] or 0)
    if kind in ("value", "none"):
        return reads_otherwise(values, steps[0].split()[1:], outcome, folder) if values else ""
    if kind in BEFORE and path != "program.ngc":
        if any(e[0] == path and (not line or e[1] == line) for e in of_machine):
            return ""
        return "%s, owlint reports %s" % (kind, errors or "nothing")
    if of_machine:
        return "starts, owlint reports %s" % of_machine
    if kind == "ok":
        return "runs, owlint reports %s" % of_program if of_program else ""
    if path == "machine.ini":   # a command of the INI that stops when it runs
        return "" if any(f["code"] in ("OW419", "OW208", "OW422") for f in found.get(path, ())) else "nothing about the line in the INI"
    return "" if of_program or not path else "%s in %s, owlint reports nothing" % (kind, path)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--values", help="tests/ini_values, which prints what owlint reads in an INI")
    parser.add_argument("--list", action="store_true", help="print every probe that differs, also those that are listed")
    parser.add_argument("--findings", metavar="PROBE", help="print what owlint finds in one probe")
    parser.add_argument("probes", nargs="?", default=PROBES, metavar="FOLDER")
    options = parser.parse_args(argv)
    table = os.path.join(options.probes, "outcomes.tsv")
    if not os.path.exists(table):
        print("machines.py: skipped, there is no %s" % table)
        return SKIPPED
    counts, wrong = collections.Counter(), 0
    with open(table, encoding="latin-1", newline="") as f:
        rows = list(csv.DictReader(f, delimiter="\t", quoting=csv.QUOTE_NONE))
    for row in rows:
        name = row["probe"]
        if options.findings and options.findings != name:
            continue
        with tempfile.TemporaryDirectory(prefix="owlint-machines-") as scratch:
            folder = os.path.join(scratch, "m")
            steps = unpack(os.path.join(options.probes, name), folder, os.path.join(options.probes, "bench"))
            found = findings_of(options.owlint, folder)
            problem = differs(steps, row, found, folder, options.values)
        if options.findings:
            print(json.dumps(found, indent=1))
        reason = is_open(name)
        counts["as recorded" if not problem else "listed" if reason else "different"] += 1
        if problem and options.list:
            print("%s: %s%s" % (name, problem, " (%s)" % reason if reason else ""))
        elif problem and not reason:
            wrong += 1
            print("%s: %s" % (name, problem))
        elif not problem and reason and name in OPEN:
            wrong += 1
            print("%s: is as recorded now, and no longer open" % name)
    print("%d probes: %s" % (sum(counts.values()), ", ".join("%d %s" % (n, what) for what, n in counts.items())))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
