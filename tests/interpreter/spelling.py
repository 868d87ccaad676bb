"""How a program is written down: case, blanks, names for numbers, leading zeros, line numbers, comments.

None of it changes what the interpreter does, so every program comes in many spellings.
"""
OPENERS = ("if", "elseif", "else", "while", "repeat", "do", "sub")     # what indents the lines that follow


class Style:
    """How one program is written down."""

    def __init__(self, rng, lines):
        chance = lambda p: rng.random() < p
        self.rng = rng
        self.upper = chance(0.15)
        self.mixed = chance(0.1)
        self.blanks = chance(0.12)
        self.indent = chance(0.4)
        self.zeros = chance(0.08)
        self.decimals = chance(0.03)
        self.numbers = chance(0.1)
        self.comments = rng.choice((0, 0, 0, 0.2))
        self.block_delete = chance(0.07)
        self.names = {}
        if chance(0.25):
            words = rng.sample(("probe", "Pocket_1", "my sub", "face-mill", "a", "loop", "x10"), 7)
            for label in sorted({line.label for line in lines if isinstance(line.label, int)}):
                if words and chance(0.6):
                    self.names[label] = words.pop()

    def spell_label(self, label):
        rng = self.rng
        if isinstance(label, str):      # the name of a file
            name = label if label.isdigit() and rng.random() < 0.7 else "<%s>" % label
            return name.upper() if self.mixed and rng.random() < 0.5 else name
        if label in self.names:
            name = self.names[label]
            return "<%s>" % (name.upper() if self.mixed and rng.random() < 0.5 else name)
        if self.zeros and rng.random() < 0.5:
            return "%0*d" % (rng.choice((4, 5)), label)
        if self.decimals and rng.random() < 0.3:
            return "%d.0" % label
        return "<%d>" % label if self.mixed and rng.random() < 0.3 else str(label)

    def spell_word(self, word):
        rng = self.rng
        if self.mixed:
            word = "".join(rng.choice((c, c.upper())) for c in word)
        if self.upper:
            word = word.upper()
        if self.blanks and rng.random() < 0.4 and len(word) > 2:
            cut = rng.randrange(1, len(word))
            word = word[:cut] + rng.choice((" ", "  ", "\t")) + word[cut:]
        return word

    def spell(self, line, depth):
        rng = self.rng
        if not line.is_oword:
            text = line.plain
        else:
            parts = [self.spell_word("o") + self.spell_label(line.label), self.spell_word(line.keyword),
                     line.argument, line.tail]
            text = rng.choice((" ", " ", " ", "")).join(p for p in parts if p)
        if text == "%" or text.startswith((";", "(")):
            return text
        if self.numbers and rng.random() < 0.7:
            text = "N%d %s" % (rng.randrange(1, 9999), text)
        if self.block_delete and not line.kept and rng.random() < 0.2:
            text = "/" + text
        if rng.random() < self.comments:
            text += rng.choice((" (note)", " ; note", "(o1 endif)", " ;o2 if [1]"))
        return "  " * depth + text if self.indent else text


def spell(lines, rng):
    """The text of a program."""
    style = Style(rng, lines)
    out, depth = [], 0
    for line in lines:
        if line.keyword.startswith("e") and depth:
            depth -= 1
        out.append(style.spell(line, depth))
        if line.keyword in OPENERS:
            depth += 1
    newline = "\r\n" if rng.random() < 0.04 else "\n"
    return newline.join(out) + (newline if rng.random() < 0.97 else "")
