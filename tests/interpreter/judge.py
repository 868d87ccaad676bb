"""owlint's claims about a program held against what its runs showed.

A claim is a finding with `stops` that is not of reach `never`; with OWORD_WARNONLY also OW503 (crashes) and OW504
(never ends). A contour on which the interpreter loses its way may be shown by a crash or by an endless run.  A program with lines that begin with `/` is run with block delete off and on, and a claim may be about one of
the two.  A disagreement is one of
  miss          the interpreter stops where owlint claims nothing
  unwitnessed   no run ends where owlint claims a stop, or none with the numbers of an arc that it quotes
  not always    a run ends elsewhere although owlint says that every run gets to this stop
  never stops   a finding says that nothing gets there, and that it stops there
  other words   the stop is claimed there, with a message that the interpreter does not print
  other body    another sub runs than the one that is written, and owlint does not say so (bodies.py)
  no other body owlint says so, and no run shows it
"""
from dataclasses import dataclass

from messages import EOF, EOF_CODES, FILE_LACKS_SUB, UNKNOWN, codes_of, said_elsewhere, same_words
from oracle import for_interpreter

CRASH = "OW503"
HANGS = frozenset({"OW504", "OW508", "OW510"})
HAZARDS = HANGS | {CRASH}
MISS, UNWITNESSED, NOT_ALWAYS, NEVER_STOPS, OTHER_WORDS = "miss", "unwitnessed", "not always", "never stops", "other words"
OTHER_BODY, NO_OTHER_BODY = "other body", "no other body"


@dataclass(frozen=True)
class Claim:
    code: str
    line: int
    reach: str
    at_file_end: bool = False   # the finding stands at the cause; the interpreter stops where the file ends
    message: str = ""           # what LinuxCNC says, as owlint quotes it, of the program as it runs here
    block_delete: str = ""      # `on` or `off` if it is about runs with that setting

    def is_about(self, explorer):
        return self.block_delete in ("", "on" if explorer.block_delete else "off")


@dataclass(frozen=True)
class Disagreement:
    kind: str
    codes: frozenset
    line: int
    run: object = None      # the run that shows it, where one does
    reach: str = ""

    @property
    def key(self):
        """What must stay the same while a program is shrunk."""
        return self.kind, self.codes, self.reach if self.kind != OTHER_WORDS else ""

    def __str__(self):
        codes = "|".join(sorted(self.codes))
        at = "line %d" % self.line if self.line else "end of file"
        if self.kind == MISS:
            what = "the interpreter stops (%s)" % self.run.message if self.run.outcome == "error" else \
                "the interpreter %ss after this line" % self.run.outcome.rstrip("e")
            return "miss: %s at %s: %s" % (codes or self.run.outcome, at, what)
        if self.kind == OTHER_WORDS:
            return "other words: %s at %s: `%s` is claimed, `%s` is said" % (codes, at, self.reach, self.run.words)
        if self.kind == NOT_ALWAYS:
            ends = self.run.message or "the program ends"
            where = " on line %d" % self.run.line if self.run.line else ""
            return "not always: %s at %s is claimed for every run, but%s: %s" % (codes, at, where, ends)
        return "%s: %s at %s%s" % (self.kind, codes, at, ", reach %s" % self.reach if self.reach else "")


def claims_of(findings):
    """The stops that these findings claim, with those that they name as consequences of the same mistake."""
    claims = set()
    for f in findings:
        if not f["stops"] or f["reach"] == "never":
            continue
        stops = [(c, "maybe") for c in f.get("consequences", []) if c["interpreter"]]   # the others are never met
        if f["code"] not in HAZARDS:
            stops.append((f, f["reach"]))
        for stop, reach in stops:
            said = stop.get("interpreter", "")
            claims.add(Claim(stop["code"], stop["start"]["line"], reach, EOF in codes_of(said), for_interpreter(said), f.get("block_delete", "")))
    return claims


