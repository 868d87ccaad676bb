"""The lines of random programs in which modes decide: set on some paths, in callers and in callees, and used behind them.

Geometry never decides: arcs are full circles about a far centre, or have words that no plane takes; axis words are never
positive, so that no cycle begins below its end; compensation has no radius, but on the one straight path that brings all it
needs; and nothing asks the tool table but for tool 0.
"""
from maker import CONDITIONAL, Line, Maker

AXES = "X-1 Y-1 Z-1"

# For each subject: lines that set modes, lines that need some, and lines whose words are faulty in some modes or in all.
SUBJECTS = {
    "feed": (
        "F100|F100|F{v}|G94 F100|G94|G95|G93|G95 F.5|G94 F{v}|G93 F2|S100|S{v}|G20|G21|G20 F10|G93 G0 X{n}|M3 S{v}|G95 F.1 S100|G21 F{v}",
        "G1 X{n}|G1 X{n}|G1 X{n} F{v}|G1 Y{n} F50|G1|G1 F2|X{n}|X{n} F5|G2 I100|G3 I100 F{v}|G2 I100 J100 F9|G38.3 Z{n}|G38.5 Z{n} F20|"
        "G5.1 X{n} Y-1 I1 J1|G5 X{n} Y-1 I0 J0 P1 Q1 F3|G5.2 X{n} Y-1 P1 L3|G81 {a} R1|G53 G1 X{n}|G1 X{n} M2|G81 {a} R1 F5",
        "G95 F0 S0|F0|G94 F0|G1 F0|S0|G2 I100 F0"),
    "spindle": (
        "M3|M3|M4|M3 S100|M4 S{v}|M5|M19 R0|S100|S{v}|T0 M6|G96 S100|G96 S{v} D200|G97|G97 S50|M3 $0|M5 $-1|G95 F.1|G94 F100|M4 $-1 S10|M3 F20",
        "G33 Z{n} K1|G33 Z{n} K1|G33.1 Z{n} K1|G33 Z{n} K1 M3|Z{n} K1|G76 P1 Z-1 I-.1 J.01 K.05|G74 {a} R1|G84 {a} R1|G86 {a} R1 P1|"
        "G87 {a} R1 I1 J1 K-.5|G88 {a} R1 P1|G1 X{n}|G95 F.2 G1 X{n}|G84 {a} R1 M3|G74 {a} R1 M4|G88 {a} R1 P0 F9 M4",
        "G96|G33 Z{n}|G33 Z{n} F5 K1|M19|M5|S0 G96|G33 K1|Z{n} K1"),
    "plane": (
        "G17|G18|G19|G18 G0 X{n}|G17 G1 Y{n}|G19 G40|G17.1|G17|G2 I100|F100|G40",
        "G2 I100|G3 J100 K100|G3 K100|G2 I100 J100|G2 I100 K100|G3 J100 K100 P2|I100|J100|K100|G41|G42|G41.1 D0 L1|G5.1 X{n} Y-1 I1 J1|"
        "G5 X{n} Y-1 I0 J0 P1 Q1|G81 {a} R1|G0 @5 ^30|G1 @5 ^30|G18 G2 I100 K100|G17 G3 J100|G0 @5 Z{n} ^30|G70 Q900|G71.1 Q900",
        "G81 X-1 Z-1 R1|G82 Y-1 Z-2 R1 P0|G72 D1|G2 I100 J100 K100|G18.1|G70"),
    "arcs": (
        "G17|G18|G19|G90.1|G91.1|G20|G21|G0|G1|G2 I100|G3 I100 J100|G93|G94 F100|G90.1 G18|F100|G17 G91.1",
        "G2 I100 J100|G2 I100|G3 J100|G3 I100 K100|G2 J100 K100|I100 J100|I100|J100 K100|G2 I100 P2|I100 J100 F5|G3 I100 J100 F{v}|G0 X{n}|G17.1",
        "G2|G3 X{n}|G2 R5|G3 R5 A{n}|G2 I100 R5|G3 I100 J100 K100|X{n}|R5|G2 X{n} R5 I100|G2 A-1|G2 Z{n} R5 J1"),
    "compensation": (
        "G40|G40|G40|G41|G42|G41 D0|G42 D0|G41.1 D0|G41.1 D0 L2|G42.1 D0 L1|G40 G18|G40 G19|G40 M5|G40 G17|G20|G91|M3 S100|F100|G40 G55|G90.1|G40 G54",
        "G17|G18|G19|G43|G49|G43.1 Z{n}|G54|G55|G59.3|G61|G64 P.1|G98|G99|G10 L2 P1 X0|G10 L2 P2 X1|G10 L2 P0 X0|G10 L20 P1 X0|G28|G30|G28.1|G30.1|"
        "G52 X1|G92 X0|G92.1|G92.3|G53 G0 X{n}|G38.3 Z{n}|G5.1 X{n} Y-1 I1 J1|G5 X{n} Y-1 I0 J0 P1 Q1|G81 {a} R1|G76 P1 Z-1 I-.1 J.01 K.05|"
        "G33 Z{n} K1|G72.1 Q900|T0 M6|M62 P1|M63 P2|M64 P1|M65 P1|M66 P0 L0|M66 E0 L0|M67 E0 Q1|M68 E0 Q1|M48|M49|M50 P0|M50|M52 P1|M53 P0|"
        "#6=#5420|G0 X[#5421*0]|G1 X{n}|G2 I100|G40 G28|T0|M61 Q0|G70 Q900|G5.2 X{n} Y-2 P1|G42|G41",
        "G41 D.5|G42.1|G17.1|G18.1 G41|G42.1 D0 L1|M51"),
    "saved": (
        "M70|M70|M70|M73|M70 F5|M70 G93|M73 S5|G96 S100|G97|G96 S{v}|G41|G40|G55|G54|G18|G17|M49|M48|M50 P0|M3|M5|M4|F100|F{v}|G93|G94|G95|G94 F50|"
        "G20|G21|G91|G90|G98|G43.1 Z{n}|G49|G61|S100|S{v}|G90.1|G7|M8|M53 P1|G19|G0 X{n}",
        "M72|M72 G1 X{n}|G33 Z{n} K1|G1 X{n}|G2 I100|G2 J100 K100|G53 G0 X{n}|G43|G81 {a} R1|X{n}|G1 X{n} F5|G18|G55|M71 G1 X{n}|"
        "G76 P1 Z-1 I-.1 J.01 K.05|M72 G80",
        "M71|M72 M2|M72|M71|G97 S0"),
    "cycles": (
        "F100|G80|G98|G99|G91|G90|G17|G18|M3 S50|M4|G94 F100|G0 X{n}|G81 {a} R1|G82 {a} R1 P0|G20|G89 {a} R1 P1|G83 {a} R1 Q.5|G81 {a} R1|G73 {a} R1 Q1|G86 {a} R1 P0",
        "X{n}|X{n} Y-2|Z{n}|Y{n} L2|G81 X{n}|G81 X{n}|G82 X{n}|G83 X{n}|G89 X{n}|G73 X{n} R1|G73 {a} R1 Q.5|G83 Y{n} Q.4|G85 {a} R1|G85 Z{n} R2|G86 X{n}|"
        "G87 {a} R1 I1 J1 K-.5|G84 {a} R1|G74 {a} R1|G81 {a} R1 F5|X{n} G98|G88 Y{n} P1|G81 L2|G1 X{n}",
        "G81 Y-3 R1|G81 {a}|G81 {a} R1 L0|G82 {a} R1|G83 {a} R1|G73 {a} R1 Q0|G89 {a} R1|G86 {a} R1|G88 {a} R1|G87 {a} R1 I1|X{n} L0|G93|G95 F.5|G87 X{n}|G84 X{n}|G19|G21|M5"),
    "coordinates": (
        "G90|G91|G90|G54|G55|G59.1|G92 X0|G92.1|G52 X1|G43.1 Z{n}|G49|G10 L2 P2 X1|G10 L20 P1 X0|G28.1|G20|G7|G8|G0|G1 F50|M61 Q0|G10 L0 P1|G28 X{n}|F50",
        "G53 G0 X{n}|G53 G1 X{n}|G53 X{n}|G53 G90 G0 X{n}|G53 G1 Y{n} F10|G28|G30 X{n}|X{n}|G28.1 X{n}|G92.2 Y{n}|A{n}|G52 X1 G92.1|G43.1 X0|G10 L2 P{v} X0",
        "G53 G91 X{n}|G53 G2 I100|G52|G92|M61|G10 L2 P1 I1 X0|G10 L20 P1 R5 X0|G43.2 Z1|G80 X{n}|G43.2|G10 L3 P1|G80|G10 L2 P7.2"),
    "splines": (
        "F100|G94 F{v}|G93|G95 F.1|G17|G18|G91|G0|G1 X{n}|G0 X{n}|G5.1 X{n} Y-1 I1 J1 F9|G41|G40|G20|F100|G17",
        "G5 X{n} Y-1 I0 J0 P1 Q1|G5 X{n} Y-1 P1 Q1 I1 J1|G5.1 X{n} Y-1 I1 J1|X{n}|X{n} Y-3|P1|X{n} Y-1 P1|G1 X{n}",
        "G5 X{n} Y-1 P1 Q1 I1|G5 X{n} Y-1 I0 J0|G5 X{n} Y-1 Z-1 I0 J0 P1 Q1|G5 X{n} Y-1 I0 J0 P1|G5.1 X{n} Y-2 I1|G5.1 X{n} I1 J1 A-1|G5.3|G80|G5.3"),
    "threads": (
        "M3|M4|M3 S100|G17|G18|G19|G0 X{n}|G33 Z{n} K1|M5|F100|G40|G91|M3 F10|G41|G76 P1 Z-1 I-.1 J.01 K.05",
        "G76 P1 Z-1 I-.1 J.01 K.05|G33 Z{n} K1|G33.1 Z{n} K1|Z{n} K1|X{n}|G33.1 Z{n} K1 M5|G33 X{n} K1 M4 S5|G76 P1 Z-1 I-.1 J.01 K.05 R1",
        "G76 P1 Z-1 I0 J.01 K.05|G76 P1 Z-1 I-.1 J0 K.05|G76 P1 Z-1 I-.1 J.1 K.05|G76 Z-1 I-.1 J.01 K.05|G76 P1 Z-1|G33 Z{n} F5 K1|G33 Z{n}|Z{n}|G33 K1|G80"),
    "lines": (
        "F100|M3 S100|G0 X{n}|M48|M49|M64 P1|M66 P0 L0|M67 E0 Q1|M62 P0|M8|M7|G4 P0|M9|M1|M60|G64 P.1|G61|T0|M6|M19 R5 P1",
        "G1 X{n}|X{n}|M65 P1 X{n}|M67 E0 X{n}|G43|G98|M66 E0 X{n}|G33 Z{n} K1|M6 G1 X{n}",
        "M62|M63|M64|M65|M66|M66 P1 E1|M66 P0 L1|M66 E0 L1 Q1|M67 Q1|M68 E-2 Q1|M61 Q-1|M19 R5 Q-2|M66 P0 L2 Q0|G4|M61|G43.2 H0 Z1|G10 L20 P0 I1"),
}
# What belongs together, one line after the other.
NURBS = ("G5.2 X-1 Y-1 P1 L3", "X-2 Y-3 P1", "X-4 Y-1 P1", "G5.3")
STRAIGHT = ("G91", "G41.1 D.1", "G1 X-5", "X-5", "G40", "G90")
# What is in effect when it is saved, and before it is restored.
RESTORED = (("G96 S100", "G97"), ("G96 S50", "G97"), ("G41", "G40"), ("G40", "G41 D0"), ("G54", "G55"), ("G49", "G43.1 Z-1"), ("G61", "G64"),
            ("G98", "G99"), ("M48", "M49"), ("M50 P1", "M50 P0"), ("M53 P0", "M53 P1"), ("G17", "G18"), ("G18", "G17"), ("G20", "G21"),
            ("G90", "G91"), ("G93", "G94"), ("G94 F100", "G95"), ("F100", "F0"), ("F100", "G93"), ("M3", "M5"), ("M5", "M4"), ("S100", "S0"),
            ("G8", "G7"), ("M8", "M9"), ("G91.1", "G90.1"), ("M3 S100", "T0 M6"), ("G42.1 D0", "G40"))
