"""Programs as CAM systems write them, for the benchmarks: a piece of some 40,000 lines, again and again. Each piece begins with a
move to a known place, so that arcs fit each time.

Each function of STYLES returns (lines at the beginning, lines of the piece, lines at the end).
"""
import math
import random

ARCS = 0.3  # of the lines, where a style has that many
LINES = 40_000  # of a piece


def place(rng, digits=4):
    return "X%.*f Y%.*f Z%.*f" % (digits, rng.uniform(0, 300), digits, rng.uniform(0, 200), digits, rng.uniform(-20, 5))


def straight():
    """Moves by G1, which one line in ten says."""
    rng = random.Random(1)
    return ["%", "G21 G90 F800"], [("G1 " if i % 10 == 0 else "") + place(rng) for i in range(LINES)], ["M2", "%"]


def numbered():
    head, piece, end = straight()
    return head, ["N%d G01 %s" % (10 + 10 * (i % 9999), line.removeprefix("G1 ")) for i, line in enumerate(piece)], end


def commented():
    """One line in ten is a comment, and one in ten ends with one."""
    head, piece, end = straight()
    piece = ["(pass %d of the pocket)" % i if i % 10 == 3 else line + " ; finish" if i % 20 == 7 else line + " (ramp)" if i % 20 == 17 else line
             for i, line in enumerate(piece)]
    return head, piece, end


def incremental():
    rng = random.Random(2)
    move = lambda: "X%.4f Y%.4f Z%.4f" % (rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-0.5, 0.5))
    return ["%", "G21 G91 F800"], [("G1 " if i % 10 == 0 else "") + move() for i in range(LINES)], ["M2", "%"]


class Path:
    """Straight moves and arcs from one place to the next; arcs by their center."""

    def __init__(self, rng, digits, share):
        self.rng, self.digits, self.share = rng, digits, share
        self.x, self.y = 50.0, 50.0

    def number(self, letter, value):
        text = "%.*f" % (self.digits, value)
        return letter + text

    def next(self):
        """-> the code, and the words"""
        rng = self.rng
        if rng.random() >= self.share:
            self.x, self.y = round(rng.uniform(0, 300), self.digits), round(rng.uniform(0, 200), self.digits)
            return 1, " ".join((self.number("X", self.x), self.number("Y", self.y)))
        radius, begin, turn = rng.uniform(0.5, 20), rng.uniform(0, 2 * math.pi), rng.uniform(0.3, 3)
        i, j = round(-radius * math.cos(begin), self.digits), round(-radius * math.sin(begin), self.digits)
        code = rng.choice((2, 3))
        end = math.atan2(-j, -i) + (turn if code == 3 else -turn)
        radius = math.hypot(i, j)
        center = self.x + i, self.y + j
        self.x, self.y = round(center[0] + radius * math.cos(end), self.digits), round(center[1] + radius * math.sin(end), self.digits)
        return code, " ".join((self.number("X", self.x), self.number("Y", self.y), self.number("I", i), self.number("J", j)))


def arcs():
    path = Path(random.Random(3), 4, ARCS)
    piece = ["G0 X50 Y50"]
    for _ in range(LINES):
        code, words = path.next()
        piece.append("G%d %s" % (code, words))
    return ["%", "G21 G90 G17 F800"], piece, ["M2", "%"]


