"""Does another sub's body run than the one that is written?  What OW410 and OW411 claim, tried in runs.

Nothing that the interpreter says shows which body it runs.  So lines are put into the program that fail there, and only
if they are reached in the way that is asked about: a flag is set before the line in question and cleared at every call.
"""
import re
from dataclasses import dataclass

import bundle
from claims import settings
from explore import Explorer
from judge import NO_OTHER_BODY, OTHER_BODY, Disagreement

FLAG = "#<_asked>"
FAILS = "G0 X[1/[1-%s]]" % FLAG
HELPER_CLASH, IN_CALLED_FILE = "OW410", "OW411"
RUNS, PATIENCE = 60, 25

OPENERS, CLOSERS = ("if", "while", "do", "repeat"), ("endif", "endwhile", "while", "endrepeat")
_OWORD = re.compile(r"/?(?:n[\d.]+)?o(<[^>]*>|[\d.]+)(sub|endsub|call|%s|$)" % "|".join(dict.fromkeys(OPENERS + CLOSERS)))


@dataclass(frozen=True)
class Place:
    """A line with a sub, a call, or a block, or the end of one."""
    row: int            # of the bundle, from 0
    file: str           # without its folder and `.ngc`; empty for the program
    label: str
    keyword: str        # `sub` for a bare number, too, and `call` for M98


def places_of(text):
    """All such lines of a bundle."""
    places, file = [], ""
    for row, line in enumerate(text.split("\n")):
        if line.startswith("; file: "):
            file = re.sub(r".*/|\.ngc.*", "", line[len("; file: "):])
        code = re.sub(r"\([^)]*\)|;.*|\s", "", line).lower()
        if found := re.match(r"/?(?:n[\d.]+)?m98p([\d.]+)", code):
            places.append(Place(row, file, str(int(float(found[1]))), "call"))
        elif found := _OWORD.match(code):
            label = found[1].strip("<>")
            places.append(Place(row, file, str(int(float(label))) if re.fullmatch(r"[\d.]+", label) else label, found[2] or "sub"))
    return places


def questions(text, claims):
    """Of these claims {(code, line)}, and where it could be: {(code, line): lines to put in, {row: (before, after)}}"""
    places = places_of(text)
    subs = [p for p in places if p.keyword == "sub"]
    asked = [(HELPER_CLASH, call) for call in places if call.keyword == "call" and call.file]
    asked += [(IN_CALLED_FILE, place) for outer in subs for place in inside(places, outer)]
    asked += [(code, place) for place in places for code in (HELPER_CLASH, IN_CALLED_FILE) if (code, place.row + 1) in claims]
    put = {(code, place.row + 1): helper(place, subs) if code == HELPER_CLASH else inner(place, places) for code, place in asked}
    return {where: rows for where, rows in put.items() if rows}


def inside(places, outer):
    """The subs, and the ends of others, between the beginning and the end of the sub for which its file is called."""
    ends = [p for p in places if (p.file, p.label, p.keyword) == (outer.file, outer.label, "endsub") and p.row > outer.row]
    if outer.label != outer.file or not ends:
        return
    rows = [p for p in places if p.file == outer.file and outer.row < p.row < ends[0].row]
    for place in rows:
        before, after = ({p.label for p in rows if p.keyword in kinds and (p.row < place.row) == early}
                         for kinds, early in ((OPENERS, True), (CLOSERS, False)))
        if place.keyword == "sub":
            yield place
        # In a block it is an early way out; the end of an inner sub is one mistake with its beginning.
        elif place.keyword == "endsub" and not before & after and not any((p.label, p.keyword) == (place.label, "sub") for p in rows):
            yield place


def helper(call, subs):
    """Lines that fail where the call of a sub that its file has runs that of another file."""
    own = [s for s in subs if s.label == call.label and s.file == call.file]
    other = [s for s in subs if s.label == call.label and s.file != call.file]
    return own and other and {call.row: ([FLAG + "=1"], [FLAG + "=0"]), **{s.row: ([], [FLAG + "=0"]) for s in own}, **{s.row: ([], [FAILS]) for s in other}}


def inner(place, places):
    """Lines that fail where a `sub` is run into, or an `endsub` reached."""
    if place.keyword != "sub":
        return {place.row: (["G0 X[1/0]"], [])}
    return {**{p.row: ([FLAG + "=0"], []) for p in places if p.keyword == "call"}, place.row: ([FLAG + "=1"], [FAILS])}


def happens(interpreter, text, put, seed):
    """Whether some run gets to one of the lines that fail."""
    rows, failing = [], set()
    begin = 1 if text.startswith("%") else 0
    for row, line in enumerate(text.split("\n")):
        before, after = put.get(row, ([], []))
        for one in [*before, line, *after, *([FLAG + "=0"] if row == begin - 1 else [])]:
            rows.append(one)
            if one in (FAILS, "G0 X[1/0]"):
                failing.add(len(rows))
    if not begin:
        rows.insert(0, FLAG + "=0")
        failing = {row + 1 for row in failing}
    for block_delete in settings(text):
        explorer = Explorer(interpreter, "\n".join(rows), seed, block_delete)
        explorer.explore(RUNS, PATIENCE)
        if any(outcome == "error" and line in failing for outcome, _, line in explorer.ends):
            return True
    return False


def judge_bodies(interpreter, text, findings, seed):
    """-> (disagreements, how many places were asked about, at how many of them it happens)"""
    if not bundle.is_bundle(text):
        return [], 0, 0
    met = [f for f in findings if f["code"] in (HELPER_CLASH, IN_CALLED_FILE) and f["reach"] != "never"]
    # The other calls of the same helper are related places of its finding.
    claims = {(f["code"], f["start"]["line"]) for f in met}
    claims |= {(HELPER_CLASH, r["start"]["line"]) for f in met for r in f.get("related", ()) if r["message"] == "so does this call"}
    # An inner sub speaks for the calls of its label.
    claims |= {(c["code"], c["start"]["line"]) for f in met for c in f.get("consequences", ()) if c["code"] == HELPER_CLASH}
    answers = {where: happens(interpreter, text, put, seed) for where, put in questions(text, claims).items()}
    seen = {place for place, yes in answers.items() if yes}
    found = [Disagreement(OTHER_BODY, frozenset({code}), line) for code, line in sorted(seen - claims)]
    found += [Disagreement(NO_OTHER_BODY, frozenset({code}), line) for code, line in sorted(claims - seen)]
    return found, len(answers), len(seen)
