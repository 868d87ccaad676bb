#!/usr/bin/python3
"""owlint's fixes take their findings away, come to an end, and, where they are called safe, change no run.

usage: fix.py --owlint build/release/owlint [--programs 0] [--seed S] [--jobs 2] [--through-program]

The programs: the corpus, the fixtures, and --programs random ones (generate.py, a third of them roughened.py).  Bundles
count as one program.  Checked is that

1. each fix made alone takes its finding away;
2. a safe fix made alone, and all safe ones made in rounds until nothing is left to make, change no run: one that came to
   its end tells the machine the same things; one that stopped tells the same up to its stop, and may then go on;
3. the rounds come to an end, and made again they change nothing: of the safe fixes, and of all.

Runs have all their conditions false, all true, or at random.  Four things are counted and no violation: another finding of
the same rule that the fixed one hid (LinuxCNC reports the first error only); other comments that only a reader sees; other output of a run that never ended; another end where nothing was fixed (one stop may stand
before another).  By default the edits of the JSON report are made here; with --through-program `owlint check --fix` makes
the rounds.  Violations are shrunk and printed.

Exit status: 0 none; 1 violations; 2 trouble; 77 LinuxCNC's Python module is not here.
"""
import argparse
import glob
import multiprocessing
import os
import random
import re
import shutil
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, replace

try:
    from oracle import Interpreter, scratch
except (ImportError, SystemExit):
    Interpreter = None

from generate import generate
from linter import Linter, LinterFailed
from fixer import JsonFixer, ProgramFixer, apply, first_fix
from messages import EOF, EOF_CODES, codes_of
from roughen import roughen

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
SKIPPED = 77
AT_ONCE = 60                # programs for one start of owlint
CPU_LIMIT_S = 0.25          # the longest program of the corpus takes 0.07 s with all its moves written down
READINGS = 40               # choices of a run; see plugin/namedparams.py
SHOWN_PER_KEY = 2
LINES_SHOWN = 60

STAYS, UNCOVERS, OVERLAP = "the finding stays", "as many findings of its code", "edits overlap"
STOPS, OUTPUT, BEFORE = "a run that ended stops", "another output", "another output before the stop"
ENDLESS, AGAIN = "no end of fixes", "fixes made again change something"
COMMENTS, NEVER_ENDED, OTHER_END = "other comments", "other output of an endless run", "another end where nothing was fixed"
COUNTED = (COMMENTS, NEVER_ENDED, OTHER_END, UNCOVERS)  # what one stop hid may be the same mistake again
SAFE, ALL = "all safe fixes", "all fixes"

# A comment does something to the machine if it begins so; the others are for readers.
_ACTIVE = re.compile(r"comment ['\"]\s*(PROBE|RPY|LOG|AXIS)", re.IGNORECASE)


@dataclass(frozen=True)
class Violation:
    kind: str
    what: str               # the code and the title of the fix, or SAFE, ALL
    codes: str = ""         # of the findings fixed together; of a single one also its reach
    after: str = ""         # the fixed program
    detail: tuple = ()

    @property
    def key(self):
        """What must stay the same while a program is shrunk."""
        return self.kind, self.what


def title_of(finding, fix):
    """A fix without the labels and numbers of its program."""
    title = re.sub(r"\d+", "N", re.sub(r"`o(\d|<)[^ `]* ?", "`o… ", fix["title"]))
    return "%s %s: %s" % (finding["code"], "safe" if fix["safe"] else "unsafe", title)


def for_machine(text):
    """The program as it can be run: gcode.parse hands on comments only if they are UTF-8."""
    try:
        text.encode("latin-1").decode("utf-8")
        return text
    except UnicodeDecodeError:
        return re.sub(r"[\x80-\xff]", "?", text)


def stops_of(findings):
    """The lines at which these findings say that a run stops; 0 for the end of the file."""
    stops = [stop for f in findings for stop in (f, *f.get("consequences", []))]
    at_end = any(stop["code"] in EOF_CODES or EOF in codes_of(stop.get("interpreter", "")) for stop in stops)
    return {stop["start"]["line"] for stop in stops} | ({0} if at_end else set())


