#!/usr/bin/python3
"""Random machines: an INI, a tool table, a file of parameters, subs for remapped codes and a straight program.

usage: machine_sets.py --owlint build/release/owlint [--sets 400] [--seed S] [--only NUMBER] [--keep DIR]

`rs274 -i -t -v` runs each set.  What it refuses before the first line must be an error of owlint in the INI, the table or the
file; what stops must be claimed with the interpreter's message; what runs must not be claimed to stop.  Lines that rs274 runs
otherwise than LinuxCNC (M6 without T, tools that change places) are not made.

Exit status: 0 all as owlint says; 1 differences; 77 rs274 is not here.
"""
import argparse
import collections
import json
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

import rs274

SKIPPED = 77
BATCH = 50                  # sets in one run of owlint
REFUSED = re.compile(r"Parameter (file|number)|REMAP|modalgroup|argspec|option '|remap function|setting ignored|remapped :|can't (parse|remap)|expecting integer|NULL argument|NGC file")
CODES = ("M400", "M401", "M60", "M6", "M62", "G88.1", "G33.5", "M9", "T", "S", "F", "M1")


def sometimes(rng, chance):
    return rng.random() < chance


class Maker:
    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.files, self.remaps, self.tools = {}, {}, [0]

    def number(self):
        return self.rng.choice(("0", "1", "2", "5", "7.5", "-3", "12.5", "0.25"))

    def argspec(self):
        letters = self.rng.sample("PQRXYEJ", self.rng.randint(0, 3))
        text = "".join(c if sometimes(self.rng, 0.6) else c.lower() for c in letters)
        return self.rng.choice(("", "", ">", "^", "@")) + text + ("1" if sometimes(self.rng, 0.02) else "")

    def sub(self, name, argspec, code):
        rng, lines = self.rng, []
        for _ in range(rng.randint(0, 3)):
            letter = rng.choice(argspec.lower().strip("@^>1") or "p") if sometimes(rng, 0.8) else rng.choice("pqrx")
            lines.append(rng.choice((
                "G4 P0", "G0 X1", "G91", "G90", "F100", "S500", "G20", "G21", "G4 P[ABS[#<%s>]]" % letter, "G0 X#<%s>" % letter,
                "G0 Y[1 / #<%s>]" % letter, "G0 X[#1 + #2]", "#<_kept> = #<%s>" % letter, "o1 if [EXISTS[#<%s>]]\nG0 X#<%s>\no1 endif" % (letter, letter),
                "G1 X2", "#500 = 7", "M3 S100", "G43 H1", "T1" if code not in ("M6",) else "M6", code if sometimes(rng, 0.5) else "G4 P0",
                rng.choice(list(self.remaps) or ["G4 P0"]))))
        label = "other" if sometimes(rng, 0.02) else name
        self.files[name + ".ngc"] = "o<%s> sub\n%s\no<%s> endsub\n" % (label, "\n".join(lines), label)

    def remap(self, number):
        rng = self.rng
        code = rng.choice(CODES)
        if code in self.remaps and not sometimes(rng, 0.05):
            return ""
        name, argspec = "r%d" % number, self.argspec()
        self.sub(name, argspec, code)
        group = {"M6": "6", "M62": "5", "M60": "4", "M1": "4", "M9": "8", "G88.1": "1", "G33.5": "1"}.get(code, rng.choice(("10", "10", "4", "5", "7", "9")))
        if sometimes(rng, 0.03):
            group = rng.choice(("3", "11", "6x", "text", "-1"))
        words = [code]
        if code not in ("T", "S", "F") or sometimes(rng, 0.02):
            words.append("modalgroup=" + group)
        if argspec:
            words.append("argspec=" + argspec)
        words.append("ngc=" + name if not sometimes(rng, 0.02) else rng.choice(("ngc=nothere", "ngc=", "ngc = " + name, "")))
        self.remaps[code] = argspec
        return "REMAP = %s%s\n" % (" ".join(words), rng.choice(("", "", "", " # comment")))

    def ini(self):
        rng = self.rng
        text = "[RS274NGC]\nSUBROUTINE_PATH = .\nPARAMETER_FILE = machine.var\n"
        for key, values in (("OWORD_NARGS", "01"), ("DISABLE_FANUC_STYLE_SUB", "01"), ("DISABLE_G92_PERSISTENCE", "01"), ("INI_VARS", "10"),
                            ("CENTER_ARC_RADIUS_TOLERANCE_INCH", ("0.001", "0.5", "0.00005")), ("CENTER_ARC_RADIUS_TOLERANCE_MM", ("0.01", "7mm"))):
            if sometimes(rng, 0.2):
                text += "%s = %s\n" % (key, rng.choice(values))
        for number in range(rng.choice((0, 0, 1, 1, 2, 3))):
            text += self.remap(number)
        if sometimes(rng, 0.3):
            text += "[TRAJ]\nSPINDLES = %s\nCOORDINATES = XYZABC\n" % rng.choice("123")
        else:
            text += "[TRAJ]\nCOORDINATES = XYZABC\n"
        for axis in "AB":
            if sometimes(rng, 0.2):
                text += "[AXIS_%s]\n%s\n" % (axis, rng.choice(("WRAPPED_ROTARY = 1", "LOCKING_INDEXER_JOINT = 3", "WRAPPED_ROTARY = YES")))
        return text + "[EMCIO]\nTOOL_TABLE = tool.tbl\n[USER]\nDEPTH = 4\nNAME = text\n"

    def table(self):
        rng, lines = self.rng, []
        for place in range(1, rng.randint(1, 6)):
            tool = rng.randint(1, 6)
            line = "T%d P%d" % (tool, place)
            for letter in rng.sample("ZXDIJQ", rng.randint(0, 3)):
                line += " %s%s" % (letter, rng.choice(("1", "0.5", "2")) if letter != "Q" else rng.choice("139"))
            lines.append(rng.choice((line,) * 12 + (line.replace(" ", "\t"), line + " ; comment", line + " R1", "; only a comment", "text", line + " (comment)")))
        return "\n".join(lines) + "\n"

    def parameters(self):
        rng = self.rng
        numbers = sorted({*rng.sample(range(31, 60), 3), 5161, 5181, 5210, 5211, 5220, 5221, 5230, 5241})
        if sometimes(rng, 0.04):
            rng.shuffle(numbers)
        if sometimes(rng, 0.03):
            numbers.append(rng.choice((5602, 9999)))
        return "".join("%d %s\n" % (n, rng.choice("0012") if n == 5210 else rng.choice("1234") if n == 5220 else "0" if n > 5000 else self.number()) for n in numbers)

    def line(self):
        rng = self.rng
        words = lambda letters: " ".join("%s%s" % (c, self.number()) for c in letters)
        lines = ["G0 " + words("XY"), "G1 X1 F100", "G1 X2", "T%d M6" % rng.randint(0, 7), "G43 H%d" % rng.randint(0, 7), "G43", "G49", "G41 D%d" % rng.randint(0, 7), "G40",
                 "G10 L2 P%d X1" % rng.randint(0, 9), "G10 L1 P%d Z1" % rng.randint(0, 7), "#%d = 3" % rng.choice((31, 500, 5400, 5161)), "G0 X#500",
                 "#<depth> = #<_ini[user]depth>", "G0 X#<_ini[user]%s>" % rng.choice(("depth", "name", "none")), "M3 S100 $%d" % rng.randint(0, 3), "S200", "F50",
                 "G0 A%s" % rng.choice(("90", "360", "-360", "10")), "G1 A5 F10", "G28", "G92 X1", "G92.1", "G54", "G55", "G91", "G90", "M1", "M60", "M9", "M62 P1",
                 "G2 X1 Y0 I0.5 J0 F10", "(comment)", "G4 P0.01", "M61 Q%d" % rng.randint(0, 7)]
        if self.remaps and sometimes(rng, 0.6):
            code = rng.choice(list(self.remaps))
            given = "".join(c for c in self.remaps[code].upper().strip("@^>1") if sometimes(rng, 0.85))
            if code in ("T", "S", "F"):
                return "%s%s %s" % (code, rng.choice("123"), rng.choice(("", "M3", "G0 X1")))
            return "%s%s %s%s" % ("T1 " if code == "M6" else "", code, " ".join("%s%s" % (c, self.number()) for c in given), rng.choice(("", "", "", " F100", " S100", " G1", " G0 X3")))
        return rng.choice(lines)

    def make(self):
        self.files["machine.ini"] = self.ini()
        self.files["tool.tbl"] = self.table()
        self.files["machine.var"] = self.parameters()
        start = self.rng.choice(("G20 G90 F100", "G20 G90", "G21 G90 F200 S100", "G20"))
        self.files["program.ngc"] = "\n".join([start] + [self.line() for _ in range(self.rng.randint(1, 7))]) + "\nM2\n"
        return self.files


