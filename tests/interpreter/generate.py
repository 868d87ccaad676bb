#!/usr/bin/python3
"""Random O-word programs: sound ones, sound ones with mistakes, and soup.

usage: generate.py [--seed S] [--count N] FOLDER     writes FOLDER/p00000.ngc …

`generate(seed)` gives one program's text; the same seed gives the same text.  A program is made in two steps: a list of
`Line`s (what the interpreter understands), then spelling.py writes them in one of many styles.  Mutations work on the
list, so that a moved line keeps its meaning.

Conditions whose outcome is to be unknown read `#[1000+#99]`, repeat counts `#[3000+#99]`, each with a number of its own;
`#99` is a counter which plain lines advance, so nothing about the value can be known from the text.
"""
import argparse
import os
import random
import sys
from dataclasses import dataclass, replace

from spelling import spell

CLOSERS = {"if": "endif", "while": "endwhile", "repeat": "endrepeat", "do": "while", "sub": "endsub"}
CONDITIONAL = ("if", "elseif", "while", "repeat")
KEYWORDS = ("sub", "endsub", "call", "do", "while", "repeat", "if", "elseif", "else", "endif", "break", "continue",
            "endwhile", "endrepeat", "return")
MISSPELT = ("endiff", "els", "esleif", "wend", "endloop", "then", "brake", "until", "subr", "end", "foo")


@dataclass(frozen=True)
class Line:
    """An O-word line (`label` set) or a plain one."""
    label: object = None     # a number, or the name of a file
    keyword: str = ""       # '' on a line with a label: a bare O-number
    argument: str = ""      # conditions, arguments, values: with their brackets
    plain: str = ""
    tail: str = ""          # further text on the line

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
        call = lambda label: Line(plain="M98 P%d%s" % (label, rng.choice(("", "", " L2", " L0"))))
        body = lambda label: [self.plain()] + self.block(5, 2, [], None) + ([call(two)] if rng.random() < 0.3 else [])
        lines = [Line(main)] if rng.random() < 0.5 else []
        for _ in range(rng.randint(1, 3)):
            lines += [self.plain(), call(rng.choice((one, one, two))) if rng.random() < 0.8 else self.oword(one, "call")]
        lines.append(Line(plain=rng.choice(("M2", "M2", "M30", "M99", "G0 X9"))))
        for label in (one, two):
            if rng.random() < 0.15:
                lines += self.definition(label, 4)
            else:
                lines += [Line(label)] + body(label) + [Line(plain="M99") if rng.random() < 0.85 else self.plain()]
        return lines


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


def generate_values(seed):
    """A sound program, seldom with a mistake in its O-words, whose values go astray."""
    rng = random.Random("values/%s" % seed)
    for _ in range(100):
        maker = ValueMaker(rng)
        lines = maker.sound()
        if rng.random() < 0.12:
            lines = mutate(lines, maker, rng)
        if 8 <= len(lines) <= 45:
            break
    return spell(lines, rng)


def mutate(lines, maker, rng):
    """One mistake."""
    lines = list(lines)
    owords = [i for i, line in enumerate(lines) if line.is_oword]
    if not owords:
        return lines
    at = rng.choice(owords)
    kind = rng.choice(("delete", "delete", "double", "swap", "move", "label", "other label", "keyword", "nest"))
    if kind == "delete":
        del lines[at]
    elif kind == "double":
        lines.insert(rng.choice((at, rng.randrange(len(lines) + 1))), lines[at])
    elif kind == "swap":
        other = rng.choice((rng.choice(owords), min(at + 1, len(lines) - 1)))
        lines[at], lines[other] = lines[other], lines[at]
    elif kind == "move":
        lines.insert(rng.randrange(len(lines)), lines.pop(at))
    elif kind == "label":
        lines[at] = replace(lines[at], label=max([line.label for line in lines if isinstance(line.label, int)] or [0]) + 1)
    elif kind == "other label":
        lines[at] = replace(lines[at], label=lines[rng.choice(owords)].label)
    elif kind == "keyword":
        keyword = rng.choice(KEYWORDS)
        fits = (keyword in CONDITIONAL) == (lines[at].keyword in CONDITIONAL) and keyword != "repeat"
        lines[at] = replace(lines[at], keyword=keyword,
                            argument=lines[at].argument if fits or rng.random() < 0.05 else maker.argument(keyword))
    else:
        label = maker.label()
        inner = [maker.oword(label, "sub"), maker.plain(), maker.oword(label, "endsub")]
        lines[at:at] = inner if rng.random() < 0.7 else inner[:2]
    return lines


