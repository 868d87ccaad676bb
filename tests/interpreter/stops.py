"""What owlint says of a program held against how it ended in rs274: one verdict for slipped.py and words.py.

A verdict is a Disagreement, one of COUNTED, MACHINE where the machine decides (of_machine.py), or None where owlint says what
happens.
"""
import re
from dataclasses import dataclass

import bundle
import rs274
from claims import Claims, said_by
from messages import EOF, codes_of, said_elsewhere, same_words
from of_machine import MACHINE, decides, general

SILENT, ELSEWHERE, WORDS, NOT_ALWAYS, CRASH = "silent", "other place", "other words", "not always", "crash"
FAILS = "owlint fails"
UNKNOWABLE, ENDLESS = "unknowable", "endless"
COUNTED = (UNKNOWABLE, ENDLESS)

_COMPUTED_LABEL = re.compile(r"(?i)/?(n\d+\s*)?o[#\[]")
_COMMENT = re.compile(r"\([^)]*\)?|;.*")
# Errors of reading that no value of a parameter makes.
_WITHOUT_VALUES = re.compile(
    r"Bad character|Bad format unsigned|bad number format|No characters found|Unknown word|Unclosed|Nested comment|"
    r"Unknown operation|Left bracket|Slash missing|Equal sign|Command too long|Named parameter not terminated|"
    r"Multiple [^pq ]+ words|Expected [#\]]")
# Those of words that a value makes.
_OF_VALUES = re.compile(
    r"Negative \w+ (word|code|tool)|Negative (spindle|tool)|Non integer|out of range|P value|R value|Dwell time missing|"
    r"Line with G10|Multiple [pq] words|Unknown [gm] code|M-code greater|Two [gm] codes|Parameter (number|is readonly)")
# Those of where a line begins, and the codes behind which only the machine knows where that is.
_OF_PLACES = re.compile(
    r"Radius to end of arc|Zero-radius arc|Current point same|Arc radius too small|R less than|Must specify angle in polar|"
    r"(Incremental|G91) motion with polar|Start point too close|Cannot move rotary axes")
_ASKED = re.compile(r"(?i)(?<![a-z<])(g\s*38|m\s*0*6(?![\d.])|m\s*61|g\s*10(?!\d).*l\s*0)")


@dataclass(frozen=True)
class Disagreement:
    kind: str
    what: str           # what the interpreter says, or which claim is wrong

    @property
    def key(self):
        """What must stay the same while a program is shrunk."""
        return self.kind, general(self.what)


@dataclass
class Checked:
    """A program as owlint has seen it."""
    texts: dict         # name -> text
    findings: list      # each with the `path` of its file
    fixed: bool = False
    failure: str = ""   # how owlint ended, if not with a report


