"""The lines of random programs: sound ones, soup, Fanuc style.  generate.py makes programs of them.

Conditions whose outcome is to be unknown read `#[1000+#99]`, repeat counts `#[3000+#99]`, each with a number of its own;
`#99` is a counter which plain lines advance, so nothing about the value can be known from the text.
"""
from dataclasses import dataclass

CLOSERS = {"if": "endif", "while": "endwhile", "repeat": "endrepeat", "do": "while", "sub": "endsub"}
CONDITIONAL = ("if", "elseif", "while", "repeat")
KEYWORDS = ("sub", "endsub", "call", "do", "while", "repeat", "if", "elseif", "else", "endif", "break", "continue",
            "endwhile", "endrepeat", "return")

M98_WORDS = ("", "", "", "", " L2", " L0", " G0 X7", " M2", " #31=4", " L-1", " P1", " X[1/0]")   # behind M98 P1
M99_LINES = ("M99",) * 8 + ("G0 X8 M99", "M99 G0 X8", "(back) M99")

@dataclass(frozen=True)
class Line:
    """An O-word line (`label` set) or a plain one."""
    label: object = None     # a number, or the name of a file
    keyword: str = ""       # '' on a line with a label: a bare O-number
    argument: str = ""      # conditions, arguments, values: with their brackets
    plain: str = ""
    tail: str = ""          # further text on the line
    kept: bool = False      # block delete never skips it

    @property
    def is_oword(self):
        return self.label is not None


class Values:
    """Hands out the unknown values, each with its own number."""

    def __init__(self, rng, constant=0.12):
        self.rng = rng
        self.constant = constant
        self.used = 0

    def fresh(self, base):
        """An unknown value: 0 or 1 from 1000 on, a small count from 3000 on."""
        self.used += 1
        return "#[%d+#99]" % (base + 20 * (self.used % 90))

    def condition(self):
        rng = self.rng
        if rng.random() < self.constant:
            return rng.choice(("[0]", "[1]", "[0]", "[1]", "[2 GT 1]", "[1 EQ 2]", "[1-1]"))
        return rng.choice(("[%s EQ 1]", "[%s EQ 1]", "[%s]", "[%s GT 0]", "[%s NE 0]", "[[%s] GE 1]")) % self.fresh(1000)

    def count(self):
        if self.rng.random() < 0.6:
            return "[%d]" % self.rng.choice((0, 1, 2, 2, 3))
        return "[%s]" % self.fresh(3000)


