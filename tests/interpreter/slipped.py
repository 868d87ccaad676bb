#!/usr/bin/python3
"""What owlint says of programs with a slip of the pen, after its safe fixes, is what rs274 does with them.

usage: slipped.py --owlint build/release/owlint [--programs 1000] [--seed S] [--jobs 2] [--show 40] [--keep DIR]

The programs are the fixtures, the corpus and LinuxCNC's own, each with one slip (slips.py).  `owlint check --fix` makes its
safe fixes, and rs274 runs what comes out, a process for each.  Held against what owlint says then:

  silent      the interpreter stops, owlint claims no stop at all
  other place the interpreter stops, owlint claims stops elsewhere only
  other words the stop is claimed there, with a message that the interpreter does not print
  not always  a stop that is claimed for every run is not the one that ends this run
  crash       the interpreter crashes, owlint does not say so

Counted, and no disagreements, are
  ordinary    a stop at a line of words that no fix touched, with a message about words: owlint does not read them yet.  A
              line of words has neither an O-word (with or without its label) nor M98 or M99, and begins no assignment
  unknowable  a stop for what the machine holds and the program does not set: a pin, an INI's entry, a numbered parameter
  endless     the interpreter never ends, owlint claims neither that nor a stop in every run
Disagreements are shrunk and printed.

Exit status: 0 none; 1 disagreements; 2 trouble; 77 rs274 is not here.
"""
import argparse
import glob
import hashlib
import json
import multiprocessing
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, replace

import bundle
import rs274
from claims import Claims, said_by, settings
from confirm import Program, corpus, fixtures, read
from messages import EOF, UNKNOWN, codes_of, same_words
from slips import slip

NCFILES = "/usr/share/linuxcnc/ncfiles"
LARGEST = 20_000            # bytes of a program that is tried
SKIPPED = 77
AT_ONCE = 25                # programs for one start of owlint
SHOWN_PER_KEY = 2
SILENT, ELSEWHERE, WORDS, NOT_ALWAYS, CRASH = "silent", "other place", "other words", "not always", "crash"
ORDINARY, UNKNOWABLE, ENDLESS = "ordinary", "unknowable", "endless"
COUNTED = (ORDINARY, UNKNOWABLE, ENDLESS)

_OF_WORDS = re.compile(r"Bad character|bad number format|Unknown word|No characters found|Non integer value|G-code out of range|Multiple \S+ words|Unknown m code|words? with no|Cannot use axis values|Two . codes used")
_AMONG_WORDS = re.compile(r"Multiple \S+ words|Cannot use axis values|P word with no|Unknown g code used|Two g codes|Cannot (do|make) ")
_COMMENT = re.compile(r"\([^)]*\)?|;.*")
# O-words, also where the letter or the label is lost; assignments; calls and returns of the other style.
_NO_WORDS = re.compile(r"^/?(n[\d.]+)?(#|o|(0|n)?(\d+|<[^>]*>|\[.*?\])?(sub|endsub|call|do\b|while|endwhile|repeat|endrepeat|if|elseif|else|endif|break|continue|return)(?![a-z]))"
                       r"|m0*(98|99)(?!\d)", re.IGNORECASE)


@dataclass(frozen=True)
class Disagreement:
    kind: str
    what: str           # what the interpreter says, or which claim is wrong

    @property
    def key(self):
        """What must stay the same while a program is shrunk."""
        return self.kind, re.sub(r"'[^']*'|\d+|<[^>]*>|#\S+|file:\S+", "…", self.what)


@dataclass
class Checked:
    """A program after its safe fixes."""
    texts: dict         # name -> text
    findings: list      # each with the `path` of its file
    fixed: bool


def programs_to_slip():
    """Fixtures, the corpus, LinuxCNC's own programs, these with the files of their folder that they call."""
    # What is suppressed is there all the same.
    programs = [replace(p, text=p.text.replace("owlint: ignore", "owlint ignored")) for p in [*fixtures(), *corpus()]]
    for path in sorted(glob.glob(os.path.join(NCFILES, "**", "*.ngc"), recursive=True)):
        programs.append(Program(os.path.relpath(path, NCFILES), with_called(path)))
    # A file with a sub of its own name is checked as one that others call; rs274 would run it as a program.
    own_sub = re.compile(r"(?im)^\s*o<%s>\s*sub\b" % bundle.MAIN.removesuffix(".ngc"))
    return [p for p in programs if len(p.text) <= LARGEST and not own_sub.search(p.text)]


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


