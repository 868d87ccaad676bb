#!/usr/bin/python3
"""Does owlint claim exactly the stops that LinuxCNC's interpreter makes?  Random programs, both directions.

usage: agree.py --owlint build/release/owlint [--programs 2000] [--seed S] [--jobs 2] [--keep DIR] [--warnonly] [--files] [--values] [--modes] [--places]
       agree.py --table [--modes …]      only run the programs, and count how they end

Each program runs under many combinations of its unknown values (explore.py).  Every stop seen must be claimed by a
finding with `stops` at that line under that rule that quotes the interpreter's message, and every claim must be seen in some
run; a claim of reach `always` must end every run.  What disagrees is shrunk and printed.  With --warnonly the interpreter has OWORD_WARNONLY and
owlint `--feature 0x20`: crashes and endless loops after a warning must then be predicted by OW503 and OW504.
With --coarse owlint analyses each program like a very large one, without values: no stop may be missed but of an
expression that fails for its values.  With --modes the modes of the machine decide what stops, with
--places where it stands, and `rs274` runs the programs (stand_alone.py).

Exit status: 0 agreement; 1 a miss, another message, a stop of reach `never`, or fewer than 99.5 % of the claims witnessed; 2 trouble.
"""
import argparse
import multiprocessing
import os
import shutil
import sys
import tempfile
import time
from collections import Counter

from claims import settings
from explore import Explorer
from generate import generate, generate_files, generate_modes, generate_places, generate_values
from judge import HANGS, MISS, NEVER_STOPS, NOT_ALWAYS, NO_OTHER_BODY, OTHER_BODY, OTHER_WORDS, UNWITNESSED, hazards_of, is_witnessed, to_witness
from linter import Linter, LinterFailed
from of_machine import general
from oracle import Interpreter, scratch
from shrink import Shrinker, investigate
from stand_alone import StandAlone

AT_ONCE = 300           # programs for one start of owlint
ENOUGH = 0.995          # of the claims must be witnessed
ENOUGH_VALUES = 0.99    # what an earlier run has left takes few values here
ENOUGH_COARSE = 0.90    # the same without values
SHRUNK_PER_KEY = 2      # alike disagreements that are shrunk; the others are counted

_interpreter = None


def interpreter_for(options, folder):
    return (StandAlone if options.modes or options.places else Interpreter)(options.warnonly, folder)


def _start_worker(options, folder):
    global _interpreter
    _interpreter = interpreter_for(options, folder)


def maker_for(options):
    if options.files:
        return generate_files
    return generate_values if options.values else generate_modes if options.modes else generate_places if options.places else generate


def _check(task):
    """One program, in a worker: -> (name, counts, disagreements)."""
    name, text, findings = task
    warnonly = _interpreter.warnonly
    explorers, disagreements, (asked, others) = investigate(_interpreter, text, findings, warnonly, seed=name)
    counts = Counter(runs=sum(e.runs for e in explorers), complete=all(e.complete for e in explorers), asked=asked, other_bodies=others)
    for explorer in explorers:
        counts.update({"run: " + outcome: count for outcome, count in explorer.outcomes.items()})
        for (outcome, codes, _), run in explorer.ends.items():
            if outcome == "error" or (run.warned and outcome in ("crash", "hang")):
                counts["stops"] += 1
                counts["stop: " + ("|".join(sorted(codes)) if outcome == "error" else outcome)] += 1
    for claim in to_witness(findings, warnonly):
        counts["claims " + claim.reach] += 1
    for disagreement in disagreements:
        counts[disagreement.kind] += 1
        counts["missed for lack of values"] += disagreement.kind == MISS and "OW512" in disagreement.codes
        counts["%s %s" % (disagreement.kind, disagreement.reach)] += 1
    loops = [h for h in hazards_of(findings) if h.code in HANGS]
    if any(e.outcomes["hang"] for e in explorers) and not loops:
        counts["programs that hang unannounced"] += 1
    if not warnonly:
        counts["programs that crash"] += any(e.outcomes["crash"] for e in explorers)
        counts["endless loops announced"] += len(loops)
        counts["endless loops seen"] += sum(any(is_witnessed(loop, e) for e in explorers) for loop in loops)
    return name, counts, disagreements


