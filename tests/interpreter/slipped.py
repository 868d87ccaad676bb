#!/usr/bin/python3
"""Of programs with a slip of the pen, owlint says what rs274 does with them: after its safe fixes, or as written.

usage: slipped.py --owlint build/release/owlint [--as-written] [--arcs] [--programs 1000] [--seed S] [--jobs 2] [--show 40]
                  [--keep DIR] [DIR...]

The programs are the fixtures, the corpus, LinuxCNC's own and those in DIR..., each with one slip (slips.py).  `owlint check
--fix` makes its safe fixes, and rs274 runs what comes out, a process for each.  With --as-written nothing is fixed, most of
the slips are in lines of words, and only programs are taken that run without the slip.  Held against what owlint says then:

  silent      the interpreter stops, owlint claims no stop at all
  other place the interpreter stops, owlint claims stops elsewhere only
  other words the stop is claimed there, with a message that the interpreter does not print
  not always  a stop that is claimed for every run is not the one that ends this run, or an error is, and it runs
  crash       the interpreter crashes, owlint does not say so
  owlint fails    it crashes or does not end

Counted, and no disagreements, are
  machine     a stop that the machine decides (of_machine.py); as written, the line is then taken out, and what is left is
              compared in turn
  unknowable  a stop for what the machine holds and the program does not set: a pin, an INI's entry, a numbered parameter
  endless     the interpreter never ends, owlint claims neither that nor a stop in every run
Disagreements are shrunk and printed.

Exit status: 0 none; 1 disagreements; 77 rs274 is not here.
"""
import argparse
import glob
import hashlib
import os
import random
import re
import shutil
import sys
import tempfile
import time
from dataclasses import replace

import bundle
import rs274
from arc_slips import has_arcs
from claims import settings
from confirm import Program, corpus, fixtures, read
from examiner import Examiner, Task, by_message, compare, files_of, report, summary
from slips import slip

NCFILES = "/usr/share/linuxcnc/ncfiles"
LARGEST = 20_000            # bytes of a program that is tried
SKIPPED = 77
ROUNDS = 4                  # lines that are taken out of one program
OF_WORDS, OF_WORDS_FIXED = 0.75, 0.2    # of the slips, how many are in a line of words


def programs_to_slip(folders):
    """Fixtures, the corpus, LinuxCNC's own programs and those of the folders, these with the files that they call."""
    # What is suppressed is there all the same.
    programs = [replace(p, text=p.text.replace("owlint: ignore", "owlint ignored")) for p in [*fixtures(), *corpus()]]
    for folder in (NCFILES, *folders):
        for path in sorted(glob.glob(os.path.join(folder, "**", "*.ngc"), recursive=True)):
            if os.path.getsize(path) <= LARGEST:
                programs.append(Program(os.path.relpath(path, folder), with_called(path)))
    # A file with a sub of its own name is checked as one that others call; rs274 would run it as a program.
    own_sub = re.compile(r"(?im)^\s*o<%s>\s*sub\b" % bundle.MAIN.removesuffix(".ngc"))
    # What is no text is one finding, wherever it stops.
    return [p for p in programs if len(p.text) <= LARGEST and not own_sub.search(p.text) and "\0" not in p.text]


def with_called(path):
    """The program, as a bundle where it calls files of its folder."""
    folder = os.path.dirname(path)
    text, wanted = read(path), {}
    todo = [text]
    while todo:
        for name in re.findall(r"(?i)o\s*<([\w-]+)>\s*call", todo.pop()):
            called = os.path.join(folder, name.lower() + ".ngc")
            if name.lower() not in wanted and called != path and os.path.isfile(called):
                wanted[name.lower()] = read(called)
                todo.append(wanted[name.lower()])
    for name, called in wanted.items():
        text += ("" if text.endswith("\n") else "\n") + "; file: %s.ngc\n%s" % (name, called)
    return text


def slipped(program, rng, of_words, arcs):
    """-> (what was done, the program with a slip in one of its files)"""
    parts = re.split(r"(?m)^(; file: .*\n)", program.text) if bundle.is_bundle(program.text) else [program.text]
    # An INI or a tool table is no program.
    programs = [0] + [at for at in range(2, len(parts), 2) if parts[at - 1].strip().endswith(".ngc")]
    at = rng.choice([at for at in programs if has_arcs(parts[at])] if arcs else programs)
    what, parts[at] = slip(parts[at], rng, of_words, arcs)
    if at + 1 < len(parts) and not parts[at].endswith("\n"):
        parts[at] += "\n"
    return what, replace(program, text="".join(parts))


class Runs:
    """Which programs run, each tried once."""

    def __init__(self, folder):
        self.folder = os.path.join(folder, "before")
        self.known = {}

    def __call__(self, program):
        key = program.name, program.text
        if key not in self.known:
            bundle.write(self.folder, files_of(program))
            main = os.path.join(self.folder, bundle.MAIN)
            self.known[key] = all(rs274.run(main, program.mode, on).kind == "ok" for on in settings(program.text))
            shutil.rmtree(self.folder)
        return self.known[key]


def tasks_of(options, folder):
    sources, runs = programs_to_slip(options.folders), Runs(folder)
    if options.arcs:
        sources = [source for source in sources if any(has_arcs(text) for name, (_, text) in files_of(source).items() if name.endswith(".ngc"))]
    for number in range(options.programs):
        name = "slip/%d/%d" % (options.seed, number)
        rng = random.Random(name)
        # A new fixture takes a few of the tasks, and leaves the others as they are.
        by_chance = lambda program: hashlib.blake2b((name + program.name).encode()).digest()
        if options.as_written:
            source = next(filter(runs, sorted(sources, key=by_chance)))
        else:
            source = min(sources, key=by_chance)
        what, program = slipped(source, rng, OF_WORDS if options.as_written else OF_WORDS_FIXED, options.arcs)
        yield Task(source.name, what, program)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--owlint", required=True, help="the program to test", type=os.path.abspath)
    parser.add_argument("--as-written", action="store_true", help="fix nothing, and slip in programs that run")
    parser.add_argument("--arcs", action="store_true", help="only slips with arcs")
    parser.add_argument("--programs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--show", type=int, default=40, help="sorts of disagreements to shrink and print")
    parser.add_argument("--keep", metavar="DIR", help="save the programs that disagree, with their slip")
    parser.add_argument("folders", nargs="*", metavar="DIR", help="more programs")
    options = parser.parse_args(argv)
    if not rs274.available:
        print("skipped: rs274 is not here")
        return SKIPPED
    if options.seed is None:
        options.seed = int(time.time())
    folder = tempfile.mkdtemp(prefix="owlint-slipped-", dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None)
    started = time.monotonic()
    arguments = (options.owlint, folder, not options.as_written, ROUNDS if options.as_written else 1)
    try:
        found, counts = compare(list(tasks_of(options, folder)), options.jobs, arguments)
        seconds = time.monotonic() - started
        report(found, Examiner(*arguments), options.show, options.keep)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    by_message(counts)
    print("seed %d: %d programs with a slip, %s, runs: %s; %d disagreements, %.0f s" % (
        options.seed, options.programs, "as written" if options.as_written else "%d fixed safely" % counts["fixed"],
        summary(counts), len(found), seconds))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
