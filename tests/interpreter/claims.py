"""What owlint's findings say about how a program ends, held against how it ended in rs274."""
import re

from messages import same_words

CRASHES = frozenset({"OW503", "OW505"})
ENDLESS = frozenset({"OW504", "OW508", "OW510"})


_CONTOUR = re.compile(r"(?i)g\s*0*7\s*[0-2](?!\d)")
_DELETED = re.compile(r"^[ \t]*/", re.MULTILINE)


def settings(text):
    """Of block delete, those with which this program is run."""
    return (False, True) if _DELETED.search(text) else (False,)


def said_by(finding):
    """The finding, what follows from the same mistake, and the other places that it stands for, as claims."""
    yield finding
    yield from finding.get("consequences", [])
    for place in finding.get("related", ()) if finding["code"] == "OW208" else ():
        if place["message"] == "here as well":
            line = place["start"]["line"]
            yield {**finding, "start": place["start"], "interpreter": re.sub(r"from line: \d+", "from line: %d" % line, finding.get("interpreter", ""))}

# What LinuxCNC does with an INI before it has an interpreter, or without one: machines.py holds it against LinuxCNC itself.
OF_LINUXCNC = frozenset(("OW412", "OW414", "OW415", "OW419", "OW421", "OW422", "OW424", "OW907"))


def loses_contour(finding):
    """Whether it says of a lathe contour that the interpreter crashes or never ends: for that there is no message."""
    return finding["code"] == "OW908" and not finding.get("interpreter")


class Claims:
    """What owlint's findings say about how a program ends, with that setting of block delete."""

    def __init__(self, findings, block_delete=False, text=""):
        self.contours = {number for number, line in enumerate(text.split("\n"), 1) if _CONTOUR.search(line)}
        met = [f for f in findings if f["reach"] != "never" and f["code"] not in OF_LINUXCNC and f.get("block_delete", "on" if block_delete else "off") == ("on" if block_delete else "off")]
        self.stops = [f for f in met if f["stops"] and f["code"] not in ENDLESS | CRASHES and not loses_contour(f)]
        self.crashes = [f for f in met if (f["code"] in CRASHES or loses_contour(f)) and f["stops"]]
        self.endless = [f for f in met if f["code"] in ENDLESS or loses_contour(f)]
        self.foreign = any(f["code"] == "OW319" for f in met)  # for another controller: it stops, and nobody is told where
        self.always = [f for f in self.stops + self.crashes if f["reach"] == "always" and f["severity"] == "error"]
        # Errors of reading contradict a run to the end even where they stop only once another mistake is gone.
        self.errors = [f for f in met if f["reach"] == "always" and f["severity"] == "error" and f["code"].startswith(("OW3", "OW7"))]

    @property
    def quoted(self):
        return [f.get("interpreter", "") for f in self.stops]

    def stop_at(self, outcome):
        """The finding that claims this error, or None."""
        for f in self.stops:
            for claim in said_by(f):
                if same_words(outcome.message, claim.get("interpreter", "")) and (not outcome.line or self._fits(outcome, claim["start"]["line"])):
                    return f
        return None

    def _fits(self, outcome, line):
        """Whether the finding is on the line of the message. Where the message names its file, the finding may be at the
        cause, as the call from which one runs into a definition. A contour is cut once its sub has been read: the interpreter
        then shows the end of the sub, owlint the line with G70 to G72."""
        return (line == outcome.line or outcome.message.startswith("File:") or "levels" in outcome.message or "nesting of remapped" in outcome.message
                or line in self.contours)


def judge(outcome, claims):
    """What owlint says wrongly about this outcome."""
    if outcome.kind == "error" and not claims.foreign and not claims.stop_at(outcome):
        at = " on line %d" % outcome.line if outcome.line else ""
        yield "the interpreter stops%s (%s), owlint claims %s" % (at, outcome.message, claims.quoted or "no stop")
    if outcome.kind == "crash" and not any(f["start"]["line"] == outcome.line or not outcome.line for f in claims.crashes):
        yield "the interpreter crashes on line %d (%s), without OW503 there" % (outcome.line, outcome.message)
    if outcome.kind == "hang" and not claims.endless:
        yield "the interpreter never ends, without OW504, OW508 or OW510"
    if outcome.kind == "ok" and claims.foreign:
        yield "OW319 says that it is for another controller, but it runs"
    if outcome.kind == "ok":
        for f in claims.always:
            yield "%s on line %d is claimed for every run, but the program ends" % (f["code"], f["start"]["line"])
