"""The interpreter's error messages as owlint's rule codes.

`codes_of` answers with every code under which owlint may report that error; usually there is one.
"""
import re

EOF = "EOF"                                             # the file ended before the program did
EOF_CODES = frozenset({"OW315", "OW204", "OW205"})      # how owlint reports it: at its cause, so on any line
FILE_LACKS_SUB = "OW401"                                # its message does not say where the call is
UNKNOWN = "unknown message"                             # no rule is named for it; any claim on that line will do

_BY_KEYWORD = {
    "undefined O-word label": {"else": "OW105", "elseif": "OW105", "endif": "OW106", "break": "OW107",
                               "continue": "OW107", "endwhile": "OW108", "endrepeat": "OW108"},
    "duplicate O-word label": {"repeat": "OW102", "while": "OW103", "if": "OW104"},
    "no matching label": {"endif": "OW106", "endwhile": "OW108", "endrepeat": "OW108"},
}
# A message with the numbers of an arc: others when the line is reached from elsewhere.
_OF_ARC = re.compile(r"(Radius to end of arc differs from radius to start|Zero-radius arc): ")
_FILE = re.compile(r"((?i:file):)\s*\S+?(?=\s|$)")
_WARNING = re.compile(r"\d+: (duplicate|undefined|no matching|not in a)")
# The quoted line of a message: 'o100 end if (comment)'.  Blanks inside words are kept there, the case is not.
_KEYWORDS = ("endsub", "sub", "endwhile", "while", "endrepeat", "repeat", "elseif", "else", "endif", "if",
             "break", "continue", "return", "call", "do")

# (pattern, codes), the first match counts
_TABLE = [(re.compile(pattern), frozenset(codes.split())) for pattern, codes in (
    # What restores modes quotes another message.
    (r"restore context from invalid stack frame|restore_settings", "OW807"),
    (r"no matching 'if' label", "OW106"),
    (r"no matching while/do label", "OW107"),
    (r"not in a subroutine definition|Not in subroutine definition", "OW101"),
    (r"Nested subroutine definition", "OW202"),
    (r"redefining sub", "OW201"),
    (r"found in illegal location", "OW203 OW207"),
    (r"EOF in file.*seeking o-word: .* from line: 0$", FILE_LACKS_SUB),
    (r"EOF in file.*seeking", "OW208 OW404"),
    (r"File ended", EOF),
    (r"Failed to find sub", EOF + " OW208 OW409"),  # the closing %: an unclosed block and an unknown call look alike
    (r"Too many subroutine parameters", "OW209"),
    (r"Too many subroutine levels", "OW210"),
    (r"Fanuc 'O|'O\.\.\.\. ", "OW211"),
    (r"Found 'm98' code", "OW208"),
    (r"Unknown m code used: M98|convert_stop\(\) from M99", "OW217"),
    # Of an M98 line, which LinuxCNC reads as one of words, the rule about such lines speaks; M99 is a code, too.
    (r"Multiple .+ words on one line", "OW704 OW217"),
    (r"Two g codes used from same modal group", "OW706"),
    (r"Two m codes used from same modal group", "OW706 OW217"),
    (r"Too many m codes|G4 not allowed with G2|Between G5\.2 and G5\.3|Bug bad g code modal group 0|Must use g0 or g1 with g53|"
     r"Cannot use g53 incremental|R word is ambiguous", "OW706"),
    (r"Negative l word", "OW703 OW217"),
    (r"Negative (f word|h word|spindle speed|tool id|g code|m code)|G-code out of range|P value not an integer|P value out of range|"
     r"P value must be|P value should be|R value must be within", "OW703"),
    (r"Unknown g code used|Unknown m code used|M-code greater than|Bug code not m0", "OW705"),
    (r"P word with no", "OW707 OW217"),
    (r"^[A-Z] word with no|\$ \(spindle selection\) word with no|Cannot put an? [abc] in canned cycle|F word used with a g33", "OW707"),
    (r"Dwell time missing|Line with G10 does not have|All axes missing with|S word missing with G96|K word missing with g33|"
     r"P word missing with G76|I J or K words missing", "OW708"),
    (r"Cannot use axis values|Cannot use two g codes that both|polar coordinate (except|on a machine|and)|Polar coordinates can only", "OW709"),
    (r"with zero feed rate|NURBS with 0 feedrate|nurbs with 0 feedrate", "OW801"),
    (r"Cannot feed with zero spindle speed|^Spindle not turning|^Chosen spindle|^Spindle turning", "OW802"),
    (r"F word missing with inverse time|inverse time feed with canned cycles|probe with feed per rev", "OW803"),
    (r"Cannot do an arc in planes|^[IJK] word given for arc|Splines must be in the XY|can only be used in XZ plane|"
     r"Cannot put an? [UVWXYZ] in a canned cycle|canned cycle is not possible|for plane .* not implemented|one plane must be selected", "OW804"),
    (r"^(?!Length of|Radius of|BUG: cutter).*[Cc]utter (radius )?comp|G4[12]\.1 with (no D|L) word|G4[12] requires D word|G4[12] with lathe tool|cutter compensation mode must be straight|"
     r"Cannot use g53 with|Bug code not g0 or g1", "OW805"),
    (r"Requested tool|Need tool prepared", "OW806"),
    (r"spindle \(\$\) number|Spindle \(\$\) number|Invalid [DE]-number|G10 L1 without|Q number in G10|Invalid tool orientation|"
     r"I J words not allowed|R not allowed in G10|G10 L0 not allowed|Need non-negative Q-word|Q word with M19|No valid P word|"
     r"both a digital and an analog|Zero timeout|Can't select analog|valid P or a valid E|input selected out of bounds|Invalid analog index|"
     r"^G43\.2: |polar coordinates with G53|^Must specify angle in polar|with polar coordinates is indeterminate|^Start point too close|wrapped rotary axis|Indexing axis|along with an indexer", "OW808"),
    (r"^Radius to end of arc differs", "OW901 OW908"),
    (r"^Arc radius too small", "OW902"),
    (r"^(Length|Radius) of cutter compensation entry|^Bug in tool radius comp", "OW905"),
    (r"without gouging|^Tool radius not less than arc radius|arcs have the same center|^BUG: cutter compensation has generated", "OW906"),
    (r"^Zero-radius arc", "OW903 OW908"),
    (r"^Current point same as end point|words all missing for arc|Mixed radius ijk|word missing in absolute center arc|words missing for arc in", "OW903"),
    (r"R clearance plane|zero repeats of cycle|value unspecified in|^R less than|Dwell time p word|Q word missing with g|"
     r"[Nn]egative or zero q|^[IJK] word missing with g87", "OW904"),
    (r"requires a Q word|Splines may not|Must specify both|You must specify|P without X and Y|positive weight P|G5\.3 without|^In G76|"
     r"rotary axes with G76|[Nn]urbs|^G7[Xx] error", "OW908"),
    (r"Unknown control command", "OW301 OW314"),
    (r"Left bracket missing after (unary|slash)", "OW302 OW303 OW701 OW702"),
    (r"Left bracket missing", "OW302"),
    (r"Unexpected character after O-word", "OW304 OW303 OW217"),
    (r"Named parameter .* not defined", "OW603"),
    (r"read-?only", "OW604"),
    (r"divide by zero|Zero to negative power|[Nn]egative argument to|raise negative|Calculation resulted|out of range",
     "OW512 OW303 OW604"),
    (r"Unclosed expression|Unknown operation|Unknown word where|Slash missing|bad number format|"
     r"Unknown operator|Bad number", "OW303 OW306 OW314 OW701 OW702"),
    (r"comment found", "OW308"),
    (r"Command too long", "OW309"),
    (r"No characters found in reading real value|Unknown word starting with", "OW306 OW303 OW701 OW702"),
    (r"Non integer value", "OW703 OW306 OW303 OW512 OW217"),
    (r"Bad character 'o'", "OW305 OW702"),
    (r"Bad character '[uvwabcxyz]'", "OW701"),
    (r"Bad character '%'", "OW315 OW314"),
    (r"Bad character", "OW303 OW305 OW306 OW307 OW313 OW314"),
)]