def misspell(lines, maker, rng):
    """One slip of the pen: an unknown keyword, a bracket lost, text after the O-word, a value that can fail."""
    lines = list(lines)
    owords = [i for i, line in enumerate(lines) if line.is_oword]
    kind = rng.choice(("keyword", "bracket", "no bracket", "text", "text", "name", "arguments", "fails"))
    at = rng.choice(owords) if owords else None
    bracketed = [i for i in owords if lines[i].argument.startswith("[")]
    if kind == "name":
        place = rng.randrange(len(lines))
        lines.insert(place, Line(plain="#<width>=1"))
        lines.insert(rng.randrange(len(lines)), Line(plain="G0 X#<width>"))
    elif at is None:
        pass
    elif kind == "keyword":
        lines[at] = replace(lines[at], keyword=rng.choice(MISSPELT), argument=rng.choice(("", lines[at].argument)))
    elif kind == "bracket" and bracketed:
        at = rng.choice(bracketed)
        lines[at] = replace(lines[at], argument=rng.choice((lines[at].argument[:-1], lines[at].argument + "]")))
    elif kind == "no bracket" and bracketed:
        at = rng.choice(bracketed)
        lines[at] = replace(lines[at], argument=rng.choice(("", lines[at].argument[1:-1])))
    elif kind == "arguments":
        lines[at] = Line(lines[at].label, "call", "[1]" * rng.choice((30, 31, 32)))
    elif kind == "fails":
        ends = [i for i in owords if lines[i].keyword in ("return", "endsub")]
        if ends:
            at = rng.choice(ends)
            lines[at] = replace(lines[at], argument="[1/#31]")
            # Set first of all, so that it is known whether the value fails: what nobody sets, owlint cannot know.
            lines.insert(1 if lines[0].plain == "%" else 0, Line(plain="#31=%d" % rng.choice((0, 2))))
    else:
        lines[at] = replace(lines[at], tail=rng.choice(("G0 X5", "x", "(fine)", "then", "[1]", "M3")))
    return lines


def generate(seed):
    """The text of the program with this seed (an int or a string)."""
    rng = random.Random(seed)
    for _ in range(100):
        maker = Maker(rng)
        source = rng.random()
        if source < 0.57:
            lines = maker.sound()
            for _ in range(rng.choice((0, 1, 1, 1, 2, 2, 3))):
                lines = mutate(lines, maker, rng)
        elif source < 0.95:
            lines = maker.soup()
        else:
            lines = maker.fanuc()
            for _ in range(rng.choice((0, 0, 1))):
                lines = mutate(lines, maker, rng)
        if rng.random() < 0.1:
            lines = misspell(lines, maker, rng)
        if 5 <= len(lines) <= 40:
            break
    return spell(lines, rng)


def generate_files(seed):
    """A bundle (bundle.py) of a program and one to three files that it calls, with this seed."""
    rng = random.Random("files/%s" % seed)
    names = rng.sample(("drill", "probe_z", "300", "301", "face"), rng.randint(1, 3))
    texts = {}
    for name in (None, *names):
        for _ in range(100):
            maker = Maker(rng)
            lines = maker.sound() if name or rng.random() < 0.8 else maker.soup()
            for _ in range(rng.choice((0, 0, 1, 1, 2))):
                lines = mutate(lines, maker, rng)
            if len(lines) <= 28:
                break
        lines = [line for line in lines if not (name and line.plain == "%" and rng.random() < 0.7)]
        if name:
            lines = called_file(lines, name, maker, rng)
        # Calls of the other files, now and then of one that is not there.
        for _ in range(rng.choice((1, 1, 2)) if not name else rng.choice((0, 0, 1))):
            target = rng.choice([n for n in names if n != name] or ["nowhere"]) if rng.random() < 0.96 else "nowhere"
            lines.insert(rng.randrange(len(lines) + 1), maker.oword(target, "call"))
        if not name and rng.random() < 0.15:        # a sub of the program with the name of a file
            lines[0:0] = maker.definition(rng.choice(names), 3)
        if rng.random() < 0.08:
            lines = misspell(lines, maker, rng)
        texts[name] = spell(lines, rng)
    text = texts.pop(None)
    newline = "\r\n" if "\r\n" in text else "\n"
    for name, part in texts.items():
        folder = "subs/" if rng.random() < 0.6 else ""
        text += ("" if text.endswith("\n") else newline) + "; file: %s%s.ngc\n" % (folder, name) + part
    return text


def called_file(lines, name, maker, rng):
    """The lines of a file that is called `name`: mostly the sub of that name, with helpers behind or before it."""
    body = [line for line in lines if line.plain not in ("M2", "M30", "%")] if rng.random() < 0.8 else lines
    if rng.random() < 0.5:      # what the lines define stays, as helpers
        cut = rng.randrange(len(lines) + 1)
        own = [maker.oword(name, "sub")] + maker.block(6, 1, [], name) + [maker.oword(name, "endsub")]
        lines = lines[:cut] + own + lines[cut:] if rng.random() < 0.3 else own + lines
    elif not any(line.keyword in ("sub", "endsub") for line in body):
        lines = [maker.oword(name, "sub")] + body + [maker.oword(name, "endsub")]
    else:
        lines = [maker.oword(name, "sub")] + maker.block(10, 1, [], name) + [maker.oword(name, "endsub")] + lines
    if rng.random() < 0.06:
        lines = [replace(line, label=rng.choice((name, 77))) if line.label == name else line for line in lines]
    if rng.random() < 0.06:
        del lines[rng.randrange(len(lines))]
    return lines


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=100)
    options = parser.parse_args(argv)
    os.makedirs(options.folder, exist_ok=True)
    for number in range(options.count):
        with open(os.path.join(options.folder, "p%05d.ngc" % number), "w", encoding="latin-1", newline="") as f:
            f.write(generate("%d/%d" % (options.seed, number)))


if __name__ == "__main__":
    main(sys.argv[1:])
