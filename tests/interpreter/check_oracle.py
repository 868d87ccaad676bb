#!/usr/bin/python3
"""Is oracle.py right, or stand_alone.py?  Compares it with a start of the stand-alone `rs274` for each run, on random programs.

usage: check_oracle.py [--programs 200] [--seed S] [--model model.py] [--modes]

Both get the same choices.  Every line carries a comment with its number, so the line that `rs274` prints after a message
is known for certain.  With --model the same runs are also put to a program with the interface of a class
`Run(lines)` whose `run()` gives (rule code, line): the O-word state machine as a model.  With --modes it is stand_alone.py
that is asked, about programs in which modes decide.  Exit status 1 on a difference.
"""
import argparse
import importlib.util
import os
import random
import re
import signal
import subprocess
import sys
import time
from collections import Counter

from bundle import is_bundle
from explore import Explorer
from generate import generate, generate_modes
from messages import EOF, call_line, codes_of, renumbered, warned_lines
from oracle import PADDING, Interpreter, for_interpreter, pad
from stand_alone import StandAlone

TIME_LIMIT_S = 1.0


def numbered(text):
    """The program with a comment on each line that can have one."""
    lines = text.split("\n")
    for at, line in enumerate(lines):
        if line.strip() and line.strip() != "%":
            lines[at] = line.rstrip("\r") + " (u%d)" % (at + 1)
    return "\n".join(lines)


def stand_alone(interpreter, text, choices, message):
    """The same run with `rs274`: -> (outcome, codes, line).

    It prints the warnings and the error without a break; whether the error is `message` can be told all the same."""
    path = os.path.join(interpreter.folder, "alone")
    with open(path, "w", encoding="latin-1", newline="") as f:
        f.write(for_interpreter(pad(text) if interpreter.warnonly else text))
    # The tool table lies in the home folder, in memory that another start shortens.
    home = os.path.join(interpreter.folder, "home")
    os.makedirs(home, exist_ok=True)
    environment = dict(os.environ, CHOICES="".join(map(str, choices)), HOME=home)
    proc = subprocess.Popen(["rs274", "-g", "-i", interpreter.ini, path], cwd=interpreter.folder, env=environment,
                            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        _, error = proc.communicate(timeout=TIME_LIMIT_S)
    except subprocess.TimeoutExpired:
        proc.kill()
        _, error = proc.communicate()
    error = error.decode("latin-1").replace("executing", "", 1)
    if proc.returncode == -signal.SIGKILL:
        return "hang", frozenset(), 0
    if proc.returncode < 0:
        warned, codes = warned_lines(error)
        return "crash", codes, warned[-1] - PADDING if warned else 0
    if proc.returncode == 0:
        return "ok", frozenset(), 0
    if "restore_settings" in error:
        return "error", codes_of(error), 0
    everything, _, last = error.rstrip("\n").rpartition("\n")
    everything = everything.replace(path, "PROGRAM")
    if interpreter.warnonly:
        everything = renumbered(everything, lambda line: line - PADDING)
    codes = codes_of(message if message and everything.endswith(message) else everything)
    place = re.findall(r"\(u(\d+)\)", last)
    return "error", codes, 0 if EOF in codes else call_line(message) or (int(place[-1]) if place else 0)


def load_model(path):
    spec = importlib.util.spec_from_file_location("model", path)
    model = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(model)
    return model


class Taking(dict):
    """Named parameters of the model; #<_choice> and #<_count> take the next choice."""

    def __init__(self, choices):
        super().__init__()
        self.choices = list(choices)

    def get(self, name, default=None):
        if name in ("_choice", "_count"):
            return float(self.choices.pop(0)) if self.choices else 0.0
        return super().get(name, default)


def modelled(model, text, choices):
    """The same run in the model: -> (outcome, codes, line), or None for what it does not cover."""
    if re.search(r"(?im)^\s*%|M98|M99|#<width|1/#|^\s*(N\d+\s*)?/", text):
        return None
    lines = for_interpreter(text).replace("\r", "").rstrip("\n").split("\n")
    run = model.Run([re.sub(r"(?i)^\s*n\d+", "", line) for line in lines])
    run.named = Taking(choices)
    try:
        code, line = run.run()
    except (SyntaxError, ValueError, NameError, TypeError, ZeroDivisionError, AttributeError):
        return None
    outcome = {"": "ok", "HANG": "hang"}.get(code, "error")
    return outcome, frozenset(code.split("|")) if outcome == "error" else frozenset(), line


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--programs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--model", help="compare with this model, too")
    parser.add_argument("--modes", action="store_true", help="ask stand_alone.py")
    options = parser.parse_args(argv)
    make = generate_modes if options.modes else generate
    model = load_model(options.model) if options.model else None
    counts = Counter()
    print("seed %d" % options.seed)
    for warnonly in (False,) if options.modes else (False, True):
        interpreter = (StandAlone if options.modes else Interpreter)(warnonly)
        for number in range(options.programs):
            text = make("check %d/%d" % (options.seed, number))
            if is_bundle(text):
                continue
            rng = random.Random(number)
            explorer = Explorer(interpreter, text, number)
            explorer.explore(12, 6)
            for choices in [rng.choice(sorted(explorer.ends.values(), key=str)).choices, rng.randbytes(40)]:
                choices = bytes(c % 3 for c in choices)
                run = interpreter.run(numbered(text), choices)
                mine = run.outcome, run.codes, run.line
                alone = stand_alone(interpreter, numbered(text), choices, run.message)
                counts["runs"] += 1
                if run.message.startswith("M7x"):       # which line that was, rs274 does not say
                    mine = *mine[:2], 0
                if mine != alone:
                    counts["differences"] += 1
                    print("program %d (warnonly %s) choices %s\n  oracle %s\n  rs274  %s" % (
                        number, warnonly, list(choices), mine, alone))
                second = modelled(model, text, run.choices) if model and not warnonly else None
                if second:
                    counts["runs of the model"] += 1
                    line = run.line if "OW208" not in run.codes else 0
                    if second != (run.outcome, run.codes, line):
                        counts["differences"] += 1
                        print("program %d choices %s\n  oracle %s\n  model  %s" % (
                            number, list(run.choices), (run.outcome, sorted(run.codes), line), second))
        interpreter.close()
    print(", ".join("%s: %d" % item for item in sorted(counts.items())))
    return 1 if counts["differences"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