BETWEEN = ("G43", "T0 M6", "G54", "G18", "G53 G0 X-50", "M64 P1", "G98", "M8", "G19", "G42", "G28", "G61", "#6=[#5+1]", "M3", "G81 X-1 Y-1 Z-1 R1")
BEGIN = ("G21 G90 G17 G94", "G94 F100", "M3 S100", "M3", "G90 G54 G40 G80 G49", "G0 X0 Y0", "S100 F100 M4 G0", "G18 F10", "G0 X-1 M3 S9")
CONTOUR = ("G1 X10 Z-5", "G1 X20 Z-20")


class ModeMaker(Maker):
    """Programs in which lines set modes and others need them."""

    def __init__(self, rng):
        super().__init__(rng)
        self.reuse = 0.0
        self.subjects = rng.sample(list(SUBJECTS), rng.choice((1, 1, 2, 2, 3)))
        self.needy = rng.choice((0.25, 0.35, 0.45))    # of the lines, how many need modes
        self.polar = rng.random() < 0.3              # at the origin it only goes in G90
        self.nurbs = rng.random() < 0.5              # whole curves, or single points
        self.numbers = rng.random() < 0.5
        self.together = []                           # lines of groups, but for the first of each

    def words(self):
        """One line of words."""
        rng = self.rng
        sort = 0 if rng.random() >= self.needy else 1 if rng.random() < 0.85 else 2
        line = rng.choice(SUBJECTS[rng.choice(self.subjects)][sort].split("|"))
        if "@" in line and not self.polar or "G91" in line.split() and self.polar:
            return "G0 X0"
        if "G5.2" in line and self.nurbs or line == "G5.3" and not self.nurbs:
            return "G1 X-1"
        return line.format(n=-rng.randrange(9), v=self.value(), a=AXES)

    def value(self):
        return self.rng.choice(("0", "100", "#5", "#7", "[#5+1]", "[#7*10]")) if self.numbers else self.rng.choice(("0", "50", "7.5"))

    def spelt(self, line):
        rng = self.rng
        kind = rng.random()
        if kind < 0.06:
            line = line.lower()
        elif kind < 0.1:
            line = line.replace(" ", "")
        elif kind < 0.16:
            some = line.split()
            rng.shuffle(some)
            line = " ".join(some)
        return ("/" if rng.random() < 0.02 else "") + line + (" (x)" if rng.random() < 0.03 else "")

    def plain(self):
        rng = self.rng
        kind = rng.random()
        if kind < 0.06:
            return Line(plain="#99=[#99+1]")
        if kind < 0.12 and self.numbers:
            name = rng.choice(("#5", "#7"))
            return Line(plain="%s=%s" % (name, rng.choice(("0", "1", "[%s+1]" % name, self.values.fresh(1000)))))
        return Line(plain=self.spelt(self.words()))

    def some(self, line=None):
        """A plain line, often in a block of its own: what stops there does not hide all that follows."""
        line = line or self.plain()
        if self.rng.random() < 0.75:
            return [line]
        label = self.label()
        return [Line(label, "if", self.values.condition()), line, Line(label, "endif")]

    def group(self):
        """Lines that belong together, now and then with one between them."""
        rng = self.rng
        if "saved" in self.subjects and rng.random() < 0.8:
            return self.saved()
        if "splines" in self.subjects and self.nurbs and rng.random() < 0.6:
            return self.unbroken(NURBS)
        lines = list(STRAIGHT)
        if self.polar:
            return []
        if rng.random() < 0.4:
            lines.insert(rng.randrange(3, 5), rng.choice(BETWEEN))
        if rng.random() < 0.5:
            lines += rng.choice((["G2 I100"], ["G0 X-1", "G2 I100"], ["G81 X-1 Y-1 Z-1 R1", "G2 I100"], ["G3 I100 J100"]))
        return self.unbroken(lines)

    def unbroken(self, lines):
        """Lines between which no call is put."""
        lines = [Line(plain=line) for line in lines]
        self.together += lines[1:]
        return lines

    def saved(self):
        """Modes that are saved, changed and restored, each of it on some paths."""
        rng = self.rng
        pairs = [(before, after) for before, after in rng.sample(RESTORED, rng.choice((1, 2, 2, 3))) if not (self.polar and after == "G91")]
        lines = [before for before, _ in pairs if rng.random() < 0.7]
        lines += ["M70"] + [after for _, after in pairs] + [rng.choice(("M72", "M72", "M72 G0 X-1", "G80 M72"))]
        lines += rng.choice(([], ["G1 X-1"], ["G33 Z-1 K1"], ["G2 I100"], ["G53 G0 X-1"], ["X-1"], ["G1 X-1 F5"]))
        return sum((self.some(Line(plain=line)) if line != "M70" else [Line(plain=line)] for line in lines), [])

    def argument(self, keyword):
        rng = self.rng
        if self.numbers and keyword in CONDITIONAL and keyword not in ("while", "repeat") and rng.random() < 0.2:
            return rng.choice(("[#5 EQ 0]", "[#7 GT 0]", "[#5 LT 2]", "[#5 EQ #7]"))
        return super().argument(keyword)

    def block(self, room, depth, loops, in_sub):
        """More plain lines; the unknown values of a loop or a sub are others each time it runs."""
        rng = self.rng
        lines = [Line(plain="#99=[#99+1]")] if depth else []
        for line in super().block(room, depth, loops, in_sub):
            lines.append(line)
            while rng.random() < 0.45:
                lines += self.some()
        chance = 0.35 if "saved" in self.subjects else 0.15 if {"splines", "compensation"} & set(self.subjects) else 0.02
        if rng.random() < chance:
            lines += self.group()
        return lines

    def definition(self, label, room):
        lines = super().definition(label, room)
        if "saved" in self.subjects and self.rng.random() < 0.6:
            lines.insert(1, Line(plain="M73"))
            # At a return it could not be told where it restores.
            lines = [line for line in lines if line.keyword != "return"]
        return lines

    def sound(self):
        """A program whose subs are called."""
        rng = self.rng
        size = rng.randint(8, 34)
        labels = [self.label() for _ in range(rng.choice((0, 1, 1, 2, 2, 3)))]
        share = size // (len(labels) + 1)
        definitions, self.subs = [], []
        for label in labels:
            definitions.append(self.definition(label, share))
            self.subs.append(label)         # for those behind it: none calls itself
        body = []
        while len(body) < share:
            body += self.block(share, 0, [], None)
        for label in labels:
            for _ in range(rng.choice((0, 1, 1, 1, 2))):
                places = [at for at, line in enumerate(body) if not any(line is one for one in self.together)]
                body.insert(rng.choice(places), self.oword(label, "call"))
        if rng.random() < 0.97:
            body.append(Line(plain=rng.choice(("M2", "M2", "M30"))))
        if rng.random() < 0.05:
            return self.begun(body + sum(definitions, []))
        return self.begun(sum(definitions, []) + body)

    def fanuc(self):
        return self.begun(super().fanuc())

    def begun(self, lines):
        """With what most programs begin with, and the subs that lines ask for."""
        rng = self.rng
        first = 1 if lines[0].plain == "%" else 0
        begin = [Line(plain="(run before) #5=%d #7=%d" % (rng.choice((0, 1)), rng.choice((0, 1, 2))))] if self.numbers else []
        begin += [Line(plain=line) for line in rng.sample(BEGIN, rng.choice((0, 1, 2, 2, 3)))]
        begin += [Line(plain=line) for line, chance in (("F100", 0.55), ("G0 X0 Y0", 0.5)) if rng.random() < chance]
        if any("900" in line.plain for line in lines):
            begin[0:0] = [Line(900, "sub")] + [Line(plain=line) for line in CONTOUR] + [Line(900, "endsub")]
        lines[first:first] = begin
        return lines
