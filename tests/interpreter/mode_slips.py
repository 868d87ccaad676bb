"""One slip with the modes of the machine, for slips.py: a feed, a spindle, a plane or a code of modes forgotten or confused.

`slip(lines, rng)` changes one of the lines, or puts one in, and says what it did; None where nothing of the kind is there.
"""
import re

from word_slips import blanked

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+|#<[^>]*>|#\d+|\[[^\]]*\])"
_CYCLE = r"(?:7[34]|8[1-9])"


def code_pattern(letter, numbers):
    """A pattern for some codes, each number as it is written without zeros before it."""
    return r"(?<![A-Za-z<#])%s\s*0*(?:%s)(?![\d.])" % (letter, numbers)


def word_pattern(letters):
    return r"(?<![A-Za-z<#])[%s]\s*%s" % (letters, _NUMBER)


# What is done; how often; where: on which lines, and what of them; what takes its place.
_CHANGES = (
    ("feed lost", 4, "", word_pattern("F"), ("",)),
    ("feed of zero", 1, "", word_pattern("F"), ("F0",)),
    ("speed lost", 2, "", word_pattern("S"), ("",)),
    ("spindle forgotten", 4, "", code_pattern("M", "[34]"), ("", "", "M5", "M8")),
    ("spindle turned the other way", 2, "", code_pattern("M", "3"), ("M4",)),
    ("another plane", 4, "", code_pattern("G", "1[789]"), ("G17", "G18", "G19", "")),
    ("another distance mode", 2, "", code_pattern("G", "9[01]"), ("G90", "G91", "G90.1")),
    ("another feed mode", 4, "", code_pattern("G", "9[345]"), ("G93", "G94", "G95", "G93", "")),
    ("other units", 1, "", code_pattern("G", "2[01]"), ("G20", "G21")),
    ("compensation not ended", 3, "", code_pattern("G", "40"), ("",)),
    ("compensation not begun", 1, "", code_pattern("G", "4[12]"), ("", "G41", "G42", "G40")),
    ("cycle not ended", 2, "", code_pattern("G", "80"), ("",)),
    ("word of a cycle lost", 4, code_pattern("G", _CYCLE), word_pattern("RZPQLXYIJK"), ("",)),
    ("cycle not written", 2, "", code_pattern("G", _CYCLE), ("", "G80", "G1")),
    ("another cycle", 2, "", code_pattern("G", _CYCLE), ("G82", "G83", "G84", "G74", "G86", "G73", "G89")),
    ("word of an arc lost", 4, code_pattern("G", "[23]"), word_pattern("IJKRXYZF"), ("",)),
    ("word of an arc with another letter", 3, code_pattern("G", "[23]"), r"(?<![A-Za-z<#])[IJKRXYZ](?=\s*%s)" % _NUMBER, tuple("IJKRXYZ")),
    ("another motion", 4, "", code_pattern("G", "[0-3]"), ("G0", "G1", "G2", "G3", "")),
    ("axis lost", 2, "", word_pattern("XYZ"), ("",)),
    ("word of a thread lost", 2, code_pattern("G", "33|76"), word_pattern("KZPIJ"), ("",)),
    ("modes not saved", 2, "", code_pattern("M", "7[03]"), ("", "M71")),
    ("modes not restored", 1, "", code_pattern("M", "72"), ("", "M71")),
    ("offset lost", 1, "", code_pattern("G", "43|49|5[3-9]|92"), ("", "G49", "G53", "G92")),
)
# A line too many, before one that needs another mode or anywhere.
_BEFORE = (
    ("stopped before it", 3, code_pattern("G", "33|76|74|8[4678]"), ("M5", "M5", "M6", "M19", "M4", "M3")),
    ("feed mode before it", 3, code_pattern("G", "[123]|" + _CYCLE), ("G93", "G95", "G94", "F0")),
    ("plane before it", 2, code_pattern("G", "[123]|4[12]|" + _CYCLE), ("G17", "G18", "G19", "G17.1")),
    ("compensation before it", 2, code_pattern("G", "[0-9.]+"), ("G41", "G42 D0", "G40", "G41.1 D0")),
    ("a mode anywhere", 4, "", ("G91", "G90", "G93", "G94", "G95", "G18", "G80", "G90.1", "M5", "M72", "M70", "G96 S100", "G98", "G0", "G1", "G20", "G28")),
)


def slip(lines, rng):
    if rng.random() < 0.75:
        what, _, place, change, others = rng.choices(_CHANGES, [row[1] for row in _CHANGES])[0]
        return what if _changed(lines, re.compile(place, re.IGNORECASE), re.compile(change, re.IGNORECASE), others, rng) else None
    what, _, place, others = rng.choices(_BEFORE, [row[1] for row in _BEFORE])[0]
    places = [at for at, line in enumerate(lines) if re.search(place, blanked(line), re.IGNORECASE)]
    if not places:
        return None
    lines.insert(rng.choice(places), rng.choice(others))
    return what


def _changed(lines, place, change, others, rng):
    found = [(at, word) for at, line in enumerate(lines) if place.search(blanked(line)) for word in change.finditer(blanked(line))]
    if not found:
        return False
    at, word = rng.choice(found)
    lines[at] = lines[at][:word.start()] + rng.choice(others) + lines[at][word.end():]
    return True