def judged(folder):
    """What rs274 does: -> (kind, what it says, but for what it goes on after)"""
    shutil.copy(os.path.join(folder, "machine.var"), os.path.join(folder, "run.var"))
    done = subprocess.run(["rs274", "-g", "-i", "machine.ini", "-t", "tool.tbl", "-v", "run.var", "program.ngc"], cwd=folder, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, env={**os.environ, "HOME": folder}, timeout=60,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (2, 3)), check=False)
    said = done.stderr.decode("latin-1").replace("executing", "", 1)
    said = re.sub(r"(invalid \[RS274NGC\]CENTER_ARC|warning: code ).*\n", "", said).strip()
    kind = "ok" if done.returncode == 0 else "crash" if done.returncode < 0 else "refuses" if REFUSED.search(said) else "stops"
    return kind, said


def findings(owlint, folder, names):
    """-> {folder: [(file, finding)]}; each program is checked with the INI beside it"""
    paths = [os.path.join(name, file) for name in names for file in ("program.ngc", "machine.ini")]
    done = subprocess.run([owlint, "check", "--isolated", "--format", "json", *paths], cwd=folder, capture_output=True, timeout=300, check=False)
    found = collections.defaultdict(list)
    for file in json.loads(done.stdout)["files"]:
        for finding in file["findings"]:
            found[os.path.normpath(file["path"]).split("/")[0]].append((os.path.basename(file["path"]), finding))
    return found


