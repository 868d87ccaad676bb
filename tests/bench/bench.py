#!/usr/bin/python3
"""Times owlint on large programs that it makes, and prints the growth for ten times the size.

usage: bench.py --owlint build/release/owlint [--runs 3] [--motion MIB]

Every figure is the median wall time of the whole command. Nothing here passes or fails. At the end a motion program of
MIB mebibytes (1024) with a few blocks in it is held against `wc -l`, which only looks for line ends: both in turn, files in
the page cache, one thread.
"""
import argparse
import os
import random
import statistics
import subprocess
import tempfile
import time


def subs(lines):
    """400 subs with nested loops and branches that call each other, and as many calls."""
    groups = max(2, lines // 400 // 12)
    for s in range(400):
        yield "o<s%d> sub" % s
        for b in range(groups):
            k = 100 + b * 10
            yield from ("#<v>=#%d" % (1 + b % 3), "o%d if [#1 GT %d]" % (k, b), "  o%d while [#2 LT %d]" % (k + 1, b),
                        "    #2=[#2+1]", "    o%d if [#2 EQ #3]" % (k + 2), "      o%d break" % (k + 1),
                        "    o%d endif" % (k + 2), "  o%d endwhile" % (k + 1), "o%d else" % k,
                        "  o%d repeat [#1]" % (k + 3), "  o%d endrepeat" % (k + 3), "o%d endif" % k)
        if s % 9:
            yield "o<s%d> call [#1] [#2] [#3]" % (s - 1)
        yield "o<s%d> endsub" % s
    for s in range(400):
        yield "o<s%d> call [#100] [%d] [3]" % (s, s)
    yield "M2"


def nested(depth):
    for i in range(depth):
        yield "o%d if [#%d GT 1]" % (i, 100 + i % 50)
    for i in reversed(range(depth)):
        yield "o%d endif" % i
    yield "M2"


def labels(count):
    for i in range(count):
        yield "o%d if [#100 GT %d]" % (i, i)
        yield "o%d endif" % i
    yield "M2"


def redefined(count):
    """One label opened again and again on paths that exclude each other or not."""
    for i in range(count):
        yield from ("o%d if [#%d]" % (i + 10, 100 + i % 900), "o5 if [1]", "o5 endif", "o%d endif" % (i + 10))
    yield "M2"


def calls(count):
    yield from ("o1 sub", "o2 if [#1]", "o2 endif", "o1 endsub")
    for i in range(count):
        yield "o1 call [%d]" % i
    yield "M2"


def doubling_calls(depth):
    """Each sub calls the one before twice: two to the power of `depth` paths."""
    for i in range(depth):
        yield "o%d sub" % i
        if i:
            yield "o%d call [#1]" % (i - 1)
            yield "o%d call [#2]" % (i - 1)
        yield "o%d endsub" % i
    yield "o%d call [1] [2]" % (depth - 1)
    yield "M2"


def branches(depth, rounds):
    for r in range(rounds):
        for i in range(depth):
            yield "o%d if [#%d]" % (r * 1000 + i, 100 + r * 1000 + i)
        for i in reversed(range(depth)):
            yield "o%d else" % (r * 1000 + i)
            yield "o%d endif" % (r * 1000 + i)
    yield "M2"


def motion(lines):
    for i in range(lines):
        yield "G1 X%.4f Y%.4f F%d" % (i * 0.01 % 300, i * 0.007 % 200, 400 + i % 7)
    yield "M2"


CASES = (
    ("O-word program, lines", lambda n: subs(n), (100_000, 1_000_000)),
    ("nested `if`, depth", nested, (10_000, 100_000)),
    ("labels in one scope", labels, (10_000, 100_000)),
    ("one label on many paths", redefined, (1_000, 10_000)),
    ("calls of one sub", calls, (10_000, 100_000)),
    ("subs that call twice, depth", doubling_calls, (9, 90)),
    ("motion lines", motion, (100_000, 1_000_000)),
    ("32 nested branches, rounds", lambda n: branches(32, n), (1,)),
    ("64 nested branches, rounds", lambda n: branches(64, n), (2,)),
)


def motion(mebibytes, write):
    """A CAM program: an O-word block now and then, else positions."""
    rng = random.Random(1)
    place = lambda: "X%.4f Y%.4f Z%.4f\n" % (rng.uniform(0, 300), rng.uniform(0, 200), rng.uniform(-20, 5))
    piece = "".join(("G1 " if i % 10 == 0 else "") + place() for i in range(40000))
    write("%\nG21 G90\n")
    pieces = (mebibytes << 20) // len(piece) + 1
    for number in range(pieces):
        if number % max(1, pieces // 20) == 0:
            write("o%d if [#%d GT 0]\n  G0 Z5\no%d endif\n" % (100 + number, 500, 100 + number))
        write(piece)
    write("M2\n%\n")


def timed(command):
    """-> (seconds, peak memory in MiB)"""
    started = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, _, usage = os.wait4(process.pid, 0)
    return time.monotonic() - started, usage.ru_maxrss / 1024


def against_wc(options, folder):
    path = os.path.join(folder, "motion.ngc")
    with open(path, "w", encoding="ascii") as f:
        motion(options.motion, f.write)
    commands = {"wc -l": ["wc", "-l", path], "owlint": [options.owlint, "check", "--isolated", "--no-find-ini", "--jobs", "1", path]}
    runs = {name: [] for name in commands}
    for _ in range(options.runs + 2):
        for name, command in commands.items():
            runs[name].append(timed(command))
    print("\n%d MiB of motion" % options.motion)
    base = statistics.median(seconds for seconds, _ in runs["wc -l"])
    for name, measured in runs.items():
        seconds = statistics.median(seconds for seconds, _ in measured)
        print("  %-8s %8.3f s  %5.2f x wc -l  %6.1f MiB of memory" % (name, seconds, seconds / base, max(m for _, m in measured)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--motion", type=int, default=1024, metavar="MIB")
    options = parser.parse_args()
    print("%-30s %10s %10s %10s %8s" % ("program", "size", "lines", "seconds", "growth"))
    with tempfile.TemporaryDirectory() as folder:
        for name, make, sizes in CASES:
            before = None
            for size in sizes:
                path = os.path.join(folder, "program.ngc")
                lines = list(make(size))
                with open(path, "w", encoding="ascii") as f:
                    f.write("\n".join(lines) + "\n")
                times = []
                for _ in range(options.runs):
                    started = time.monotonic()
                    subprocess.run([options.owlint, "check", "--isolated", "--format", "jsonl", path],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
                    times.append(time.monotonic() - started)
                seconds = statistics.median(times)
                growth = "" if before is None else "%.1f x" % (seconds / before)
                print("%-30s %10d %10d %10.3f %8s" % (name, size, len(lines), seconds, growth), flush=True)
                before = seconds
        against_wc(options, folder)


if __name__ == "__main__":
    main()
