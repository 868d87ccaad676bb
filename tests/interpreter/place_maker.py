"""The lines of random programs in which it matters where the machine stands: it is moved on some paths, in callers and in callees, and
arcs, cycles, polar words and probes come behind.

Lines are drawn for where the machine would be if the text were run from the first line to the last (nominal.py), many of them as near to a
tolerance as the interpreter still tells them apart. Modes that decide by themselves stay out of it: there always are a feed and a
turning spindle, and no compensation. Behind a probe all axes are named: where it ends, only the machine knows.
"""
import math

from maker import CLOSERS, Line
from mode_maker import ModeMaker
from nominal import AXES, LEAST, PLANES, Nominal, zeros

# How much of what is allowed an arc is off by.
OFF = (0, 0, 0, 0, 0, 0, 0.5, 0.99, 1.01, 2, 40)
CYCLES = {"G81": "", "G82": "P0", "G83": "Q1", "G73": "Q1", "G85": "", "G89": "P0"}
SUBJECTS = ("planes", "units", "centers", "distance", "offsets", "systems", "tools", "rotation", "cycles", "polar", "probes", "threads", "diameter",
            "saved", "homes", "values")


class PlaceMaker(ModeMaker):
    def __init__(self, rng):
        super().__init__(rng)
        self.subjects = set(rng.sample(SUBJECTS, rng.choice((1, 2, 3, 4, 5))))
        self.near = Nominal()
        self.ends = {}              # by sub: where it begins and ends
        self.families = []          # subs with two arguments: the place of an arc, and its radius
        self.upper = False          # G98
        self.numbers = False

    # -- numbers

    def number(self, low=-10, high=20):
        rng = self.rng
        return rng.randint(low, high) * rng.choice((1, 1, 1, 0.5, 0.1)) / (10 if self.near.inch else 1)

    def some_axes(self, most=3):
        return sorted(self.rng.sample(AXES, self.rng.choice([1, 2, 2, 3][:most + 1])))

    def spelt_number(self, value):
        """With a parameter in it, now and then."""
        known = self.near.parameters
        if known and self.rng.random() < 0.15:
            name = self.rng.choice(sorted(known))
            return "[%s+%s]" % (name, self.near.text(value - known[name]))
        return self.near.text(value)

    def axis_words(self, ends):
        near = self.near
        return ["%s%s" % (axis, self.spelt_number(near.word(axis, value))) for axis, value in ends.items()]

    # -- lines; each changes what is nominal

    def words(self):
        rng = self.rng
        kind = rng.random()
        if kind < 0.22:
            return self.move()
        if kind < 0.33:
            return self.everywhere()
        if kind < 0.6:
            return self.arc() if rng.random() < 0.7 else self.arc_by_radius()
        able = sorted(self.subjects - {"probes"})
        return getattr(self, "_" + rng.choice(able))() if able else self.move()

    def move(self):
        near, rng = self.near, self.rng
        ends = {axis: near.at[axis] * near.incremental + self.number() for axis in self.some_axes()}
        motion = rng.choice((0, 0, 1))
        words = self.axis_words(ends)
        if rng.random() > 0.2 or near.motion != motion or near.cycle["code"]:
            words.insert(0, "G%d" % motion)
        near.go(ends)
        near.motion = motion
        return " ".join(words)

    def everywhere(self):
        """To a place that does not depend on anything before."""
        near = self.near
        near.incremental, near.diameter = False, False
        ends = {axis: float(self.rng.choice((0, 0, 1, 5, 10, 20, -3))) for axis in AXES}
        near.go(ends)
        near.motion = 0
        return "G90%s G0 %s" % (" G8" if "diameter" in self.subjects else "", " ".join(self.axis_words(ends)))

    def arc(self):
        near, rng = self.near, self.rng
        (first, second), letters, across = PLANES[near.plane]
        start = near.at[first], near.at[second]
        offset = [self.number(), rng.choice((0, 0, self.number()))]
        radius = math.hypot(*offset)
        if rng.random() < 0.05 or not radius:
            offset = [LEAST[near.inch] * rng.choice((0, 0.5, 0.99, 1.01, 2)), 0]
            radius = offset[0]
        if rng.random() < 0.15:     # what is allowed grows with the radius
            offset = [part * rng.choice((10, 30, 100, 400)) for part in offset]
            radius = math.hypot(*offset)
        center = start[0] + offset[0], start[1] + offset[1]
        off = rng.choice(OFF) * rng.choice((1, -1)) * near.may_differ(radius)
        turn = math.radians(rng.choice((0, 90, 180, 270, rng.randrange(360))))
        far = max(0, radius + off)
        ends = {first: center[0] + far * math.cos(turn), second: center[1] + far * math.sin(turn)}
        polar = near.plane == 17 and "polar" in self.subjects and not near.incremental and rng.random() < 0.4
        if rng.random() < 0.1:
            ends, words = {}, []    # a full circle
        elif polar:
            words = ["@%s" % near.text(math.hypot(*ends.values())), "^%.7f" % math.degrees(math.atan2(ends["Y"], ends["X"]))]
        else:
            words = self.axis_words(ends)
        if rng.random() < 0.1:
            ends[across] = near.at[across] + 1
            words += self.axis_words({across: ends[across]})
        middle = [part * near.factor("Q") for part in (center if near.centers_absolute else offset)]
        given = [(letter, part) for letter, part in zip(letters, middle) if part or near.centers_absolute or rng.random() < 0.5]
        words += ["%s%s" % (letter, self.spelt_number(part)) for letter, part in given or [(letters[0], middle[0])]]
        return self.arc_line(words, ends)

    def arc_by_radius(self):
        near, rng = self.near, self.rng
        (first, second), _, _ = PLANES[near.plane]
        by = [self.number(), self.number()]
        if rng.random() < 0.08:
            by = [0, 0]
        ends = {first: near.at[first] + by[0], second: near.at[second] + by[1]}
        half = math.hypot(*by) / 2
        radius = half - rng.choice((0, 0.5, 0.99, 1.01, 2, 100, -500, -2000, -2000, -5000)) * LEAST[near.inch]
        words = self.axis_words(ends) + ["R%s" % self.spelt_number(radius * rng.choice((1, 1, -1)))]
        return self.arc_line(words, ends)

    def arc_line(self, words, ends):
        near, rng = self.near, self.rng
        motion = rng.choice((2, 3))
        if rng.random() < 0.06:
            words.append("P%d" % rng.choice((1, 2, 3)))
        if near.motion not in (2, 3) or near.cycle["code"] or rng.random() > 0.25:
            words.insert(0, "G%d" % motion)
            near.motion = motion
        near.go(ends)
        return " ".join(words)

    def _planes(self):
        near = self.near
        near.plane = self.rng.choice((17, 17, 18, 19))
        return "G%d" % near.plane + ("" if self.rng.random() < 0.7 else " " + self.arc())

    def _units(self):
        self.near.change_units(self.rng.random() < 0.5)
        return "G20" if self.near.inch else "G21"

    def _centers(self):
        near = self.near
        near.centers_absolute = self.rng.random() < 0.5
        return ("G90.1" if near.centers_absolute else "G91.1") + ("" if self.rng.random() < 0.6 else " " + self.arc())

    def _distance(self):
        near, rng = self.near, self.rng
        near.incremental = rng.random() < 0.5
        return ("G91 " if near.incremental else "G90 ") + rng.choice((self.move, self.arc))()

    def _offsets(self):
        near, rng = self.near, self.rng
        kind = rng.random()
        if kind < 0.5:
            words = {axis: self.number() for axis in self.some_axes(2)}
            near.set_offset(words)
            return "G92 " + self.halved(words)
        if kind < 0.75:
            words = {axis: self.number() for axis in self.some_axes(2)}
            near.change_offset({**near.offset, **words})
            return "G52 " + self.halved(words)
        code = rng.choice(("G92.1", "G92.2", "G92.3"))
        near.change_offset(near.stored if code == "G92.3" else zeros())
        if code == "G92.1":
            near.stored = zeros()
        return code

    def halved(self, words):
        """Absolute words."""
        near = self.near
        return " ".join("%s%s" % (axis, self.spelt_number(value * near.factor(axis))) for axis, value in words.items())

    def _systems(self):
        near, rng = self.near, self.rng
        kind = rng.random()
        words = {axis: self.number() for axis in self.some_axes(2)}
        if kind < 0.4:
            number = rng.choice((1, 2))
            near.set_system(number, words)
            return "G10 L2 P%d %s" % (0 if number == near.system and rng.random() < 0.3 else number, self.halved(words))
        if kind < 0.6:
            near.stand_at(words)
            return "G10 L20 P%d %s" % (rng.choice((0, near.system)), self.halved(words))
        if kind < 0.7:
            ends = {axis: self.number() for axis in self.some_axes()}
            line = "G90 G53 G0 " + self.halved(ends)
            near.incremental = False
            near.go({axis: value - near.machine(axis) for axis, value in ends.items()})
            near.motion = 0
            return line
        near.select(rng.choice((1, 2)))
        return "G5%d" % (3 + near.system)

    def _tools(self):
        near, rng = self.near, self.rng
        if rng.random() < 0.3:
            near.change_tool(zeros())
            return "G49"
        words = {axis: self.number() for axis in rng.choice(("Z", "Z", "X", "XZ"))}
        near.change_tool({**near.tool, **words})
        return "G43.1 " + self.halved(words)

    def _rotation(self):
        return "G10 L2 P%d R%d" % (self.rng.choice((0, 1, 2)), self.rng.choice((0, 0, 90, 30, 180)))

    def _cycles(self):
        near, rng = self.near, self.rng
        if rng.random() < 0.08:
            self.upper = not self.upper
            return "G98" if self.upper else "G99"
        (first, second), _, along = PLANES[near.plane]
        cycle = near.cycle
        height = near.at[along] if cycle["height"] is None else cycle["height"]
        clearance = rng.choice((1, 2, 0.5, 0)) if not near.incremental else rng.choice((1, 0, -1))
        depth = rng.choice((0, -1, -2, -5, 0.0001, -0.0001, 1, clearance, clearance + 0.0001, clearance + 1)) if not near.incremental else \
            rng.choice((-1, -2, -3, 0, -0.0001, 0.0001, 1))
        ends = {axis: near.at[axis] * near.incremental + self.number() for axis in rng.choice((first, second, first + second))}
        if cycle["code"] and rng.random() < 0.7:
            code, words = cycle["code"], [] if rng.random() < 0.7 else [cycle["code"]]
            if rng.random() < 0.75:
                clearance = cycle["R"]
            else:
                words.append("R%s" % near.text(clearance))
            if rng.random() < 0.6:
                depth = cycle["bottom"]
            else:
                words.append("%s%s" % (along, near.text(depth * near.factor(along))))
            if not words or rng.random() < 0.6:
                words += self.axis_words(ends)
            else:
                ends = {}
            if code in ("G83", "G73") and rng.random() < 0.2:
                words.append("Q2")
        else:
            code = rng.choice(sorted(CYCLES))
            words = [code, *self.axis_words(ends), "%s%s" % (along, near.text(depth * near.factor(along))), "R%s" % near.text(clearance), *CYCLES[code].split()]
        if rng.random() < 0.1:
            words.append("L2")
        near.at.update(ends)
        cycle["height"] = height
        near.drill(code, clearance, depth, self.upper)
        return " ".join(words)

    def _polar(self):
        near, rng = self.near, self.rng
        if rng.random() < 0.25:
            return self.at_origin()
        radius, angle = rng.choice((0, 5, 10, 2.5)), rng.choice((0, 30, 45, 90, 180, -60))
        words = rng.choice((("@", "^"), ("@", "^"), ("@",), ("^",)))
        line = "G%d " % rng.choice((0, 1)) + " ".join("%s%s" % (letter, radius if letter == "@" else angle) for letter in words)
        here = math.hypot(near.at["X"], near.at["Y"]), math.degrees(math.atan2(near.at["Y"], near.at["X"]))
        far = here[0] * (near.incremental or "@" not in words) + radius * ("@" in words)
        turn = math.radians(here[1] * (near.incremental or "^" not in words) + angle * ("^" in words))
        near.go({"X": far * math.cos(turn), "Y": far * math.sin(turn)})
        near.motion = int(line[1])
        return line

    def at_origin(self):
        self.near.incremental = False
        self.near.go({"X": 0.0, "Y": 0.0})
        self.near.motion = 0
        return "G90 G0 X0 Y0"

    def probe(self):
        """To where the machine stands, or a little farther."""
        near, rng = self.near, self.rng
        ends = {axis: near.at[axis] + rng.choice((0, 0, 0, 0, -1, 0.00001)) for axis in self.some_axes()}
        line = "G%s %s" % (rng.choice(("38.2", "38.4", "38.2", "38.3", "38.5")), " ".join(self.axis_words(ends)))
        near.motion = 38
        return line

    def _threads(self):
        near, rng = self.near, self.rng
        if rng.random() < 0.4:
            near.rotary = rng.choice((0, 0, 10))
            near.motion = 0
            near.go({})
            return "G0 A%d" % (0 if near.incremental else near.rotary)
        near.motion = 76
        near.go({"Z": near.at["Z"] - 1})
        rotary = "" if rng.random() < 0.4 else " A%d" % rng.choice((0, 0, near.rotary, 10))
        return "G76 P1 Z%s I-.1 J.01 K.05%s" % (near.text(near.word("Z", near.at["Z"])), rotary)

    def _diameter(self):
        self.near.diameter = self.rng.random() < 0.5
        return "G7" if self.near.diameter else "G8"

    def _saved(self):
        near = self.near
        if near.saved is None or self.rng.random() < 0.4:
            near.saved = near.copy()
            return "M70"
        saved = near.saved
        near.change_units(saved.inch)
        for name in ("plane", "incremental", "centers_absolute", "diameter"):
            setattr(near, name, getattr(saved, name))
        near.select(saved.system)
        return "M72"

    def _homes(self):
        near, rng = self.near, self.rng
        if rng.random() < 0.4:
            near.home = {axis: near.at[axis] + near.machine(axis) for axis in AXES}
            return "G28.1"
        axes = rng.choice(("", "X", "XY", "Z"))
        near.go({axis: near.home[axis] - near.machine(axis) for axis in axes or AXES})
        return "G28 " + " ".join("%s%s" % (axis, 0 if near.incremental else 1) for axis in axes)

    def _values(self):
        name = self.rng.choice(("#5", "#7"))
        self.near.parameters[name] = value = self.rng.choice((0, 1, 2, 2.5))
        return "%s=%s" % (name, value)

    # -- what is around the lines

    def plain(self):
        if self.rng.random() < 0.08:
            return Line(plain="#99=[#99+1]")
        return Line(plain=self.spelt(self.words()))

    def some(self):
        """A line, or a probe with one behind it, now and then in a block of its own."""
        rng, before = self.rng, self.near.copy()
        if "probes" in self.subjects and rng.random() < 0.25:
            lines = self.unbroken([self.probe(), self.everywhere()])
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
        arc = self.arc()
        lines = [Line(plain="G17 G91.1 G90 G0 X0 Y0"), Line(label, "repeat", rng.choice(("[%d]" % count, self.values.count())))]
        lines.append(Line(plain="G91 G1 X%s" % near.text(by)))
        inside = rng.random() < 0.3
        return lines + [Line(plain="G90 " + arc)] * inside + [Line(label, "endrepeat")] + [Line(plain="G90 " + arc)] * (not inside)

    def family(self, label):
        """A sub with an arc at its first argument, of the size of its second."""
        body = self.rng.choice((
            ("G2 X[#1+#2*2] Y0 I[#2]",), ("G2 X[#1+#2*2] I#2", "G0 X#1", "G3 X[#1-#2*2] I[0-#2]"), ("G3 X[#1+#2*2] R[#2]",),
            ("G0 Y#1", "G2 Y[#1+#2] J[#2/2]"), ("G1 X[#1]", "G2 X[#1+10] I5"), ("G81 X#1 Z#2 R1", "X[#1+5]"), ("G90.1 G2 X[#1+#2*2] I[#1+#2] J0 ", "G91.1")))
        self.families.append(label)
        return [Line(label, "sub")] + [Line(plain=line) for line in body] + [Line(label, "endsub")]

    def family_call(self):
        rng, near = self.rng, self.near
        at, size = rng.choice((0, 5, 10)), rng.choice((1, 5, 2.5))
        off = rng.choice(OFF) * near.may_differ(size) * rng.choice((1, -1))
        near.incremental = near.diameter = False
        near.plane = 17
        near.go({"X": float(at), "Y": 0.0})
        move = "G90 G17 G0 X%s Y0 Z1" % near.text(at)
        call = Line(rng.choice(self.families), "call", "[%s] [%s]" % (near.text(at + off), near.text(size)))
        near.motion = 2
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
        if keyword == "call" and label in self.ends and self.rng.random() < 0.8:
            self.near = self.ends[label][1].copy()
        return super().oword(label, keyword)

    def block(self, room, depth, loops, in_sub):
        lines = []
        for line in super(ModeMaker, self).block(room, depth, loops, in_sub):
            if line.keyword == "call" and line.label in self.ends and self.rng.random() < 0.6:
                lines.append(Line(plain=self.to(self.ends[line.label][0])))
            lines.append(line)
            while self.rng.random() < 0.5:
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
        self.near = Nominal()
        self.near.at = {axis: float(rng.choice((0, 0, 1, 5, 10))) for axis in AXES}
        begins = self.near.copy()
        lines = super(ModeMaker, self).definition(label, room)
        self.ends[label] = begins, self.near
        self.near = Nominal()
        return lines

    def sound(self):
        self.numbers = "values" in self.subjects    # what is set first may decide
        return super().sound()

    def begun(self, lines):
        rng = self.rng
        begin = [Line(plain="F1000 S100 M3")]
        if self.rng.random() < 0.85:
            begin.append(Line(plain=rng.choice(("G90 G17 G21 G0 X0 Y0 Z0", "G90 G17 G21 G0 X0 Y0 Z0 A0", "G0 X0 Y0 Z0", "G0 X0 Y0"))))
        begin += [Line(plain="%s=0" % name) for name in ("#5", "#7") if "values" in self.subjects]
        begin += [Line(plain="%s=0" % name) for name in ("#1", "#2") if self.families]
        first = 1 if lines[0].plain == "%" else 0
        lines[first:first] = begin
        return lines