def slipped(program, rng):
    """-> (what was done, the program with a slip in one of its files)"""
    parts = re.split(r"(?m)^(; file: .*\n)", program.text) if bundle.is_bundle(program.text) else [program.text]
    # An INI or a tool table is no program.
    at = rng.choice([0] + [at for at in range(2, len(parts), 2) if parts[at - 1].strip().endswith(".ngc")])
    what, parts[at] = slip(parts[at], rng)
    if at + 1 < len(parts) and not parts[at].endswith("\n"):
        parts[at] += "\n"
    return what, replace(program, text="".join(parts))


class Examiner:
    """Fixes programs, runs them, and holds the two against each other."""

    def __init__(self, owlint, folder):
        self.owlint = owlint
        self.folder = tempfile.mkdtemp(dir=folder)
        self.counts = Counter()

    def fix(self, programs):
        """-> [Checked]: after all safe fixes, what is said of the program; those with equal options in one run"""
        groups, checked = {}, [None] * len(programs)
        for number, program in enumerate(programs):
            bundle.write(self._own(number), files_of(program))
            options = re.sub(r"--linuxcnc \S+|--(extend-)?select \S+", "", program.options).split()
            groups.setdefault((tuple(options), "--ini" in options and number), []).append(number)
        for (options, alone), numbers in groups.items():
            remaps = alone is not False and "REMAP" in programs[alone].text
            found = self._run(options, numbers, self._own(alone) if alone is not False else self.folder, remaps)
            for number in numbers:
                texts = {name: read(os.path.join(self._own(number), name)) for name in files_of(programs[number])}
                before = {name: text for name, (_, text) in files_of(programs[number]).items()}
                checked[number] = Checked(texts, found[number], texts != before)
        return checked

    def _run(self, options, numbers, folder, remaps):
        """-> {number: findings}"""
        relative = lambda path: os.path.relpath(path, folder)
        mains = {relative(os.path.join(self._own(number), bundle.MAIN)): number for number in numbers}
        every = [relative(path) for number in numbers for path in glob.glob(os.path.join(self._own(number), "**", "*.ngc"), recursive=True)]
        fixed = self._owlint(["--fix", *options, *sorted(every)], folder)
        found = {number: [] for number in numbers}
        # Of a called file, what the calls of the program lead to; a remap's file is checked for itself.
        for file in (self._owlint([*options, *mains], folder) if len(every) > len(mains) and not remaps else fixed)["files"]:
            number = next((n for main, n in mains.items() if file["path"].startswith(main[:-len(bundle.MAIN)])), None)
            for finding in file["findings"] if number is not None else ():
                found[number].append({**finding, "path": os.path.relpath(os.path.join(folder, file["path"]), self._own(number))})
        return found

    def _owlint(self, arguments, folder):
        command = [self.owlint, "check", "--isolated", "--no-find-ini", "--format", "json", *arguments]
        done = subprocess.run(command, capture_output=True, cwd=folder, timeout=600)
        if done.returncode not in (0, 1) and not (done.returncode == 2 and done.stdout):
            raise RuntimeError("exit status %d of %s\n%s" % (done.returncode, " ".join(command), done.stderr.decode("utf-8", "replace")[-2000:]))
        return json.loads(done.stdout)

    def _own(self, number):
        return os.path.join(self.folder, "%04d" % number)

    def examine(self, programs):
        """-> [(Disagreement, one of COUNTED, or None; outcome; Checked)]"""
        results = []
        for number, (program, one) in enumerate(zip(programs, self.fix(programs))):
            self.counts["fixed"] += one.fixed
            results.append(self.worst(self.judge_run(number, program, one, on) for on in settings("\n".join(one.texts.values()))))
            shutil.rmtree(self._own(number))
        return results

    def judge_run(self, number, program, checked, block_delete):
        outcome = rs274.run(os.path.join(self._own(number), bundle.MAIN), program.mode, block_delete)
        self.counts["run: " + outcome.kind] += 1
        return judge(outcome, checked, program, block_delete), outcome, checked

    @staticmethod
    def worst(results):
        """With block delete off and on: a disagreement if there is one."""
        return max(results, key=lambda result: (isinstance(result[0], Disagreement), result[0] is not None))


def files_of(program):
    return bundle.split(program.text) if bundle.is_bundle(program.text) else {bundle.MAIN: (0, program.text)}


