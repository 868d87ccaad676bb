#!/usr/bin/python3
"""Holds owlint against the measured outcomes of the probe programs, in all three modes.

usage: probes.py --owlint build/release/owlint [FOLDER]

FOLDER has outcomes.tsv and probes/; it lies beside the repository (../shared/interpreter) and not in it, so that
without it there is nothing to do. Modes: default; warnonly (`--feature 0x20`); mask (the INI's FEATURE mask, which
LinuxCNC 2.9 ignores).  Exit status 1 when owlint and an outcome disagree.
"""
import argparse
import csv
import os
import sys
import tempfile

from confirm import Claims, judge
from linter import Linter
from rs274 import Outcome

HERE = os.path.dirname(os.path.abspath(__file__))
BESIDE = os.path.normpath(os.path.join(HERE, "..", "..", "..", "shared", "interpreter"))
SKIPPED = 77                # what ctest takes for "not run"


def outcomes_of(folder):
    """-> {mode: {program: Outcome}}"""
    by_mode = {}
    with open(os.path.join(folder, "outcomes.tsv"), encoding="latin-1", newline="") as f:
        for row in csv.DictReader(f, delimiter="\t", quoting=csv.QUOTE_NONE):
            said = row["message"].split(":")[0]
            line = int(said) if said.isdigit() else 0
            by_mode.setdefault(row["mode"], {})[row["program"]] = Outcome(row["outcome"], line, row["message"])
    return by_mode


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("probes", nargs="?", default=BESIDE, metavar="FOLDER")
    options = parser.parse_args(argv)
    if not os.path.exists(os.path.join(options.probes, "outcomes.tsv")):
        print("probes.py: skipped, %s has no outcomes.tsv" % options.probes)
        return SKIPPED
    by_mode = outcomes_of(options.probes)
    texts = {}
    for name in by_mode["default"]:
        with open(os.path.join(options.probes, "probes", name), encoding="latin-1", newline="") as f:
            texts[name] = f.read()
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="owlint-probes-") as folder:
        mask = os.path.join(folder, "mask.ini")
        with open(mask, "w") as f:
            f.write("[RS274NGC]\nFEATURES = 0x20\n")
        empty = os.path.join(folder, "machine.ini")
        linters = {"default": Linter(options.owlint, machine=empty),
                   "warnonly": Linter(options.owlint, warnonly=True, machine=empty),
                   "mask": Linter(options.owlint, arguments=("--linuxcnc", "2.9", "--ini", mask))}
        for mode, linter in linters.items():
            findings = linter.check(os.path.join(folder, "programs"), texts)
            for name, outcome in sorted(by_mode[mode].items()):
                for problem in judge(outcome, Claims(findings[name])):
                    wrong += 1
                    print("%s, %s: %s" % (name, mode, problem))
    print("%d probes in %d modes, %d disagreements" % (len(texts), len(linters), wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
