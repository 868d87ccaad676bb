"""The lines of random programs in which values decide: what is assigned, passed, returned, read."""
from maker import CONDITIONAL, Line, Maker


class ValueMaker(Maker):
    """Programs in which values flow: through names, numbers, arguments, `#<_value>`.

    Numbers are set first of all, so that nobody has to know what they were before the program."""

    LOCALS = ("#<a>", "#<b>", "#<c>")
    GLOBALS = ("#<_g>", "#<_h>")
    NUMBERS = ("#5", "#7", "#40", "#41")

    def __init__(self, rng):
        super().__init__(rng)
        self.reuse = 0.0
        self.in_sub = False

    def anything(self):
        return self.rng.choice(self.LOCALS + self.GLOBALS + self.NUMBERS + self.NUMBERS)

    def value(self, depth=0):
        rng = self.rng
        kind = rng.random()
        if kind < 0.4 or depth > 1:
            return str(rng.choice((0, 1, 2, 3, -1, 5, 0.5)))
        if kind < 0.65:
            return self.anything()
        if kind < 0.72:
            return rng.choice(("#1", "#2") if self.in_sub else ("#5", "#7"))
        if kind < 0.9:
            if rng.random() < 0.3:      # never so that a loop could take it to infinity
                return "[%s*%s]" % (self.value(depth + 1), rng.choice(("0", "-1", "0.5")))
            return "[%s%s%s]" % (self.value(depth + 1), rng.choice("+-"), self.value(depth + 1))
        if kind < 0.94:
            return rng.choice(("ABS[%s]", "ROUND[%s]", "FIX[%s]")) % self.value(depth + 1)
        inner = self.plain_value()
        return rng.choice(("[10/[%s]]", "SQRT[%s]", "LN[%s]", "ACOS[%s]", "#[%s]")) % inner

    def plain_value(self):
        """Made of numbers that are known: not what an earlier run has left in a name."""
        value = self.value(1)
        while "<" in value or "#1" in value or "#2" in value:
            value = self.value(1)
        return value

    def assignment(self):
        target = self.target()
        return "%s=%s" % (target, self.value() if target.startswith("#<") else self.plain_value())

    def comparison(self):
        rng = self.rng
        operator = rng.choice(("GT", "GE", "LT", "LE", "EQ", "NE"))
        left = self.anything() if rng.random() < 0.8 else self.value(1)
        return "%s %s %s" % (left, operator, rng.choice(("0", "1", "2", "5", self.value(1))))

    def condition(self):
        rng = self.rng
        kind = rng.random()
        if kind < 0.4:
            return self.values.condition()
        if kind < 0.75:
            return "[%s]" % self.comparison()
        if kind < 0.83:
            return "[EXISTS[%s]]" % rng.choice(self.LOCALS + self.GLOBALS)
        return "[[%s] %s [%s]]" % (self.comparison(), rng.choice(("AND", "OR")), self.comparison())

    def target(self):
        rng = self.rng
        if rng.random() < 0.03:
            return rng.choice(("#<_feed>", "#5420", "#<_value>", "#0", "#6000", "#[%s]" % self.plain_value(), "#<_x>"))
        return self.anything()

    def plain(self):
        kind = self.rng.random()
        if kind < 0.4:
            return Line(plain=self.assignment())
        if kind < 0.48:
            name = self.anything()
            return Line(plain="%s=[%s%s]" % (name, name, self.rng.choice(("+1", "-1", "*-1"))))
        if kind < 0.7:
            self.moves += 1
            return Line(plain="G0 X%s" % self.value())
        if kind < 0.75:
            return Line(plain="%s G0 Y%s" % (self.assignment(), self.anything()))
        return super().plain()

    def argument(self, keyword):
        rng = self.rng
        if keyword == "repeat" and rng.random() < 0.4:
            return "[%s]" % rng.choice(("#5", "#40", "[#5-1]", "2.5", "-1", "#<a>"))
        if keyword in CONDITIONAL and keyword != "repeat":
            return self.condition()
        if keyword == "call":
            return " ".join("[%s]" % self.value() for _ in range(rng.choice((0, 0, 1, 1, 2, 3))))
        if keyword in ("return", "endsub") and rng.random() < 0.45:
            # It is computed at the definition, too, where names that are not there yet have any value.
            return "[%s]" % rng.choice((self.anything(), "%s+1" % self.anything(), "10/%s" % rng.choice(self.NUMBERS), "SQRT[%s]" % rng.choice(self.NUMBERS)))
        return super().argument(keyword)

    def block(self, room, depth, loops, in_sub):
        self.in_sub = in_sub is not None
        lines = []
        for line in super().block(room, depth, loops, in_sub):
            lines.append(line)
            if line.keyword == "call" and self.rng.random() < 0.5:     # what is returned was not there before the program
                lines += self.result()
        return lines

    def result(self):
        rng = self.rng
        kind = rng.random()
        if kind < 0.6:
            return [Line(plain="%s=#<_value>" % rng.choice(self.LOCALS))]
        label = self.label()
        return [Line(label, "if", "[%s]" % rng.choice(("#<_value_returned> EQ 1", "#<_value> GT 1", "#<_value> EQ 0"))), self.plain(), Line(label, "endif")]

    def loop(self, room, depth, loops, in_sub):
        """Often one that counts."""
        rng = self.rng
        if rng.random() < 0.5:
            return super().loop(room, depth, loops, in_sub)
        label = self.label()
        counter = rng.choice(self.NUMBERS + self.LOCALS[:1])
        up = rng.random() < 0.8
        body = self.block(room, depth + 1, loops + [label], in_sub) + [Line(plain="%s=[%s%s1]" % (counter, counter, "+" if up else "-"))]
        begin = [Line(plain="%s=%d" % (counter, rng.choice((0, 1))))] if rng.random() < 0.8 else []
        condition = "[%s %s %d]" % (counter, rng.choice(("LT", "LE", "LT", "NE", "GT")), rng.choice((1, 2, 3)))
        return begin + [Line(label, "while", condition)] + body + [self.oword(label, "endwhile")]

    def sound(self):
        lines = super().sound()
        first = 1 if lines[0].plain == "%" else 0
        numbers = " ".join("%s=%d" % (n, self.rng.choice((0, 1, 2, 4))) for n in self.NUMBERS + ("#1", "#2", "#3", "#4"))
        lines[first:first] = [Line(plain="(run before) " + numbers)]
        if self.rng.random() < 0.4:
            lines.insert(first + 1, Line(plain="%s=1" % self.rng.choice(self.LOCALS + self.GLOBALS)))
        return lines
