#!/usr/bin/python3
"""Does LinuxCNC refuse what owlint takes for the mark of another controller?

usage: marks.py --owlint build/release/owlint

Runs the examples of analyzer/syntax/controllers.cc, each as a line of a program. Those that are proof, alone or with another one,
must stop rs274; hints and codes that count only in a file that names the controller need not.
"""
import os
import re
import sys
import tempfile

import rs274

HERE = os.path.dirname(os.path.abspath(__file__))
TABLE = os.path.join(HERE, "..", "..", "analyzer", "syntax", "controllers.cc")
ROW = re.compile(r'\{k\w+, "[^"]*", Proof::(\w+), "(?:[^"\\]|\\.)*", "((?:[^"\\]|\\.)*)"\}')
COMMENTS = (";", "(")
SKIPPED = 77


def main():
    if not rs274.available:
        print("marks.py: skipped, rs274 is not installed")
        return SKIPPED
    with open(TABLE, encoding="utf-8") as f:
        rows = [(proof, example.replace('\\"', '"')) for proof, example in ROW.findall(f.read())]
    problems = []
    asked = 0
    with tempfile.TemporaryDirectory(prefix="owlint-marks-") as folder:
        for proof, example in rows:
            if proof not in ("kAlone", "kTwo") or example.startswith(COMMENTS):
                continue
            path = os.path.join(folder, "program")
            with open(path, "w", encoding="utf-8") as f:
                f.write("G21 G90 F100\nG0 X0\n%s\nM2\n" % example)
            outcome = rs274.run(path, "default")
            asked += 1
            if outcome.kind != "error":
                problems.append("`%s` is no mark of another controller: rs274 runs it" % example)
    if asked < 50:
        problems.append("only %d of the table's %d examples were found" % (asked, len(rows)))
    print("\n".join(problems) if problems else "rs274 refuses all of them")
    print("%d examples, %d problems" % (asked, len(problems)))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
