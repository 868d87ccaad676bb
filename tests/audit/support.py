"""What the tests of `owlint audit` share: made-up shops, runs, and what a store or an export says."""
import argparse
import json
import os
import random
import sqlite3
import subprocess
import sys
import tempfile

SUBS = 24


class Failed(Exception):
    pass


def check(good, words):
    if not good:
        raise Failed(words)


def arguments(description, **numbers):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--owlint", required=True, type=os.path.abspath)
    for name, default in numbers.items():
        parser.add_argument("--" + name, type=int, default=default)
    return parser.parse_args()


def main(test, options):
    with tempfile.TemporaryDirectory(prefix="owlint-audit-") as folder:
        try:
            test(options, folder)
        except Failed as problem:
            print("wrong: %s" % problem)
            sys.exit(1)


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(text if isinstance(text, bytes) else text.encode())


def sub_text(number):
    """A shared sub; every sixth one calls another."""
    other = "  o<shared%d> call [#1]\n" % (number + 1) if number % 6 == 0 else ""
    return "(shared %d)\no<shared%d> sub\n%s  o100 if [#1 GT 5]\n    G0 Z5\n  o100 endif\no<shared%d> endsub\nM2\n" % (number, number, other, number)


def program_text(number, motion=20):
    """A program that calls one shared sub; every tenth one is faulty."""
    lines = ["(part %d)" % number, "G21 G90"] + ["G1 X%d Y%d F500" % (i, number % 97) for i in range(motion)]
    lines += ["o100 while [#31 LT 10]", "  #31=[#31+1]", "  o<shared%d> call [#31]" % (number % SUBS), "o100 endwhile"]
    if number % 10 == 0:
        lines += ["o100 if [#31 EQ 3]", "  G0 X1", "o100 endif"]
    return "\n".join(lines + ["M2", ""])


def make_shop(root, programs, motion=20):
    for number in range(SUBS):
        write("%s/subs/shared%d.ngc" % (root, number), sub_text(number))
    write(root + "/machine.ini", "[RS274NGC]\nSUBROUTINE_PATH = subs:more\n")
    os.makedirs(root + "/more", exist_ok=True)
    for number in range(programs):
        write("%s/f%04d/part%d.ngc" % (root, number // 100, number), program_text(number, motion))


def part(root, number):
    return "%s/f%04d/part%d.ngc" % (root, number // 100, number)


def callers(programs, sub):
    """How many programs and subs rest on a sub, itself included."""
    through = {sub} | ({sub - 1} if (sub - 1) % 6 == 0 else set())
    return sum(number % SUBS in through for number in range(programs)) + len(through)


def run(owlint, *command, cwd=None, statuses=(0, 1), **options):
    done = subprocess.run([owlint, *command], capture_output=True, text=True, cwd=cwd, errors="surrogateescape", **options)
    check(done.returncode in statuses, "%s ends with %s: %s%s" % (" ".join(command)[:200], done.returncode, done.stdout[-500:], done.stderr[-800:]))
    return done


def query(store, sql, *values):
    with sqlite3.connect(store) as db:
        return db.execute(sql, values).fetchall()


def last_run(store):
    """The row of the last run, by column."""
    with sqlite3.connect(store) as db:
        db.row_factory = sqlite3.Row
        return dict(db.execute("SELECT * FROM run ORDER BY id DESC LIMIT 1").fetchone())


def export(owlint, store, form="json", run_number="last"):
    return run(owlint, "audit", "export", run_number, "--store", store, "--format", form, statuses=(0,)).stdout


def findings(text):
    """The findings of a JSON report by file, without what hangs on how a path was written."""
    return {os.path.abspath(file["path"]): file["findings"] for file in json.loads(text)["files"]}


def checked(owlint, root, *options):
    """What `owlint check` finds in a process of its own."""
    return findings(run(owlint, "check", root, "--format", "json", "--ini", root + "/machine.ini", *options).stdout)


def shuffled(seed, items):
    items = list(items)
    random.Random(seed).shuffle(items)
    return items
