#!/usr/bin/python3
"""Does owlint read INIs as LinuxCNC's own `inivar` does?  Random files in which every rule of the format is tried.

usage: ini.py --owlint build/release/owlint --values build/release/tests/ini_values [--count N] [--seed S]
"""
import argparse
import os
import random
import shutil
import subprocess
import sys
import tempfile

SECTIONS = ("A", "B", "RS274NGC", " A", "a")
KEYS = ("X", "XY", "Y", "x")
PIECES = ("1", "a b", "a;b", "# no", '"q"', "=", "[A]", "", "  ", "\t", "v" * 40, "w" * 270, "é", "a\\b")


def line(rng):
    kind = rng.random()
    key = rng.choice(KEYS)
    blank = lambda: rng.choice(("", "", " ", "\t", "  "))
    if kind < 0.2:
        return "%s[%s]%s" % (blank(), rng.choice(SECTIONS), rng.choice(("", "", " ", "junk", " ; c")))
    if kind < 0.7:
        return "%s%s%s=%s%s%s" % (blank(), key, blank(), blank(), rng.choice(PIECES) + rng.choice(PIECES), blank())
    if kind < 0.8:
        return "%s%s = %s\\" % (blank(), key, rng.choice(PIECES))
    if kind < 0.88:
        return rng.choice(("# comment", "; comment", " # X = 3", ";X=4", "#", "#X = 5 \\"))
    return rng.choice(("", "[", "[A", "]", "X", "X Y = 5", "=5", " = 5", "X = ", "[]", "X:1", "   "))


def lines(rng):
    """The lines of one file.  No continued line stands before a section or the end: what `inivar` makes of that depends
    on the value that it is asked for; so it does where lines are too long as well, and a file has one or the other. Tabs
    at the beginning of what continues a line are left out too: no INI of LinuxCNC has them."""
    made = []
    for _ in range(rng.randint(1, 14)):
        new = line(rng)
        if "w" * 270 in new and any(m.endswith("\\") for m in made) or new.endswith("\\") and any("w" * 270 in m for m in made):
            continue
        if made and made[-1].endswith("\\") and new.strip().startswith("["):
            new = "x"
        made.append(new.lstrip("\t") if made and made[-1].endswith("\\") else new)
    if made and made[-1].endswith("\\"):
        made.append("x")
    return made or ["[A]"]


def values(program, path, queries):
    text = "".join("%s\t%s\t%d\n" % q for q in queries)
    done = subprocess.run([program, path], input=text.encode(), capture_output=True, check=True)
    return done.stdout.decode("latin-1").split("\n")[:-1]


def inivar(path, section, key, number):
    done = subprocess.run(["inivar", "-ini", path, "-sec", section, "-var", key, "-num", str(number)], capture_output=True)
    return done.stdout.decode("latin-1").rstrip("\n") if done.returncode == 0 else ""


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", help="not used: all tests have it")
    parser.add_argument("--values", required=True, help="the program that prints what owlint reads")
    parser.add_argument("--count", type=int, default=120)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(argv)
    if not shutil.which("inivar"):
        print("inivar is not installed")
        return 77
    queries = [(s, k, n) for s in SECTIONS for k in KEYS for n in (1, 2)]
    wrong = asked = 0
    with tempfile.TemporaryDirectory(prefix="owlint-ini-") as folder:
        path = os.path.join(folder, "machine.ini")
        for number in range(options.count):
            rng = random.Random("%d/%d" % (options.seed, number))
            ending = rng.choice(("\n", "\n", "\r\n"))
            text = ending.join(lines(rng)) + rng.choice(("", ending))
            with open(path, "w", encoding="utf-8", newline="") as f:
                f.write(text)
            some = rng.sample(queries, 12)
            for query, ours in zip(some, values(options.values, path, some)):
                asked += 1
                theirs = inivar(path, *query)
                if ours != theirs:
                    wrong += 1
                    if wrong < 6:
                        print("file %d/%d, [%s]%s number %d: inivar says %r, owlint %r\n%s\n" % (options.seed, number, *query, theirs, ours, text))
    print("%d values asked for, %d not as inivar says" % (asked, wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
