#!/usr/bin/python3
"""Is a large file never in memory as a whole?

usage: memory.py --owlint build/release/owlint

Checks a file of motion, with and without O-words in it, and asks how much memory that took at most: a rule that searches all
bytes once more would bring all of them in.  (The time of it is a matter of `./dev bench`.)
"""
import argparse
import os
import subprocess
import sys
import tempfile

LINES = 4_000_000
MOST = 24 << 10     # KiB; the program itself takes about 11 MiB


def motion(path, every):
    """A file of so many lines, with a loop of a few lines before each `every`th of them."""
    with open(path, "w", encoding="ascii") as f:
        f.write("G21 G90 G17\nF100\nG1 X0 Y0 Z0\n")
        for first in range(0, LINES, every):
            f.write("o%d repeat [2]\n  G1 X1\no%d endrepeat\n" % (first + 1, first + 1))
            f.writelines("X%d.125 Y-%d.5 Z1\n" % (i % 300, i % 200) for i in range(first, min(first + every, LINES)))
        f.write("M2\n")


def memory_of(command):
    """-> the exit status, and the KiB that the program has had at once at most."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    return os.waitstatus_to_exitcode(status), used.ru_maxrss


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--owlint", required=True)
    owlint = os.path.abspath(parser.parse_args().owlint)
    problems = 0
    with tempfile.TemporaryDirectory(prefix="owlint-memory-") as folder:
        path = os.path.join(folder, "motion.ngc")
        for every in (LINES, LINES // 20):
            motion(path, every)
            size = os.path.getsize(path) >> 10
            status, memory = memory_of([owlint, "check", "--isolated", "--no-find-ini", "--jobs", "1", path])
            good = status == 0 and memory < MOST < size
            problems += not good
            print("%s%d KiB of motion in %d parts: status %d, %d KiB of memory" % ("" if good else "WRONG: ", size, LINES // every, status, memory))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
