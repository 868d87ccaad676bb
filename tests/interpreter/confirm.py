#!/usr/bin/python3
"""Does LinuxCNC's interpreter do what owlint says of every program in the repository?

usage: confirm.py --owlint build/release/owlint [--record] [--only TEXT] [--portion N]

Runs `rs274 -g` over the fixtures (tests/programs), the corpus, the examples on every rule's page and the tables of
expressions and of lines (tests/unit/syntax/*.tsv), and holds the outcomes against owlint's findings: each stop is claimed by a
finding that quotes the interpreter's message to the letter, but for where files lie; a stop of reach `always` happens;
without such a finding the program ends.  Programs with lines that begin with `/` run twice, with block delete off and on.  The outcomes are kept in recorded.tsv (--record or OWLINT_UPDATE=1 writes it) and serve where rs274 is not installed.
--portion N: of the programs that have a recorded outcome only a fixed Nth part runs again (`./dev confirm` runs all).
"""
import argparse
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass, replace

import bundle
import rs274
from claims import OF_LINUXCNC, Claims, judge, settings
from linter import Linter
from rs274 import Outcome

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
RECORDED = os.path.join(HERE, "recorded.tsv")
MESSAGE_KEPT = 400          # characters of many warnings


@dataclass(frozen=True)
class Program:
    """One program to confirm. `page`: the message that its page quotes, for a bad example that has one, or "runs"."""
    name: str
    text: str               # bytes as latin-1
    options: str = ""
    page: str = ""
    moves: str = ""         # where its last rapid move goes, if the page says so
    block_delete: bool = False

    @property
    def files(self):
        """name -> text: the program itself is `program.ngc` where it brings other files (tests/support/bundle.h)"""
        if not bundle.is_bundle(self.text):
            return {"program": (0, self.text)}      # no .ngc: no call finds it as a file
        return bundle.split(self.text)

    @property
    def mode(self):
        if "machine.ini" in self.files:
            return "machine"
        if len(self.files) > 1:
            return "files"
        return "warnonly" if "--feature 0x20" in self.options else "default"

    @property
    def recorded_mode(self):
        return self.mode + ", block delete" * self.block_delete

    @property
    def digest(self):
        """What the interpreter's outcome depends on: not the words of expectations, which are comments."""
        text = re.sub(r"(?m)^; (asks|expect|options): .*?(?=\r?$)", ";", self.text)
        return hashlib.sha256(text.encode("latin-1")).hexdigest()[:12]


def plain(message):
    """A message as a page may write it: without what depends on the program and on how it is written."""
    message = re.sub(r"(?i)(file:)\s*\S+?(?=\s|$)", r"\1PROGRAM", message)
    return re.sub(r"\s+", "", re.sub(r"^\d+: ", "", message)).lower()


# -- what there is to confirm

def read(path):
    with open(path, encoding="latin-1", newline="") as f:
        return f.read()


def fixtures():
    folder = os.path.join(ROOT, "tests", "programs")
    for code in sorted(os.listdir(folder)):
        for name in sorted(os.listdir(os.path.join(folder, code))):
            if name.startswith(".") or name.endswith(".expect"):
                continue
            path = os.path.join(folder, code, name)
            text = read(path)
            beside = os.path.splitext(path)[0] + ".expect"
            said = read(beside) if os.path.exists(beside) else text
            options = re.search(r"^(?:; )?options: ([^\r\n]*)", said, re.MULTILINE)
            yield Program("tests/programs/%s/%s" % (code, name), text, options.group(1) if options else "")


def corpus():
    folder = os.path.join(ROOT, "corpus")
    for name in sorted(os.listdir(folder)):
        if name.endswith(".ngc"):
            yield Program("corpus/" + name, read(os.path.join(folder, name)))


def pages(owlint):
    rules = json.loads(subprocess.run([owlint, "rules", "--format", "json"], capture_output=True, check=True).stdout)
    for rule in rules:
        # JSON has characters, programs have bytes
        bad, good = (rule[key].encode("utf-8").decode("latin-1") for key in ("bad", "good"))
        yield Program("page:%s:bad" % rule["code"], bad, rule["options"], rule["interpreter"] or "runs", rule["moves"])
        yield Program("page:%s:good" % rule["code"], good, rule["options"], moves=rule["moves_good"])