def put_out(run):
    """What a run tells the machine, and not only readers."""
    return tuple(call for call in run.calls if not call.startswith("comment ") or _ACTIVE.match(call))


def compare(before, after, stops):
    """What the second run does that the first did not, if anything; `stops`: the lines of stops that were fixed."""
    ours, theirs = put_out(before), put_out(after)
    same = ours[:len(theirs)] == theirs[:len(ours)]
    if before.outcome == "ok":
        if after.outcome != "ok":
            return STOPS
        return OUTPUT if ours != theirs else COMMENTS if before.calls != after.calls else None
    if before.outcome == "hang":
        return NEVER_ENDED if not same or after.outcome != "hang" else None
    if not same or len(theirs) < len(ours):
        return BEFORE
    if before.line not in stops and (before.outcome, before.codes) != (after.outcome, after.codes):
        return OTHER_END
    return None


def moved(offset, edits):
    """Where a place is after these edits; None where it was taken out, as from a line that is moved."""
    if any(e["start"]["offset"] <= offset < e["end"]["offset"] and not e["text"] for e in edits):
        return None
    return offset + sum(len(e["text"].encode()) - e["end"]["offset"] + e["start"]["offset"]
                        for e in edits if e["end"]["offset"] <= offset)


def choices_of(name, runs):
    """The choices of a program's runs."""
    rng = random.Random(name)
    lists = [b"", b"\x01" * READINGS]
    for _ in range(runs):
        bias = rng.choice((0.15, 0.4, 0.6, 0.85))
        lists.append(bytes(rng.choice((1, 2)) if rng.random() < bias else 0 for _ in range(READINGS)))
    return lists


