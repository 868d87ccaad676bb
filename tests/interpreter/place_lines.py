"""The lines of place_maker.py: moves, arcs, cycles, offsets and modes, each for where the machine is taken to be (nominal.py).

Arcs and cycles are drawn as near to a tolerance as the interpreter still tells them apart.
"""
import math

from nominal import AXES, LEAST, PLANES, Nominal, zeros

# How much of what is allowed an arc is off by.
OFF = (0, 0, 0, 0, 0, 0, 0.5, 0.99, 1.01, 2, 40)
CYCLES = {"G81": "", "G82": "P0", "G83": "Q1", "G73": "Q1", "G85": "", "G89": "P0"}
# What a program is about, beside arcs; each but probes has a method that makes a line.
SUBJECTS = ("planes", "units", "centers", "distance", "offsets", "systems", "tools", "rotation", "cycles", "polar", "probes", "threads", "diameter",
            "saved", "homes", "values")


class PlaceLines:
    """Lines one after the other; each changes what is nominal."""

    def __init__(self, rng):
        self.rng = rng
        self.subjects = set(rng.sample(SUBJECTS, rng.choice((1, 2, 3, 4, 5))))
        self.near = Nominal()
        self.upper = False          # G98

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
        if self.rng.random() < 0.5:
            return self.rng.choice((self._planes, self._units, self._centers, self._distance))()
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
