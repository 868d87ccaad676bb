#!/usr/bin/python3
"""Does owlint say of programs that call files what each LinuxCNC version does with them?

usage: called.py --owlint build/release/owlint [--random N] [--seed S]

called/ holds programs that call subs in other files, with a machine's INI; called/outcomes.tsv what four versions of
LinuxCNC's interpreter did with each.  A run that stops must be claimed by a finding that stops and quotes the
interpreter's message; a run that ends must not be claimed to stop.  Where rs274 is installed, the outcomes are measured
again for its version.  With --random, N programs of two to four files (generate.py) with their choices made beforehand
are run by `rs274 -i` and held against owlint in the same way.
"""
import argparse
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

import bundle
import rs274
from generate import generate_files

HERE = os.path.dirname(os.path.abspath(__file__))
FOLDER = os.path.join(HERE, "called")
# A message that names a file which was never read, and bytes that depend on the moment.
UNCERTAIN = re.compile(r"file '\(uninitialised bytes\)' found")


def versions(said):
    """The owlint versions that a measured LinuxCNC version stands for."""
    major, minor = said.split(".")[:2]
    # Nothing that differs between 2.7 and 2.8 is in called files.
    return {"2.8": ("2.7", "2.8")}.get("%s.%s" % (major, minor), ("%s.%s" % (major, minor),))


def plain(message):
    message = UNCERTAIN.sub("file found", message)
    message = message.replace(" (%)", "").replace(" (M2)", "")      # as later versions word it
    return re.sub(r"\s+", "", re.sub(r"^\d+: ", "", message)).lower()


def findings(owlint, folder, program, version):
    command = [owlint, "check", "--isolated", "--ini", "machine.ini", "--linuxcnc", version, "--format", "json", program]
    done = subprocess.run(command, capture_output=True, cwd=folder, timeout=60)
    return [f for file in json.loads(done.stdout)["files"] for f in file["findings"]]


def judge(outcome, message, found):
    """What owlint says wrongly of this outcome, or None."""
    stops = [f for f in found if f["stops"] and f["reach"] != "never"]
    if outcome == "ok":
        sure = [f for f in stops if f["severity"] == "error" and f["reach"] == "always"]
        return "it runs, owlint says %s" % [f["message"] for f in sure] if sure else None
    if not any(plain(f.get("interpreter", "")) == plain(message) for f in stops):
        return "it stops (%s), owlint says %s" % (message, [f.get("interpreter") for f in stops])
    return None


def measured(folder, program):
    """What the installed rs274 does: -> (outcome, message), with names as seen from the folder"""
    outcome = rs274.run(os.path.join(folder, program), "machine")
    message = outcome.message.split("\n")[0].replace("PROGRAM", program).replace(folder + "/", "")
    return outcome.kind, message


def choose(text, rng):
    """The program with every unknown value replaced by a number."""
    text = re.sub(r"#\[[12]\d\d\d\+#99\]", lambda _: str(rng.randint(0, 1)), text)
    return re.sub(r"#\[[34]\d\d\d\+#99\]", lambda _: str(rng.randint(0, 2)), text)


def random_programs(owlint, count, seed):
    """-> (problems, how often each outcome was)"""
    from oracle import scratch      # only here: it needs the interpreter's Python module
    problems, seen = [], {}
    for number in range(count):
        rng = random.Random("choices/%d/%d" % (seed, number))
        text = choose(generate_files("%d/%d" % (seed, number)), rng)
        with tempfile.TemporaryDirectory(prefix="owlint-called-", dir=scratch()) as folder:
            bundle.write(folder, bundle.split(text))
            with open(os.path.join(folder, "machine.ini"), "w", encoding="ascii") as f:
                f.write("[RS274NGC]\nSUBROUTINE_PATH = subs\n")
            kind, message = measured(folder, bundle.MAIN)
            found = findings(owlint, folder, bundle.MAIN, "2.9")
        seen[kind] = seen.get(kind, 0) + 1
        if kind == "hang":
            wrong = None if any(f["code"] in ("OW508", "OW510") for f in found) else "it never ends, owlint does not say so"
        else:
            wrong = judge(kind, message, found)
        if wrong:
            problems.append("random program %d/%d: %s\n%s" % (seed, number, wrong, text))
    return problems, seen


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--random", type=int, metavar="N", help="compare N random programs instead")
    parser.add_argument("--seed", type=int, default=int(time.time()))
    options = parser.parse_args(argv)
    owlint = os.path.abspath(options.owlint)
    if options.random:
        print("seed %d" % options.seed, flush=True)
        problems, seen = random_programs(owlint, options.random, options.seed)
        print("\n".join(problems[:5]))
        print("%d programs run with rs274 -i (%s), %d not as owlint says" % (
            options.random, ", ".join("%s %d" % kind for kind in sorted(seen.items())), len(problems)))
        return 1 if problems else 0
    problems, count = [], 0
    with tempfile.TemporaryDirectory(prefix="owlint-called-") as scratch:
        folder = os.path.join(scratch, "called")
        shutil.copytree(FOLDER, folder)
        with open(os.path.join(FOLDER, "outcomes.tsv"), encoding="latin-1") as f:
            rows = [line.rstrip("\n").split("\t") for line in f][1:]
        for program, said, outcome, message, _ in rows:
            for version in versions(said):
                count += 1
                wrong = judge(outcome, message, findings(owlint, folder, program, version))
                if wrong:
                    problems.append("%s, LinuxCNC %s: %s" % (program, said, wrong))
            if rs274.available and said.startswith("2.9.0"):
                real = measured(folder, program)
                if real[0] != outcome or (outcome != "ok" and plain(real[1]) != plain(message)):
                    problems.append("%s: recorded %s %s, rs274 says %s %s" % (program, outcome, message, *real))
    print("\n".join(problems) if problems else "all as owlint says")
    print("%d outcomes of %d programs%s" % (count, len({r[0] for r in rows}), ", measured again with rs274" if rs274.available else ""))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
