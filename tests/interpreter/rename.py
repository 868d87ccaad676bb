#!/usr/bin/python3
"""The language server's renames change no run: random programs, random places, random new names.

usage: rename.py --owlint build/release/owlint [--programs 200] [--seed S]

What the server refuses is left alone.  After a rename that it accepts, owlint must find the same at the same lines, and
the interpreter must tell the machine the same and end alike, for several choices of the program's unknown values; a few
programs also go through the stand-alone rs274.  A label that several blocks share is the exception: to rename one of
them tells them apart, which is what such a rename is for.
"""
import argparse
import json
import os
import random
import re
import subprocess
import sys
import tempfile
from collections import Counter

try:
    from oracle import Interpreter, scratch
except SystemExit:
    Interpreter = None

import bundle
import rs274
from generate import generate, generate_files, generate_values
from linter import Linter

SKIPPED = 77
RENAMES = 8                 # for each program
STAND_ALONE = 40            # renames that rs274 is asked about as well
AT_ONCE = 200               # programs for one start of owlint
TRIES = 3
PLACE = re.compile(r"[oO][ \t]*(?:<[^>\n]*>|\d+)|#[ \t]*(?:<[^>\n]*>|\d+)")
FRESH = {"o": ("zeta", "o901", "o<omega>"), "<": ("#<zeta>", "<zeta>"), "_": ("#<_zeta>", "#<_Omega>"), "#": ("#9", "#29", "#77", "#4000")}
OTHERS = ("#<_feed>", "#<_x>", "#<n_args>", "#5420", "#0", "#6000", "o<a/b>", "#<>", "o1.5")
# About how a name is written, or about other things of the same name.
OF_SPELLING = ("OW215", "OW311", "OW312", "OW405", "OW406")
# owlint goes by the name alone where a parameter is printed somewhere, or set like a switch, in whatever sub.
OF_NAMES = ("OW606", "OW608", "OW610")

OF_SHARED_LABELS = ("OW102", "OW103", "OW104", "OW105", "OW106", "OW107", "OW108", "OW205", "OW206", "OW214", "OW510")