def expressions():
    """-> [(Program, wanted)]: the value as it is printed, or the message"""
    for row in read(os.path.join(ROOT, "tests", "unit", "syntax", "expressions.tsv")).splitlines():
        if row and not row.startswith("#"):
            text, wanted = row.split("\t")
            yield Program("expression:" + text, "G21 G90\n#100=[%s]\nG0 X#100\nM2\n" % text), wanted


# What a line that runs in any mode may find: LinuxCNC's start, and the opposite of all that.
MODES = ["", "G20 G18 G91 G93 G99 G64 G59 G0 X1 M4 S5 M7 M49\n", "G19 G95 S100 M3 F1\nG81 X1 Y1 Z1 R2\n", "F100\nG2 X1 I0.5\nG92 X2\n"]


def known_lines():
    """Lines that surely_runs() says yes to, each in several modes: they must run."""
    for row in read(os.path.join(ROOT, "tests", "unit", "syntax", "known_lines.tsv")).splitlines():
        kind, _, text = row.partition("\t")
        if kind == "runs":
            for number, modes in enumerate(MODES):
                yield Program("line:%s:%d" % (text, number), "%s%s\nM2\n" % (modes, text))


def further_faults():
    """-> [(Program, message)]: a line with several mistakes, and the same line without the first of them, and so on"""
    for row in read(os.path.join(ROOT, "tests", "unit", "syntax", "further_faults.tsv")).splitlines():
        line, *mistakes = row.split("\t")
        for number, mistake in enumerate([] if row.startswith("#") else mistakes):
            at, word, message = re.match(r"(\d+):(.*?): (.*)", mistake).groups()
            yield Program("further:%s:%d" % (row.split("\t")[0], number), "F100\n%s\nM2\n" % line), message
            line = line[:int(at)] + " " * len(word) + line[int(at) + len(word):]


# -- recorded outcomes

def load():
    """-> {(name, digest, mode): Outcome}"""
    recorded = {}
    if os.path.exists(RECORDED):
        for row in read(RECORDED).split("\n")[1:]:
            if row:
                name, digest, mode, kind, line, message, x = row.split("\t")
                recorded[name, digest, mode] = Outcome(kind, int(line or 0), message, x)
    return recorded


def save(outcomes):
    with open(RECORDED, "w", encoding="latin-1", newline="") as f:
        f.write("program\tdigest\tmode\toutcome\tline\tmessage\tx\n")
        for p, o in outcomes.items():
            f.write("\t".join([p.name, p.digest, p.recorded_mode, o.kind, str(o.line or ""), o.message, o.x]) + "\n")


def measure(programs):
    """Run them all: -> {Program: Outcome}"""
    outcomes = {}
    with tempfile.TemporaryDirectory(prefix="owlint-confirm-") as folder:
        for number, program in enumerate(programs):
            own = os.path.join(folder, str(number))
            bundle.write(own, program.files)
            outcome = rs274.run(os.path.join(own, next(iter(program.files))), program.mode, program.block_delete)
            shutil.rmtree(own)
            message = re.sub(r"[\t\r\n\0]", " ", outcome.message.replace(own + "/", ""))
            message = re.sub(r"^\d+ (?=emc/)", "", message)     # the number of the process, in what it logs
            outcomes[program] = Outcome(outcome.kind, outcome.line, message[:MESSAGE_KEPT], outcome.x)
    return outcomes


def lint_files(owlint, program, folder):
    """The findings of a program that brings other files, in all of them."""
    bundle.write(folder, program.files)
    # The interpreter is asked for the version that is installed.
    options = re.sub(r"--linuxcnc \S+", "", program.options).split()
    done = subprocess.run([owlint, "check", "--isolated", "--no-find-ini", "--format", "json", "program.ngc", *options],
                          capture_output=True, cwd=folder)
    return [f for file in json.loads(done.stdout)["files"] for f in file["findings"] if f["code"] not in OF_LINUXCNC]


