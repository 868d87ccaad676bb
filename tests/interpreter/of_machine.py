"""Which stops the machine decides and the program does not: for what its tool table holds, or for axes that others have.

This is the one list of them.  slipped.py, words.py and probes.py count a stop with such a message, and take any other that
owlint does not predict for a miss.
"""
import re

MACHINE = "machine"

# Which tools there are, and which one is in the spindle.
_OF_TABLE = re.compile(r"Requested tool -?\d+ not found in the tool table|G\d+ with lathe tool, but plane|G10 L0 not allowed with loaded tool")
# What compensation with a radius stops, and not without one: the tool table decides where the line gives no diameter itself.
_OF_RADIUS = re.compile(
    r"The move just after exiting cutter compensation|Cannot use g53 with cutter radius comp|Cannot use G76 threading cycle with|"
    r"(Length|Radius) of cutter compensation entry|Arc move in concave corner|Straight (feed|traverse) in concave corner|"
    r"Tool radius not less than arc radius|Zero degree inside corner|Bug code not g0 or g1|BUG: (Invalid|Unsupported) plane")
# `G41 D1` and `G42` alone: `G41.1 D5` says its diameter.
_ASKS_TABLE = re.compile(r"(?i)g\s*0*4\s*[12](?![\s\d]*\.)")
_COMMENT = re.compile(r"\([^)]*\)?|;.*")


def decides(message, everything, axes_known):
    """Whether the machine does.  `everything`: the program with its files.  `axes_known`: owlint was given the axes."""
    if _OF_TABLE.match(message):
        return True
    # Axes that another machine has.
    if re.match(r"Bad character '[uvw]' used", message):
        return not axes_known
    return _OF_RADIUS.match(message) is not None and _ASKS_TABLE.search(_COMMENT.sub("", everything)) is not None


def general(message):
    """The message without what differs between programs."""
    varied = r"'[^']*'|(?<![\w.])-?\d+(?:\.\d+)?(?![\w.])|<[^>]*>|#\S+|file:\S+|(?<=used: M)\d+|(?<=199: M)\d+"
    return re.sub(varied, "…", re.sub(r"(?<=arc: start=).*|(?<=to start: start=).*", "…", message))
