#!/usr/bin/python3
"""Holds owlint against the measured outcomes of the probe programs, in all modes that were measured.

usage: probes.py --owlint build/release/owlint [FOLDER...]

A folder has outcomes.tsv, and the programs in probes/ or beside it: those of O-words, of the reading of words, of modes and of
geometry.  They lie beside the repository (../shared/interpreter) and not in it, so that without them there is nothing to do.
Modes: default; warnonly (`--feature 0x20`); mask (the INI's FEATURE mask, which LinuxCNC 2.9 ignores); else the name of an INI in
the folder.  A stop that the machine decides (of_machine.py) is counted.  Exit status 1 when owlint and an outcome disagree.
"""
import argparse
import csv
import os
import re
import sys
import tempfile

from confirm import Claims, judge
from linter import MACHINE as MACHINE_INI, Linter
from of_machine import decides
from rs274 import AT_FILE_END, Outcome

HERE = os.path.dirname(os.path.abspath(__file__))
BESIDE = os.path.normpath(os.path.join(HERE, "..", "..", "..", "shared", "interpreter"))
OF_WORDS = [os.path.join(BESIDE, "words", "probes", name) for name in ("reading", "modes", "geometry")]
# Not predicted, by folder: what some do to memory, and a name on a line of M98; cycles and contours that never end or crash for
# their numbers, and lines of a contour, which are read otherwise there.
OPEN = {
    "reading": {"m98-line-with-a-named-assignment.ngc", "param-assign-51-on-a-line-overruns.ngc", "print-66-parameters-overrun.ngc"},
    # What M72 does to its line and to an offset of a tool, the feed that waits behind a compensated move, RETAIN_G43, and which of
    # two spindles is meant.
    "modes": {"ctx-m72-comp-with-tool-offset.ngc",
              "feed-g20-loses-a-feed-queued-by-compensation.ngc", "ini-retain-g43-comp-refused-while-offset-is-on.ngc",
              "ini-retain-g43-g49-does-not-help.ngc", "ini-spindles2-g84-dollar-with-s.ngc"},
    # Contours, what never ends, and where a probe has stopped.
    "geometry": {"cycle-g83-q-tiny-never-ends.ngc", "g76-large-r-takes-k-over-j-to-the-r-passes.ngc",
                 "g7x-contour-bad-word.ngc", "g7x-x-too-large-in-dive.ngc",
                 "position-after-g38-is-not-the-end-point.ngc", "units-switch-with-comp-on-forgets-queued-feed.ngc",
                 "spline-g5-order-p-q-after-polar.ngc"}}
SKIPPED = 77                # what ctest takes for "not run"


def outcomes_of(folder):
    """-> {mode: {program: Outcome}}"""
    by_mode = {}
    with open(os.path.join(folder, "outcomes.tsv"), encoding="latin-1", newline="") as f:
        for row in csv.DictReader(f, delimiter="\t", quoting=csv.QUOTE_NONE):
            said = re.match(r"(\d+):", row["message"])
            # Of the end of the file, owlint speaks at the cause.
            said = said[1] if said else "" if AT_FILE_END.search(row["message"]) else row["line"]
            line = int(said) if said.isdigit() else 0
            by_mode.setdefault(row["mode"], {})[row["program"]] = Outcome(row["outcome"], line, row["message"])
    return by_mode


def texts_of(folder, names):
    """-> {name: text}"""
    where = os.path.join(folder, "probes")
    texts = {}
    for name in names:
        with open(os.path.join(where if os.path.isdir(where) else folder, name), encoding="latin-1", newline="") as f:
            texts[name] = f.read()
    return texts


def problems_of(outcome, findings, text):
    """-> (what owlint says wrongly, whether it stops for what the machine decides)"""
    claims = Claims(findings, text=text)
    lines = text.split("\n")
    at = lines[outcome.line - 1] if 0 < outcome.line <= len(lines) else ""
    # What a program asks for itself is no mistake in it; what Python, pins or the parameters of the machine do is not known.
    if re.match(r"(?i).*\(\s*abort,[^)]*\)[^(]*$|[(;]py,", at) or re.search(r"#<_hal\[|##1", at):
        return [], False
    problems = list(judge(outcome, claims))
    if problems and outcome.kind == "error" and decides(outcome.message, text, axes_known=True):
        wrong = "%s is claimed for every run on line %d, which stops with: %s"
        problems = [wrong % (f["code"], outcome.line, outcome.message) for f in claims.always
                    if outcome.line and f["start"]["line"] < outcome.line]
        return problems, True
    return problems, False


def linter_with(owlint, ini, folder):
    """owlint with that INI, and the axes of rs274 in it."""
    with open(ini, encoding="latin-1") as f:
        text = f.read()
    own = os.path.join(folder, os.path.basename(ini))
    with open(own, "w", encoding="latin-1") as f:
        f.write(text.rstrip("\n") + "\n" + MACHINE_INI)
    return Linter(owlint, arguments=("--ini", own))


def compare(owlint, probes, folder):
    """-> how many disagreements there are in one folder of probes"""
    by_mode = outcomes_of(probes)
    texts = {mode: texts_of(probes, outcomes) for mode, outcomes in by_mode.items()}
    mask, empty = os.path.join(folder, "mask.ini"), os.path.join(folder, "machine.ini")
    with open(mask, "w") as f:
        f.write("[RS274NGC]\nFEATURES = 0x20\n")
    linters = {"default": lambda: Linter(owlint, machine=empty),
               "warnonly": lambda: Linter(owlint, warnonly=True, machine=empty),
               "mask": lambda: Linter(owlint, arguments=("--linuxcnc", "2.9", "--ini", mask))}
    wrong, others, open_ones = 0, 0, OPEN.get(os.path.basename(probes), ())
    for mode, outcomes in by_mode.items():
        linter = linters[mode]() if mode in linters else linter_with(owlint, os.path.join(probes, mode + ".ini"), folder)
        findings = linter.check(os.path.join(folder, "programs"), texts[mode])
        for name, outcome in sorted(outcomes.items()):
            problems, other = problems_of(outcome, findings[name], texts[mode][name])
            others += other or name in open_ones
            if name in open_ones:
                if not problems:
                    print("%s, %s: is predicted now, and no longer open" % (name, mode))
                    wrong += 1
                continue
            for problem in problems:
                wrong += 1
                print("%s, %s: %s" % (name, mode, problem))
    print("%s: %d probes in %d modes, %d disagreements, %d stops that the machine decides or that are open" % (
        probes, len(set().union(*by_mode.values())), len(by_mode), wrong, others))
    return wrong


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("probes", nargs="*", default=[BESIDE, *OF_WORDS], metavar="FOLDER")
    options = parser.parse_args(argv)
    folders = [folder for folder in options.probes if os.path.exists(os.path.join(folder, "outcomes.tsv"))]
    if not folders:
        print("probes.py: skipped, %s has no outcomes.tsv" % " and ".join(options.probes))
        return SKIPPED
    wrong = 0
    for probes in folders:
        with tempfile.TemporaryDirectory(prefix="owlint-probes-") as folder:
            wrong += compare(options.owlint, probes, folder)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