class Examiner:
    """Holds programs against what is said of fixes."""

    def __init__(self, options, folder):
        self.options = options
        self.folder = tempfile.mkdtemp(dir=folder)
        self.linter = Linter(options.owlint, arguments=["--no-find-ini", "--extend-select", "OW", "--jobs", "1"])
        fixer = ProgramFixer if options.through_program else JsonFixer
        self.fixer = fixer(self.linter, os.path.join(self.folder, "fixed"))
        self.interpreter = Interpreter(False, folder, record=True, cpu_limit=CPU_LIMIT_S)
        self.counts = Counter()

    def examine(self, programs):
        """name -> text: -> [(name, Violation)]"""
        findings = self._check(programs)
        found = self._alone(programs, findings)
        for unsafe, what in ((False, SAFE), (True, ALL)):
            fixed = self.fixer.fix(programs, unsafe)
            again = self.fixer.fix({name: one.text for name, one in fixed.items() if one.ended}, unsafe)
            for name, one in fixed.items():
                fixed = [f for f in findings[name] if first_fix(f, unsafe)]
                codes = "|".join(sorted({f["code"] for f in fixed}))
                self.counts["fixed programs, " + what] += one.text != programs[name]
                self.counts["longest rounds"] = max(self.counts["longest rounds"], one.rounds)
                if not one.ended:
                    found.append((name, Violation(ENDLESS, what, codes, one.text)))
                elif again[name].text != one.text:
                    found.append((name, Violation(AGAIN, what, codes, again[name].text)))
                elif not unsafe and one.text != programs[name]:
                    violation = self._runs(name, programs[name], one.text, stops_of(fixed), what, codes)
                    # Reported already, of the fix that does it.
                    alone = any(n == name and v.kind not in (STAYS, UNCOVERS) for n, v in found)
                    found += [(name, violation)] if violation and not alone else []
        return found

    def _check(self, programs):
        return self.linter.check(os.path.join(self.folder, "checked"), programs)

    def _alone(self, programs, findings):
        """Each fix for itself."""
        found, singles = [], {}
        for name, text in programs.items():
            for finding in findings[name]:
                for fix in finding["fixes"]:
                    self.counts["fixes"] += 1
                    self.counts["safe fixes"] += fix["safe"]
                    try:
                        singles["%06d.ngc" % len(singles)] = name, finding, fix, apply(text, fix["edits"])
                    except ValueError:
                        found.append((name, Violation(OVERLAP, title_of(finding, fix))))
        left = self._check({single: after for single, (_, _, _, after) in singles.items()})
        for single, (name, finding, fix, after) in singles.items():
            code, title = finding["code"], title_of(finding, fix)
            sort = "%s %s%s" % (code, finding["reach"], " stops" if finding["stops"] else "")
            said = tuple("%s: line %d %s%s: %s" % (when, f["start"]["line"], f["reach"], " stops" if f["stops"] else "", f["message"])
                         for when, some in (("fixed", [finding]), ("then", left[single])) for f in some if f["code"] == code)
            place = moved(finding["start"]["offset"], fix["edits"])
            if any((f["code"], f["start"]["offset"]) == (code, place) for f in left[single]):
                found.append((name, Violation(STAYS, title, sort, after, said)))
            elif len(said) > sum(f["code"] == code for f in findings[name]):
                self.counts[UNCOVERS] += 1
                if self.options.also == UNCOVERS:
                    found.append((name, Violation(UNCOVERS, title, sort, after, said)))
            if fix["safe"]:
                violation = self._runs(name, programs[name], after, stops_of([finding]), title, sort)
                self.counts["safe " + sort] += 1
                self.counts["changing safe " + sort] += violation is not None
                found += [(name, replace(violation, detail=said[:1] + violation.detail))] if violation else []
        return found

    def _runs(self, name, before, after, stops, what, codes):
        """The first run that a safe fix must not change, and does."""
        before, after = for_machine(before), for_machine(after)
        for choices in choices_of(name, self.options.runs):
            runs = self.interpreter.run(before, choices), self.interpreter.run(after, choices)
            self.counts["runs"] += 1
            kind = compare(*runs, stops)
            if kind:
                self.counts[kind] += 1
            if kind and (kind not in COUNTED or kind == self.options.also):
                return Violation(kind, what, codes, after, difference(*runs, choices))
            if "hang" in (runs[0].outcome, runs[1].outcome):    # each takes a long time
                break
        return None

    def first(self, name, texts, key):
        """The first of these programs that has a violation of this key: -> (text, Violation) or None."""
        # Choices depend on the name: they must stay the same.
        for text in texts:
            for _, violation in self.examine({name: text}):
                if violation.key == key:
                    return text, violation
        return None

    def shrink(self, name, text, key):
        """-> (text, Violation), with lines taken out as long as there is a violation of this key."""
        best = self.first(name, [text], key)
        newline = "\r\n" if "\r\n" in text else "\n"
        size = text.count(newline)
        while best and size:
            lines = best[0].split(newline)
            shorter = (newline.join(lines[:at] + lines[at + size:]) for at in range(0, len(lines), size) if len(lines) > size)
            found = self.first(name, shorter, key)
            best = found or best
            size = size if found else size // 2
        return best

    def close(self):
        self.interpreter.close()


def difference(before, after, choices):
    """The first difference of two runs, in words."""
    ends = ["%s: %s, line %d, %s" % (when, run.outcome, run.line, run.message) for when, run in (("before", before), ("after", after))]
    ours, theirs = put_out(before), put_out(after)
    at = next((i for i, (a, b) in enumerate(zip(ours, theirs)) if a != b), min(len(ours), len(theirs)))
    calls = ["call %d %s: %s" % (at, when, run[at] if at < len(run) else "none")
             for when, run in (("before", ours), ("after", theirs))] if ours != theirs else []
    return ("--choices '%s'" % "".join(map(str, choices[:len(before.trace)])), *ends, *calls)


_examiner = None


def _start_worker(options, folder):
    global _examiner
    _examiner = Examiner(options, folder)


def _examine(programs):
    """In a worker: -> (violations, counts so far)"""
    _examiner.counts.clear()
    return _examiner.examine(programs), _examiner.counts


def own_programs():
    """Those of the corpus and the fixtures, bundles as one program: a marked line is no mark any more."""
    paths = sorted(glob.glob(os.path.join(ROOT, "corpus", "*.ngc")) + glob.glob(os.path.join(ROOT, "tests", "programs", "*", "*.ngc")))
    programs = {}
    for path in paths:
        with open(path, encoding="latin-1", newline="") as f:
            name = "%s-%s" % (os.path.basename(os.path.dirname(path)), os.path.basename(path))
            programs[name.lower()] = f.read().replace("\n; file: ", "\n; part: ")
    return programs


