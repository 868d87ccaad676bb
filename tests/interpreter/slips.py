"""One slip of the pen in a program that somebody wrote: what fingers, habits from other controllers and English do.

`slip(text, rng)` gives (what was done, the text with it); with `of_words`, mostly in a line of words (word_slips.py,
mode_slips.py, arc_slips.py).  Programs are bytes as latin-1.  roughen.py and mistakes.py make
mistakes for random programs; these are for real ones.
"""
import re

import arc_slips
import mode_slips
from word_slips import IN_WORDS, has_words

KEYWORDS = ("sub", "endsub", "call", "do", "while", "endwhile", "repeat", "endrepeat", "if", "elseif", "else", "endif",
            "break", "continue", "return")
CONFUSED = {"if": ("while", "elseif", "repeat"), "elseif": ("else", "if", "else if", "elif"), "else": ("elseif", "endif"),
            "endif": ("end", "endwhile", "end if", "fi", "endrepeat"), "while": ("endwhile", "if", "until", "do"),
            "endwhile": ("while", "end", "wend", "endif"), "do": ("while", "repeat", "sub"), "repeat": ("while", "for", "do"),
            "endrepeat": ("endwhile", "end", "until", "repeat"), "sub": ("call", "endsub"), "endsub": ("return", "sub", "end", "M99"),
            "call": ("sub", "goto", "gosub"), "return": ("endsub", "M99", "break"), "break": ("continue", "exit", "return"),
            "continue": ("break", "next")}
BESIDE = dict(zip("qwertyuiopasdfghjklzxcvbnm", "wqertyuioapsdfghjkxzcvbnmn"))
ENGLISH = (" then", " then G0 X1", " and [#1 LT 9]", " AND [#2 EQ 1]", " or [#3 GT 0]", " please", " do", ":", " {", " = 1", " begin",
           " now", " goto 20", " GOTO 20", " THEN #3=1", " DO1", " times", " until done", " is true", ",", ";", " == 1", " G0 X5", " M5")
LINES = ("then", "GOTO 20", "goto 20", "END", "end", "begin", "end if", "endif", "else", "endsub", "END1", "DO1", "please stop", "stop",
         "M99", "M98 P100", "G0 X1 M99", "M99 G0 X1", "M98 P100 L2", "G0 X1 M98 P100", "M98 P100 G0 X1", "G65 P100 A1", "M98",
         "M99 P10", "IF [#1 EQ 2] THEN #3=1", "IF [#1 EQ 2] GOTO 20", "WHILE [#1 LT 3] DO1", "#1 = #2 + 1", "#1 = 1,5", "#depth = 5",
         "#<rot = 5", "#rot> = 5", "<d> = 5", "#1 =", "#1 := 5", "set #1 5", "call o100", "M2", "M30", "%", "/ M30", "O1000", "N20")
LOOKALIKES = {"-": "\u2212", " ": "\u00a0", "0": "\uff10", "1": "\uff11", "[": "\uff3b", "<": "\u2039", "o": "\u043e", "(": "\uff08", ",": "\u201a"}

_OWORD = re.compile(r"^\s*/?\s*(?:n\s*\d+\s*)?o\s*(?:<[^>]*>|[\d.]+|\[.*?\]|#)", re.IGNORECASE)
_LABEL = re.compile(r"(?<=[oO])(\d+|<[^>]*>)")
_WORD = re.compile(r"[A-Za-z]{2,}")
_TOKEN = re.compile(r"\[[^\]]*\]|#?<[^>]*>|[A-Za-z]+[-+\d.]*|#?\d+(?:\.\d*)?|\S")


def _replaced(line, match, text):
    return line[:match.start()] + text + line[match.end():]


def _any(rng, pattern, line):
    found = list(pattern.finditer(line))
    return rng.choice(found) if found else None


