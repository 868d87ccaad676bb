"""One slip in a line of words, for slips.py: a letter, digit, point or sign lost or wrong, a word too many or too few.

Each takes (line, rng) and gives the line with the slip, or None where there is nothing to slip on.
"""
import re

_COMMENT = re.compile(r"\([^)]*\)?|;.*")
_VALUE = r"[-+]?(?:\d+\.?\d*|\.\d+|#<[^>]*>|#\d+|\[[^\]]*\])"
_ANY_WORD = re.compile(r"(?<![A-Za-z<])([A-Za-z@^$])\s*(%s)" % _VALUE)
_CODE = re.compile(r"(?<![A-Za-z<])([GgMm])\s*0*(\d+)(\.\d)?(?![\d.])")
_DECIMAL = re.compile(r"\d*\.\d+|\d+\.")
_BESIDE = {
    "x": "zcs", "y": "tu", "z": "xa", "a": "sqz", "b": "vn", "c": "xv", "f": "dg", "g": "fh", "h": "gj", "i": "uoj",
    "j": "hki", "k": "jl", "l": "k", "m": "n", "n": "m", "p": "o", "q": "wa", "r": "et", "s": "ad", "t": "ry",
    "d": "sf", "e": "wr", "u": "yi", "v": "cb", "w": "qe",
}
_ANOTHER = (
    "G0", "G1", "G2", "G3", "G80", "G81", "G90", "G91", "G20", "G21", "G17", "G18", "G4", "G28", "G53", "G92",
    "G43", "G54", "M2", "M3", "M5", "M6", "M8", "M9", "X1", "Z5", "F100", "S1000", "P1", "R1", "I1", "J0", "L2",
    "T1", "Q1", "H1", "D1", "A0", "K1",
)


def blanked(line):
    """The line with its comments blanked, so that places stay the same."""
    return _COMMENT.sub(lambda comment: " " * len(comment[0]), line)


def has_words(line):
    return _ANY_WORD.search(blanked(line)) is not None


def _any(rng, pattern, line):
    found = list(pattern.finditer(blanked(line)))
    return rng.choice(found) if found else None


def _put(line, start, end, text):
    return line[:start] + text + line[end:]


def lost_letter(line, rng):
    found = _any(rng, _ANY_WORD, line)
    return found and _put(line, *found.span(1), "")


def lost_number(line, rng):
    found = _any(rng, _ANY_WORD, line)
    return found and _put(line, *found.span(2), "")


def lost_word(line, rng):
    found = _any(rng, _ANY_WORD, line)
    return found and _put(line, *found.span(), "")


def lost_code(line, rng):
    found = _any(rng, _CODE, line)
    return found and _put(line, *found.span(), "")


def lost_sign(line, rng):
    found = _any(rng, re.compile(r"(?<=[A-Za-z])\s*-"), line)
    return found and _put(line, *found.span(), "")


def added_sign(line, rng):
    found = _any(rng, _ANY_WORD, line)
    return found and _put(line, found.start(2), found.start(2), rng.choice(("-", "-", "+", "--")))


def lost_point(line, rng):
    found = _any(rng, _DECIMAL, line)
    return found and _put(line, *found.span(), found[0].replace(".", rng.choice(("", " "))))


def second_point(line, rng):
    found = _any(rng, _DECIMAL, line)
    if not found:
        return None
    number = found[0]
    return _put(line, *found.span(), rng.choice((number.replace(".", ".."), number + ".", number + ".0", "." + number)))


def comma(line, rng):
    found = _any(rng, _DECIMAL, line)
    return found and _put(line, *found.span(), found[0].replace(".", ","))


def letter_o(line, rng):
    found = _any(rng, re.compile(r"(?<=[A-Za-z\d.-])0"), line)
    return found and _put(line, *found.span(), rng.choice("Oo"))


def letter_l(line, rng):
    found = _any(rng, re.compile(r"(?<=[A-Za-z\d.-])1"), line)
    return found and _put(line, *found.span(), rng.choice("lI"))


def twice(line, rng):
    found = _any(rng, _ANY_WORD, line)
    if not found:
        return None
    blank = " " if " " in line else ""
    at = found.end() if rng.random() < 0.6 else len(blanked(line).rstrip())
    other = rng.choice((found[0], found[0], found[1] + rng.choice(("0", "1", "2.5", "-1"))))
    return _put(line, at, at, blank + other)


def wrong_code(line, rng):
    found = _any(rng, _CODE, line)
    if not found:
        return None
    digits, at = found[2], rng.randrange(len(found[2]))
    digit = str((int(digits[at]) + rng.choice((-1, 1))) % 10)
    beside = digits[:at] + digit + digits[at + 1:]
    changed = rng.choice((beside, beside, digits[::-1], digits + digit, digits + digits[-1]))
    return _put(line, *found.span(2), changed)


def wrong_letter(line, rng):
    found = _any(rng, _ANY_WORD, line)
    if not found:
        return None
    letter = rng.choice(_BESIDE.get(found[1].lower(), "x"))
    return _put(line, *found.span(1), letter.upper() if found[1].isupper() else letter)


def added(line, rng):
    """A word or a code that does not belong there."""
    at = len(blanked(line).rstrip()) if rng.random() < 0.5 else len(line) - len(line.lstrip())
    return _put(line, at, at, " %s " % rng.choice(_ANOTHER)).rstrip(" ")


def doubled_digit(line, rng):
    found = _any(rng, re.compile(r"\d"), line)
    return found and _put(line, *found.span(), found[0] * 2)


def swapped(line, rng):
    """Two characters in each other's place."""
    found = _any(rng, re.compile(r"(?<=\S)\S"), line)
    return found and line[:found.start() - 1] + line[found.start()] + line[found.start() - 1] + line[found.end():]


# How often each.
IN_WORDS = ((lost_letter, 4), (lost_number, 3), (lost_word, 3), (lost_code, 3), (lost_sign, 1), (added_sign, 2),
            (lost_point, 2), (second_point, 3), (comma, 3), (letter_o, 3), (letter_l, 1), (twice, 4), (wrong_code, 4),
            (wrong_letter, 4), (added, 4), (doubled_digit, 1), (swapped, 2))
