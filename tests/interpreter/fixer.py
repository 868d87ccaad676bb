"""Makes owlint's fixes: from the edits in its report, or by its own `--fix`.

Both give for each program what comes out when its fixes are made in rounds until nothing is left to make.
"""
import bisect
import os
import shutil
import subprocess
from dataclasses import dataclass

from linter import LinterFailed

MAX_ROUNDS = 20
TIME_LIMIT_S = 300


@dataclass
class Fixed:
    """A program after its fixes; `ended` is false where there was always one more to make."""
    text: str
    rounds: int = 0
    ended: bool = True


def first_fix(finding, unsafe):
    """The fix of a finding that would be made, or None."""
    return next((fix for fix in finding["fixes"] if unsafe or fix["safe"]), None)


def apply(text, edits):
    """The text, bytes as latin-1, with these edits made; ValueError where two overlap."""
    out, at = [], 0
    for edit in sorted(edits, key=lambda e: e["start"]["offset"]):
        start, end = edit["start"]["offset"], edit["end"]["offset"]
        if not at <= start <= end <= len(text):
            raise ValueError("edits overlap or lie outside the file")
        out += text[at:start], edit["text"].encode().decode("latin-1")
        at = end
    return "".join(out) + text[at:]


def round_of(findings, unsafe):
    """The edits of the first fixes that do not touch each other, front to back."""
    edits, taken = [], []       # taken: (start, end), sorted, none touching another
    for finding in findings:
        fix = first_fix(finding, unsafe)
        spans = [(e["start"]["offset"], e["end"]["offset"]) for e in fix["edits"]] if fix else []
        if spans and not any(_touches(taken, span) for span in spans):
            for span in spans:
                bisect.insort(taken, span)
            edits += fix["edits"]
    return edits


def _touches(taken, span):
    at = bisect.bisect_right(taken, (span[1], float("inf")))
    return at > 0 and taken[at - 1][1] >= span[0]


class JsonFixer:
    """Makes the edits of the JSON report."""

    def __init__(self, linter, folder):
        self.linter = linter
        self.folder = folder

    def fix(self, programs, unsafe):
        """name -> text: name -> Fixed"""
        done = {name: Fixed(text) for name, text in programs.items()}
        left = list(programs)
        for _ in range(MAX_ROUNDS):
            findings = self.linter.check(self.folder, {name: done[name].text for name in left})
            rounds = {name: round_of(findings[name], unsafe) for name in left}
            left = [name for name in left if rounds[name]]
            if not left:
                break
            for name in left:
                done[name].text = apply(done[name].text, rounds[name])
                done[name].rounds += 1
        for name in left:
            done[name].ended = False
        return done


class ProgramFixer:
    """Lets `owlint check --fix` do it, in place."""

    def __init__(self, linter, folder):
        self.linter = linter
        self.folder = folder
        self.command = linter.command + ["--fix"]

    def fix(self, programs, unsafe):
        shutil.rmtree(self.folder, ignore_errors=True)
        os.makedirs(self.folder)
        for name, text in programs.items():
            with open(os.path.join(self.folder, name), "w", encoding="latin-1", newline="") as f:
                f.write(text)
        command = self.command + ["--unsafe"] * unsafe + [self.folder]
        try:
            done = subprocess.run(command, capture_output=True, timeout=TIME_LIMIT_S, cwd=self.folder)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise LinterFailed("%s: %s" % (" ".join(command), error)) from error
        said = done.stderr.decode("utf-8", "replace")
        # 2 is also what it ends with where a file is left as it is because there was always one more fix to make.
        if done.returncode not in (0, 1) and not (done.returncode == 2 and "does not come to an end" in said):
            raise LinterFailed("exit status %d of %s\n%s" % (done.returncode, " ".join(command), said[-2000:]))
        fixed = {}
        for name, text in programs.items():
            with open(os.path.join(self.folder, name), encoding="latin-1", newline="") as f:
                fixed[name] = Fixed(f.read())
            fixed[name].rounds = int(fixed[name].text != text)
        shutil.rmtree(self.folder)
        # Where a fix is left, it did not come to an end, whatever was said.
        findings = self.linter.check(self.folder, {name: one.text for name, one in fixed.items()})
        for name, one in fixed.items():
            one.ended = not round_of(findings[name], unsafe)
        return fixed
