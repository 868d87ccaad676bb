"""Lints and runs programs for slipped.py and words.py, and takes them past stops that the machine decides."""
import glob
import json
import multiprocessing
import os
import re
import shutil
import subprocess
import tempfile
from collections import Counter
from dataclasses import dataclass, field, replace

import bundle
import rs274
from claims import settings
from confirm import Program, read
from linter import MACHINE as MACHINE_INI, by_path
from of_machine import MACHINE, general
from stops import COUNTED, ENDLESS, Checked, Disagreement, judge

AT_ONCE = 25                # programs for one start of owlint
SHOWN_PER_KEY = 2
OWLINT_LIMIT_S = 120
TAKEN_OUT = ";"             # what stands in place of a line that stops for what the machine decides


@dataclass
class Result:
    """The verdict on one program: where it was wrong, or where its run ended."""
    verdict: object
    outcome: rs274.Outcome
    checked: Checked
    program: Program


@dataclass
class Task:
    name: str
    what: str               # what was done to the program
    program: Program


@dataclass
class Examiner:
    """`fixing`: the safe fixes are made first.  `machine`: owlint is given an INI with the axes of rs274.

    So many lines that stop are taken out of a program, one after another, as there are `rounds`: those that the
    machine decides; with `past_found` also those that stop as owlint says.
    """
    owlint: str
    folder: str
    fixing: bool = False
    rounds: int = 1
    past_found: bool = False
    machine: bool = False
    counts: Counter = field(default_factory=Counter)
    failure: str = ""

    def __post_init__(self):
        self.folder = tempfile.mkdtemp(dir=self.folder)
        self.options = ["--no-find-ini"]
        if self.machine:
            ini = os.path.join(self.folder, "machine.ini")
            with open(ini, "w", encoding="ascii") as f:
                f.write(MACHINE_INI)
            self.options = ["--ini", ini]

    def examine(self, programs):
        """-> [Result]: the first disagreement of each program, or how it ended when all is as owlint says"""
        results, todo = [None] * len(programs), dict(enumerate(programs))
        for _ in range(self.rounds):
            numbers = list(todo)
            for number, result in zip(numbers, self.once([todo[number] for number in numbers])):
                results[number] = result
                as_said = result.verdict is None and result.outcome.kind == "error"
                past = result.verdict == MACHINE or self.past_found and as_said
                further = without_stop(result) if past else None
                if further:
                    todo[number] = further
                else:
                    del todo[number]
            if not todo:
                break
        return results

    def once(self, programs):
        """One Result after another; what has not been asked for is not run."""
        for number, (program, one) in enumerate(zip(programs, self.check(programs))):
            self.counts["fixed"] += one.fixed
            block_delete = settings("\n".join(one.texts.values()))
            yield max((self._judge_run(number, program, one, on) for on in block_delete), key=_weight)
            shutil.rmtree(self._own(number))

    def _judge_run(self, number, program, checked, block_delete):
        outcome = rs274.run(os.path.join(self._own(number), bundle.MAIN), program.mode, block_delete)
        self.counts["run: " + outcome.kind] += 1
        verdict = judge(outcome, checked, program, block_delete, self.machine)
        if outcome.kind == "error":
            message = general(outcome.message)
            self.counts["found" if verdict is None else verdict if isinstance(verdict, str) else "wrong", message] += 1
        return Result(verdict, outcome, checked, program)

    def check(self, programs):
        """-> [Checked]: what is said of each program, after the fixes; those with equal options in one run"""
        groups, checked = {}, [None] * len(programs)
        for number, program in enumerate(programs):
            shutil.rmtree(self._own(number), ignore_errors=True)
            bundle.write(self._own(number), files_of(program))
            options = re.sub(r"--linuxcnc \S+|--(extend-)?select \S+", "", program.options).split()
            groups.setdefault((tuple(options), "--ini" in options and number), []).append(number)
        for (options, alone), numbers in groups.items():
            remaps = alone is not False and "REMAP" in programs[alone].text
            folder = self._own(alone) if alone is not False else self.folder
            found, failures = self._findings(options, numbers, folder, remaps), {}
            if found is None:
                each = {number: self._findings(options, [number], folder, remaps) for number in numbers}
                found = {number: one[number] if one else [] for number, one in each.items()}
                failures = {number: self.failure for number, one in each.items() if one is None}
            for number in numbers:
                texts = {name: read(os.path.join(self._own(number), name)) for name in files_of(programs[number])}
                before = {name: text for name, (_, text) in files_of(programs[number]).items()}
                checked[number] = Checked(texts, found[number], texts != before, failures.get(number, ""))
        return checked

    def _findings(self, options, numbers, folder, remaps):
        """-> {number: findings}, or None where owlint fails"""
        relative = lambda path: os.path.relpath(path, folder)
        mains = {relative(os.path.join(self._own(number), bundle.MAIN)): number for number in numbers}
        below = lambda number: glob.glob(os.path.join(self._own(number), "**", "*.ngc"), recursive=True)
        every = sorted(relative(path) for number in numbers for path in below(number))
        report = self._owlint(["--fix", *options, *every], folder) if self.fixing else None
        if self.fixing and not report:
            return None
        # Of a called file, what the calls of the program lead to; a remap's file is checked for itself.
        if remaps and not report:
            report = self._owlint([*options, *every], folder)
        elif not report or len(every) > len(mains) and not remaps:
            report = self._owlint([*options, *mains], folder)
        if not report:
            return None
        found = {number: [] for number in numbers}
        for path, findings in by_path(report).items():
            number = next((n for main, n in mains.items() if path.startswith(main[:-len(bundle.MAIN)])), None)
            if number is not None:
                own = os.path.relpath(os.path.join(folder, path), self._own(number))
                found[number] += [{**finding, "path": own} for finding in findings]
        return found

    def _owlint(self, arguments, folder):
        """-> the report, or None; then `failure` says why"""
        command = [self.owlint, "check", "--isolated", *self.options, "--format", "json", *arguments]
        try:
            done = subprocess.run(command, capture_output=True, cwd=folder, timeout=OWLINT_LIMIT_S)
        except subprocess.TimeoutExpired:
            self.failure = "no report in %d s" % OWLINT_LIMIT_S
            return None
        if done.returncode in (0, 1) or done.returncode == 2 and done.stdout:
            return json.loads(done.stdout)
        said = [line for line in done.stderr.decode("utf-8", "replace").split("\n") if line.strip()]
        self.failure = " ".join(["exit status %d" % done.returncode, *said[-1:]])
        return None

    def _own(self, number):
        return os.path.join(self.folder, "%04d" % number)


