"""The inputs of the benchmarks: each function yields the lines of a program, in a fixed order for a fixed size."""
import random


def dense(megabytes):
    """Every second line an O-word: subs with branches and loops, motion in between, each sub called once."""
    rng = random.Random(2)
    moves = ["G1 X%.4f Y%.4f Z%.4f F%d" % (rng.uniform(0, 300), rng.uniform(0, 200), rng.uniform(-20, 5),
                                           rng.choice((400, 600, 900))) for _ in range(5000)]
    move = iter_forever(moves)
    written, number, calls = 0, 0, []
    while written < megabytes * 1_000_000:
        lines = ["o<part%d> sub" % number, "  #<left> = #1"]
        for r in range(6):
            k = 100 + 10 * r
            lines += ["  o%d if [#2 GT %d]" % (k, r), "    " + next(move), "  o%d elseif [#2 LT -%d]" % (k, r + 1),
                      "    " + next(move), "  o%d else" % k, "    " + next(move), "  o%d endif" % k, "  " + next(move),
                      "  o%d while [#<left> GT %d.5]" % (k + 1, r), "    " + next(move), "    o%d if [#<left> EQ #3]" % (k + 2),
                      "      " + next(move), "      o%d break" % (k + 1), "      " + next(move), "    o%d endif" % (k + 2),
                      "    #<left> = [#<left> - 1]", "  o%d endwhile" % (k + 1), "  " + next(move),
                      "  o%d repeat [#4]" % (k + 3), "    " + next(move), "  o%d endrepeat" % (k + 3), "  " + next(move)]
        lines += ["o<part%d> endsub [#<left>]" % number, ""]
        calls += ["o<part%d> call [5] [#500] [%d] [2]" % (number, number % 7), next(move)]
        written += sum(map(len, lines)) + len(lines) + 80
        number += 1
        yield from lines
        if len(calls) > 2000:
            yield from calls
            calls = []
    yield from calls
    yield "M2"


def iter_forever(items):
    while True:
        yield from items


def motion(mebibytes, blocks=20):
    """A CAM program: positions, and an O-word block now and then."""
    rng = random.Random(1)
    place = lambda: "X%.4f Y%.4f Z%.4f" % (rng.uniform(0, 300), rng.uniform(0, 200), rng.uniform(-20, 5))
    piece = "\n".join(("G1 " if i % 10 == 0 else "") + place() for i in range(40000))
    pieces = (mebibytes << 20) // len(piece) + 1
    yield "%"
    yield "G21 G90 F800"
    for number in range(pieces):
        if number % max(1, pieces // blocks) == 0:
            yield "o%d if [#%d GT 0]\n  G0 Z5\no%d endif" % (100 + number, 500, 100 + number)
        yield piece
    yield "M2"
    yield "%"


def json_texts(mebibytes):
    """The same positions as JSON: the text in large pieces."""
    rng = random.Random(1)
    piece = ",\n".join('{"x":%.4f,"y":%.4f,"z":%.4f}' % (rng.uniform(0, 300), rng.uniform(0, 200), rng.uniform(-20, 5)) for _ in range(40000))
    yield "["
    for _ in range((mebibytes << 20) // len(piece)):
        yield piece + ",\n"
    yield piece + "]\n"


def small(number):
    """A program of 4 KiB as a shop has thousands."""
    rng = random.Random(number)
    lines = ["(part %d)" % number, "G21 G90", "o100 sub", "  G0 X#1 Y#2", "  G1 Z-2 F100", "  G0 Z5", "o100 endsub", "#<n> = 0",
             "o110 while [#<n> LT 6]", "  o100 call [#<n> * 20] [10]", "  #<n> = [#<n> + 1]", "o110 endwhile"]
    end = ["o120 if [#500 GT 0]", "  G0 Z50", "o120 endif", "M2"]
    size = sum(map(len, lines + end)) + len(lines + end)
    while size < 4070:
        lines.append("G1 X%.3f Y%.3f F%d" % (rng.uniform(0, 300), rng.uniform(0, 200), rng.choice((300, 600))))
        size += len(lines[-1]) + 1
    return lines + end


def twenty_lines():
    return ["o100 sub", "  o110 if [#1 GT 5]", "    G1 X[#1] F100", "  o110 else", "    G1 X5", "  o110 endif", "  #<a> = 0",
            "  o120 while [#<a> LT 3]", "    G1 Y[#<a>]", "    #<a> = [#<a> + 1]", "  o120 endwhile", "o100 endsub", "G21 G90",
            "o100 call [1]", "o100 call [7]", "o130 repeat [3]", "  G1 Z1", "o130 endrepeat", "G0 Z5", "M2"]


def nested(depth):
    for i in range(depth):
        yield "o%d if [#%d GT 1]" % (i, 100 + i % 50)
    for i in reversed(range(depth)):
        yield "o%d endif" % i
    yield "M2"


def labels(count):
    for i in range(count):
        yield "o%d if [#100 GT %d]" % (i, i)
        yield "o%d endif" % i
    yield "M2"


def chain(count):
    """Each sub calls the next; the tenth level is the end for LinuxCNC."""
    for i in range(count):
        yield from ("o%d sub" % i, "  o%d call" % (i + 1), "o%d endsub" % i)
    yield "o1 call"
    yield "M2"


def fan(count):
    """As many subs as calls, each called once."""
    for i in range(count):
        yield from ("o%d sub" % i, "  G1 X#1", "o%d endsub" % i)
    for i in range(count):
        yield "o%d call [%d]" % (i, i % 9)
    yield "M2"


def calls(count):
    yield from ("o1 sub", "o2 if [#1]", "o2 endif", "o1 endsub")
    for i in range(count):
        yield "o1 call [%d]" % i
    yield "M2"


def redefined(count):
    """One label opened again and again on paths that exclude each other or not."""
    for i in range(count):
        yield from ("o%d if [#%d]" % (i + 10, 100 + i % 900), "o5 if [1]", "o5 endif", "o%d endif" % (i + 10))
    yield "M2"


def doubling(depth):
    """Each sub calls the one before twice: two to the power of `depth` paths."""
    for i in range(depth):
        yield "o%d sub" % i
        if i:
            yield "o%d call [#1]" % (i - 1)
            yield "o%d call [#2]" % (i - 1)
        yield "o%d endsub" % i
    yield "o%d call [1] [2]" % (depth - 1)
    yield "M2"


def long_line(megabytes):
    yield "G1 " + "X" * (megabytes * 1_000_000)
    yield "M2"