def random_programs(options):
    for number in range(options.programs):
        seed = "%d/%d" % (options.seed, number)
        text = generate(seed)
        yield "p%06d.ngc" % number, text if number % 3 else roughen(text, seed)


def batches(programs):
    batch = {}
    for name, text in programs:
        batch[name] = text
        if len(batch) == AT_ONCE:
            yield batch
            batch = {}
    if batch:
        yield batch


def examine_all(options, folder, programs):
    """-> (counts, [(name, Violation)])"""
    counts, found = Counter(), []
    with multiprocessing.Pool(options.jobs, _start_worker, (options, folder)) as pool:
        for violations, more in pool.imap_unordered(_examine, batches(programs.items())):
            found += violations
            longest = max(counts["longest rounds"], more["longest rounds"])
            counts.update(more)
            counts["longest rounds"] = longest
    return counts, found


def report(options, folder, programs, found):
    """Shrink and print a few of each sort."""
    examiner = Examiner(options, folder)
    shown = Counter()
    for name, violation in sorted(found, key=lambda one: (one[1].key, one[1].codes, len(programs[one[0]]))):
        sort = violation.key + (violation.codes,)
        if shown[sort] == SHOWN_PER_KEY or sum(shown.values()) >= options.show:
            continue
        shown[sort] += 1
        text, violation = examiner.shrink(name, programs[name], violation.key) or (programs[name], violation)
        print("\n== %s: %s: %s (%s)" % (name, violation.kind, violation.what, violation.codes))
        for title, lines in (("before", text), ("after", violation.after)):
            print("   %s" % title)
            print("\n".join("%4d  %s" % (number, ascii(line)[1:-1]) for number, line in enumerate(lines.split("\n")[:LINES_SHOWN], 1)))
        for line in violation.detail:
            print("   " + ascii(line)[1:-1])
    examiner.interpreter.close()
    left = len(found) - sum(shown.values())
    if left:
        print("\n%d further violations of these sorts or beyond --show %d" % (left, options.show))


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--owlint", required=True, help="the program to test")
    parser.add_argument("--programs", type=int, default=0, help="random programs, besides the corpus and the fixtures")
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--runs", type=int, default=6, help="runs with random choices, for each fix")
    parser.add_argument("--show", type=int, default=40, help="violations to shrink and print")
    parser.add_argument("--through-program", action="store_true", help="let `owlint check --fix` make the rounds")
    parser.add_argument("--also", choices=COUNTED, help="show these as well, which are no violations")
    options = parser.parse_args(argv)
    if Interpreter is None:
        print("skipped: LinuxCNC's Python module is not here")
        return SKIPPED
    if options.seed is None:
        options.seed = int(time.time())
    folder = tempfile.mkdtemp(prefix="owlint-fix-", dir=scratch())
    started = time.monotonic()
    try:
        programs = {**own_programs(), **dict(random_programs(options))}
        counts, found = examine_all(options, folder, programs)
        seconds = time.monotonic() - started
        report(options, folder, programs, found)
    except LinterFailed as error:
        print("fix.py: %s" % error, file=sys.stderr)
        return 2
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    print("\nsafe fixes, by code and reach, and those of them that change a run:")
    for key in sorted(key for key in counts if key.startswith("safe OW")):
        print("  %-24s%5d%5d" % (key[5:], counts[key], counts["changing " + key]))
    print("seed %d: %d programs, %d fixes (%d safe), %d programs fixed safely and %d wholly in up to %d rounds, %d pairs of runs compared "
          "(%s), %d violations, %.0f s" % (
              options.seed, len(programs), counts["fixes"], counts["safe fixes"], counts["fixed programs, " + SAFE],
              counts["fixed programs, " + ALL], counts["longest rounds"], counts["runs"],
              ", ".join("%s: %d" % (kind, counts[kind]) for kind in COUNTED), len(found), seconds))
    return 1 if found or not counts["safe fixes"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