def _weight(result):
    """With block delete off and on: a disagreement if there is one, else a stop that the machine decides."""
    verdict = result.verdict
    return isinstance(verdict, Disagreement), verdict == MACHINE, verdict is not None, result.outcome.kind


def files_of(program):
    return bundle.split(program.text) if bundle.is_bundle(program.text) else {bundle.MAIN: (0, program.text)}


def without_stop(result):
    """The program without the line at which it stopped, or None where it is not known which one that is."""
    if not result.outcome.text or result.checked.fixed:
        return None
    lines = result.program.text.split("\n")
    hits = [at for at, line in enumerate(lines) if line.strip().split("\0")[0].strip() == result.outcome.text]
    if len(hits) != 1:
        return None
    lines[hits[0]] = TAKEN_OUT + "\r" * lines[hits[0]].endswith("\r")
    return replace(result.program, text="\n".join(lines))


# -- shrinking and printing

class Shrinker:
    def __init__(self, examiner):
        self.examiner = examiner

    def first(self, programs, key):
        """The first of these programs that shows it: its Result or None."""
        for at in range(0, len(programs), AT_ONCE):
            for result in self.examiner.once(programs[at:at + AT_ONCE]):
                if isinstance(result.verdict, Disagreement) and result.verdict.key == key:
                    return result
        return None

    def shrink(self, program, key):
        """The result of the program without the lines, and then the words, that the disagreement does not need."""
        best = self.first([program], key)
        newline = "\r\n" if "\r\n" in program.text else "\n"
        best = best and self._shorter(best, key, newline, lambda part: part.startswith("; file:"))
        if best and not bundle.is_bundle(best.program.text):
            best = self._shorter(best, key, " ", lambda part: "\n" in part)
        return best

    def _shorter(self, best, key, separator, stays):
        size = max(1, best.program.text.count(separator) // 2)
        while size:
            parts = best.program.text.split(separator)
            shorter = [parts[:at] + parts[at + size:] for at in range(0, len(parts), size) if len(parts) > size]
            # What makes a bundle of it stays.
            shorter = [some for some in shorter if [x for x in some if stays(x)] == [x for x in parts if stays(x)]]
            found = self.first([replace(best.program, text=separator.join(some)) for some in shorter], key)
            best = found or best
            size = size if found else size // 2
        return best


def show(task, result):
    disagreement, outcome = result.verdict, result.outcome
    before = {file: text for file, (_, text) in files_of(result.program).items()}
    after = result.checked.texts
    out = ["", "== %s, %s: %s: %s" % (task.name, task.what, disagreement.kind, ascii(disagreement.what)[1:-1])]
    for title, texts in (("before", before), ("after", after)) if before != after else (("", after),):
        for file, text in texts.items():
            out.append("   %s" % " ".join(filter(None, (title, file if len(texts) > 1 else ""))))
            out += ["%4d  %s" % (number, ascii(line)[1:-1]) for number, line in enumerate(text.split("\n"), 1)]
    out.append("   rs274: %s, line %d, %s, at `%s`" % (
        outcome.kind, outcome.line, ascii(outcome.message)[1:-1], ascii(outcome.text)[1:-1]))
    said = [f for f in result.checked.findings if f["severity"] != "info" or f["stops"]]
    for f in said:
        out.append("   owlint: %s line %d %s %s %s%s: %s [%s]" % (
            f["path"], f["start"]["line"], f["code"], f["severity"], f["reach"], " stops" if f["stops"] else "",
            ascii(f["message"])[1:-1], f.get("interpreter", "")))
    print("\n".join(out if said else out + ["   owlint: nothing"]), flush=True)


def report(found, examiner, most, keep=None):
    """Shrink and print a few of each sort.  found: [(Task, Disagreement)]"""
    shrinker = Shrinker(examiner)
    shown = Counter()
    for task, disagreement in sorted(found, key=lambda one: (one[1].key, len(one[0].program.text))):
        if keep:
            os.makedirs(keep, exist_ok=True)
            name = re.sub(r"\W+", "-", "%s %s %s" % (disagreement.kind, task.name, task.what)) + ".ngc"
            with open(os.path.join(keep, name), "w", encoding="latin-1", newline="") as f:
                f.write(task.program.text)
        shown[disagreement.key] += 1
        if shown[disagreement.key] > SHOWN_PER_KEY or len(shown) > most:
            continue
        shrunk = shrinker.shrink(task.program, disagreement.key)
        if shrunk:
            show(task, shrunk)
        else:
            print("\n== %s, %s: %s: not seen again" % (task.name, task.what, disagreement.kind))
    print("\nby sort:")
    for (kind, what), count in sorted(shown.items(), key=lambda one: -one[1]):
        print("%6d  %s: %s" % (count, kind, ascii(what)[1:-1]))


# -- many programs

_examiner = None


def _start_worker(arguments):
    global _examiner
    _examiner = Examiner(*arguments)


def _examine(tasks):
    """In a worker: -> ([(Task, Disagreement)], counts)"""
    _examiner.counts.clear()
    found = []
    for task, result in zip(tasks, _examiner.examine([task.program for task in tasks])):
        if isinstance(result.verdict, Disagreement):
            found.append((replace(task, program=result.program), result.verdict))
        elif result.verdict:
            _examiner.counts[result.verdict] += 1
    return found, Counter(_examiner.counts)


def compare(tasks, jobs, arguments):
    """Examine all, in `jobs` processes with an Examiner of these arguments each: -> ([(Task, Disagreement)], counts)"""
    counts, found = Counter(), []
    with multiprocessing.Pool(jobs, _start_worker, (arguments,)) as pool:
        for some, more in pool.imap(_examine, [tasks[at:at + AT_ONCE] for at in range(0, len(tasks), AT_ONCE)]):
            found += some
            counts.update(more)
    return found, counts


def by_message(counts):
    """Print the messages of all stops: those that owlint has to predict, and those that the machine decides."""
    messages = sorted({key[1] for key in counts if isinstance(key, tuple)})
    rows = [(counts["found", m], counts["wrong", m], sum(counts[kind, m] for kind in COUNTED), m) for m in messages]
    print("\nstops  found  message")
    for found, wrong, unknowable, message in sorted(rows, key=lambda row: -sum(row[:3])):
        if found + wrong + unknowable:
            beside = ", unknowable: %d" % unknowable if unknowable else ""
            print("%5d  %5d  %s%s" % (found + wrong + unknowable, found, ascii(message)[1:-1], beside))
    some = sorted(((counts[MACHINE, m], m) for m in messages if counts[MACHINE, m]), reverse=True)
    print("the machine decides: %d" % sum(count for count, _ in some))
    for count, message in some:
        print("%5d         %s" % (count, ascii(message)[1:-1]))


def summary(counts):
    """-> the figures of all runs, in one line"""
    kinds = sorted(key for key in counts if isinstance(key, str) and key.startswith("run: "))
    runs = ", ".join("%s %d" % (kind[5:], counts[kind]) for kind in kinds)
    stops = lambda *kinds: sum(count for key, count in counts.items() if isinstance(key, tuple) and key[0] in kinds)
    due = stops("found", "wrong")
    form = "%s; stops to predict: %d, at their line with their message: %d (%s); not counted: the machine decides %d, unknowable %d, endless %d"
    return form % (
        runs, due, stops("found"), "%.2f %%" % (100.0 * stops("found") / due) if due else "none",
        stops(MACHINE), stops("unknowable"), counts[ENDLESS])