def _keyword(message):
    """The keyword of the O-word line that the message quotes, or ''."""
    quoted = re.search(r"'([^']*)'[^']*$", re.sub(r" ?\(found '.*?\)", "", message))
    text = quoted.group(1) if quoted else ""
    text = re.sub(r"\([^)]*\)|;.*|\s", "", text).lower()
    word = re.sub(r"^/?(n[\d.]+)?o(<[^>]*>|\[[^\]]*\]|[-+#\d.]+)", "", text)
    return next((k for k in _KEYWORDS if word.startswith(k)), "")


def codes_of(message):
    """The set of codes for one message; {EOF} for an early end of file, {UNKNOWN} where no rule is named."""
    for kind, by_keyword in _BY_KEYWORD.items():
        if kind in message:
            return frozenset({by_keyword.get(_keyword(message), UNKNOWN)})
    for pattern, codes in _TABLE:
        if pattern.search(message):
            return codes
    return frozenset({UNKNOWN})


def call_line(message):
    """The line of the call in `EOF in file:… seeking o-word: … from line: N`, else None."""
    found = re.search(r"seeking o-word: .* from line: (\d+)", message, re.DOTALL)
    return int(found.group(1)) if found else None


def same_words(message, quote):
    """Whether the interpreter's message is what owlint quotes, to the letter but for where files lie.  Under OWORD_WARNONLY
    the messages of its warnings stand before it."""
    message, quote = (_FILE.sub(r"\1FILE", text).replace("\t", " ").rstrip() for text in (message, quote.encode().decode("latin-1")))
    if _OF_ARC.match(quote) and "..." in quote:     # dots stand for numbers that are not known
        return re.fullmatch(re.escape(quote).replace(r"\.\.\.", ".*"), message) is not None
    return bool(quote) and (message == quote or (message.endswith(quote) and _WARNING.match(message) is not None))


def said_elsewhere(message, quote):
    """Whether both say that a line is no arc, perhaps with the numbers of different runs."""
    said, quoted = _OF_ARC.match(message), _OF_ARC.match(quote)
    return said is not None and quoted is not None and said[1] == quoted[1]


def renumbered(message, change):
    """The message with its line numbers changed."""
    return re.sub(r"^\d+(?=: )|(?<=line )\d+|(?<=line:)\d+|(?<=line: )\d+", lambda m: str(change(int(m[0]))), message)


def warned_lines(text):
    """The lines of all `NNN: …` warnings that OWORD_WARNONLY printed, in order, and the codes of the last one.

    They follow each other without a break, also after `defined in line NNN`: line numbers must have three digits."""
    parts = re.split(r"(\d{3}): (?=duplicate|undefined|no matching|not in a)", text)
    return [int(n) for n in parts[1::2]], codes_of(parts[-1]) if len(parts) > 1 else frozenset()