class Maker:
    """Builds the lines of one program."""

    def __init__(self, rng):
        self.rng = rng
        self.values = Values(rng, rng.choice((0.0, 0.1, 0.1, 0.3)))
        self.next_label = rng.choice((1, 1, 100, 100, 1000))
        self.reuse = rng.choice((0.0, 0.0, 0.0, 0.1, 0.3))
        self.labels = []
        self.subs = []
        self.moves = 0

    def label(self):
        """A free label, or now and then one that is in use."""
        if self.labels and self.rng.random() < self.reuse:
            return self.rng.choice(self.labels)
        self.labels.append(self.next_label)
        self.next_label += 1
        return self.labels[-1]

    def plain(self):
        kind = self.rng.random()
        if kind < 0.5:
            return Line(plain="#99=[#99+1]")
        if kind < 0.9:
            self.moves += 1
            return Line(plain="G0 X%d" % self.moves)
        return Line(plain=self.rng.choice(("#5=3", "(step)", "", "; step", "G4 P0", "#<_made>=1")))

    def argument(self, keyword):
        """What usually follows the keyword."""
        rng = self.rng
        if keyword == "repeat":
            return self.values.count()
        if keyword in CONDITIONAL:
            return self.values.condition()
        if keyword == "call" and rng.random() < 0.3:
            return " ".join("[%s]" % rng.choice(("1", "#1", "#5+1", "2.5")) for _ in range(rng.choice((1, 1, 2, 3))))
        if keyword in ("return", "endsub") and rng.random() < 0.2:
            return rng.choice(("[5]", "[#1]", "[#5*2]"))
        return ""

    # -- sound programs

    def block(self, room, depth, loops, in_sub):
        """Lines of a body; `loops` are the labels of the loops around it that can be broken out of."""
        rng = self.rng
        lines = []
        for _ in range(rng.randint(1, 3)):
            kind = rng.random()
            if room - len(lines) < 3 or kind < 0.3 or depth > 3:
                lines.append(self.plain())
            elif kind < 0.52:
                lines += self.choice(room - len(lines) - 2, depth, loops, in_sub)
            elif kind < 0.8:
                lines += self.loop(room - len(lines) - 2, depth, loops, in_sub)
            elif kind < 0.9 and self.subs:
                lines.append(self.oword(rng.choice(self.subs), "call"))
            elif loops and kind < 0.96:
                label = self.label()
                lines += [self.oword(label, "if"), self.oword(rng.choice(loops), rng.choice(("break", "continue"))),
                          self.oword(label, "endif")]
            elif in_sub and kind < 0.99:
                label = self.label()
                lines += [self.oword(label, "if"), self.oword(in_sub, "return"), self.oword(label, "endif")]
            elif kind > 0.995:
                lines.append(Line(plain="M2"))
            else:
                lines.append(self.plain())
        return lines

    def oword(self, label, keyword):
        return Line(label, keyword, self.argument(keyword))

    def choice(self, room, depth, loops, in_sub):
        rng = self.rng
        label = self.label()
        lines = [self.oword(label, "if")] + self.block(room // 2, depth + 1, loops, in_sub)
        while rng.random() < 0.3 and len(lines) < room:
            lines += [self.oword(label, "elseif")] + self.block(room // 4, depth + 1, loops, in_sub)
        if rng.random() < 0.45:
            lines += [self.oword(label, "else")] + self.block(room // 4, depth + 1, loops, in_sub)
        return lines + [self.oword(label, "endif")]

    def loop(self, room, depth, loops, in_sub):
        label = self.label()
        opener = self.rng.choice(("while", "while", "do", "repeat"))
        breakable = loops + [label] if opener != "repeat" else loops
        body = self.block(room, depth + 1, breakable, in_sub)
        return [self.oword(label, opener)] + body + [self.oword(label, CLOSERS[opener])]

    def definition(self, label, room):
        body = self.block(room, 1, [], label)
        return [self.oword(label, "sub")] + body + [self.oword(label, "endsub")]

    def sound(self):
        """A program as it should be, but for calls before a definition, recursion and missing ends."""
        rng = self.rng
        size = rng.randint(5, 36)
        self.subs = [self.label() for _ in range(rng.choice((0, 0, 1, 1, 2, 3)))]
        share = size // (len(self.subs) + 1)
        before, after = [], []
        for label in self.subs:
            (before if rng.random() < 0.7 else after).append(self.definition(label, share))
        if rng.random() < 0.04:
            self.subs.append(self.label())      # called, never defined
        body = []
        while len(body) < share:
            body += self.block(share, 0, [], None)
        end = [Line(plain=rng.choice(("M2", "M2", "M30")))] if rng.random() < 0.92 else []
        lines = sum(before, []) + body + end + sum(after, [])
        if rng.random() < 0.12:
            lines = [Line(plain="%")] + lines + ([Line(plain="%")] if rng.random() < 0.9 else [])
        return lines

    # -- soup

    def soup(self):
        """Anything anywhere; closing lines mostly name a block that has been opened."""
        rng = self.rng
        labels = rng.sample(rng.choice(((1, 2, 3, 4), (100, 101, 102, 200))), rng.randint(1, 4))
        weights = {"if": 4, "elseif": 2, "else": 2.5, "endif": 4, "while": 3, "endwhile": 3, "do": 2, "repeat": 1.5,
                   "endrepeat": 2, "break": 2, "continue": 1.5, "sub": 1.2, "endsub": 1.6, "call": 1.6, "return": 1.2}
        lines, opened = [], []
        for _ in range(rng.randint(6, 20)):
            if rng.random() < 0.25:
                lines.append(self.plain() if rng.random() < 0.96 else Line(plain="M2"))
                continue
            keyword = rng.choices(list(weights), weights.values())[0]
            if not opened and keyword not in CLOSERS and keyword != "call" and rng.random() < 0.8:
                keyword = rng.choice(("if", "if", "while", "do", "repeat", "sub"))
            label = rng.choice(labels)
            if opened and keyword not in ("if", "do", "repeat", "sub") and rng.random() < 0.75:
                fitting = [o for o in opened if keyword == CLOSERS[o[1]] or rng.random() < 0.15]
                if fitting:
                    label = fitting[-1][0]
            if keyword in CLOSERS:
                opened.append((label, keyword))
            lines.append(self.oword(label, keyword))
        if rng.random() < 0.85:
            lines.append(Line(plain="M2"))
        return lines

    # -- program numbers, M98 and M99

    def fanuc(self):
        rng = self.rng
        main, one, two = rng.sample((1, 2, 3, 100, 200), 3)
        call = lambda label: Line(plain="M98 P%d%s" % (label, rng.choice(M98_WORDS)))
        body = lambda label: [self.plain()] + self.block(5, 2, [], None) + ([call(two)] if rng.random() < 0.3 else [])
        lines = [Line(main)] if rng.random() < 0.5 else []
        for _ in range(rng.randint(1, 3)):
            lines += [self.plain(), call(rng.choice((one, one, two))) if rng.random() < 0.8 else self.oword(one, "call")]
        lines.append(Line(plain=rng.choice(("M2", "M2", "M30", "M99", "G0 X9", "G0 X8 M99", "M99 P10"))))
        for label in (one, two):
            if rng.random() < 0.15:
                lines += self.definition(label, 4)
            else:
                lines += [Line(label)] + body(label) + [Line(plain=rng.choice(M99_LINES)) if rng.random() < 0.85 else self.plain()]
        return lines
