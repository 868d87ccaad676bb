"""Lathe contours for place_maker.py: the lines of a sub, and the line that cuts along it.

Most contours can be cut; the others turn back, have an arc that does not fit or two lines in one direction, or lead their layers astray.
"""
CODES = ("G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2")


def text(number):
    """As it is written."""
    written = ("%.4f" % number).rstrip("0").rstrip(".")
    return "0" if written in ("-0", "") else written


class Contour:
    """Z and X are drawn one after the other, from the right to the left or, for G72, from the axis outwards."""

    def __init__(self, rng):
        self.rng = rng
        self.code = rng.choice(CODES)
        self.outside = rng.random() < 0.75
        self.start = float(rng.choice((0, 1, 2))), float(rng.choice((20, 25, 30)) if self.outside else rng.choice((0, 2)))
        self.at = self.start
        self.lines = [self.first()] + [self.line() for _ in range(rng.choice((0, 1, 2, 2, 3, 4, 6)))]

    def go(self, z, x):
        words = [] if z == self.at[0] and self.rng.random() < 0.5 else ["Z" + text(z)]
        words += [] if x == self.at[1] and words and self.rng.random() < 0.5 else ["X" + text(x)]
        self.at = z, x
        return words

    def first(self):
        rng = self.rng
        x = float(rng.choice((5, 8, 10)) if self.outside else rng.choice((20, 25)))
        z = -float(rng.choice((10, 20))) if self.code.startswith("G72") else self.start[0] - rng.choice((0, 0, 1, 3))
        return " ".join([rng.choice(("G0", "G1")), *self.go(z, x), *self.corner()])

    def corner(self):
        rng = self.rng
        if rng.random() > 0.1:
            return []
        letters = rng.choice(("A", "A", "C", "C", "AC")) if rng.random() < 0.3 else rng.choice("AC")
        return [letter + text(rng.choice((0.2, 0.5, 1, 3))) for letter in letters]

    def line(self):
        rng = self.rng
        if rng.random() < 0.05:
            return rng.choice(("F50", "(a note)", "G4 P1", "M8", "Y3", "", "G91", "G17", "S500"))
        out = 1 if self.outside else -1
        dz, dx = -float(rng.choice((0, 1, 2, 3, 4))), out * float(rng.choice((0, 0, 1, 2, 3, -1, -2)))
        if self.code.startswith("G72"):
            dz, dx = rng.choice((1, -1, -1)) * abs(dx), out * abs(dz)
        if rng.random() < 0.08:
            dz *= rng.choice((-1, -0.0002, -0.0009, -0.0011))
        if rng.random() < 0.2:
            dz, dx = dz * rng.choice((0.5, 0.3, 1.1)), dx * rng.choice((0.5, 0.7, 1))
        z, x = self.at
        if rng.random() < 0.65 or not (dz or dx):
            if rng.random() < 0.1:
                self.at = z + dz, x + dx
                return "G1 " + " ".join(rng.choice((("U" + text(dx), "W" + text(dz)), ("U" + text(dx), "Z" + text(z + dz)))))
            return " ".join(["G1", *self.go(z + dz, x + dx), *self.corner()])
        return self.arc(z, x, dz, dx)

    def arc(self, z, x, dz, dx):
        rng = self.rng
        code, kind = rng.choice(("G2", "G3")), rng.random()
        if kind < 0.35:
            reach = (dz * dz + dx * dx) ** 0.5 / 2
            return " ".join([code, *self.go(z + dz, x + dx), "R" + text(reach * rng.choice((1.0001, 1.2, 1.5, 2, 0.9)))])
        if kind < 0.75 and dz and dx:
            dx = abs(dz) * (1 if dx > 0 else -1)
            center = rng.choice((["K" + text(dz)], ["I" + text(dx)]))
        else:
            center = ["I" + text(dx / 2), "K" + text(dz / 2)]
        if rng.random() < 0.1:
            center = rng.choice((["I1"], ["K-2", "I0.5"], [*center, "R3"], []))
        return " ".join([code, *self.go(z + dz, x + dx), *center])

    def cut(self, label):
        """The line that cuts it."""
        rng, words = self.rng, [self.code, "Q%d" % label]
        if rng.random() < 0.4:
            words.append("D" + text(rng.choice((0.2, 0.5, 1, 2))))
        if self.code == "G70":
            words += ["E" + text(rng.choice((0, 0.1)))] * (rng.random() < 0.4) + ["P%d" % rng.choice((1, 2, 3))] * (rng.random() < 0.4)
        else:
            words += ["I" + text(rng.choice((0.5, 0.7, 2, 5, 0, -1)))] * (rng.random() < 0.4) + ["R" + text(rng.choice((0.1, 1)))] * (rng.random() < 0.3)
        words += ["X" + text(self.start[1])] * (rng.random() < 0.2) + ["Z" + text(self.start[0])] * (rng.random() < 0.2)
        return " ".join(words)
