#!/usr/bin/python3
"""What can be said of the sources without running owlint.

usage: check.py [--all] [--since COMMIT] [--portion N]

  format      clang-format would change nothing
  lengths     no source has more than 400 lines, and no comment is wider than 130 columns (clang-format sees to the code)
  rooms       every include is in the table of docs/architecture.md (layers.py)
  clang-tidy  finds nothing in the sources that have changed since COMMIT, or whose headers have, committed or not; with --all,
              in any.  All of them take a quarter of an hour on two cores, so CI takes --portion: N sources, the same
              each time.  Unset, COMMIT is where this branch left origin/main, or the one before.

clang-tidy reads compile commands without precompiled headers: configure with `cmake --preset debug` first.

Exit status: 0 nothing is wrong, 1 something is.
"""
import argparse
import concurrent.futures
import hashlib
import os
import re
import subprocess
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
BUILD = os.path.join(ROOT, "build", "debug")
MOST_LINES = 400
WIDEST_COMMENT = 130
COMMENT = re.compile(r"^\s*(//|\*|/\*)")


def run(*command):
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True)


def stem(path):
    return os.path.splitext(path)[0]


def sources():
    """Tracked C++ files, and new ones that are not ignored."""
    listed = run("git", "ls-files", "-co", "--exclude-standard", "*.cc", "*.h", "*.hpp").stdout.split("\n")
    return sorted(path for path in listed if path and os.path.isfile(os.path.join(ROOT, path)))


def format_problems(paths):
    result = run("clang-format", "--dry-run", "-Werror", *paths)
    return sorted({line.split(": error:")[0] + ": clang-format would change it (./dev format)"
                   for line in result.stderr.split("\n") if ": error:" in line})


def length_problems(paths):
    for path in paths:
        with open(os.path.join(ROOT, path), encoding="utf-8", errors="replace") as f:
            lines = f.read().split("\n")
        if len(lines) - 1 > MOST_LINES:
            yield "%s: %d lines, more than %d" % (path, len(lines) - 1, MOST_LINES)
        for number, line in enumerate(lines, 1):
            if len(line) > WIDEST_COMMENT and COMMENT.match(line):
                yield "%s:%d: %d columns, more than %d" % (path, number, len(line), WIDEST_COMMENT)


def room_problems():
    result = run(sys.executable, "tests/toolchain/layers.py")
    return result.stdout.strip().split("\n") if result.returncode != 0 else []


def before():
    """The commit that changes are counted from; None where there is none, as in a checkout of one commit."""
    head = run("git", "rev-parse", "HEAD").stdout
    base = run("git", "merge-base", "HEAD", "origin/main")
    if base.returncode == 0 and base.stdout != head:
        return base.stdout.strip()
    return "HEAD~1" if run("git", "rev-parse", "--verify", "HEAD~1").returncode == 0 else None


def changed_since(commit):
    """What has changed, without endings."""
    changed = []
    if commit:
        diff = run("git", "diff", "--name-only", commit)
        if diff.returncode != 0:
            sys.exit("check.py: " + diff.stderr.strip())
        changed = diff.stdout.split("\n")
    return {stem(path) for path in changed + run("git", "ls-files", "-o", "--exclude-standard").stdout.split("\n")}


def tidy_problems(paths, changed):
    def tidy(path):
        result = run("clang-tidy", "-p", BUILD, "--quiet", "--extra-arg=-Wno-unknown-warning-option", path)
        return [line.replace(ROOT + "/", "") for line in result.stdout.split("\n") if re.search(r": (warning|error): ", line)]

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = {problem for problems in pool.map(tidy, paths) for problem in problems}
    return sorted(p for p in found if changed is None or stem(p.split(":")[0]) in changed)  # headers are in many sources


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--all", action="store_true", help="clang-tidy looks at all sources")
    parser.add_argument("--since", metavar="COMMIT", help="clang-tidy looks at what has changed since this commit")
    parser.add_argument("--portion", type=int, metavar="N", help="clang-tidy looks at N sources, the same each time")
    options = parser.parse_args(argv)
    paths = sources()
    with open(os.path.join(BUILD, "compile_commands.json"), encoding="utf-8") as f:
        compiled = f.read()
    changed = None if options.all or options.portion else changed_since(options.since or before())
    to_tidy = [path for path in paths if path.endswith(".cc") and "/" + path + '"' in compiled
               and (changed is None or stem(path) in changed)]
    if options.portion:
        to_tidy = sorted(to_tidy, key=lambda path: hashlib.sha256(path.encode()).digest())[:options.portion]
        changed = {stem(path) for path in to_tidy}
    found = [*format_problems(paths), *length_problems(paths), *room_problems(), *tidy_problems(to_tidy, changed)]
    print("\n".join(found) if found else "%d sources, clang-tidy over %d of them: nothing is wrong" % (len(paths), len(to_tidy)))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