def judge(outcome, checked, program, block_delete, axes_known=False):
    """The verdict of one run.  `axes_known`: owlint was given the machine's axes."""
    if checked.failure:
        return Disagreement(FAILS, checked.failure)
    claims = Claims(checked.findings, block_delete, checked.texts.get(bundle.MAIN, ""))
    # A remap's file is checked for itself: what is said of it holds when its code is used.
    # rs274 has the axes X Y Z A B C, whatever an INI says.
    of_ini = lambda f: program.mode == "machine" and re.match(r"Bad character '[abc]'", f.get("interpreter", ""))
    of_remap = lambda f: f["path"] != bundle.MAIN and "REMAP" in program.text
    mine = lambda findings: [f for f in findings if not of_remap(f) and not of_ini(f)]
    claims.always, claims.errors = mine(claims.always), mine(claims.errors)
    if outcome.kind == "hang":
        if claims.endless:
            return None
        # A cycle that pecks too often is geometry.
        pecks = any(re.search(r"(?i)g\s*[78]\s*3", _COMMENT.sub("", text)) for text in checked.texts.values())
        if claims.always and not pecks:
            return Disagreement(NOT_ALWAYS, "%s: it never ends" % claims.always[0]["code"])
        return ENDLESS
    if outcome.kind == "crash":
        return None if claims.crashes else Disagreement(CRASH, outcome.message)
    # What a program asks for itself is no mistake in it.
    if outcome.kind == "error" and re.search(r"(?i)\(\s*abort,", outcome.text):
        return None
    # A REMAP that is refused, or names no file, stops every program, before its first line.
    if outcome.message.startswith("INTERP_REMAP") or re.search(r"\d+:REMAP = ", outcome.message):
        said = any(f.get("interpreter") == outcome.message for f in checked.findings)
        return None if said else Disagreement(SILENT, outcome.message)
    if outcome.kind == "ok":
        wrong = claims.always or claims.errors
        return Disagreement(NOT_ALWAYS, "%s: it runs" % quoted(wrong[0])) if wrong else None
    there = [(f, claim) for f in claims.stops for claim in said_by(f)
             if is_there(f, claim, outcome, checked.texts, program.mode)]
    # Of an arc that is met from several places, owlint quotes one.
    is_met = lambda f, said: same_words(outcome.message, said) or f["reach"] != "always" and said_elsewhere(outcome.message, said)
    met = [f for f, claim in there if is_met(f, claim.get("interpreter", ""))]
    if met:
        wrong = [f for f in claims.always if f not in met]
        before = "%s: it stops before: `%s`"
        return Disagreement(NOT_ALWAYS, before % (quoted(wrong[0]), outcome.message)) if wrong else None
    if decides(outcome.message, "\n".join(checked.texts.values()), axes_known):
        return MACHINE
    if is_unknowable(outcome, checked) or is_lost(outcome, checked):
        return UNKNOWABLE
    if there:
        return Disagreement(WORDS, "%s is `%s`" % (quoted(there[0][1]), outcome.message))
    return Disagreement(ELSEWHERE if claims.stops else SILENT, outcome.message)


def quoted(claim):
    return "%s: `%s`" % (claim["code"], claim.get("interpreter", ""))


def is_there(finding, claim, outcome, texts, mode):
    """Whether a claim is about the line at which it stopped.  Where the message names its file, it may be at the
    cause."""
    line = claim["start"]["line"]
    if rs274.AT_FILE_END.search(outcome.message) or outcome.message.startswith("File:") or "levels" in outcome.message:
        return same_words(outcome.message, claim.get("interpreter", ""))
    # Under OWORD_WARNONLY the number may be that of a warning.
    numbered = re.match(r"\d+: ", outcome.message) and mode != "warnonly"
    lines = texts.get(finding["path"], "").split("\n")
    said = lines[line - 1].strip().split("\0")[0].strip() if line <= len(lines) else ""
    if re.match(r"O[\d.]+ CALL$", outcome.text):      # what G71 makes of its Q
        return same_words(outcome.message, claim.get("interpreter", ""))
    # What a contour makes of the lines of its sub is shown at these.
    if re.search(r"(?i)g\s*7\s*[012]", said) and outcome.message.startswith("G7X error"):
        return same_words(outcome.message, claim.get("interpreter", ""))
    # A contour, and the rest of a line with a remapped code, run where the sub ends, and that line is shown.
    if re.search(r"(?i)g\s*7\s*[012]", said) or "REMAP" in texts.get("machine.ini", ""):
        if re.match(r"(?i)o(<[^>]*>|[\d.]+)\s*(endsub|return)", outcome.text):
            return same_words(outcome.message, claim.get("interpreter", ""))
    # What M72 and the end of a sub with M73 write is all that it shows.
    if outcome.message.startswith("M7x: restore_settings"):
        return same_words(outcome.message, claim.get("interpreter", ""))
    remapped = re.match(r"user-defined ([\w.]+):", outcome.message)
    if remapped:                                      # the call that the interpreter makes of a remapped code is all that it shows
        return remapped[1].lower() in re.sub(r"\s", "", said).lower()
    fits = said.startswith(outcome.text) if outcome.message == "Command too long" else said == outcome.text
    return fits and (not numbered or line == outcome.line)