def lint(owlint, programs, folder):
    """-> {name: findings}; programs with equal options in one run"""
    findings, by_options = {}, {}
    for number, program in enumerate(programs):
        if len(program.files) > 1:
            findings[program.name] = lint_files(owlint, program, os.path.join(folder, "files%d" % number))
        else:
            by_options.setdefault(re.sub(r"--linuxcnc \S+", "", program.options), []).append(program)
    for options, members in by_options.items():
        linter = Linter(owlint, machine=os.path.join(folder, "machine.ini"), arguments=options.split())
        names = {"%05d.ngc" % number: program for number, program in enumerate(members)}
        result = linter.check(os.path.join(folder, "programs"), {n: p.text for n, p in names.items()})
        findings.update({program.name: result[name] for name, program in names.items()})
    return findings


def judge_page(program, outcome):
    """A page's example must do what the page says."""
    if program.name.endswith(":good") and outcome.kind != "ok":
        yield "the good example ends in: %s %s" % (outcome.kind, outcome.message)
    if program.moves and (not outcome.x or program.moves != "X%g" % float(outcome.x)):
        yield "the page says that it moves to %s, the interpreter moves to X%s" % (program.moves, outcome.x)
    of_linuxcnc = any(":%s:" % code in program.name for code in OF_LINUXCNC)
    if program.page and program.page != "runs" and not of_linuxcnc:
        pattern = re.escape(plain(program.page)).replace("linen", r"line\d+").replace("line:n", r"line:\d+")
        if not re.search(pattern, plain(outcome.message)):
            yield "the page quotes `%s`, the interpreter says %s: `%s`" % (program.page, outcome.kind, outcome.message)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--record", action="store_true", help="write recorded.tsv")
    parser.add_argument("--only", default="", help="programs whose name contains this")
    parser.add_argument("--portion", type=int, default=1, help="of the recorded ones only every Nth runs")
    options = parser.parse_args(argv)
    if os.environ.get("OWLINT_UPDATE", "0") not in ("", "0"):
        options.record = True
    owlint = os.path.abspath(options.owlint)
    wanted = dict([*expressions(), *further_faults()])
    programs = [replace(p, block_delete=on) for p in [*fixtures(), *corpus(), *pages(owlint), *wanted, *known_lines()]
                if options.only in p.name for on in settings(p.text)]
    recorded = load()
    stale = []
    ran = 0
    if rs274.available:
        known = {p: recorded[p.name, p.digest, p.recorded_mode] for p in programs
                 if (p.name, p.digest, p.recorded_mode) in recorded and int(p.digest, 16) % options.portion != 0}
        measured = measure([p for p in programs if p not in known])
        ran = len(measured)
        outcomes = {p: known[p] if p in known else measured[p] for p in programs}
        if options.record and not options.only:
            save(outcomes)
        elif not options.record:
            stale = [p for p, o in outcomes.items() if recorded.get((p.name, p.digest, p.recorded_mode)) != o]
    else:
        outcomes = {p: recorded[p.name, p.digest, p.recorded_mode] for p in programs if (p.name, p.digest, p.recorded_mode) in recorded}
        stale = [p for p in programs if p not in outcomes]

    problems = ["%s: not as in recorded.tsv: run confirm.py --record where rs274 is installed" % p.name for p in stale]
    with tempfile.TemporaryDirectory(prefix="owlint-confirm-") as folder:
        findings = lint(owlint, [p for p in outcomes if p not in wanted], folder)
    for program, outcome in outcomes.items():
        if program in wanted:
            said = outcome.message if outcome.kind == "error" else outcome.x
            if said != wanted[program]:
                problems.append("%s: `%s` expected, the interpreter says `%s`" % (program.name, wanted[program], said))
            continue
        if program.name.startswith("line:") and outcome.kind != "ok":
            problems.append("%s: said to run, the interpreter says %s: %s" % (program.name, outcome.kind, outcome.message))
        problems += ["%s: %s" % (program.name, p) for p in judge(outcome, Claims(findings[program.name], program.block_delete, program.text))]
        problems += ["%s: %s" % (program.name, p) for p in judge_page(program, outcome)] if not program.block_delete else []
    print("\n".join(problems) if problems else "all as owlint says")
    kinds = [o.kind for o in outcomes.values()]
    print("%d programs (%s), outcomes %s" % (
        len(outcomes), ", ".join("%s %d" % (k, kinds.count(k)) for k in sorted(set(kinds))),
        "as recorded: rs274 is not installed" if not rs274.available else
        "measured with rs274" if ran == len(outcomes) else "as recorded, %d of them measured again with rs274" % ran))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
