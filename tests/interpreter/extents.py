#!/usr/bin/python3
"""Holds `owlint extents` against what rs274 does: random programs of moves, arcs, cycles, loops and subs.

usage: extents.py --owlint build/release/owlint [--programs N] [--seed S]

rs274 prints every move that it makes (`-g`), in coordinates of the program.  From these follow the least and the greatest coordinate of
each axis in each coordinate system, with arcs between their ends; owlint has to say the same, and that it knows everything.  Exit status 1
when a program differs, which is then printed.
"""
import argparse
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import rs274  # noqa: E402

SKIPPED = 77                # what ctest takes for "not run"
INCH = 25.4
PRINTED = 0.0002            # rs274 prints four decimals; a center is printed, too
MOVE = re.compile(r"(STRAIGHT_TRAVERSE|STRAIGHT_FEED|ARC_FEED|USE_LENGTH_UNITS|SELECT_PLANE|SET_G5X_OFFSET)\(([^)]*)\)")
PLANES = {"CANON_PLANE_XY": (0, 1, 2), "CANON_PLANE_XZ": (2, 0, 1), "CANON_PLANE_YZ": (1, 2, 0)}    # first, second, across


class Maker:
    """A random program whose every coordinate is known in its coordinate system."""

    def __init__(self, choose):
        self.choose = choose
        self.lines = []
        self.at = [0.0, 0.0, 0.0]
        self.inch = choose.random() < 0.2
        self.labels = 100

    def number(self, low, high):
        return round(self.choose.uniform(low, high), 2)

    def text(self):
        choose = self.choose
        self.lines = ["G20 G90 G17 G54 F50" if self.inch else "G21 G90 G17 G54 F500"]
        if choose.random() < 0.4:
            self.lines += ["o<row> sub", "G91 G1 X#1 Y[#1 / 2]", "X#1", "G90", "o<row> endsub"]
            self.has_sub = True
        else:
            self.has_sub = False
        self.go_to(choose.choice(("G0", "G1")))
        for _ in range(choose.randint(3, 25)):
            choose.choice((self.plain, self.plain, self.plain, self.arc, self.arc, self.radius, self.incremental, self.cycle, self.system,
                           self.units, self.loop, self.call, self.circle))()
        return "\n".join(self.lines + ["M2", ""])

    def go_to(self, code):
        self.at = [self.number(-50, 50) for _ in range(3)]
        self.lines.append("%s X%g Y%g Z%g" % (code, *self.at))

    def plain(self):
        words = []
        for axis in self.choose.sample(range(3), self.choose.randint(1, 3)):
            self.at[axis] = self.number(-50, 50)
            words.append("%s%g" % ("XYZ"[axis], self.at[axis]))
        self.lines.append(self.choose.choice(("G0 ", "G1 ")) + " ".join(words))

    def plane(self):
        code, first, second, centers = self.choose.choice((("G17", 0, 1, "IJ"), ("G18", 2, 0, "KI"), ("G19", 1, 2, "JK")))
        return code, first, second, centers

    def arc(self):
        """By its center: turned about it by any angle, so that the radii fit."""
        code, first, second, centers = self.plane()
        center = [self.number(-30, 30), self.number(-30, 30)]
        if math.hypot(*center) < 1:
            return
        angle = self.choose.choice((self.number(5, 355), 90, 180, 270))
        turn = math.radians(angle)
        dx, dy = -center[0], -center[1]
        end = [self.at[first] + center[0] + dx * math.cos(turn) - dy * math.sin(turn),
               self.at[second] + center[1] + dx * math.sin(turn) + dy * math.cos(turn)]
        words = "%s%.6f %s%.6f %s%g %s%g" % ("XYZ"[first], end[0], "XYZ"[second], end[1], centers[0], center[0], centers[1], center[1])
        across = 3 - first - second
        if self.choose.random() < 0.3:
            self.at[across] = self.number(-50, 50)
            words += " %s%g" % ("XYZ"[across], self.at[across])
        if self.choose.random() < 0.2:
            words += " P2"
        self.lines.append("%s %s %s" % (code, self.choose.choice(("G2", "G3")), words))
        self.at[first], self.at[second] = end

    def circle(self):
        code, first, second, centers = self.plane()
        self.lines.append("%s %s %s%g" % (code, self.choose.choice(("G2", "G3")), centers[0], self.number(2, 20)))

    def radius(self):
        code, first, second, _ = self.plane()
        end = [self.number(-50, 50), self.number(-50, 50)]
        way = math.hypot(end[0] - self.at[first], end[1] - self.at[second])
        if way < 1:
            return
        radius = self.choose.choice((1, -1)) * (way / 2 + self.number(0.5, 30))
        self.lines.append("%s %s %s%g %s%g R%.4f" % (code, self.choose.choice(("G2", "G3")), "XYZ"[first], end[0], "XYZ"[second], end[1], radius))
        self.at[first], self.at[second] = end

    def incremental(self):
        self.lines.append("G91")
        for _ in range(self.choose.randint(1, 4)):
            axis = self.choose.randrange(3)
            by = self.number(-20, 20)
            self.at[axis] += by
            self.lines.append("%s %s%g" % (self.choose.choice(("G0", "G1")), "XYZ"[axis], by))
        self.lines.append("G90")

    def cycle(self):
        clearance = self.number(-20, 20)
        retract = self.choose.choice(("G98", "G99"))
        code = self.choose.choice(("G81", "G82 P0.1", "G85", "G89 P0.1", "G83 Q5"))
        self.lines.append("G17 %s %s X%g Y%g Z%g R%g" % (retract, code, self.number(-50, 50), self.number(-50, 50), clearance - self.number(0, 30), clearance))
        for _ in range(self.choose.randint(0, 2)):
            self.lines.append("X%g" % self.number(-50, 50))
        self.lines.append("G80")
        self.go_to("G0")

    def system(self):
        self.lines.append(self.choose.choice(("G54", "G55", "G59.1")))
        self.go_to("G0")

    def units(self):
        self.lines.append(self.choose.choice(("G20", "G21")))
        self.go_to("G1")

    def loop(self):
        self.labels += 1
        self.lines += ["o%d repeat [%d]" % (self.labels, self.choose.randint(1, 4)),
                       "G91 G1 X%g Z%g" % (self.number(-9, 9), self.number(-9, 9)), "o%d endrepeat" % self.labels, "G90"]
        self.go_to("G0")

    def call(self):
        if self.has_sub:
            self.lines.append("o<row> call [%g]" % self.number(-9, 9))
            self.go_to("G0")


