"""Makes a program that shows a disagreement as short as it can be while it still shows it."""
import os

from bodies import judge_bodies
from claims import settings
from explore import Explorer
from judge import is_witnessed, judge, to_witness
from oracle import FROM_BEFORE


def investigate(interpreter, text, findings, warnonly, seed=0, first=150, patience=50, more=2000):
    """Run a program until its claims are witnessed or the budget is spent.  -> (explorers, disagreements, (places where another
    sub may run than the one that is written, at how many of them it does))"""
    explorers = [Explorer(interpreter, text, seed, on) for on in settings(text)]
    for explorer in explorers:
        explorer.explore(first, patience)
        claims = [claim for claim in to_witness(findings, warnonly) if claim.is_about(explorer)]
        explorer.search(more, lambda: all(is_witnessed(claim, explorer) for claim in claims))
    bodies, asked, others = judge_bodies(interpreter, text, findings, seed) if not warnonly else ([], 0, 0)
    return explorers, judge(findings, explorers, warnonly) + bodies, (asked, others)


def has_before(lines):
    return any(FROM_BEFORE in line.lower() for line in lines)


class Shrinker:
    def __init__(self, linter, interpreter, folder, warnonly=False):
        self.linter = linter
        self.interpreter = interpreter
        self.folder = os.path.join(folder, "shrink")
        self.warnonly = warnonly

    def shrink(self, text, key):
        """-> (text, findings, disagreement), with lines taken out as long as one of the same `key` remains."""
        newline = "\r\n" if "\r\n" in text else "\n"
        lines = text.split(newline)
        best = self._first([lines], key, newline)
        if best is None:
            return None
        size = max(1, len(lines) // 2)
        while size:
            shorter = [lines[:at] + lines[at + size:] for at in range(0, len(lines), size) if len(lines) > size]
            # What the run before left is part of the question.
            shorter = [some for some in shorter if has_before(some) == has_before(lines)]
            found = self._first(shorter, key, newline)
            if found:
                best = found
                lines = best[0].split(newline)
                size = min(size, max(1, len(lines) // 2))
            else:
                size //= 2
        return best

    def _first(self, candidates, key, newline):
        """The first of these programs that still shows the disagreement; all are linted together."""
        programs = {"s%04d.ngc" % number: newline.join(lines) for number, lines in enumerate(candidates)}
        if not programs:
            return None
        findings = self.linter.check(self.folder, programs)
        for name, text in programs.items():
            _, found, _ = investigate(self.interpreter, text, findings[name], self.warnonly, first=60, patience=20,
                                   more=400)
            for disagreement in found:
                if disagreement.key == key:
                    return text, findings[name], disagreement
        return None