def letter(line, rng):
    """A letter lost, doubled, swapped with the next, or its neighbour on the keyboard."""
    word = _any(rng, _WORD, line)
    if not word:
        return None
    at = rng.randrange(word.start(), word.end())
    kind = rng.choice(("lost", "doubled", "swapped", "wrong"))
    if kind == "lost":
        return line[:at] + line[at + 1:]
    if kind == "doubled":
        return line[:at] + line[at] + line[at:]
    if kind == "swapped":
        return line[:at] + line[at:at + 2][::-1] + line[at + 2:]
    return line[:at] + BESIDE[line[at].lower()] + line[at + 1:]


def word(line, rng):
    """A word, label, bracket pair or number lost or doubled."""
    token = _any(rng, _TOKEN, line)
    return token and _replaced(line, token, rng.choice(("", token[0] + " " + token[0], token[0] + token[0])))


def bracket(line, rng):
    """A bracket lost, added, moved, or one of another sort."""
    at = _any(rng, re.compile(r"[\[\]<>()]"), line)
    if not at or rng.random() < 0.2:
        place = rng.randrange(len(line) + 1)
        return line[:place] + rng.choice("[]]<>()") + line[place:]
    without = _replaced(line, at, "")
    kind = rng.random()
    if kind < 0.4:
        return without
    if kind < 0.7:
        place = rng.randrange(len(without) + 1)
        return without[:place] + at[0] + without[place:]
    return _replaced(line, at, {"[": "(", "]": ")", "<": "[", ">": "]", "(": "[", ")": "]"}[at[0]] if kind < 0.9 else at[0] * 2)


def english(line, rng):
    """A word of English or of another controller behind the code of a line, or in it."""
    code = re.match(r"[^(;]*", line)[0].rstrip()
    if not code:
        return None
    if rng.random() < 0.15:
        place = rng.choice([m.start() for m in re.finditer(r"(?<=\s)\S", code)] or [0])
        return code[:place] + rng.choice(("then ", "the ", "please ", "if ", "call ", "not ")) + line[place:]
    return code + rng.choice(ENGLISH) + line[len(code):]


def keyword(line, rng):
    """Another keyword, or what another language calls it."""
    found = _any(rng, re.compile(r"(?<![A-Za-z<])(%s)(?![A-Za-z>])" % "|".join(KEYWORDS), re.IGNORECASE), line)
    return found and _replaced(line, found, rng.choice(CONFUSED[found[0].lower()]))


def label(line, rng):
    """Another label, none, or a zero for the letter."""
    found = _LABEL.search(line)
    if not found or not _OWORD.match(line):
        return None
    kind = rng.random()
    if kind < 0.5:
        if found[0][0] == "<":
            name = found[0][1:-1]
            return _replaced(line, found, "<%s>" % rng.choice((name + "s", name[:-1] or "x", name[::-1], name.replace("_", "-"))))
        return _replaced(line, found, str(int(found[0]) + rng.choice((-1, 1, 10, 100))))
    if kind < 0.6:
        return _replaced(line, found, found[0][1:-1] if found[0][0] == "<" else "<%s>" % found[0])
    if kind < 0.7:
        return _replaced(line, found, "")
    head = line[:found.start() - 1]
    return head + rng.choice(("0", "", "N", "Q", "oo", "0")) + line[found.start():] if kind < 0.9 else head + line[found.end():].lstrip()


def mark(line, rng):
    """A comma, a point, an equals sign or a hash lost, added or of another sort."""
    found = _any(rng, re.compile(r"[#=,.+*/-]"), line)
    if found and rng.random() < 0.7:
        other = {"=": ("", "==", ":="), "#": ("", "##", "$"), ".": (",", ""), ",": (".", ""), "+": ("++", ""), "-": ("--", ""), "*": ("x", "**"), "/": (":", "\\")}
        return _replaced(line, found, rng.choice(other[found[0]]))
    place = rng.randrange(len(line) + 1)
    return line[:place] + rng.choice((",", ";", ".", "=", "#", "'", '"', ":")) + line[place:]