class Canon:
    """The extents of the moves that rs274 prints."""

    def __init__(self, printed):
        self.reach = {}     # system, axis -> least, greatest, in units of the first move
        unit, first_unit, system, plane, at = 1.0, None, 1, "CANON_PLANE_XY", None
        for name, arguments in MOVE.findall(printed):
            values = arguments.split(", ")
            if name == "USE_LENGTH_UNITS":
                unit = INCH if arguments == "CANON_UNITS_INCHES" else 1.0
                at = None
            elif name == "SELECT_PLANE":
                plane = arguments
            elif name == "SET_G5X_OFFSET":
                system, at = int(values[0]), None
            else:
                first_unit = first_unit or unit
                self.factor = unit / first_unit
                numbers = [float(value) for value in values]
                if name != "ARC_FEED":
                    at = numbers[:3]
                    self.add(system, at)
                    continue
                first, second, across = PLANES[plane]
                end = list(at)
                end[first], end[second], end[across] = numbers[0], numbers[1], numbers[5]
                for point in arc_points([at[first], at[second]], numbers[2:4], numbers[:2], int(numbers[4])):
                    swept = list(end)
                    swept[first], swept[second] = point
                    self.add(system, swept)
                at = end

    def add(self, system, point):
        for axis, value in zip("XYZ", point):
            least, greatest = self.reach.get((system, axis), (math.inf, -math.inf))
            value *= self.factor
            self.reach[system, axis] = min(least, value), max(greatest, value)


def arc_points(start, center, end, turns):
    """The end of an arc, and where it goes furthest: counterclockwise if `turns` is positive."""
    angle_of = lambda point: math.atan2(point[1] - center[1], point[0] - center[0])  # noqa: E731
    radius = math.hypot(start[0] - center[0], start[1] - center[1])
    begin, sweep = angle_of(start), angle_of(end) - angle_of(start)
    if turns < 0:
        begin, sweep = angle_of(end), -sweep
    sweep %= 2 * math.pi
    if abs(turns) > 1 or sweep < 1e-4:
        sweep = 2 * math.pi
    yield end
    for quarter in range(4):
        angle = quarter * math.pi / 2
        if (angle - begin) % (2 * math.pi) <= sweep:
            yield [center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)]


def system_number(name):
    return {"G54": 1, "G55": 2, "G59.1": 7}[name]


def differences(text, owlint, folder):
    """What owlint says otherwise; None for a program that does not run to its end."""
    path = os.path.join(folder, "p.ngc")
    with open(path, "w", encoding="ascii") as f:
        f.write(text)
    status, printed = rs274.canonical(path)
    if status != 0:
        return None
    wanted = Canon(printed.decode("latin-1")).reach
    done = subprocess.run([os.path.abspath(owlint), "extents", "--isolated", "--format", "json", path], capture_output=True, timeout=60)
    said = json.loads(done.stdout)
    found = {}
    for origin in said["origins"]:
        for axis, reach in origin["axes"].items():
            found[system_number(origin["system"]), axis] = reach["least"], reach["greatest"]
    problems = ["%s: unknown %s" % (said["file"], said["unknown"])] if not said["complete"] else []
    for key in sorted(set(wanted) | set(found)):
        a, b = wanted.get(key), found.get(key)
        if a is None or b is None or max(abs(a[0] - b[0]), abs(a[1] - b[1])) > PRINTED * max(1, *map(abs, a)):
            problems.append("%s: rs274 %s, owlint %s" % (key, a, b))
    return problems


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--programs", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(argv)
    if not rs274.available:
        print("extents.py: skipped, there is no rs274")
        return SKIPPED
    wrong = ran = 0
    with tempfile.TemporaryDirectory(prefix="owlint-extents-") as folder:
        for number in range(options.programs):
            text = Maker(random.Random("%d %d" % (options.seed, number))).text()
            problems = differences(text, options.owlint, folder)
            ran += problems is not None
            if problems:
                wrong += 1
                print("program %d:\n%s\n%s" % (number, "\n".join(problems), text))
    print("extents.py: %d programs, %d of them run, %d differ" % (options.programs, ran, wrong))
    return 1 if wrong or ran < options.programs // 2 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