def plain(message):
    return re.sub(r"\s+", "", message).lower()


def difference(kind, said, found):
    """What owlint says wrongly of this outcome; empty if nothing."""
    stops = [(path, f) for path, f in found if f["stops"] and f["reach"] != "never" and f.get("block_delete", "off") == "off"]
    of_machine = [f for path, f in stops if not path.endswith(".ngc")]
    of_program = [f for path, f in stops if path.endswith(".ngc")]
    if kind in ("refuses", "crash"):
        return "" if of_machine else "%s, and owlint says nothing about the machine" % kind
    if of_machine:
        return "starts, owlint says %s" % [f["message"] for f in of_machine]
    if kind == "ok":
        sure = [f for f in of_program if f["severity"] == "error" and f["reach"] == "always"]
        return "runs, owlint says %s" % [f["message"] for f in sure] if sure else ""
    wanted = plain(said.split("\n")[0])
    if any(plain(f.get("interpreter") or "") == wanted for f in of_program):
        return ""
    return "stops, owlint says %s" % [f.get("interpreter") for f in of_program]


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True, type=os.path.abspath)
    parser.add_argument("--sets", type=int, default=400)
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--only", type=int, metavar="NUMBER", help="only this set, with its files")
    parser.add_argument("--show", type=int, default=5, help="differences to print")
    parser.add_argument("--keep", metavar="DIR", help="save the sets that differ")
    options = parser.parse_args(argv)
    if not rs274.available:
        print("skipped: rs274 is not here")
        return SKIPPED
    counts, wrong = collections.Counter(), 0
    numbers = [options.only] if options.only is not None else list(range(options.sets))
    for at in range(0, len(numbers), BATCH):
        batch = numbers[at:at + BATCH]
        with tempfile.TemporaryDirectory(prefix="owlint-sets-", dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None) as scratch:
            outcomes = {}
            for number in batch:
                folder = os.path.join(scratch, str(number))
                os.mkdir(folder)
                for name, text in Maker("sets/%d/%d" % (options.seed, number)).make().items():
                    with open(os.path.join(folder, name), "w", encoding="ascii", newline="") as f:
                        f.write(text)
                outcomes[number] = judged(folder)
            found = findings(options.owlint, scratch, [str(number) for number in batch])
            for number in batch:
                kind, said = outcomes[number]
                problem = difference(kind, said, found[str(number)])
                counts[kind] += 1
                wrong += bool(problem)
                if problem and options.keep:
                    shutil.copytree(os.path.join(scratch, str(number)), os.path.join(options.keep, str(number)), dirs_exist_ok=True)
                if options.only is not None or (problem and wrong <= options.show):
                    print("set %d: %s (%s)" % (number, problem or "as owlint says", said))
                    print("\n".join("--- %s\n%s" % file for file in Maker("sets/%d/%d" % (options.seed, number)).make().items()))
    print("seed %d: %d sets (%s), %d not as owlint says" % (options.seed, sum(counts.values()), ", ".join("%d %s" % (n, kind) for kind, n in counts.most_common()), wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