def drilling():
    rng = random.Random(4)
    piece = []
    for i in range(LINES // 50):
        piece += ["G0 Z5", "G%d X%.3f Y%.3f Z-12.5 R2 F120%s" % (81 + 2 * (i % 2), rng.uniform(0, 300), rng.uniform(0, 200), " Q3" * (i % 2))]
        piece += ["X%.3f Y%.3f" % (rng.uniform(0, 300), rng.uniform(0, 200)) for _ in range(47)] + ["G80"]
    return ["%", "G21 G90 G98"], piece, ["M2", "%"]


def fusion():
    """As Fusion's post processor: a code only where it changes, no zeros behind the point, arcs, operations with a comment."""
    path = Path(random.Random(5), 3, 0.15)
    path.number = lambda letter, value: letter + (("%.3f" % value).rstrip("0").replace("-0.", "-.") or "0")
    piece, motion, number = [], None, 10
    for i in range(LINES):
        if i % 2000 == 0:
            piece += ["", "(2D Contour%d)" % (i // 2000), "N%d G0 X50. Y50." % number, "Z15.", "Z5.", "G1 Z-1.5 F333."]
            path.x, path.y, motion, number = 50.0, 50.0, 1, number + 10
        code, words = path.next()
        piece.append(words if code == motion and code == 1 else "G%d %s" % (code, words))
        motion = code
        if i % 100 == 99:
            piece[-1] += " F1000."
    head = ["%", "(1001)", "(T1 D=6. CR=0. - ZMIN=-1.5 - flat end mill)", "N5 G90 G94 G17 G91.1 G40 G49 G80", "G21", "T1 M6", "S12000 M3", "G54", "M8"]
    return head, piece, ["M9", "G0 Z15.", "M5", "M30", "%"]


def pcb2gcode():
    rng = random.Random(6)
    piece = []
    for i in range(LINES // 40):
        piece += ["G00 Z1.00000 ( retract )", "", "G00 X%.5f Y%.5f ( rapid move to begin. )" % (rng.uniform(0, 99), rng.uniform(0, 99)),
                  "F100.00000", "G01 Z-0.07000", "G04 P0 ( dwell for no time -- G64 should not smooth over this point )", "F200.00000"]
        piece += ["G01 X%.5f Y%.5f" % (rng.uniform(0, 99), rng.uniform(0, 99)) for _ in range(33)]
    head = ["( pcb2gcode )", "( Software-independent Gcode )", "", "G94 ( Millimeters per minute feed rate. )", "G21 ( Units == Millimeters. )",
            "G90 ( Absolute coordinates. )", "G00 S30000 ( RPM spindle speed. )", "G64 P0.00200 ( set maximum deviation from commanded toolpath )",
            "M3 ( Spindle on clockwise. )", "G04 P0 ( Wait for spindle to get up to speed )"]
    return head, piece, ["G04 P0", "M9 ( Coolant off. )", "M2 ( Program end. )"]


def freecad():
    """As FreeCAD's post processor: the code, the feed and every axis on each line, and blanks at its end."""
    rng = random.Random(7)
    path = Path(rng, 3, 0.1)
    piece = ["(begin operation: Profile)", "(machine units: mm/min)", "G0 X50.000 Y50.000 Z5.000", "G1 X50.000 Y50.000 Z-1.000 F300.000"]
    for i in range(LINES):
        code, words = path.next()
        piece.append("G%d %s%s F600.000 " % (code, words, "" if code > 1 else " Z%.3f" % -1))
    piece += ["G0 Z5.000 ", "(finish operation: Profile)"]
    head = ["(Exported by FreeCAD)", "(Post Processor: linuxcnc_post)", "(begin preamble)", "G17 G54 G40 G49 G80 G90 G94", "G21", "M6 T1", "G43 H1", "M3 S10000"]
    return head, piece, ["(begin postamble)", "M05", "G17 G54 G90 G80 G40", "M2"]


STYLES = {"straight": straight, "numbered": numbered, "commented": commented, "incremental": incremental, "arcs": arcs, "drilling": drilling,
          "fusion": fusion, "pcb2gcode": pcb2gcode, "freecad": freecad}


def program(style, mebibytes, line_end="\n"):
    """Yields the text of a program in large pieces."""
    head, piece, end = ("".join(line + line_end for line in lines) for lines in STYLES[style]())
    yield head
    for _ in range((mebibytes << 20) // len(piece) + 1):
        yield piece
    yield end
