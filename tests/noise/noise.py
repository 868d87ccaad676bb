#!/usr/bin/python3
"""How much does owlint say of real programs? Findings per 100 programs, by rule and severity, as a user sees them by default.

usage: noise.py --owlint build/release/owlint DIR...   print the table for these programs
       noise.py --owlint build/release/owlint --kept   compare with what docs/rules/noise.md keeps (the test)

Counted are errors, warnings and infos; a finding that stands for many places counts once. INI files are not programs, their findings
count.

docs/rules/noise.md has a row for each rule: its level, why, and its findings per 100 programs, in two sets of programs:
tests/noise/programs, programs of ours that are written as people write them, and the 716 programs of ../shared/programs where
that folder is beside the checkout. --kept fails when a rule has more findings than are kept, or when a level or its reason
is another one than in the catalogue. With OWLINT_UPDATE=1 in the environment it writes the page; figures of a set that is not
there stay as they are.
"""
import argparse
import json
import os
import re
import subprocess
import sys
from collections import Counter

SEVERITIES = ("error", "warning", "info")
ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PAGE = os.path.join(ROOT, "docs", "rules", "noise.md")
OURS = os.path.join(ROOT, "tests", "noise", "programs")
REAL = os.path.normpath(os.path.join(ROOT, "..", "shared", "programs"))
HEAD = """# Levels, and how often each rule reports something

Made by `./dev noise`, which runs owlint with its default settings and counts what a user sees: errors, warnings and infos. The last two
columns are findings per 100 programs: for 716 programs from 25 public repositories, and for the programs in `tests/noise/programs`,
which are correct and written as people write them. A test fails if a rule reports more than this page says.

| rule | level | why | real | ours |
|---|---|---|---|---|
"""
ROW = re.compile(r"\| \[(OW\d{3})\]\([^)]*\) [^|]*\| (\w+) \| (.*) \| ([\d.]+) \| ([\d.]+) \|$")


def catalogue(owlint):
    return json.loads(subprocess.run([owlint, "rules", "--format", "json"], capture_output=True, check=True).stdout)


class Noise:
    """What owlint says of the programs in some folders."""

    def __init__(self, owlint, folders):
        done = subprocess.run([owlint, "check", "--isolated", "--format", "json", "--quiet", *folders], capture_output=True)
        if done.returncode > 1:
            sys.exit("noise.py: %s" % done.stderr.decode("utf-8", "replace"))
        files = json.loads(done.stdout)["files"]
        self.programs = sum(not f["path"].endswith(".ini") for f in files)
        self.counts = Counter()    # by code and severity
        self.names = {}
        for file in files:
            for finding in file["findings"]:
                self.counts[finding["code"], finding["severity"]] += 1
                self.names[finding["code"]] = finding["rule"]

    def per_hundred(self, number):
        return 100.0 * number / max(self.programs, 1)

    def of(self, code):
        return round(self.per_hundred(sum(self.counts[code, severity] for severity in SEVERITIES)), 1)

    def total(self):
        return self.per_hundred(sum(self.counts.values()))

    def table(self):
        yield "%-6s %-28s %8s %8s %8s %12s" % ("code", "rule", "errors", "warnings", "infos", "per 100")
        for code in sorted(self.names, key=lambda c: (-self.of(c), c)):
            yield "%-6s %-28s %8d %8d %8d %12.1f" % (code, self.names[code], *(self.counts[code, severity] for severity in SEVERITIES), self.of(code))
        yield "%d findings in %d programs: %.1f per 100" % (sum(self.counts.values()), self.programs, self.total())


def kept():
    """By code: level, reason, and the two figures of the page."""
    rows = {}
    if os.path.exists(PAGE):
        with open(PAGE, encoding="utf-8") as f:
            for line in f:
                row = ROW.match(line)
                if row:
                    rows[row[1]] = (row[2], row[3], float(row[4]), float(row[5]))
    return rows


def page(rules, before, real, ours):
    sums = [0.0, 0.0]
    out = HEAD
    for rule in rules:
        code = rule["code"]
        old = before.get(code, ("", "", 0.0, 0.0))
        figures = [real.of(code) if real else old[2], ours.of(code)]
        sums = [a + b for a, b in zip(sums, figures)]
        out += "| [%s](%s.md) %s | %s | %s | %.1f | %.1f |\n" % (code, code, rule["name"], rule["severity"], rule["level_reason"], *figures)
    return out + "| all | | | %.1f | %.1f |\n" % tuple(sums)


def problems(rules, rows, real, ours):
    for rule in rules:
        code = rule["code"]
        if code not in rows:
            yield "%s is not on the page" % code
            continue
        level, reason, real_figure, our_figure = rows.pop(code)
        if (level, reason) != (rule["severity"], rule["level_reason"]):
            yield "%s: the page has another level or reason than the catalogue" % code
        for noise, figure, where in ((real, real_figure, "real programs"), (ours, our_figure, "tests/noise/programs")):
            if noise and noise.of(code) > figure + 0.05:
                yield "%s is louder than it was: %.1f findings per 100 %s, not %.1f" % (code, noise.of(code), where, figure)
    for code in rows:
        yield "%s is on the page and not in the catalogue" % code


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--kept", action="store_true")
    parser.add_argument("folders", nargs="*", metavar="DIR")
    options = parser.parse_args(argv)
    if not options.kept:
        if not options.folders:
            parser.error("a folder of programs, please")
        print("\n".join(Noise(options.owlint, options.folders).table()))
        return 0
    rules = catalogue(options.owlint)
    ours = Noise(options.owlint, [OURS])
    real = Noise(options.owlint, [REAL]) if os.path.isdir(REAL) else None
    if os.environ.get("OWLINT_UPDATE"):
        text = page(rules, kept(), real, ours)
        with open(PAGE, "w", encoding="utf-8") as f:
            f.write(text)
        return 0
    found = list(problems(rules, kept(), real, ours))
    print("\n".join(found) if found else "no rule is louder than docs/rules/noise.md says")
    print("%s, %.1f per 100 programs of ours" % ("%.1f findings per 100 real programs" % real.total() if real else "without the real programs", ours.total()))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
