"""One slip with an arc, for slips.py: in its numbers, its letters or its codes, or in the move that leads to it.

`slip(lines, rng)` changes one of the lines, and says what it did; None where nothing of the kind is there.
"""
import re

from mode_slips import code_pattern, word_pattern
from word_slips import blanked

_ARC = re.compile(code_pattern("G", "[23]"), re.IGNORECASE)
_CENTER = re.compile(word_pattern("IJKR"), re.IGNORECASE)
_NO_ARC = re.compile(code_pattern("G", "10|33|38|4|5|7[0-6]|8[1-9]") + r"|(?<![A-Za-z<#])M", re.IGNORECASE)
_DIGIT = re.compile(r"(?<![A-Za-z<#])([XYZIJKR]\s*-?[\d.]*)(\d)", re.IGNORECASE)
_SIGN = re.compile(r"(?<![A-Za-z<#])([XYZIJKR]\s*)(-)", re.IGNORECASE)
_UNSIGNED = re.compile(r"(?<![A-Za-z<#])([XYZIJKR]\s*)(?=[\d.\[#])()", re.IGNORECASE)
_POINT = re.compile(r"(?<![A-Za-z<#])([XYZIJKR]\s*-?\d*)(\.)(?=\d)", re.IGNORECASE)


def is_arc(line):
    code = blanked(line)
    return _ARC.search(code) is not None or _CENTER.search(code) is not None and not _NO_ARC.search(code)


def has_arcs(text):
    return any(is_arc(line) for line in text.split("\n"))


def _put(line, match, group, text):
    return line[:match.start(group)] + text + line[match.end(group):]


def _any(rng, pattern, line):
    found = list(pattern.finditer(blanked(line)))
    return rng.choice(found) if found else None


def another_digit(line, rng):
    found = _any(rng, _DIGIT, line)
    return found and _put(line, found, 2, rng.choice("0123456789"))


def lost_sign(line, rng):
    found = _any(rng, _SIGN, line)
    return found and _put(line, found, 2, "")


def added_sign(line, rng):
    found = _any(rng, _UNSIGNED, line)
    return found and _put(line, found, 2, "-")


def moved_point(line, rng):
    found = _any(rng, _POINT, line)
    return found and _put(line, found, 2, rng.choice(("", ".0")))


def swapped_letters(line, rng):
    pairs = {"I": "J", "J": "I", "X": "Y", "Y": "X"}
    these = rng.choice(("IJ", "IJ", "XY"))
    change = lambda word: (lambda other: other if word[0].isupper() else other.lower())(pairs[word[0].upper()])
    parts = re.split(r"(\([^)]*\)?|;.*|#?<[^>]*>)", line)
    parts[::2] = [re.sub(r"(?<![A-Za-z])[%s](?=\s*[-+\d.#\[])" % these, change, part, flags=re.IGNORECASE) for part in parts[::2]]
    return "".join(parts)


def lost_word(line, rng):
    found = _any(rng, re.compile("(%s)" % word_pattern("XYZIJKRP"), re.IGNORECASE), line)
    return found and _put(line, found, 1, "")


def lost_center(line, rng):
    """All words of the center, or the radius."""
    found = list(_CENTER.finditer(blanked(line)))
    for one in reversed(found):
        line = line[:one.start()] + line[one.end():]
    return line if found else None


def other_way(line, rng):
    found = _any(rng, _ARC, line)
    return found and _put(line, found, 0, rng.choice(("G3", "G2", "G3", "G2", "G1", "")))


def before_it(line, rng):
    """A code that changes what the numbers mean."""
    codes = ("G90.1", "G90.1", "G91.1", "G91", "G90", "G18", "G19", "G17", "G20", "G21", "G7", "G92 X0", "G52 X1", "G10 L2 P0 X1", "G43.1 Z1", "G0 X0 Y0")
    return rng.choice(codes) + "\n" + line


_IN_ARC = ((another_digit, 8), (lost_sign, 3), (added_sign, 2), (moved_point, 2), (swapped_letters, 3), (lost_word, 3), (lost_center, 1), (other_way, 3), (before_it, 4))
_IN_MOVE = ((another_digit, 4), (lost_sign, 2), (added_sign, 1), (lost_word, 3), (moved_point, 1))
# A code that says how arcs are read, and others in its place.
_CODES = (("G", "9[01]\\s*\\.\\s*1", ("G90.1", "G91.1", "")), ("G", "1[789]", ("G17", "G18", "G19", "")), ("G", "9[01]", ("G90", "G91", "")), ("G", "2[01]", ("G20", "G21")))


def slip(lines, rng):
    arcs = [at for at, line in enumerate(lines) if is_arc(line)]
    if not arcs:
        return None
    at, kind = rng.choice(arcs), rng.random()
    if kind < 0.15:
        letter, numbers, others = rng.choice(_CODES)
        pattern = re.compile(code_pattern(letter, numbers), re.IGNORECASE)
        found = [(n, one) for n, line in enumerate(lines) for one in pattern.finditer(blanked(line))]
        if not found:
            return None
        n, one = rng.choice(found)
        lines[n] = _put(lines[n], one, 0, rng.choice(others))
        return "another code for arcs"
    if kind < 0.3 and at:
        if rng.random() < 0.3:
            del lines[at - 1]
            return "move to an arc lost"
        change = rng.choices(*zip(*_IN_MOVE))[0]
        at -= 1
    else:
        change = rng.choices(*zip(*_IN_ARC))[0]
    changed = change(lines[at], rng)
    if not changed:
        return None
    lines[at:at + 1] = changed.split("\n")
    return "of an arc: " + change.__name__.replace("_", " ")
