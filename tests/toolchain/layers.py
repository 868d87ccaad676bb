#!/usr/bin/python3
"""Every include goes from a room to one that it may use.

usage: layers.py [--table]

The rooms and what each may use are the table between the markers in docs/architecture.md.  A room is a folder; the longest
fitting one counts.  README's list of rooms is made from the same table (--table prints it; a test compares).  Only the text
room and the front ends know of the operating system: files, folders, processes and threads.

Exit status: 0 all includes are in the table, and nothing in the table is unused; 1 not so.
"""
import argparse
import os
import re
import subprocess
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
DOCUMENT = os.path.join(ROOT, "docs", "architecture.md")
ROW = re.compile(r"^\| `([a-z_/]+)/` \| (.*?) \| (.*?) \|$")
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
SYSTEM_ROOMS = ("analyzer/text", "analyzer/audit", "analyzer/lsp", "analyzer/cli")
SYSTEM = re.compile(
    r"#include <(?:filesystem|fstream|thread|future|omp\.h|unistd\.h|fcntl\.h|dirent\.h|glob\.h|ftw\.h|spawn\.h|poll\.h|sys/\w+\.h)>"
    r"|std::filesystem|#pragma omp|\b(?:fopen|freopen|tmpfile|popen|opendir|realpath|mmap)\(|::(?:open|stat|access|unlink)\(")


def rooms():
    """-> {room: (what it holds, [rooms that it may use])}, in the order of the table"""
    with open(DOCUMENT, encoding="utf-8") as f:
        table = f.read().split("<!-- rooms -->")[1].split("<!-- end -->")[0]
    found = {}
    for line in table.split("\n"):
        row = ROW.match(line)
        if row:
            found[row.group(1)] = (row.group(2), re.findall(r"`([a-z_/]+)/`", row.group(3)))
    return found


def room_of(path, table):
    fitting = [room for room in table if path.startswith(room + "/")]
    return max(fitting, key=len) if fitting else None


def sources():
    """Tracked sources, and new ones that are not ignored; all files where there is no Git."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard", "analyzer", "rules", "api"], capture_output=True, text=True)
    paths = listed.stdout.split("\n") if listed.returncode == 0 else [
        os.path.relpath(os.path.join(folder, name), ROOT)
        for top in ("analyzer", "rules", "api") for folder, _, names in os.walk(os.path.join(ROOT, top)) for name in names]
    return sorted(p for p in paths if p.endswith((".cc", ".h")) and os.path.isfile(os.path.join(ROOT, p)))


def problems(table):
    used = set()
    order = list(table)
    for room, (_, uses) in table.items():
        for other in uses:
            if other not in table:
                yield "%s may use %s, which is no room" % (room, other)
            elif order.index(other) > order.index(room):
                yield "%s may use %s, which comes after it: the table goes from the bottom up" % (room, other)
    for path in sources():
        room = room_of(path, table)
        if room is None:
            yield "%s is in no room" % path
            continue
        with open(os.path.join(ROOT, path), encoding="utf-8") as f:
            text = f.read()
        if room not in SYSTEM_ROOMS:
            for system in sorted({found.group(0) for found in SYSTEM.finditer(text)}):
                yield "%s has `%s`: `%s/` may not; files come from analyzer/text/files.h, threads from parallel.h" % (path, system, room)
        for include in INCLUDE.findall(text):
            other = room_of(include, table)
            if other is None or other == room:
                continue
            used.add((room, other))
            if other not in table[room][1]:
                yield "%s includes %s: `%s/` may not use `%s/`" % (path, include, room, other)
    for room, (_, uses) in table.items():
        for other in uses:
            if (room, other) not in used:
                yield "`%s/` may use `%s/`, and does not" % (room, other)


def table_for_readme(table):
    """The list of rooms as README shows it."""
    return "\n".join(["| folder | holds |", "|---|---|"] + ["| `%s/` | %s |" % (room, holds) for room, (holds, _) in table.items()]) + "\n"


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--table", action="store_true", help="print README's list of rooms")
    options = parser.parse_args(argv)
    table = rooms()
    if options.table:
        print(table_for_readme(table), end="")
        return 0
    found = list(problems(table))
    with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as f:
        if table_for_readme(table) not in f.read():
            found.append("README.md: its list of rooms is not that of docs/architecture.md (layers.py --table)")
    print("\n".join(found) if found else "%d rooms, no include outside of the table" % len(table))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