class Server:
    """`owlint lsp`, which is asked one thing at a time."""

    def __init__(self, owlint):
        self.process = subprocess.Popen([owlint, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.asked = 0
        operations = {"workspaceEdit": {"documentChanges": True, "resourceOperations": ["rename"]}}
        self.ask("initialize", {"capabilities": {"workspace": operations, "general": {"positionEncodings": ["utf-8"]}}, "workspaceFolders": []})
        self.tell("initialized", {})

    def tell(self, method, params):
        self._send({"jsonrpc": "2.0", "method": method, "params": params})

    def ask(self, method, params):
        """-> (result, None) or (None, the error)"""
        self.asked += 1
        self._send({"jsonrpc": "2.0", "id": self.asked, "method": method, "params": params})
        while True:
            length = 0
            for line in iter(self.process.stdout.readline, b"\r\n"):
                if not line:
                    raise RuntimeError("the server has ended")
                if line.lower().startswith(b"content-length:"):
                    length = int(line.split(b":")[1])
            answer = json.loads(self.process.stdout.read(length))
            if answer.get("id") == self.asked and "method" not in answer:
                return answer.get("result"), answer.get("error")

    def _send(self, message):
        body = json.dumps(message).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self.process.stdin.flush()

    def close(self):
        self.ask("shutdown", None)
        self.tell("exit", None)
        self.process.wait(20)


def applied(text, edits):
    lines = text.split("\n")
    for edit in sorted(edits, key=lambda e: (e["range"]["start"]["line"], e["range"]["start"]["character"]), reverse=True):
        start, end = edit["range"]["start"], edit["range"]["end"]
        row = lines[start["line"]].encode("latin-1")
        assert start["line"] == end["line"]
        lines[start["line"]] = (row[:start["character"]] + edit["newText"].encode() + row[end["character"]:]).decode("latin-1")
    return "\n".join(lines)


def renamed(files, edit, folder):
    """{name: text} after a workspace edit"""
    after = dict(files)
    for change in edit["documentChanges"]:
        if change.get("kind") == "rename":
            old, new = (os.path.relpath(change[key][len("file://"):], folder) for key in ("oldUri", "newUri"))
            assert new not in after, new
            after = {new if name == old else name: text for name, text in after.items()}
        else:
            name = os.path.relpath(change["textDocument"]["uri"][len("file://"):], folder)
            after[name] = applied(after[name], change["edits"])
    return after


def joined(files):
    """A bundle of {name: text}"""
    rest = "".join("; file: %s\n%s" % (name, text) for name, text in files.items() if name != bundle.MAIN)
    return files[bundle.MAIN] + ("\n" if rest else "") + rest


def program_of(seed, rng):
    kind = rng.random()
    text = generate_values(seed) if kind < 0.55 else generate(seed) if kind < 0.75 else generate_files(seed)
    text = text.replace("(run before)", "")
    if "\r" in text or any(ord(c) > 126 for c in text):
        return None
    files = {name: part for name, (_, part) in bundle.split(text).items()}
    if rng.random() < 0.5:  # a line that prints, somewhere
        names = re.findall(r"#(?:<[a-z_]+>|\d+)", files[bundle.MAIN]) or ["#5"]
        rows = files[bundle.MAIN].split("\n")
        rows.insert(rng.randrange(len(rows)), "(%s, %s is %s)" % (rng.choice(("debug", "PRINT", "log")), rng.choice(names), rng.choice(names)))
        files[bundle.MAIN] = "\n".join(rows)
    return files


def kind_of(place):
    name = re.sub(r"[\s]", "", place).lower()
    return "o" if name[0] == "o" else name[1:3] == "<_" and "_" or (name[1] == "<" and "<") or "#"


def told_apart(place, before, after, findings):
    """Whether the label at `place` stays on lines of another block, or of another sub, that a run may take for the same."""
    name = re.sub(r"[<>\s]", "", place[1:]).lower()
    name = re.escape(name if "<" in place else name.lstrip("0") or "0")
    label = re.compile(r"/?(?:n\d+)?o(?:<%s>|0*%s(?!\d))(.*)" % (name, name))
    kept, changed = {}, {}
    for number, rows in enumerate(zip(before.split("\n"), after.split("\n")), 1):
        match = label.match(re.sub(r"\s", "", rows[0]).lower())
        if match and rows[0] != rows[1]:
            changed[number] = match.group(1)
        elif match:
            kept[number] = match.group(1)
    is_sub = any(keyword.startswith(("sub", "endsub", "call", "return")) or not keyword for keyword in changed.values())
    if is_sub:
        return any(keyword.startswith("sub") for keyword in kept.values())
    return bool(kept) and any(f["code"] in OF_SHARED_LABELS and f["start"]["line"] in {**kept, **changed} for f in findings)


def make_renames(server, folder, number, rng, counts):
    """Renames of one random program: -> [(title, the old name, before, after)], texts as bundles"""
    files = program_of("rename/%s" % number, rng)
    if files is None:
        return []
    home = os.path.join(folder, "p%05d" % number)
    bundle.write(home, {name: (0, text) for name, text in files.items()})
    os.makedirs(os.path.join(home, "subs"), exist_ok=True)
    with open(os.path.join(home, "machine.ini"), "w", encoding="ascii") as f:
        f.write("[RS274NGC]\nSUBROUTINE_PATH = subs\n")
    name = rng.choice(list(files))
    uri = "file://" + os.path.join(home, name)
    text = files[name]
    server.tell("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": "gcode", "version": 1, "text": text}})
    places = list(PLACE.finditer(text))
    everywhere = [m.group() for part in files.values() for m in PLACE.finditer(part)]
    found = []
    for _ in range(RENAMES if places else 0):
        at = rng.choice(places)
        line = text.count("\n", 0, at.start())
        position = {"line": line, "character": at.start() - (text.rfind("\n", 0, at.start()) + 1) + 1}
        params = {"textDocument": {"uri": uri}, "position": position}
        new = rng.choice(rng.choice((FRESH[kind_of(at.group())],) * 3 + (everywhere, OTHERS)))
        edit, error = server.ask("textDocument/rename", {**params, "newName": re.sub(r"\s", "", new)})
        if error:
            counts["refused"] += 1
            assert error["code"] in (-32602, -32803) and error["message"], error
            continue
        if not edit["documentChanges"]:
            continue
        counts["accepted"] += 1
        title = "%s to %s on line %d of %s" % (at.group(), new, line + 1, name)
        found.append((title, at.group(), joined(files), joined(renamed(files, edit, home))))
    server.tell("textDocument/didClose", {"textDocument": {"uri": uri}})
    return found


