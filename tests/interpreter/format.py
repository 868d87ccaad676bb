#!/usr/bin/python3
"""`owlint fmt` changes nothing that the interpreter sees: programs end alike before and after.

usage: format.py --owlint build/release/owlint

All programs of the corpus and of the fixtures, run by the interpreter in process, each with all its conditions false and
with all of them true.  How they end is compared, and what they tell the machine.
"""
import argparse
import glob
import os
import subprocess
import sys

try:
    from oracle import Interpreter, scratch
except ImportError:
    Interpreter = None

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
SKIPPED = 77
CPU_LIMIT_S = 0.25          # the longest program of the corpus takes 0.07 s with all its moves written down


def formatted(owlint, text):
    done = subprocess.run([owlint, "fmt", "-"], input=text, capture_output=True, check=True)
    return done.stdout


def ending(interpreter, text, choices):
    run = interpreter.run(text.decode("latin-1"), choices)
    if run.outcome == "hang":  # how much of an endless run there is depends on the time
        return run.outcome, run.line, "", ()
    return run.outcome, run.line, " ".join(run.message.split()), run.calls  # messages quote the line, with its indentation


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--every", type=int, default=1, help="only every Nth program")
    options = parser.parse_args()
    if Interpreter is None:
        print("skipped: LinuxCNC's Python module is not here")
        return SKIPPED
    owlint = os.path.abspath(options.owlint)
    paths = sorted(glob.glob(os.path.join(ROOT, "corpus", "*.ngc")) + glob.glob(os.path.join(ROOT, "tests", "programs", "*", "*.ngc")))[::options.every]
    interpreter = Interpreter(False, scratch(), record=True, cpu_limit=CPU_LIMIT_S)
    compared = different = changed = 0
    for path in paths:
        with open(path, "rb") as f:
            before = f.read()
        after = formatted(owlint, before)
        if after == before:
            continue
        changed += 1
        for choices in (b"", bytes([1]) * 40):
            compared += 1
            ends = ending(interpreter, before, choices), ending(interpreter, after, choices)
            # A spline leaves a place that is different in every run.
            if ends[0] != ends[1] and ending(interpreter, before, choices) == ends[0]:
                different += 1
                print("%s: %s before, %s after" % (path, ends[0][:3], ends[1][:3]))
    interpreter.close()
    print("%d programs, %d of them changed, %d runs compared, %d differ" % (len(paths), changed, compared, different))
    return 1 if different or not changed else 0


if __name__ == "__main__":
    sys.exit(main())