def hazards_of(findings):
    """The crashes and endless loops that these findings claim."""
    return {Claim(f["code"], f["start"]["line"], f["reach"], block_delete=f.get("block_delete", "")) for f in findings
            if f["code"] in HAZARDS and f["reach"] != "never"}


def _agrees(claim, end):
    """Is this end of a run the stop that the claim is about?"""
    outcome, codes, line = end
    if claim.code == "OW908" and not claim.message:
        return outcome in ("crash", "hang")
    if outcome != "error":
        return False
    if FILE_LACKS_SUB in codes:
        return claim.code == FILE_LACKS_SUB
    if EOF in codes:
        return claim.code in EOF_CODES or claim.code in codes or claim.at_file_end
    return claim.line == line and (claim.code in codes or UNKNOWN in codes)


def is_witnessed(claim, explorer):
    """Has some run shown what the claim says?"""
    if claim.code == CRASH:
        return any(outcome == "crash" and line == claim.line for outcome, _, line in explorer.ends)
    if claim.code in HANGS:
        if claim.code == "OW504":
            return claim.line in explorer.hung_after
        return any(outcome == "hang" for outcome, _, _ in explorer.ends)
    shown = [end for end in explorer.ends if _agrees(claim, end)]
    # Of the runs that come to an arc from different places, owlint quotes one.
    if said_elsewhere(claim.message, claim.message):
        return any(same_words(words, claim.message) for end in shown for words in explorer.said[end])
    return bool(shown)


def to_witness(findings, warnonly):
    """The claims that need a run each.  Without OWORD_WARNONLY the endless loops are counted, not judged."""
    hazards = {c for c in hazards_of(findings) if c.code in (CRASH, "OW504")} if warnonly else set()
    return claims_of(findings) | hazards


def judge(findings, explorers, warnonly=False):
    """All disagreements about one program, taken through its runs by one explorer or two."""
    claims, hazards, found = claims_of(findings), hazards_of(findings), []
    for explorer in explorers:
        found += misses({c for c in claims if c.is_about(explorer)}, {h for h in hazards if h.is_about(explorer)}, explorer, warnonly)
    for claim in sorted(to_witness(findings, warnonly), key=lambda c: (c.line, c.code)):
        about = [explorer for explorer in explorers if claim.is_about(explorer)]
        if not any(is_witnessed(claim, explorer) for explorer in about):
            found.append(Disagreement(UNWITNESSED, frozenset({claim.code}), claim.line, None, claim.reach))
        elif claim.reach == "always" and claim in claims:
            elsewhere = [run for explorer in about for end, run in explorer.ends.items() if end[0] in ("ok", "error") and not _agrees(claim, end)]
            if elsewhere:
                found.append(Disagreement(NOT_ALWAYS, frozenset({claim.code}), claim.line, elsewhere[0], "always"))
    for finding in findings:
        if finding["stops"] and finding["reach"] == "never":
            found.append(Disagreement(NEVER_STOPS, frozenset({finding["code"]}), finding["start"]["line"]))
    return found


def misses(claims, hazards, explorer, warnonly):
    """What was seen and is not claimed, or with other words."""
    for end, run in explorer.ends.items():
        outcome, codes, line = end
        agreeing = [claim for claim in claims if _agrees(claim, end)]
        if outcome == "error" and not agreeing:
            yield Disagreement(MISS, codes, line, run)
        elif outcome == "error" and not any(same_words(run.words, claim.message) or said_elsewhere(run.words, claim.message) for claim in agreeing):
            yield Disagreement(OTHER_WORDS, codes, line, run, "|".join(sorted({claim.message for claim in agreeing})))
        elif warnonly and run.warned and (
                (outcome == "crash" and not any(h.code == CRASH and h.line == line for h in hazards)) or
                (outcome == "hang" and not any(h.code in HANGS for h in hazards))):
            yield Disagreement(MISS, frozenset({CRASH if outcome == "crash" else "OW504"}), line, run)
