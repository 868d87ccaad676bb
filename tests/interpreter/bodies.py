"""Does another sub's body run than the one that is written?  What OW410 and OW411 claim, tried in runs.

Nothing that the interpreter says shows which body it runs.  So lines are put into the program that fail there, and only
if they are reached in the way that is asked about: a flag is set before the line in question and cleared at every call.
"""
import re
from dataclasses import dataclass

import bundle
from explore import Explorer
from judge import NO_OTHER_BODY, OTHER_BODY, Disagreement

FLAG = "#<_asked>"
FAILS = "G0 X[1/[1-%s]]" % FLAG
HELPER_CLASH, IN_CALLED_FILE = "OW410", "OW411"
RUNS, PATIENCE = 60, 25

_OWORD = re.compile(r"/?(?:n[\d.]+)?o(<[^>]*>|[\d.]+)(sub|endsub|call|$)")


@dataclass(frozen=True)
class Place:
    """A line with a sub, its end, or a call."""
    row: int            # of the bundle, from 0
    file: int           # 0 is the program
    label: str
    keyword: str        # `sub` for a bare number, too, and `call` for M98


def places_of(text):
    """All lines of a bundle that open, end, or call subs."""
    places, file = [], 0
    for row, line in enumerate(text.split("\n")):
        file += line.startswith("; file: ")
        code = re.sub(r"\([^)]*\)|;.*|\s", "", line).lower()
        if found := re.match(r"/?(?:n[\d.]+)?m98p([\d.]+)", code):
            places.append(Place(row, file, str(int(float(found[1]))), "call"))
        elif found := _OWORD.match(code):
            label = found[1].strip("<>")
            places.append(Place(row, file, str(int(float(label))) if re.fullmatch(r"[\d.]+", label) else label, found[2] or "sub"))
    return places


def questions(text):
    """-> [(code, Place, lines to put in: {row: (before, after)})]"""
    places = places_of(text)
    subs = [p for p in places if p.keyword == "sub"]
    asked = []
    open_sub = None
    for place in places:
        if not place.file:
            continue
        if open_sub and open_sub.file != place.file:
            open_sub = None
        if place.keyword == "call":
            own = [s for s in subs if s.label == place.label and s.file == place.file]
            other = [s for s in subs if s.label == place.label and s.file != place.file]
            if own and other:
                put = {place.row: ([FLAG + "=1"], [FLAG + "=0"]), **{s.row: ([], [FLAG + "=0"]) for s in own}, **{s.row: ([], [FAILS]) for s in other}}
                asked.append((HELPER_CLASH, place, put))
        elif place.keyword == "sub":
            if open_sub:
                put = {p.row: ([FLAG + "=0"], []) for p in places if p.keyword == "call"}
                put[place.row] = ([FLAG + "=1"], [FAILS])
                asked.append((IN_CALLED_FILE, place, put))
            else:
                open_sub = place
        elif place.keyword == "endsub" and open_sub:
            if place.label == open_sub.label:
                open_sub = None
            else:
                asked.append((IN_CALLED_FILE, place, {place.row: (["G0 X[1/0]"], [])}))
    return asked


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
    explorer = Explorer(interpreter, "\n".join(rows), seed)
    explorer.explore(RUNS, PATIENCE)
    return any(outcome == "error" and line in failing for outcome, _, line in explorer.ends)


def judge_bodies(interpreter, text, findings, seed):
    """-> (disagreements, how many places were asked about, at how many of them it happens)"""
    if not bundle.is_bundle(text):
        return [], 0, 0
    claims = {(f["code"], f["start"]["line"]) for f in findings if f["code"] in (HELPER_CLASH, IN_CALLED_FILE) and f["reach"] != "never"}
    answers = {(code, place.row + 1): happens(interpreter, text, put, seed) for code, place, put in questions(text)}
    seen = {place for place, yes in answers.items() if yes}
    found = [Disagreement(OTHER_BODY, frozenset({code}), line) for code, line in sorted(seen - claims)]
    found += [Disagreement(NO_OTHER_BODY, frozenset({code}), line) for code, line in sorted(claims - seen)]
    return found, len(answers), len(seen)
