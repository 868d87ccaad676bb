"""Makes a program rougher: the careless spellings and slips that owlint has fixes for, which generate.py makes seldom."""
import random
import re

_OWORD = re.compile(r"^(\s*)(/?\s*(?:[nN]\d+\s*)?)([oO])(?=[\d<\s])(.*)$")

_COMMENTS = ("(note)", "; note", "(one) (two)", "(MSG,hello)", "(PROBEOPEN points.txt)", "(LOGCLOSE)", "(PRINT,#1)", ";(odd",
             "(a) ; b", "(open", "; MSG,x", "(\xfcber)", "( o100 call )", "(DEBUG,x)", ";py,x=1", "(PROBECLOSE)", "(AXIS,hide)", "(owlint: ignore OW1)")
_TAILS = ("G0 X9", "M5", "o1 call", "#7=1", "M2", "(c) G0 X8", "/", "x", "G4 P0 (c)", "[1]", "then")
_HEADS = ("G0 X7 ", "#6=2 ", "(c) ", "N5 /", "/N5 ", "N5 ", "M5 ", "/ ", "G0 X6 (c) ", "N5 / ", "%")


def roughen(text, seed):
    """The text with a few of its lines changed."""
    rng = random.Random("rough/%s" % seed)
    newline = "\r\n" if "\r\n" in text else "\n"
    lines = text.split(newline)
    owords = [at for at, line in enumerate(lines) if _OWORD.match(line)]
    for at in rng.sample(owords, min(len(owords), rng.choice((1, 1, 2, 3, 5)))):
        blanks, before, letter, rest = _OWORD.match(lines[at]).groups()
        slip = rng.random()
        if slip < 0.35:
            rest = rest.rstrip("\r") + rng.choice(("", " ", "\t")) + rng.choice(_COMMENTS)
        elif slip < 0.5:
            rest += " " + rng.choice(_TAILS)
        elif slip < 0.65:
            before = rng.choice(_HEADS)
        elif slip < 0.75:
            letter = "0"
        elif slip < 0.85:
            rest = re.sub(r"\d+", lambda m: rng.choice(("0%s", "%s.0", " %s", "00 %s")) % m[0], rest, count=1)
        elif slip < 0.92:
            letter = "O"
        elif re.search(r"if|while|repeat|sub|else", rest):
            # An end of another kind, or with another label.
            rest = re.sub(r"end(if|while|repeat|sub)", lambda m: "end" + rng.choice(("if", "while", "repeat", "sub")), rest)
            rest = re.sub(r"^\d+", lambda m: str(int(m[0]) + rng.choice((0, 1, 10))), rest)
        changed = blanks + before + letter + rest
        # Both now and then: a line that is passed over may have another one do its work.
        lines[at] = changed if rng.random() < 0.8 else newline.join(rng.sample((lines[at], changed), 2))
    if rng.random() < 0.2:      # without its end
        lines = [line for line in lines if line.strip().upper() not in ("M2", "M30")]
    if rng.random() < 0.15:     # an early way out of a sub
        ends = [at for at, line in enumerate(lines) if re.search(r"endsub", line)]
        if ends:
            at = rng.choice(ends)
            lines[at:at] = ["o9901 if [#[1000+#99]]", re.match(r"[^\[(;]*", lines[at])[0], "o9901 endif"]
    if rng.random() < 0.03:
        lines[0] = "\xef\xbb\xbf" + lines[0]
    return newline.join(lines)
