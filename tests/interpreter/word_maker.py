"""Random programs of words: codes with fitting and unfitting words, odd numbers, settings, comments; and mutations.

`program(rng)` gives the text, bytes as latin-1.  Most lines run, so that a stop comes after others have set modes.  Most
lines carry their number in a comment: then it is known which of them the interpreter has stopped at.
"""

MOTIONS = (0, 10, 20, 30, 50, 51, 52, 330, 331, 382, 383, 384, 385, 700, 710, 711, 712, 720, 721, 722, 730, 740, 760, 800,
           810, 820, 830, 840, 850, 860, 870, 880, 890)
G_CODES = MOTIONS + (40, 53, 100, 170, 171, 180, 181, 190, 191, 200, 210, 280, 281, 300, 301, 400, 410, 411, 420, 421, 430,
                     431, 432, 490, 520, 530, 540, 550, 560, 570, 580, 590, 591, 592, 593, 610, 611, 640, 70, 80, 900,
                     901, 910, 911, 920, 921, 922, 923, 930, 940, 950, 960, 970, 980, 990)
GENTLE = (0, 10, 10, 0, 910, 900, 170, 180, 190, 800, 920, 430, 540, 980, 610, 940, 901, 430)
M_CODES = (0, 1, 3, 4, 5, 6, 7, 8, 9, 19, 48, 49, 50, 51, 52, 53, 60, 61, 62, 63, 64, 65, 66, 67, 68, 70, 71, 73, 100, 150)
LAST_CODES = (2, 30, 99, 72)
# The words that a code may take; others are for those that it may not.
FITTING = {20: "XYIJ", 30: "XYIJ", 50: "XYIJPQ", 51: "XYIJ", 52: "XYPL", 330: "ZK", 331: "ZK", 760: "ZPIJKRQHEL$", 730: "XZRQ",
           810: "XYZRL", 820: "XYZRPL", 830: "XZRQ", 870: "XYZRIJK", 100: "LPXYZR", 410: "D", 411: "DL", 420: "D", 430: "H",
           40: "P", 640: "PQ", 960: "SD", 700: "XZQDEP", 710: "XZQDIR", 720: "XZQDIR"}
FITTING_M = {19: "RPQ$", 66: "PLQE", 67: "EQ", 68: "EQ", 62: "P", 63: "P", 64: "P", 65: "P", 61: "Q", 50: "P", 51: "P$", 52: "P",
             3: "S$", 4: "S$", 100: "PQ"}
