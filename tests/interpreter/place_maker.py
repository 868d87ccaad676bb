"""The lines of random programs in which it matters where the machine stands: it is moved on some paths, in callers and in callees, and
arcs, cycles, polar words and probes come behind.

Lines are drawn (place_lines.py) for where the machine would be if the text were run from the first line to the last. Modes that decide by
themselves stay out of it: there always are a feed and a turning spindle, and no compensation. Behind a probe all axes are named: where it
ends, only the machine knows.
"""
from contour_lines import Contour
from maker import CLOSERS, Line
from mode_maker import ModeMaker
from nominal import AXES, Nominal
from place_lines import OFF, PlaceLines


class PlaceMaker(ModeMaker):
    def __init__(self, rng):
        super().__init__(rng)
        self.lines = PlaceLines(rng)
        self.ends = {}              # by sub: where it begins and ends
        self.families = []          # subs with two arguments: the place of an arc, and its radius
        self.contours = []          # subs of lathe contours: (label, Contour)
        self.numbers = False

    @property
    def near(self):
        return self.lines.near

    @near.setter
    def near(self, near):
        self.lines.near = near

    # -- what is around the lines

    def plain(self):
        if self.rng.random() < 0.08:
            return Line(plain="#99=[#99+1]")
        return Line(plain=self.spelt(self.lines.words()))

    def some(self):
        """A line, or a probe with one behind it, now and then in a block of its own."""
        rng, before = self.rng, self.near.copy()
        if "probes" in self.lines.subjects and rng.random() < 0.25:
            lines = self.unbroken([self.lines.probe(), self.lines.everywhere()])
        else:
            lines = [self.plain()]
        if rng.random() < 0.8:
            return lines
        if rng.random() < 0.5:
            self.near = before
        label = self.label()
        return [Line(label, "if", self.values.condition()), *lines, Line(label, "endif")]

    def group(self):
        rng = self.rng
        kind = rng.random()
        if self.contours and rng.random() < 0.5:
            return self.contour_cut()
        if kind < 0.4:
            return self.counted()
        return self.family_call() if self.families and kind < 0.75 else self.passes()

    def counted(self):
        """A loop over arcs that are farther off from pass to pass."""
        rng, label = self.rng, self.label()
        near = self.near
        step = rng.choice((0, 0.5, 0.99, 1.01, 2, 20)) * near.may_differ(5) / rng.choice((1, 2, 3)) / 2
        arc = rng.choice(("G2 X[#8*10+10] Y0 I[5+#8*{d}] J0", "G3 X10 Y[#8*{d}*2] I5 J0", "G2 X[10+#8*2*{d}] Y0 R5", "G2 X10 Y0 R[5-#8*{d}/10]"))
        body = ["G17 G90 G91.1 G0 X%s Y0" % ("[#8*10]" if "10+10" in arc else "0"), arc.format(d=near.text(step))]
        near.plane, near.incremental, near.centers_absolute, near.motion = 17, False, False, 2
        near.go({"X": 10.0, "Y": 0.0})
        lines = [Line(plain="#8=0"), Line(label, "while", "[#8 LT %d]" % rng.choice((1, 2, 3, 5)))]
        return lines + [Line(plain=line) for line in [*body, "#8=[#8+1]"]] + [Line(label, "endwhile")]

    def passes(self):
        """A loop that goes a little farther each time; behind it, or in it, an arc that is right after some number of them."""
        rng, near, label = self.rng, self.near, self.label()
        count, right = rng.choice((1, 2, 3)), rng.choice((1, 2, 3))
        by = rng.choice((1, 2, 0.1, 0.001))
        near.plane, near.incremental, near.centers_absolute = 17, False, False
        near.go({"X": by * right, "Y": 0.0})
        arc = self.lines.arc()
        lines = [Line(plain="G17 G91.1 G90 G0 X0 Y0"), Line(label, "repeat", "[%d]" % count)]
        lines.append(Line(plain="G91 G1 X%s" % near.text(by)))
        inside = rng.random() < 0.3
        return lines + [Line(plain="G90 " + arc)] * inside + [Line(label, "endrepeat")] + [Line(plain="G90 " + arc)] * (not inside)

    def contour(self, label):
        """The sub of a lathe contour."""
        contour = Contour(self.rng)
        self.contours.append((label, contour))
        return [Line(label, "sub")] + [Line(plain=line) for line in contour.lines] + [Line(label, "endsub")]

    def contour_cut(self):
        """Cuts along one, from its start or, now and then, from wherever the machine is."""
        rng, near = self.rng, self.near
        label, contour = rng.choice(self.contours)
        z, x = contour.start
        begin = "G90 G21 G91.1 G18 G0 X%s Z%s" % (near.text(x), near.text(z))
        near.incremental = near.centers_absolute = near.inch = near.diameter = False
        near.plane, near.motion = 17, 0
        near.go({"X": 0.0, "Y": 0.0, "Z": 0.0})
        lines = [begin] if rng.random() < 0.9 else ["G18"]
        lines += [contour.cut(label), "G17 G90 G0 X0 Y0 Z0"]
        return [Line(plain=line) for line in lines]

    def family(self, label):
        """A sub with an arc at its first argument, of the size of its second."""
        body = self.rng.choice((
            ("G2 X[#1+#2*2] Y0 I[#2]",), ("G2 X[#1+#2*2] I#2", "G0 X#1", "G3 X[#1-#2*2] I[0-#2]"), ("G3 X[#1+#2*2] R[#2]",),
            ("G0 Y#1", "G2 Y[#1+#2] J[#2/2]"), ("G1 X[#1]", "G2 X[#1+10] I5"), ("G81 X#1 Z#2 R1", "X[#1+5]"), ("G90.1 G2 X[#1+#2*2] I[#1+#2] J0 ", "G91.1")))
        self.families.append(label)
        return [Line(label, "sub")] + [Line(plain=line) for line in body] + [Line(label, "endsub")]

    def of_family(self):
        """Arguments for where the machine stands, or nearly."""
        rng, near = self.rng, self.near
        at, size = near.at["X"], rng.choice((1, 5, 2.5))
        off = rng.choice(OFF) * near.may_differ(size) * rng.choice((1, -1))
        near.motion = 2
        return "[%s] [%s]" % (near.text(at + off), near.text(size))

    def family_call(self):
        rng, near = self.rng, self.near
        near.incremental = near.diameter = False
        near.plane = 17
        near.go({"X": float(rng.choice((0, 5, 10))), "Y": 0.0})
        move = "G90 G17 G0 X%s Y0 Z1" % near.text(near.at["X"])
        call = self.oword(rng.choice(self.families), "call")
        return [Line(plain=move), call] if rng.random() < 0.8 else [call]

    def choice(self, room, depth, loops, in_sub):
        """Each arm from where the branch is met; behind it, from the end of one of them."""
        before, ends, lines = self.near.copy(), [], []
        label = self.label()
        keywords = ["if"] + ["elseif"] * (self.rng.random() < 0.25) + ["else"] * (self.rng.random() < 0.5)
        for keyword in keywords:
            self.near = before.copy()
            lines += [self.oword(label, keyword)] + self.block(room // 3, depth + 1, loops, in_sub)
            ends.append(self.near)
        self.near = self.rng.choice(ends if "else" in keywords else [*ends, before])
        return lines + [Line(label, "endif")]

    def loop(self, room, depth, loops, in_sub):
        label, before = self.label(), self.near.copy()
        opener = self.rng.choice(("while", "do", "repeat", "repeat"))
        body = self.block(room, depth + 1, loops + [label] if opener != "repeat" else loops, in_sub)
        if opener != "do" and self.rng.random() < 0.3:
            self.near = before
        return [self.oword(label, opener)] + body + [self.oword(label, CLOSERS[opener])]

    def oword(self, label, keyword):
        if keyword == "call" and label in self.families:
            return Line(label, "call", self.of_family())
        if keyword == "call" and label in self.ends and self.rng.random() < 0.8:
            self.near = self.ends[label][1].copy()
        return super().oword(label, keyword)

    def argument(self, keyword):
        # What is passed by chance is not known; and after more passes than are tried it would stand elsewhere.
        if keyword == "repeat":
            return "[%d]" % self.rng.choice((0, 1, 2, 2, 3))
        return "" if keyword == "call" else super().argument(keyword)

    def block(self, room, depth, loops, in_sub):
        lines = []
        inner = super(ModeMaker, self).block(room, depth, loops, in_sub)
        for line, behind in zip(inner, [*inner[1:], None]):
            if line.keyword == "call" and line.label in self.ends and self.rng.random() < 0.6:
                lines.append(Line(plain=self.to(self.ends[line.label][0])))
            lines.append(line)
            unbroken = any(behind is one for one in self.together)
            while not unbroken and self.rng.random() < 0.5:
                lines += self.some()
        if self.rng.random() < 0.15:
            lines += self.group()
        return [Line(plain="#99=[#99+1]")] * bool(depth) + lines

    def to(self, place):
        return "G90 G0 " + " ".join("%s%s" % (axis, self.near.text(place.at[axis])) for axis in AXES)

    def definition(self, label, room):
        rng = self.rng
        if rng.random() < 0.25:
            return self.family(label)
        if rng.random() < 0.3:
            return self.contour(label)
        self.near = Nominal()
        self.near.at = {axis: float(rng.choice((0, 0, 1, 5, 10))) for axis in AXES}
        begins = self.near.copy()
        lines = super(ModeMaker, self).definition(label, room)
        self.ends[label] = begins, self.near
        self.near = Nominal()
        return lines

    def sound(self):
        self.numbers = "values" in self.lines.subjects    # what is set first may decide
        return super().sound()

    def begun(self, lines):
        rng = self.rng
        begin = [Line(plain="F1000 S100 M3")]
        if self.rng.random() < 0.85:
            begin.append(Line(plain=rng.choice(("G90 G17 G21 G0 X0 Y0 Z0", "G90 G17 G21 G0 X0 Y0 Z0 A0", "G0 X0 Y0 Z0", "G0 X0 Y0"))))
        known = ("#5", "#7") * ("values" in self.lines.subjects) + ("#1", "#2") * bool(self.families)
        begin += [Line(plain="%s=0" % name, kept=True) for name in known]
        first = 1 if lines[0].plain == "%" else 0
        lines[first:first] = begin
        return lines