def compare(options, folder, linter):
    """Generate, lint and run all programs: -> (counts, [(name, text, disagreement)])."""
    counts, disagreements, pending = Counter(), [], []

    def collect(texts, results):
        for name, more, found in results.get():
            counts.update(more)
            disagreements.extend((name, texts[name], one) for one in found)

    make = maker_for(options)
    with multiprocessing.Pool(options.jobs, _start_worker, (options, folder)) as pool:
        for first in range(0, options.programs, AT_ONCE):
            texts = {"p%06d.ngc" % number: make("%d/%d" % (options.seed, number))
                     for number in range(first, min(first + AT_ONCE, options.programs))}
            findings = linter.check(os.path.join(folder, "programs"), texts)
            tasks = [(name, text, findings[name]) for name, text in texts.items()]
            pending.append((texts, pool.map_async(_check, tasks, chunksize=10)))
            if len(pending) > 2:
                collect(*pending.pop(0))
        for one in pending:
            collect(*one)
    return counts, disagreements


def show(name, text, findings, disagreement):
    """One disagreement with all that is needed to look into it."""
    out = ["", "== %s: %s" % (name, disagreement)]
    out += ["%4d  %s" % (number, line.rstrip("\r")) for number, line in enumerate(text.split("\n"), 1)]
    run = disagreement.run
    if run:
        values = " ".join("%d=%d" % (line, value) for line, _, value in run.trace) or "nothing to choose"
        out.append("   values read (line=value): %s" % values)
        out.append("   --choices '%s' ends: %s, line %d, %s" % (
            "".join(map(str, run.choices)), run.outcome, run.line, run.message))
    for f in findings:
        out.append("   owlint: line %d %s %s%s: %s [%s]" % (f["start"]["line"], f["code"], f["reach"], " stops" if f["stops"] else "",
                                                           f["message"], f.get("interpreter", "")))
    print("\n".join(out) if findings else "\n".join(out + ["   owlint: nothing"]), flush=True)


def report(options, folder, linter, disagreements):
    """Shrink and print, a few of each sort."""
    interpreter = interpreter_for(options, folder)
    shrinker = Shrinker(linter, interpreter, folder, options.warnonly)
    shown, seen = Counter(), set()
    if options.keep:
        os.makedirs(options.keep, exist_ok=True)
    for name, text, disagreement in sorted(disagreements, key=lambda d: (d[2].kind, sorted(d[2].codes), len(d[1]))):
        if options.keep:
            keep(options.keep, name, text)
        if (name, disagreement.key) in seen or shown[disagreement.key] == SHRUNK_PER_KEY or \
                sum(shown.values()) >= options.show:
            continue
        seen.add((name, disagreement.key))
        shown[disagreement.key] += 1
        shrunk = shrinker.shrink(text, disagreement.key)
        if shrunk is None:      # a rare run that was not found again
            shrunk = text, linter.check(shrinker.folder, {name: text})[name], disagreement
        elif options.keep:
            keep(options.keep, name.replace(".ngc", "-%s.ngc" % disagreement.kind.replace(" ", "-")), shrunk[0])
        show(name, *shrunk)
    left = len(disagreements) - sum(shown.values())
    if left:
        print("\n%d further disagreements of these sorts or beyond --show %d" % (left, options.show))
    interpreter.close()


def keep(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="latin-1", newline="") as f:
        f.write(text)