LETTERS = "abcdefghijklmpqrstuvwxyz@^$"
# Lines that leave a motion mode behind.
SETUPS = (
    ("G0 X1",), ("G1 X1",), ("G2 X1 I.5",), ("G3 X1 I.5",), ("G5 X1 Y1 I0 J0 P1 Q1",), ("G5.1 X1 Y1 I1 J1",),
    ("G1 X1", "G5.2 X1 Y1 P1 L3"),
    ("G1 X1", "G5.2 X1 Y1 P1 L3", "G5.2 X2 P1", "G5.2 X3 Y2 P1", "G5.2 X4 P1", "G5.3"), ("M3 S100", "G33 Z1 K1"),
    ("M3 S100", "G33.1 Z-1 K1"), ("G38.2 Z-1",), ("G38.3 Z-1",), ("G38.4 Z-2",), ("G38.5 Z-2",),
    ("G73 X1 Z-1 R1 Q1",), ("M4 S100", "G74 X1 Z-1 R1"), ("M3 S100", "G18 G0 X1 Z1", "G76 P.1 Z-1 I-.1 J.01 K.05"),
    ("G80",), ("G81 X1 Z-1 R1",), ("G82 X1 Z-1 R1 P1",), ("G83 X1 Z-1 R1 Q.5",), ("M3 S100", "G84 X1 Z-1 R1"),
    ("G85 X1 Z-1 R1",), ("M3 S100", "G86 X1 Z-1 R1 P1"), ("M3 S100", "G87 X1 Z-1 R1 I1 J1 K-.5"),
    ("M3 S100", "G88 X1 Z-1 R1 P1"), ("G89 X1 Z-1 R1 P1",), ("G91",), ("G91", "G0 X1"), ("G18",), ("G18", "G1 X1"),
    ("G19 G0 X1",), ("G17.1 G0 X1",), ("M3 S100",), ("G53 G1 X1",),
)
NUMBERS = """
    0 1 1 1 2 2 3 .5 10 -1 -1 -2 5 0.5 1.5 -0.5 20 100 360 361 1.00009 1.0002 0.9999 0.9998 1.9995 .9985
    1.0009 1.0011 2147483647 2147483648 99999999999 -99999999999 -0 -.9999 -1.0001 .0001 .4 .49 1.49 9.5 10.1
    9 11 -.00005 4.99991 3.00009 359.9999 360.0001 -1.00001 -.99999 +2 05 5. 0002.50 -00
""".split()
G_NUMBERS = """
    0.0001 0.9999 1.05 -.05 -1 100 99.9 0.99999 1.00009 1.00011 1.00001 0.99992 214748364.7 214748364.8
    99999999999 -99999999999 -0 0.05 33.1001 33.09999 33.10011 38.20009 81.99991 4.9999 5.0999 5.09991 99.99
    99.9999 -.00005 -.0001 6 6.1 12 45 01 000 1. 5.10
""".split()
M_NUMBERS = """
    3.00009 4.99991 3.0002 -1 -.00005 200 199 201 10 98.5 1000 2147483647 2147483648 99999999999 -99999999999
    7.9999 6.9998 98.00005 -2147483648 -2147483649 2147483647.5 03 09. 98
""".split()
COMPUTED = (
    "#1", "#2", "#3", "[#1+2]", "-#2", "[#1/#2]", "#<a>", "#<_g>", "sin[30]", "[1 LT 2]", "##1", "[-1]", "-[1]",
    "abs[-2]", "[2*[#1+1]]", "fix[2.7]", "round[1.5]", "atan[1]/[1]", "[7 mod 3]", "#[#1+1]", "exists[#<a>]", "--1",
    "+-2", "[#3 ** 2]", "# 1", "#<A>", "[#1 eq 1]",
)
BROKEN = (
    "", "[1", "1]", "#", "#<a", "[1/0]", "sqrt[-1]", "1.2.3", "1..2", ".", "-", "1,5", "1O", "O", "#<nope>",
    "[1 2]", "[]", "sin30", "1e5", "1-3", "1+2", "=1", "[1+]", "#0", "#9999", "#1.5", "acos[2]", "atan[1]",
    "[1 xx 2]", "foo", "ln[0]", "[0-1]**.5", "1 .5 .", "(c)1", "1(c)0", "exists[1]", "/2", "*", "l", "S",
)
SETTINGS = (
    "#1=2", "#2=[#2+1]", "#3=-1", "#<a>=1", "#<a>=[#<a>+1]", "#<b>=#1", "#<_g>=5", "#4=#1 #5=#4", "#[#1+3]=7",
    "#1 = 1", "#<new>=[#<new>+1]", "# 2 = 2",
)
BROKEN_SETTINGS = (
    "#1==5", "#1", "#1=", "#5400=1", "#<_x>=1", "#<_feed> = 2", "#0=1", "#1.5=2", "#<a=1", "#1 5", "#5161=1",
    "#5420=1", "#9999=1", "#<b>=#<nope>", "#=1",
)
ODD = (
    "hello world", "X", "X1 X2", "G", "M", "GO X1", "G1 G2", "G0 G80 X1", "M3 M4", "M7 M8", "X1..5",
    "(abort,stop #1)", "(abort,x) G1 X1 (c)", "G1 X2 (abort,here)", "(msg,hi)", "(debug,#1)",
    "(print,#<nope> #1 %d)", "(print) G1 G2", "(log,x", "%", "/", "/ /", "//G0", "N", "N10.", "N10. G0 X1", "N X1",
    "N1.5 X1", "(abort,x) #<_x>=1", "(x) #<_x>=1", "M98 P100 #<a>=5", "X[EXISTS[#1.5]]", "X[1/0**-1]", "X##9",
    "N-1", "N#1", "N10 N20", "X1 N10", "O", "o1", "X1E5", "(a(b)", "(unclosed", "X1)", "G0 X1;)(",
    "stop here please", "T", "T1.5", "T1 M6", "S-1", "F-1", "F", "H-2 G43", "M110", "M98", "X1 O1", "G1 X1 Y",
    "IF [#1 EQ 1] GOTO 20", "G4", "G4 P1", "G4 P-1", "P-1 P2 G4", "G10", "G10 L2", "G10 L2 P1.5 X1", "G53 X1",
    "G53 G0 X1", "G91 G53 G0 X1", "G28 X1", "G28 G0 X1", "G92", "G52 X1", "G80 X1", "X1 Y1", "Z-1", "A1", "U1",
    "@1 ^30", "I1", "J1 K1", "R5", "L2", "G43.1 Z1", "G43.1", "M19", "M19 P3 R5", "M19 R361", "G96",
    "G96 S100 D200", "M2 X", "G0 (c) X1 (d) Y2", "G1 2", "G 1 X 1 0", "M 3 0 X5", "X1 0", "$1 M3", "S1 $0.9", "E1",
    "D1", "G41 D1", "G40", "G64 P.01", "G5.3", "(ordinary)", "; just text", "", " \t ", "G33 Z1", "G76 Z1",
    "G81 Z-1 R1 A1", "F1 G33 Z1 K1", "G99", "M62", "M66 P0", "G2 X2 I1 P0", "G2 X2 I1 P1.5", "M1 M0",
    "M3 S1 M8 M48 M6 M1", "#<p>=1 M98 P100", "G#1 X1", "M#2", "G[#1+1]", "M[9-4]",
)
TAILS = (
    "M2", "M2", "M2", "M2", "M2", "M30", "M02", "m2", "G80 M2", "M2 (end)", "M 2",
)


