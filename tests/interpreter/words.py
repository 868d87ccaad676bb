#!/usr/bin/python3
"""Random programs of words: owlint says of each line that stops one what rs274 says, and of no other.

usage: words.py --owlint build/release/owlint [--programs 1500] [--seed S] [--jobs 2] [--show 40] [--keep DIR]

The programs come from word_maker.py: straight lines, lines in a block that runs or not, in a sub that is called or not.
rs274 runs each, a process for each.  Where it stops as owlint says, or for what the machine decides
(of_machine.py), the line is taken out and the rest is compared in turn.  Held against what owlint says:

  silent, other place   a miss: the interpreter stops, owlint does not claim it at that line
  other words           the stop is claimed there, with a message that the interpreter does not print
  not always            a false alarm: an error for every run, and this run does not end there
  crash                 the interpreter crashes, owlint does not say so
  owlint fails          it crashes or does not end

Counted by message, and no disagreements, are stops that are not followed, and stops for what a program does not set.
Disagreements are shrunk and printed.

Exit status: 0 none; 1 disagreements; 77 rs274 is not here.
"""
import argparse
import os
import random
import shutil
import sys
import tempfile
import time

import rs274
from confirm import Program
from examiner import Examiner, Task, by_message, compare, report, summary
from word_maker import program

SKIPPED = 77
ROUNDS = 15                 # lines that are taken out of one program


def tasks_of(options):
    for number in range(options.programs):
        name = "words/%d/%d" % (options.seed, number)
        yield Task(name, "random words", Program(name, program(random.Random(name))))


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--owlint", required=True, help="the program to test", type=os.path.abspath)
    parser.add_argument("--programs", type=int, default=1500)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--show", type=int, default=40, help="sorts of disagreements to shrink and print")
    parser.add_argument("--keep", metavar="DIR", help="save the programs that disagree")
    options = parser.parse_args(argv)
    if not rs274.available:
        print("skipped: rs274 is not here")
        return SKIPPED
    if options.seed is None:
        options.seed = int(time.time())
    folder = tempfile.mkdtemp(prefix="owlint-words-", dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None)
    started = time.monotonic()
    arguments = (options.owlint, folder, False, ROUNDS, True, True)
    try:
        found, counts = compare(list(tasks_of(options)), options.jobs, arguments)
        seconds = time.monotonic() - started
        report(found, Examiner(*arguments), options.show, options.keep)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    by_message(counts)
    print("seed %d: %d programs, runs: %s; %d disagreements, %.0f s" % (
        options.seed, options.programs, summary(counts), len(found), seconds))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
