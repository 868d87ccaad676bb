#!/usr/bin/python3
"""Random O-word programs: sound ones, sound ones with mistakes, and soup; of several files; with values, modes, places.

usage: generate.py [--seed S] [--count N] FOLDER     writes FOLDER/p00000.ngc …

`generate(seed)` gives one program's text; the same seed gives the same text.  A program is made in two steps: a list of
`Line`s (maker.py: what the interpreter understands), then spelling.py writes them in one of many styles.  Mistakes
(mistakes.py) are made in the list, so that a moved line keeps its meaning.
"""
import argparse
import os
import random
import sys
from dataclasses import replace

from maker import Line, Maker
from mistakes import misspell, mutate
from mode_maker import ModeMaker
from place_maker import PlaceMaker
from spelling import spell
from value_maker import ValueMaker


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


def generate_modes(seed):
    """A program in which modes decide, of several files now and then."""
    rng = random.Random("modes/%s" % seed)
    if rng.random() < 0.06:
        return generate_files(seed, ModeMaker)
    for _ in range(100):
        maker = ModeMaker(rng)
        lines = maker.sound() if rng.random() < 0.93 else maker.fanuc()
        if rng.random() < 0.04:
            lines = mutate(lines, maker, rng)
        if 8 <= len(lines) <= 45:
            break
    return spell(lines, rng)


def generate_places(seed):
    """A program in which it matters where the machine stands, of several files now and then."""
    rng = random.Random("places/%s" % seed)
    if rng.random() < 0.05:
        return generate_files(seed, PlaceMaker)
    for _ in range(100):
        maker = PlaceMaker(rng)
        lines = maker.sound() if rng.random() < 0.96 else maker.fanuc()
        if 8 <= len(lines) <= 45:
            break
    return spell(lines, rng)


def generate_files(seed, make=Maker):
    """A bundle (bundle.py) of a program and one to three files that it calls, with this seed."""
    rng = random.Random("files/%s" % seed)
    names = rng.sample(("drill", "probe_z", "300", "301", "face"), rng.randint(1, 3))
    helper = rng.choice((500, 500, "step")) if rng.random() < 0.3 else None      # of one label in several files
    texts = {}
    for name in (None, *names):
        for _ in range(100):
            maker = make(rng)
            lines = maker.sound() if name or rng.random() < 0.8 else maker.soup()
            for _ in range(rng.choice((0, 0, 1, 1, 2))):
                lines = mutate(lines, maker, rng)
            if len(lines) <= 28:
                break
        lines = [line for line in lines if not (name and line.plain == "%" and rng.random() < 0.7)]
        if name:
            lines = fanuc_file(name, maker) if name.isdigit() and rng.random() < 0.2 else called_file(lines, name, helper, maker, rng)
        # Calls of the other files, now and then of one that is not there.
        for _ in range(rng.choice((1, 1, 2)) if not name else rng.choice((0, 0, 1))):
            target = rng.choice([n for n in names if n != name] or ["nowhere"]) if rng.random() < 0.96 else "nowhere"
            fanuc = target.isdigit() and rng.random() < 0.15
            lines.insert(rng.randrange(len(lines) + 1), Line(plain="M98 P%s" % target) if fanuc else maker.oword(target, "call"))
        if not name and rng.random() < 0.15:        # a sub of the program with the name of a file, or of a helper
            lines[0:0] = maker.definition(rng.choice([*names, helper or names[0]]), 3)
        if rng.random() < 0.08:
            lines = misspell(lines, maker, rng)
        texts[name] = spell(lines, rng)
    text = texts.pop(None)
    newline = "\r\n" if "\r\n" in text else "\n"
    for name, part in texts.items():
        folder = "subs/" if rng.random() < 0.6 else ""
        text += ("" if text.endswith("\n") else newline) + "; file: %s%s.ngc\n" % (folder, name) + part
    return text


def called_file(lines, name, helper, maker, rng):
    """The lines of a file that is called `name`: mostly the sub of that name, with helpers behind or before it."""
    body = [line for line in lines if line.plain not in ("M2", "M30", "%")] if rng.random() < 0.8 else lines
    own = [maker.oword(name, "sub")] + maker.block(6, 1, [], name) + [maker.oword(name, "endsub")]
    if rng.random() < 0.5:      # what the lines define stays, as helpers
        cut = rng.randrange(len(lines) + 1) if rng.random() < 0.3 else 0
        before, after = lines[:cut], lines[cut:]
    elif not any(line.keyword in ("sub", "endsub") for line in body):
        before, own, after = [], [own[0], *body, own[-1]], []
    else:
        before, after = [], lines
    if helper and rng.random() < 0.8:
        own.insert(rng.randrange(1, len(own)), maker.oword(helper, "call"))
        definition = maker.definition(helper, 4)
        before, after = (definition + before, after) if rng.random() < 0.2 else (before, definition + after)
    if rng.random() < 0.15:     # passed over when the file is called
        before = [maker.plain() for _ in range(rng.randint(1, 3))] + before
    lines = before + inside(own, maker, rng) + after
    if rng.random() < 0.06:
        lines = [replace(line, label=rng.choice((name, 77))) if line.label == name else line for line in lines]
    if rng.random() < 0.06:
        del lines[rng.randrange(len(lines))]
    return lines


def inside(own, maker, rng):
    """A file's own sub, now and then with what does not belong into one."""
    own = list(own)
    at = rng.randrange(1, len(own))
    kind = rng.random()
    label = maker.label()
    if kind < 0.1:
        inner = maker.definition(label, 3)
        own[at:at] = inner + ([maker.oword(label, "call")] if rng.random() < 0.6 else [])
    elif kind < 0.16:
        own.insert(at, maker.oword(label, "endsub"))
    elif kind < 0.22:
        own.insert(at, Line(plain=rng.choice(("M2", "M30"))))
    return own


def fanuc_file(name, maker):
    """A file for M98."""
    return [Line(int(name))] + maker.block(5, 1, [], None) + [Line(plain="M99")]


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