def is_unknowable(outcome, checked):
    """Whether it stops for what was in the machine before the program."""
    everything = "".join(checked.texts.values())
    if _WITHOUT_VALUES.match(outcome.message):
        return False
    # The value of a parameter whose number is computed.
    codes = codes_of(outcome.message)
    if re.search(r"#\s*[#\[]", outcome.text) or codes & {"OW208"} and re.search(r"(?i)[oq]\s*#\s*[#\[]", everything):
        return True
    # Files that a remap names are checked for themselves.
    in_remap = "REMAP" in everything and outcome.message.startswith(("EOF in file", "Fanuc 'O"))
    if in_remap or re.match(r"Named parameter #<_(hal|ini)\[", outcome.message) or "[PYTHON]" in everything:
        return True
    # A part of a program that ngcgui makes.
    if "(not_a_subfile)" in everything:
        return True
    # The value of a name that is not there, when a definition is skipped, is whatever is in memory.
    if outcome.message.startswith("Calculation resulted in") and re.search(r"(?i)#<_value>", outcome.text):
        return True
    computed_labels = lambda text: "".join(re.findall(r"(?i)[oq]\s*[#[].*", text))
    settings_of = lambda names, text: "".join(
        line for name in names for line in re.findall(r"(?m)^\s*%s\s*=.*" % re.escape(name), text))
    where = ""
    if codes & {"OW512", "OW604", "OW217"} or _OF_VALUES.match(outcome.message) or _COMPUTED_LABEL.match(outcome.text):
        where = re.sub(r"\s", "", outcome.text)
    elif codes & {EOF, "OW208"} or not outcome.line:
        where = computed_labels(everything)     # of the end of the file it is not said which label was sought
    where += settings_of(re.findall(r"#<\w+>", where), everything)
    # Outside of subs no number is an argument.
    outside = re.sub(r"(?ims)^\s*o[^\n]*?sub\b.*?endsub", "", _COMMENT.sub("", everything))
    of_machine = computed_labels(outside) if codes & {EOF, "OW208"} else ""
    of_machine += settings_of(re.findall(r"#<\w+>", where), outside)
    main = checked.texts[bundle.MAIN]
    # What is set behind the line is not set when it is reached first.
    before = re.sub(r"(?is)(?<!end)sub\b.*?endsub", "", _COMMENT.sub("", until(main, outcome.text)))
    before = re.split(r"(?i)[oq]\s*[#\[]", before)[0]
    last_argument = 30 if re.search(r"(?i)o(<[^<>\n]*>|[\d.]+|\[.*?\])\s*sub\b", main) else 0
    numbers = [n for n in re.findall(r"#(\d+)", where) if int(n) > last_argument] + re.findall(r"#(\d+)", of_machine)
    return any(not re.search(r"(?<!#)#\s*%s\s*=" % number, before) for number in numbers)


def is_lost(outcome, checked):
    """Whether it stops for where it stands, and that has been asked from the machine: behind a probe, a change of tools or G10 L0,
    until X, Y and Z are named again."""
    if not _OF_PLACES.match(outcome.message):
        return False
    before = _COMMENT.sub("", until(checked.texts[bundle.MAIN], outcome.text)).split("\n")
    lost = [at for at, line in enumerate(before) if _ASKED.search(line)]
    behind = "\n".join(before[lost[-1] + 1:]) if lost else "xyz"
    return any(not re.search(r"(?i)(?<![a-z<])%s" % axis, behind) for axis in "xyz")


def until(text, line):
    """The text before a line, or all of it where that is not one line of it."""
    lines = text.split("\n")
    hits = [at for at, one in enumerate(lines) if one.strip() == line]
    return "\n".join(lines[:hits[0]]) if len(hits) == 1 else text