def g(tenths):
    return "G%d" % (tenths // 10) + (".%d" % (tenths % 10) if tenths % 10 else "")


def number(rng):
    kind = rng.random()
    if kind < 0.86:
        return rng.choice(NUMBERS)
    return rng.choice(COMPUTED) if kind < 0.98 else rng.choice(BROKEN)


def word(letter, rng):
    if letter == "g":
        return g(rng.choice(G_CODES)) if rng.random() < 0.88 else "G" + rng.choice(G_NUMBERS)
    if letter == "m":
        return "M%d" % rng.choice(M_CODES + LAST_CODES) if rng.random() < 0.85 else "M" + rng.choice(M_NUMBERS)
    return letter.upper() + number(rng)


def plain(rng):
    return rng.choice(("1", "2", ".5", "0")) if rng.random() < 0.85 else number(rng)


def words(rng, gentle):
    """The words of one line."""
    some = []
    kind = rng.random()
    if kind < 0.72:
        code = rng.choice(MOTIONS if rng.random() < 0.5 else G_CODES)
        if gentle and rng.random() < 0.7:
            code = rng.choice(GENTLE)
        some.append(g(code))
        fitting = FITTING.get(code, "XYZ" if code in MOTIONS else "")
        some += [letter + plain(rng) for letter in fitting if rng.random() < 0.8]
    elif kind < 0.85:
        some.append(rng.choice("XYZABC") + plain(rng))
    if rng.random() < 0.2:
        code = rng.choice(M_CODES)
        some.append("M%d" % code)
        some += [letter + plain(rng) for letter in FITTING_M.get(code, "") if rng.random() < 0.7]
    if rng.random() < (0.06 if gentle else 0.4):
        for _ in range(rng.choice((1, 1, 1, 2, 2, 3, 5))):
            some.append(word(rng.choice(LETTERS if rng.random() < 0.6 else "gmpqxij@^lr"), rng))
    if rng.random() < 0.01:
        some += ["M%d" % code for code in rng.sample((3, 7, 48, 62, 6, 1, 100), 5)]
    if rng.random() < 0.02:
        some += ["P" + number(rng) for _ in range(2)] + ["Q" + number(rng) for _ in range(2)]
    if rng.random() < 0.12:
        some.append(rng.choice(SETTINGS))
    if rng.random() < (0.005 if gentle else 0.05):
        some.append(rng.choice(BROKEN_SETTINGS))
    if rng.random() < 0.7:
        rng.shuffle(some)
    return some


def line(rng, count):
    """A line with its spelling, and its number in a comment."""
    gentle = rng.random() < 0.85
    kind = rng.random()
    if kind < 0.08:
        text = rng.choice(ODD)
    elif kind < 0.16:
        text = rng.choice(SETTINGS)
    else:
        some = words(rng, gentle)
        comments = rng.random() < 0.05
        text = "".join(one + (rng.choice(("", " ", " (c) ", "(c)")) if comments else " ") for one in some).strip()
        style = rng.random()
        if style < 0.06:
            text = text.replace(" ", "")
        elif style < 0.10:
            text = " ".join(text)
        elif style < 0.13:
            text = text.replace(" ", "\t")
        elif style < 0.23:
            text = text.lower()
        if rng.random() < 0.05:
            text = "N%d %s" % (count, text)
        if rng.random() < 0.03:
            text = rng.choice(("/", "/ ", " /")) + text
    mark = rng.random()
    return text + (" (%d)" % count if mark < 0.5 else " ;%d" % count if mark < 0.95 else "")


def flow(lines, rng):
    """The lines, some of them in a block or in a sub."""
    if rng.random() < 0.55 or len(lines) < 6:
        return lines
    first = rng.randrange(len(lines) - 3)
    last = rng.randrange(first + 1, len(lines))
    head, inner, tail = lines[:first], lines[first:last], lines[last:]
    label = rng.choice((100, 200, 300))
    kind = rng.random()
    if kind < 0.55:
        test = rng.choice(("0", "1", "#1 EQ 1", "#1 EQ 9", "#<a> GT 0", "#5399 EQ 0", "#77 GT 5", "#5420 LT 5"))
        middle = rng.randrange(len(inner) + 1) if rng.random() < 0.4 else None
        inner = inner if middle is None else inner[:middle] + ["o%d else" % label] + inner[middle:]
        return head + ["o%d if [%s]" % (label, test)] + inner + ["o%d endif" % label] + tail
    if kind < 0.65:
        count = rng.choice(("0", "1", "2", "#1"))
        return head + ["o%d repeat [%s]" % (label, count)] + inner + ["o%d endrepeat" % label] + tail
    sub = ["o%d sub" % label] + inner + ["o%d endsub" % label]
    if rng.random() < 0.5:
        return sub + head + tail
    at = rng.randrange(len(tail) + 1)
    return sub + head + tail[:at] + ["o%d call%s" % (label, rng.choice(("", " [1]", " [1] [2]")))] + tail[at:]


def mutated(text, rng):
    """One to four bytes changed."""
    for _ in range(rng.choice((1, 1, 2, 4))):
        at = rng.randrange(len(text) + 1)
        kind = rng.random()
        if kind < 0.3:
            text = text[:at] + text[at + 1:]
        elif kind < 0.5:
            text = text[:at] + rng.choice("0123456789.-+#[]()<>=/%;,oOgGmMxXnN*&'\"_ \t~{") + text[at:]
        elif kind < 0.6:
            code = rng.choice((0, 1, 9, 10, 11, 12, 13, 27, 127, 128, 194, 195, 226, 255, rng.randrange(256)))
            text = text[:at] + chr(code) + text[at + rng.randrange(2):]
        elif kind < 0.8:
            text = text[:at] + text[at:at + 2][::-1] + text[at + 2:]
        else:
            other = rng.randrange(len(text) + 1)
            text = text[:at] + text[other:other + rng.randrange(1, 8)] + text[at:]
    return text


def program(rng):
    lines = ["F100"] if rng.random() < 0.95 else []
    if rng.random() < 0.93:
        lines.append("#1=1 #2=2 #3=-1 #<a>=1 #<_g>=3")
    if rng.random() < 0.6:
        lines.append("M3 S100")
    if rng.random() < 0.5:
        lines += rng.choice(SETUPS)
    lines += [line(rng, count) for count in range(len(lines) + 1, len(lines) + rng.randint(5, 30))]
    lines = flow(lines, rng)
    if rng.random() < 0.93:
        lines.append(rng.choice(TAILS))
    if rng.random() < 0.08:
        lines += rng.choice((["garbage"], ["%"], ["G1 G2"], ["M2"]))
    if rng.random() < 0.06:
        lines = ["%"] + lines + (["%"] if rng.random() < 0.8 else [])
    if rng.random() < 0.01:
        lines.insert(rng.randrange(len(lines)), "G0 X1 (%s)" % ("x" * rng.randint(235, 250)))
    newline = "\r\n" if rng.random() < 0.05 else "\n"
    text = newline.join(lines) + newline * (rng.random() < 0.95)
    return mutated(text, rng) if rng.random() < 0.3 else text