def lookalike(line, rng):
    """A character that looks right and is not: from a web page or a word processor."""
    places = [at for at, c in enumerate(line) if c.lower() in LOOKALIKES]
    if not places:
        return None
    at = rng.choice(places)
    return line[:at] + LOOKALIKES[line[at].lower()].encode().decode("latin-1") + line[at + 1:]


# One line becomes another; how often each.
IN_LINE = ((letter, 4), (word, 4), (bracket, 4), (english, 5), (keyword, 3), (label, 3), (mark, 2), (lookalike, 1))


def _lose(lines, at, rng):
    del lines[at]


def _double(lines, at, rng):
    lines.insert(at if rng.random() < 0.7 else rng.randrange(len(lines) + 1), lines[at])


def _join(lines, at, rng):
    if at + 1 < len(lines):
        lines[at:at + 2] = [lines[at] + " " + lines[at + 1].strip()]


def _break(lines, at, rng):
    blanks = [m.start() for m in re.finditer(r"(?<=\S)\s+(?=\S)", lines[at])]
    if blanks:
        cut = rng.choice(blanks)
        lines[at:at + 1] = [lines[at][:cut], lines[at][cut:]]


def _move(lines, at, rng):
    line = lines.pop(at)
    lines.insert(max(0, min(len(lines), at + rng.choice((-2, -1, 1, 2)))), line)


def _foreign(lines, at, rng):
    lines.insert(at, rng.choice(LINES))


def _no_end(lines, at, rng):
    lines[:] = [line for line in lines if not re.match(r"\s*(m2|m30|m02)\b", line, re.IGNORECASE)]


def _no_block_end(lines, at, rng):
    ends = [at for at, line in enumerate(lines) if re.search(r"\bend(if|while|repeat|sub)\b", line, re.IGNORECASE)]
    if ends:
        del lines[rng.choice(ends)]


# Lines come and go; how often each.
OF_LINES = ((_lose, 3), (_double, 2), (_join, 2), (_break, 2), (_move, 2), (_foreign, 6), (_no_end, 2), (_no_block_end, 3))


def _line(lines, rng):
    """Mostly one with an O-word or parameters."""
    owords = [at for at, line in enumerate(lines) if _OWORD.match(line)]
    values = [at for at, line in enumerate(lines) if "#" in line and at not in owords]
    kind = rng.random()
    some = owords if kind < 0.65 else values if kind < 0.8 else []
    return rng.choice(some or range(len(lines)))


OF_MODES, OF_ARCS = 0.3, 0.4    # of the slips in lines of words


def slip(text, rng, of_words=0.0, arcs=False):
    """-> (what was done, the text with it); another text than the one given.  `of_words`: how probably in a line of words.
    `arcs`: with an arc, of which there has to be one."""
    newline = "\r\n" if "\r\n" in text else "\n"
    if not text.strip():
        return "begun", "please" + newline
    while True:
        lines = text.split(newline)
        if arcs:
            what = arc_slips.slip(lines, rng)
            if what and newline.join(lines) != text:
                return what, newline.join(lines)
            continue
        at = _line(lines, rng)
        of_these = [at for at, line in enumerate(lines) if not _OWORD.match(line) and has_words(line)] if of_words and rng.random() < of_words else []
        kind = rng.random()
        if of_these and kind < OF_MODES + OF_ARCS:
            what = (mode_slips if kind < OF_MODES else arc_slips).slip(lines, rng)
            if what and newline.join(lines) != text:
                return what, newline.join(lines)
            continue
        if of_these:
            at = rng.choice(of_these)
            change = rng.choices(*zip(*IN_WORDS))[0]
            lines[at] = change(lines[at], rng) or lines[at]
        elif rng.random() < 0.6:
            change = rng.choices(*zip(*IN_LINE))[0]
            lines[at] = change(lines[at], rng) or lines[at]
        else:
            change = rng.choices(*zip(*OF_LINES))[0]
            change(lines, at, rng)
        if newline.join(lines) != text:
            return change.__name__.strip("_").replace("_", " "), newline.join(lines)