def judge(outcome, checked, program, block_delete):
    """-> Disagreement, one of COUNTED, or None where owlint says what happens."""
    claims = Claims(checked.findings, block_delete)
    # A remap's file is checked for itself: what is said of it holds when its code is used.
    claims.always = [f for f in claims.always if f["path"] == bundle.MAIN or "REMAP" not in program.text]
    if outcome.kind == "hang":
        if claims.always:
            return Disagreement(NOT_ALWAYS, "%s: it never ends" % claims.always[0]["code"])
        return None if claims.endless else ENDLESS
    if outcome.kind == "crash":
        return None if claims.crashes else Disagreement(CRASH, outcome.message)
    if outcome.kind == "ok":
        return Disagreement(NOT_ALWAYS, "%s: it runs" % claims.always[0]["code"]) if claims.always else None
    there = [(f, claim) for f in claims.stops for claim in said_by(f) if is_there(f, claim, outcome, checked.texts, program.mode)]
    met = [f for f, claim in there if same_words(outcome.message, claim.get("interpreter", ""))]
    if met:
        wrong = [f for f in claims.always if f not in met]
        return Disagreement(NOT_ALWAYS, "%s: it stops before" % wrong[0]["code"]) if wrong else None
    if is_ordinary(outcome, checked, program):
        return ORDINARY
    if is_unknowable(outcome, checked):
        return UNKNOWABLE
    if there:
        return Disagreement(WORDS, "%s: `%s` is `%s`" % (there[0][1]["code"], there[0][1].get("interpreter", ""), outcome.message))
    return Disagreement(ELSEWHERE if claims.stops else SILENT, outcome.message)


def is_there(finding, claim, outcome, texts, mode):
    """Whether a claim is about the line at which it stopped.  Where the message names its file, it may be at the cause."""
    line = claim["start"]["line"]
    if rs274.AT_FILE_END.search(outcome.message) or outcome.message.startswith("File:") or "levels" in outcome.message:
        return same_words(outcome.message, claim.get("interpreter", ""))
    # Under OWORD_WARNONLY the number may be that of a warning.
    numbered = re.match(r"\d+: ", outcome.message) and mode != "warnonly"
    lines = texts.get(finding["path"], "").split("\n")
    said = lines[line - 1].strip().split("\0")[0] if line <= len(lines) else ""
    if re.match(r"O[\d.]+ CALL$", outcome.text):      # what G71 makes of its Q
        return same_words(outcome.message, claim.get("interpreter", ""))
    fits = said.startswith(outcome.text) if outcome.message == "Command too long" else said == outcome.text
    return fits and (not numbered or line == outcome.line)


def is_ordinary(outcome, checked, program):
    """Whether it is a stop at a line of words that no fix touched, of a sort that owlint does not read yet."""
    code = re.sub(r"\s", "", _COMMENT.sub("", outcome.text))
    # What is wrong with a contour is found at the end of its sub.
    if outcome.message.startswith(("G7X error", "Radius to end of arc")) and (outcome.message.startswith("G") or re.search(r"(?i)endsub", code)):
        return True
    # A contour on the line that ends the program.
    if re.match(r"O[\d.]+ CALL$", outcome.text) and re.search(r"(?i)g7[0-2][^\n(;]*m0*(2|30)\b", "\n".join(checked.texts.values())):
        return True
    if code[:1].lower() in ("u", "v", "w") and outcome.message.startswith("Unknown word where unary"):     # axes, within a contour
        return True
    # What words are against each other is their matter on any line; but M98 has a P and an L of its own.
    among_words = _AMONG_WORDS.match(outcome.message) and not (outcome.message.startswith("Multiple") and re.search(r"(?i)m0*98(?!\d)", code))
    if outcome.message.startswith("Non integer value"):     # of a code beside M99
        code = re.sub(r"(?i)m0*99(?!\d)", "", code)
    # `M5 M5 M99`: what is wrong is not the M99.
    if outcome.message.startswith("Two m codes") and len(re.findall(r"m0*(?:98|99|2|30)(?!\d)", code, re.IGNORECASE)) == 1:
        code = re.sub(r"m0*(98|99|2|30)(?!\d)", "", code, flags=re.IGNORECASE)
    if (not among_words and _NO_WORDS.search(code)) or not (_OF_WORDS.search(outcome.message) or codes_of(outcome.message) == {UNKNOWN}):
        return False
    alike = lambda texts: sum(line.strip() == outcome.text for text in texts for line in text.split("\n"))
    return alike(checked.texts.values()) <= alike(text for _, text in files_of(program).values())


