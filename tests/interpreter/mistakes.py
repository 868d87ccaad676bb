"""Mistakes for random programs, one at a time."""
from dataclasses import replace

from maker import CONDITIONAL, KEYWORDS, Line

MISSPELT = ("endiff", "els", "esleif", "wend", "endloop", "then", "brake", "until", "subr", "end", "foo")


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
