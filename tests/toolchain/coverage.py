#!/usr/bin/python3
"""Which part of the code the C++ tests run, room by room.

usage: coverage.py --build FOLDER

FOLDER is a build of the preset `coverage`: clang counts what is run, in the tests and in each owlint that they start.  The rooms
are those of docs/architecture.md.  A line, function or region counts if it was run at least once; a region is a stretch of code
between two branches.

Exit status: that of the tests.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import layers

COUNTS = ("lines", "functions", "regions")


def run_tests(build):
    """-> (exit status, profile)"""
    profiles = os.path.join(build, "profiles")
    shutil.rmtree(profiles, ignore_errors=True)
    os.makedirs(profiles)
    # %m: all runs of one program share a file, which each adds to.
    tests = subprocess.run([os.path.join(build, "tests", "owlint_tests")], stdout=sys.stderr,
                           env={**os.environ, "LLVM_PROFILE_FILE": os.path.join(profiles, "%4m.profraw")})
    profile = os.path.join(build, "owlint.profdata")
    raw = [os.path.join(profiles, name) for name in sorted(os.listdir(profiles))]
    subprocess.run(["llvm-profdata", "merge", "-sparse", "-o", profile, *raw], check=True)
    return tests.returncode, profile


def counted(build, profile):
    """-> {room: {"lines": [covered, all], ...}}, in the order of the table"""
    exported = subprocess.run(["llvm-cov", "export", "-summary-only", "-instr-profile", profile, os.path.join(build, "tests", "owlint_tests"),
                               "-object", os.path.join(build, "owlint")], check=True, capture_output=True, text=True)
    table = layers.rooms()
    rooms = {room: {count: [0, 0] for count in COUNTS} for room in table}
    for file in json.loads(exported.stdout)["data"][0]["files"]:
        room = layers.room_of(os.path.relpath(os.path.realpath(file["filename"]), layers.ROOT), table)
        for count in COUNTS if room else ():
            rooms[room][count][0] += file["summary"][count]["covered"]
            rooms[room][count][1] += file["summary"][count]["count"]
    return {room: counts for room, counts in rooms.items() if counts["lines"][1] > 0}


def row(name, counts):
    cells = ["%6.1f %% of %6d" % (100 * counts[count][0] / counts[count][1] if counts[count][1] else 100, counts[count][1])
             for count in COUNTS]
    return "%-28s %s" % (name, "  ".join(cells))


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", required=True)
    build = os.path.abspath(parser.parse_args(argv).build)
    status, profile = run_tests(build)
    rooms = counted(build, profile)
    total = {count: [sum(counts[count][i] for counts in rooms.values()) for i in (0, 1)] for count in COUNTS}
    print("%-28s %s" % ("room", "  ".join("%18s" % count for count in COUNTS)))
    for room, counts in rooms.items():
        print(row(room + "/", counts))
    print(row("all", total))
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