def is_unknowable(outcome, checked):
    """Whether it stops for what was in the machine before the program."""
    everything = "".join(checked.texts.values())
    # The value of a parameter whose number is computed.
    if re.search(r"#\s*[#\[]", outcome.text) or (codes_of(outcome.message) & {"OW208"} and re.search(r"(?i)[oq]\s*#\s*[#\[]", everything)):
        return True
    # A part of a program that ngcgui makes.
    in_remap = "REMAP" in everything and outcome.message.startswith(("EOF in file", "Fanuc 'O"))      # files that a remap names are checked for themselves
    if in_remap or re.match(r"Named parameter #<_(hal|ini)\[", outcome.message) or "(not_a_subfile)" in everything or "[PYTHON]" in everything:
        return True
    # The value of a name that is not there, when a definition is skipped, is whatever is in memory.
    if outcome.message.startswith("Calculation resulted in") and re.search(r"(?i)#<_value>", outcome.text):
        return True
    codes = codes_of(outcome.message)
    # Of the end of the file it is not said which label was sought.
    where = outcome.text if codes & {"OW512", "OW604", "OW217"} or re.match(r"(?i)/?(n\d+\s*)?o[#\[]", outcome.text) else "".join(re.findall(r"(?i)[oq]\s*[#[].*", everything)) if codes & {EOF, "OW208"} or not outcome.line else ""
    where += "".join(line for name in re.findall(r"#<\w+>", where) for line in re.findall(r"(?m)^\s*%s\s*=.*" % re.escape(name), everything))
    # Outside of subs no number is an argument.
    outside = re.sub(r"(?ims)^\s*o[^\n]*?sub\b.*?endsub", "", _COMMENT.sub("", everything))
    of_machine = "".join(re.findall(r"(?i)[oq]\s*[#[].*", outside)) if codes & {EOF, "OW208"} else ""
    of_machine += "".join(line for name in re.findall(r"#<\w+>", where) for line in re.findall(r"(?m)^\s*%s\s*=.*" % re.escape(name), outside))
    before = re.split(r"(?i)[oq]\s*[#\[]", re.sub(r"(?is)(?<!end)sub\b.*?endsub", "", _COMMENT.sub("", checked.texts[bundle.MAIN])))[0]
    own = 30 if re.search(r"(?i)o(<[^<>\n]*>|[\d.]+|\[.*?\])\s*sub\b", checked.texts[bundle.MAIN]) else 0     # the last number that is an argument
    return any(not re.search(r"(?<!#)#\s*%s\s*=" % number, before) for number in [n for n in re.findall(r"#(\d+)", where) if int(n) > own] + re.findall(r"#(\d+)", of_machine))


# -- shrinking and printing

