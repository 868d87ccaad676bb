"""What owlint does not follow yet: messages with which the interpreter refuses a line that it has read without fault.

They come from carrying the words out, and depend on the shape of a path, or on what the machine has.  This is the one list of
them; slipped.py and words.py count a stop with such a message, and take any other that owlint does not predict for a miss.
When owlint learns to follow something, its messages leave this list.
"""
import re

GEOMETRY, MACHINE = "geometry", "machine"

_MESSAGES = {
    # Compensated paths, splines.
    GEOMETRY: r"""
        Arc (?:move|to)
        (?:Length|Radius) of cutter compensation entry
        Straight (?:feed|traverse) in concave corner
        Tool radius not less than arc radius with comp
        Zero degree inside corner
        G7[Xx] error
        BUG: cutter compensation has generated
        BUG: (?:Invalid|Unsupported) plane
        Bug in tool radius comp
        Bug code not g0 or g1
        You must specify a number of control points""",
    # Tools, spindles, axes, user M codes, what an INI or a component says.
    MACHINE: r"""
        Requested tool -?\d+ not found in the tool table
        Need tool prepared
        G\d+ with lathe tool, but plane is not G18
        G10 L0 not allowed with loaded tool
        Invalid spindle \(\$\) number
        Spindle \(\$\) number out of range
        Invalid [DE]-number in G7
        (?:Digital|Analog) input selected out of bounds
        Indexing axis
        Invalid absolute position
        Unknown m code used: M1\d\d$
        Queue is not empty after
        Named (?:hal|INI) parameter""",
}
# What compensation with a radius stops, and not without one: the tool table decides where the line gives no diameter itself.
_OF_RADIUS = re.compile(r"The move just after exiting cutter compensation|Cannot use g53 with cutter radius comp|Cannot use G76 threading cycle with")
_PATTERNS = {kind: re.compile("|".join("(?:%s)" % row.lstrip() for row in rows.split("\n") if row.strip()))
             for kind, rows in _MESSAGES.items()}
_COMMENT = re.compile(r"\([^)]*\)?|;.*")


def not_followed(message):
    """GEOMETRY or MACHINE for the message of a stop; None for one that owlint has to predict."""
    # Under OWORD_WARNONLY warnings stand before the message.
    warned = re.match(r"\d+: (duplicate|undefined|no matching|not in a)", message)
    for kind, pattern in _PATTERNS.items():
        if pattern.search(message) if warned else pattern.match(message):
            return kind
    return None


def of_axes(message):
    """Whether an axis letter is refused that another machine has: for owlint to predict only where it knows the machine."""
    return re.match(r"Bad character '[uvw]' used", message) is not None


def of_a_tool(message, everything):
    """Whether it stops, or not, for the diameter of a tool."""
    return _OF_RADIUS.match(message) is not None and re.search(r"(?i)g\s*0*4\s*[12](?![\s\d]*\.)", _COMMENT.sub("", everything)) is not None


def in_a_contour(message, text, everything):
    """Whether it stops while G70 to G72 read the lines of their contour's sub: those are geometry, whatever the message."""
    if not re.search(r"(?i)g\s*7\s*[0-2]", _COMMENT.sub("", everything)):
        return False
    # The call that the interpreter makes of the Q, and axes that only a contour may name.
    if re.match(r"O[-\d.]+ CALL$", text):
        return True
    if re.match(r"(?i)\s*[uvw]", text) and message.startswith("Unknown word where unary"):
        return True
    return message == "Non integer value for integer" and re.search(r"(?i)q\s*-?\d*\.\d", everything) is not None


def general(message):
    """The message without what differs between programs."""
    varied = r"'[^']*'|(?<![\w.])-?\d+(?:\.\d+)?(?![\w.])|<[^>]*>|#\S+|file:\S+|(?<=used: M)\d+|(?<=199: M)\d+"
    return re.sub(varied, "…", re.sub(r"(?<=arc: start=).*|(?<=to start: start=).*", "…", message))
