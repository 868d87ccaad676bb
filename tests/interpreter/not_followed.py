"""What owlint does not follow yet: messages with which the interpreter refuses a line that it has read without fault.

They come from carrying the words out, and depend on what earlier lines have set or moved.  This is the one list of
them; slipped.py and words.py count a stop with such a message, and take any other that owlint does not predict for a miss.
When owlint learns to follow something, its messages leave this list.
"""
import re

MODES, GEOMETRY, MACHINE = "modes", "geometry", "machine"

_MESSAGES = {
    # Feed, spindle, compensation, plane, distance mode, states that are saved.
    MODES: r"""
        Cannot (?:do g1|feed|make arc|probe) with zero feed rate
        Cannot make a NURBS with 0 feedrate
        Cannot feed with zero spindle speed in feed per rev mode
        Cannot probe with feed per rev mode
        Cannot use inverse time feed with canned cycles
        F word missing with inverse time (?:arc|g1) move
        Spindle not turning in [gG]\d
        Spindle turning (?:counter)?clockwise in G\d
        Chosen spindle \(\d+\) not turning in G76
        Cannot .* with cutter (?:radius )?comp(?:ensation)?(?: on| in effect)?$
        Cannot turn cutter radius comp on when on
        G\d+(?:\.\d)? cannot be used with cutter compensation enabled
        Cutter radius compensation allowed only in XY, XZ planes
        BUG: (?:Invalid|Unsupported) plane
        Cannot do an arc in planes G17\.1
        Splines must be in the XY plane
        G\d+(?:\.\d)? can only be used in XZ plane
        G\d+ with lathe tool, but plane is not G18
        G\d+\.1 with L word, but plane is not G18
        Cannot restore context from invalid stack frame
        M7x: restore_settings""",
    # Positions: arcs, compensated paths, cycles, splines, polar coordinates, contours.
    GEOMETRY: r"""
        Arc (?:radius|move|to)
        Radius to end of arc differs
        Zero-radius arc
        Current point same as end point of arc
        R i j k words all missing for arc
        Mixed radius ijk format for arc
        [IJK] word (?:given for arc|missing in absolute center arc|missing with g87)
        [XY] and [yz] words missing for arc
        (?:Length|Radius) of cutter compensation entry
        Straight (?:feed|traverse) in concave corner
        The move just after exiting cutter compensation
        Tool radius not less than arc radius with comp
        Zero degree inside corner
        BUG: cutter compensation has generated
        Bug in tool radius comp
        R clearance plane unspecified in cycle
        R less than [UVWxyz] in cycle
        [UVWXYZ] value unspecified in .* plane canned cycle
        Cannot do zero repeats of cycle
        Negative or zero q value used
        Q word missing with g[78]3
        Dwell time p word missing with g8
        Cannot put an? [UVWXYZ] in a canned cycle in the
        G1\d(?:\.1)? canned cycle is not possible
        In G76,
        Cannot move rotary axes with G76
        Invalid [DE]-number in G7
        Must specify (?:both|positive weight|angle)
        You must specify
        Can specify P without
        Splines may not have motion
        Cannot use G5\.3 without G5\.2 first
        Cannot use polar coordinates with G53
        (?:Incremental|G91) motion with polar coordinates
        Start point too close to probe point
        G7[Xx] error
        G7x\.x  requires a Q word
        G\d+ requires D word
        G\d+\.\d with no D word
        Bug code not g0 or g1""",
    # Tools, spindles, inputs and outputs, user M codes, what an INI or a component says.
    MACHINE: r"""
        Requested tool -?\d+ not found in the tool table
        Need tool prepared
        Need non-negative Q-word to specify tool number with M61
        Negative d word tool radius index used
        G10 L0 not allowed with loaded tool
        G10 L1 without offsets has no effect
        [IJ ]+ words not allowed with G10 L2
        R not allowed in G10 L20
        Q number in G10 is not an integer
        Invalid tool orientation
        G43\.2:
        Invalid spindle \(\$\) number
        Spindle \(\$\) number out of range
        Q word with M19 requires a value > 0
        No valid P word with M6
        invalid P-word with M66
        Need to have either a valid P or a valid E word with M66
        Invalid to select both a digital and an analog input
        Invalid analog index with M6
        (?:Digital|Analog) input selected out of bounds
        Zero timeout with wait type
        Can't select analog input with wait type
        Indexing axis
        Invalid absolute position
        Unknown m code used: M1\d\d$
        Queue is not empty after
        Named (?:hal|INI) parameter""",
}
_PATTERNS = {kind: re.compile("|".join("(?:%s)" % row.lstrip() for row in rows.split("\n") if row.strip()))
             for kind, rows in _MESSAGES.items()}
# Errors of the words by a mode; that of G53 also by a G91 on the line itself.
OF_WORDS_AND_MODES = ("Cannot use g53 incremental", "Cannot use polar coordinate except in G17 plane",
                      "Cannot read current position with cutter radius compensation on")
_COMMENT = re.compile(r"\([^)]*\)?|;.*")


def not_followed(message, text):
    """MODES, GEOMETRY or MACHINE for the message of a stop at the line `text`; None for one that owlint has to predict."""
    code = re.sub(r"\s", "", _COMMENT.sub("", text)).lower()
    if message in OF_WORDS_AND_MODES:
        return None if "g53" in message and re.search(r"g0*91(?![.\d])", code) else MODES
    # Under OWORD_WARNONLY warnings stand before the message.
    warned = re.match(r"\d+: (duplicate|undefined|no matching|not in a)", message)
    for kind, pattern in _PATTERNS.items():
        if pattern.search(message) if warned else pattern.match(message):
            return kind
    return None


def of_axes(message):
    """Whether an axis letter is refused that another machine has: for owlint to predict only where it knows the machine."""
    return re.match(r"Bad character '[uvw]' used", message) is not None


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
    return re.sub(varied, "…", message)