class Shrinker:
    def __init__(self, examiner):
        self.examiner = examiner

    def first(self, programs, key):
        """The first of these programs that shows it: -> (program, its result) or None."""
        for at in range(0, len(programs), AT_ONCE):
            some = programs[at:at + AT_ONCE]
            for program, result in zip(some, self.examiner.examine(some)):
                if isinstance(result[0], Disagreement) and result[0].key == key:
                    return program, result
        return None

    def shrink(self, program, key):
        """The program without the lines that the disagreement does not need."""
        best = self.first([program], key)
        newline = "\r\n" if "\r\n" in program.text else "\n"
        size = max(1, program.text.count(newline) // 2)
        while best and size:
            lines = best[0].text.split(newline)
            shorter = [lines[:at] + lines[at + size:] for at in range(0, len(lines), size) if len(lines) > size]
            # What makes a bundle of it stays.
            shorter = [some for some in shorter if [x for x in some if x.startswith("; file:")] == [x for x in lines if x.startswith("; file:")]]
            found = self.first([replace(program, text=newline.join(some)) for some in shorter], key)
            best = found or best
            size = size if found else size // 2
        return best


def show(name, what, disagreement, before, after, outcome, findings):
    out = ["", "== %s, %s: %s: %s" % (name, what, disagreement.kind, ascii(disagreement.what)[1:-1])]
    for title, texts in (("before", before), ("after", after)) if before != after else (("", after),):
        for file, text in texts.items():
            out.append("   %s" % " ".join(filter(None, (title, file if len(texts) > 1 else ""))))
            out += ["%4d  %s" % (number, ascii(line)[1:-1]) for number, line in enumerate(text.split("\n"), 1)]
    out.append("   rs274: %s, line %d, %s, at `%s`" % (outcome.kind, outcome.line, ascii(outcome.message)[1:-1], ascii(outcome.text)[1:-1]))
    for f in findings:
        if f["severity"] != "info" or f["stops"]:
            out.append("   owlint: %s line %d %s %s %s%s: %s [%s]" % (f["path"], f["start"]["line"], f["code"], f["severity"], f["reach"], " stops" if f["stops"] else "",
                                                                     ascii(f["message"])[1:-1], f.get("interpreter", "")))
    print("\n".join(out if findings else out + ["   owlint: nothing"]), flush=True)


def report(options, folder, found):
    """Shrink and print a few of each sort."""
    shrinker = Shrinker(Examiner(options.owlint, folder))
    shown = Counter()
    for name, what, program, disagreement in sorted(found, key=lambda one: (one[3].key, len(one[2].text))):
        if options.keep:
            os.makedirs(options.keep, exist_ok=True)
            with open(os.path.join(options.keep, re.sub(r"\W+", "-", "%s %s %s" % (disagreement.kind, name, what)) + ".ngc"), "w", encoding="latin-1", newline="") as f:
                f.write(program.text)
        shown[disagreement.key] += 1
        if shown[disagreement.key] > SHOWN_PER_KEY or len(shown) > options.show:
            continue
        shrunk = shrinker.shrink(program, disagreement.key)
        if not shrunk:
            print("\n== %s, %s: %s: not seen again" % (name, what, disagreement.kind))
            continue
        small, (_, outcome, checked) = shrunk
        show(name, what, disagreement, {file: text for file, (_, text) in files_of(small).items()}, checked.texts, outcome, checked.findings)
    print("\nby sort:")
    for (kind, what), count in sorted(shown.items(), key=lambda one: -one[1]):
        print("%6d  %s: %s" % (count, kind, ascii(what)[1:-1]))


_examiner = None


def _start_worker(owlint, folder):
    global _examiner
    _examiner = Examiner(owlint, folder)


def _examine(tasks):
    """In a worker: [(name, what, program)] -> (disagreements, counts)"""
    _examiner.counts.clear()
    found = []
    for (name, what, program), (result, _, _) in zip(tasks, _examiner.examine([program for _, _, program in tasks])):
        if result in COUNTED:
            _examiner.counts[result] += 1
        elif result:
            found.append((name, what, program, result))
    return found, Counter(_examiner.counts)


def tasks_of(options):
    sources = programs_to_slip()
    for number in range(options.programs):
        task = "slip/%d/%d" % (options.seed, number)
        rng = random.Random(task)
        # A new fixture takes a few of the tasks, and leaves the others as they are.
        source = min(sources, key=lambda program: hashlib.blake2b((task + program.name).encode()).digest())
        what, program = slipped(source, rng)
        yield program.name, what, program


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--owlint", required=True, help="the program to test", type=os.path.abspath)
    parser.add_argument("--programs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--show", type=int, default=40, help="sorts of disagreements to shrink and print")
    parser.add_argument("--keep", metavar="DIR", help="save the programs that disagree, with their slip")
    options = parser.parse_args(argv)
    if not rs274.available:
        print("skipped: rs274 is not here")
        return SKIPPED
    if options.seed is None:
        options.seed = int(time.time())
    folder = tempfile.mkdtemp(prefix="owlint-slipped-", dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None)
    started = time.monotonic()
    try:
        tasks = list(tasks_of(options))
        counts, found = Counter(), []
        with multiprocessing.Pool(options.jobs, _start_worker, (options.owlint, folder)) as pool:
            for some, more in pool.imap_unordered(_examine, [tasks[at:at + AT_ONCE] for at in range(0, len(tasks), AT_ONCE)]):
                found += some
                counts.update(more)
        seconds = time.monotonic() - started
        report(options, folder, found)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    print("seed %d: %d programs with a slip, %d fixed safely (%s), not counted: %s, %d disagreements, %.0f s" % (
        options.seed, len(tasks), counts["fixed"], ", ".join("%s %d" % (key[5:], counts[key]) for key in sorted(counts) if key.startswith("run: ")),
        ", ".join("%s %d" % (kind, counts[kind]) for kind in COUNTED), len(found), seconds))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
