"""Where a maker of random programs takes the machine to be, and with what modes: place_maker.py draws its numbers for that.

It follows the text from the first line to the last, and one arm of each branch, so that it is often wrong; the interpreter judges.
"""
import copy
import math
from dataclasses import dataclass, field

INCH = 25.4
AXES = "XYZ"
# By plane: the two axes of an arc, the letters of its center, and the axis along a hole.
PLANES = {17: ("XY", "IJ", "Z"), 18: ("ZX", "KI", "Y"), 19: ("YZ", "JK", "X")}
# In mm and in inches: the smallest radius, and how far two radii may differ anyhow.
LEAST = {False: 0.00005 * INCH, True: 0.00005}
MAY_DIFFER = {False: 0.02 * math.sqrt(2), True: 0.002 * math.sqrt(2)}


def zeros():
    return dict.fromkeys(AXES, 0.0)


@dataclass
class Nominal:
    at: dict = field(default_factory=zeros)         # in the units in effect
    plane: int = 17
    incremental: bool = False
    centers_absolute: bool = False
    inch: bool = False
    diameter: bool = False
    motion: int = 0
    rotary: float = 0.0                             # A
    offset: dict = field(default_factory=zeros)     # of G92
    stored: dict = field(default_factory=zeros)     # of G92, for G92.3
    tool: dict = field(default_factory=zeros)
    systems: dict = field(default_factory=lambda: {1: zeros(), 2: zeros()})
    system: int = 1
    home: dict = field(default_factory=zeros)       # of G28
    parameters: dict = field(default_factory=dict)
    cycle: dict = field(default_factory=lambda: {"code": None, "R": 0.0, "bottom": 0.0, "height": None})
    saved: object = None                            # by M70

    def copy(self):
        return copy.deepcopy(self)

    # -- words

    def text(self, number):
        """A number so exactly that it is on the right side of a tolerance."""
        text = ("%.6f" if self.inch else "%.5f") % number
        text = text.rstrip("0").rstrip(".") if "." in text else text
        return "0" if text in ("-0", "") else text

    def factor(self, axis):
        return 2 if axis == "X" and self.diameter else 1

    def word(self, axis, value):
        """What is written to get to that coordinate."""
        return (value - self.at[axis] * self.incremental) * self.factor(axis)

    def go(self, ends):
        self.at.update(ends)
        self.cycle["code"] = self.cycle["height"] = None

    # -- modes and offsets

    def change_units(self, inch):
        if inch != self.inch:
            by = 1 / INCH if inch else INCH
            for some in (self.at, self.offset, self.stored, self.tool, self.home, *self.systems.values()):
                for axis in AXES:
                    some[axis] *= by
        self.inch = inch

    def set_offset(self, words):
        """G92."""
        for axis, value in words.items():
            self.offset[axis] += self.at[axis] - value
            self.at[axis] = value
        self.stored = dict(self.offset)

    def change_offset(self, offset):
        """Another offset of G92 or G52."""
        for axis in AXES:
            self.at[axis] += self.offset[axis] - offset[axis]
        self.offset = dict(offset)

    def change_tool(self, tool):
        for axis in AXES:
            self.at[axis] += self.tool[axis] - tool[axis]
        self.tool = dict(tool)

    def set_system(self, number, words):
        """G10 L2."""
        for axis, value in words.items():
            if number == self.system:
                self.at[axis] += self.systems[number][axis] - value
            self.systems[number][axis] = value

    def stand_at(self, words):
        """G10 L20 of the system in effect."""
        self.set_system(self.system, {axis: self.systems[self.system][axis] + self.at[axis] - value for axis, value in words.items()})

    def select(self, number):
        old, new = self.systems[self.system], self.systems[number]
        for axis in AXES:
            self.at[axis] += old[axis] - new[axis]
        self.system = number

    def machine(self, axis):
        """What is between a coordinate and that of the machine."""
        return self.systems[self.system][axis] + self.tool[axis] + self.offset[axis]

    # -- arcs and cycles

    def may_differ(self, radius):
        """How far the other radius of an arc may be from this one."""
        return min(max(MAY_DIFFER[self.inch], radius * 0.001), 100 * MAY_DIFFER[self.inch])

    def drill(self, code, clearance, bottom, upper):
        """A cycle at heights as they were written; `upper`: G98."""
        axis = PLANES[self.plane][2]
        cycle = self.cycle
        if cycle["height"] is None:
            cycle["height"] = self.at[axis]
        cycle.update(code=code, R=clearance, bottom=bottom)
        r = clearance + cycle["height"] * self.incremental
        self.at[axis] = max(r, cycle["height"]) if upper else r