def essence(findings):
    # Of names that no run reads, only those that are long enough to be misspelt are reported.
    return sorted((f["code"], f["start"]["line"], f["severity"], f["reach"], f["stops"]) for f in findings
                  if f["code"] not in OF_SPELLING + OF_NAMES and (f["code"], f["reach"]) != ("OW603", "never"))


def same_run(interpreter, before, after, choices):
    """Whether both texts run alike.  A long run may be cut off on a busy machine: only what differs each time does."""
    return any(ending(interpreter, before, choices) == ending(interpreter, after, choices) for _ in range(TRIES))


def ending(interpreter, text, choices):
    run = interpreter.run(text, choices)
    if run.outcome == "hang":  # how much of an endless run there is depends on the time
        return run.outcome, 0, (), ()
    return run.outcome, run.line, tuple(sorted(run.codes)), run.calls


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--programs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if Interpreter is None:
        print("skipped: LinuxCNC's Python module is not here")
        return SKIPPED
    owlint = os.path.abspath(options.owlint)
    rng = random.Random(options.seed)
    counts = Counter()
    renames = []
    with tempfile.TemporaryDirectory(prefix="owlint-rename-", dir=scratch()) as folder:
        server = Server(owlint)
        for number in range(options.programs):
            renames += make_renames(server, folder, options.seed * 1_000_000 + number, rng, counts)
        server.close()
        linter = Linter(owlint, machine=os.path.join(folder, "machine.ini"))
        same = []
        for first in range(0, len(renames), AT_ONCE):
            batch = renames[first:first + AT_ONCE]
            texts = {"%s%05d.ngc" % (side, i): texts[side == "b"] for i, (_, _, *texts) in enumerate(batch) for side in "ab"}
            findings = linter.check(os.path.join(folder, "checked"), texts)
            for i, (title, place, before, after) in enumerate(batch):
                a, b = (findings["%s%05d.ngc" % (side, i)] for side in "ab")
                if place[0] in "oO" and told_apart(place, before, after, a):
                    counts["told apart"] += 1
                    continue
                same.append((title, before, after))
                a, b = essence(a), essence(b)
                if a != b:
                    counts["differ"] += 1
                    print("%s: owlint finds %s before, %s after\n%s\n" % (title, [f for f in a if f not in b], [f for f in b if f not in a], before))
        interpreter = Interpreter(False, scratch(), record=True)
        for title, before, after in same:
            for choices in (b"", bytes([1]) * 40, bytes(rng.randrange(2) for _ in range(20))):
                counts["runs"] += 1
                if not same_run(interpreter, before, after, choices):
                    counts["differ"] += 1
                    ends = [ending(interpreter, text, choices)[:3] for text in (before, after)]
                    print("%s: %s before, %s after\n%s\n" % (title, *ends, before))
                    break
        interpreter.close()
        alone = [(title, *texts) for title, *texts in same if not any(map(bundle.is_bundle, texts))]
        for title, *texts in alone[:STAND_ALONE if rs274.available else 0]:
            ends = []
            for text in texts:
                path = os.path.join(folder, "alone.ngc")
                with open(path, "w", encoding="latin-1", newline="") as f:
                    f.write(text)
                ends.append(rs274.canonical(path))
            counts["through rs274"] += 1
            if ends[0] != ends[1] and min(ends)[0] >= 0:  # how much of an endless run there is depends on the time
                counts["differ"] += 1
                print("%s: rs274 puts out something else\n%s\n" % (title, texts[0]))
    print("%d programs: %s" % (options.programs, ", ".join("%d %s" % (count, what) for what, count in sorted(counts.items()))))
    return 1 if counts["differ"] or not counts["accepted"] else 0


if __name__ == "__main__":
    sys.exit(main())