def summary(options, counts, seconds):
    """Print the figures; -> does it agree?"""
    percent = lambda part, whole: "%.2f %%" % (100.0 * part / whole) if whole else "none to judge"
    unwitnessed = {reach: counts["%s %s" % (UNWITNESSED, reach)] for reach in ("maybe", "always")}
    claims = {reach: counts["claims " + reach] for reach in ("maybe", "always")}
    wrong = sum(unwitnessed.values()) + counts[NOT_ALWAYS]
    print("\nseed %d, %d programs (%d with every run made), %d runs, %.1f s, %.1f ms a program" % (
        options.seed, options.programs, counts["complete"], counts["runs"], seconds,
        1000 * seconds / max(1, options.programs)))
    print("runs: " + ", ".join("%s %d" % (key[5:], counts[key]) for key in sorted(counts) if key.startswith("run: ")))
    print("stops seen: %d, missed by owlint: %d (%s)" % (
        counts["stops"], counts[MISS], percent(counts[MISS], counts["stops"])))
    print("  " + ", ".join("%s %d" % (key[6:], counts[key]) for key in sorted(counts) if key.startswith("stop: ")))
    for reach in ("maybe", "always"):
        print("claims of reach %s: %d, unwitnessed: %d (%s)%s" % (
            reach, claims[reach], unwitnessed[reach], percent(unwitnessed[reach], claims[reach]),
            ", not so in every run: %d" % counts[NOT_ALWAYS] if reach == "always" else ""))
    if counts["asked"]:
        print("places where another sub might run than the one that is written: %d, runs: %d, not claimed: %d, claimed and not seen: %d" % (
            counts["asked"], counts["other_bodies"], counts[OTHER_BODY], counts[NO_OTHER_BODY]))
    if counts[OTHER_WORDS]:
        print("stops with another message than owlint quotes: %d" % counts[OTHER_WORDS])
    if counts[NEVER_STOPS]:
        print("findings of reach never that stop: %d" % counts[NEVER_STOPS])
    for key in ("endless loops announced", "endless loops seen", "programs that hang unannounced", "programs that crash"):
        if counts[key]:
            print("%s: %d" % (key, counts[key]))
    total = sum(claims.values())
    print("claims witnessed: %s" % percent(total - wrong, total))
    enough = ENOUGH_COARSE if options.coarse else ENOUGH_VALUES if options.values else ENOUGH
    missed = counts[MISS]
    if options.coarse:
        print("of the missed ones a value fails, which is not followed in very large programs: %d" % counts["missed for lack of values"])
        missed -= counts["missed for lack of values"]
    return not missed and not counts[NEVER_STOPS] and not counts[OTHER_WORDS] and not counts[OTHER_BODY] and total - wrong >= enough * total


def _run_only(task):
    """One program, in a worker: -> how its runs end, each different end once."""
    name, text = task
    ends = Counter()
    for on in settings(text):
        explorer = Explorer(_interpreter, text, name, on)
        explorer.explore(150, 50)
        ends.update({"run: " + outcome: count for outcome, count in explorer.outcomes.items()})
        ends.update(general(run.message) for run in explorer.ends.values() if run.outcome == "error")
    return ends


def table(options, folder):
    """How the programs end, without owlint: a maker should make each message, and leave many programs to run to their end."""
    make, counts = maker_for(options), Counter()
    tasks = [(number, make("%d/%d" % (options.seed, number))) for number in range(options.programs)]
    with multiprocessing.Pool(options.jobs, _start_worker, (options, folder)) as pool:
        for ends in pool.imap_unordered(_run_only, tasks, chunksize=10):
            counts.update(ends)
    for message, count in counts.most_common():
        print("%6d  %s" % (count, ascii(message)[1:-1]))


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", help="the program to test")
    parser.add_argument("--table", action="store_true", help="only run the programs, and count how they end")
    parser.add_argument("--programs", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--show", type=int, default=12, help="disagreements to shrink and print")
    parser.add_argument("--keep", metavar="DIR", help="save the programs that disagree")
    parser.add_argument("--warnonly", action="store_true")
    parser.add_argument("--coarse", action="store_true")
    parser.add_argument("--values", action="store_true", help="programs in which parameters decide what stops")
    parser.add_argument("--files", action="store_true", help="programs of two to four files, with a search path")
    parser.add_argument("--modes", action="store_true", help="programs in which modes of the machine decide what stops")
    parser.add_argument("--places", action="store_true", help="programs in which it matters where the machine stands")
    options = parser.parse_args(argv)
    if not options.owlint and not options.table:
        parser.error("--owlint is missing")
    if options.seed is None:
        options.seed = int(time.time())
    print("seed %d" % options.seed, flush=True)
    folder = tempfile.mkdtemp(prefix="owlint-agree-", dir=scratch())
    started = time.monotonic()
    try:
        if options.table:
            table(options, folder)
            return 0
        linter = Linter(options.owlint, options.warnonly, machine=os.path.join(folder, "machine.ini"),
                        arguments=["--coarse"] if options.coarse else [])
        counts, disagreements = compare(options, folder, linter)
        seconds = time.monotonic() - started
        report(options, folder, linter, disagreements)
        return 0 if summary(options, counts, seconds) else 1
    except LinterFailed as error:
        print("agree.py: %s" % error, file=sys.stderr)
        return 2
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
