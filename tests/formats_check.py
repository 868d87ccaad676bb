#!/usr/bin/python3
"""Every report format must be valid by its own rules, and say what `--format json` says of the same run.

usage: formats_check.py --owlint build/release/owlint [--every N]

Needs Debian's python3-fastjsonschema, python3-jsonschema and python3-lxml. SARIF is also held against the official schema and the rules of the SARIF SDK's
validator, an npm package: `npm ci` in tests/formats. What is missing makes ctest show the test as not run, unless what could be
checked is wrong.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

from formats import broken, scratch
from formats.lines import ANSI
from formats.run import Run, strict_json

TESTS = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(TESTS)
SKIPPED = 77
ALL = ["tests/programs", "corpus"]
FEW = 3  # problems of one report that are printed
LONGEST = 700
MOST = 40  # problems that are printed


def programs(*folders):
    """The programs below folders of the project, as paths from its root."""
    walks = (walk for folder in folders for walk in os.walk(os.path.join(ROOT, folder)))
    return sorted(os.path.relpath(os.path.join(at, name), ROOT) for at, _, names in walks for name in names if name.endswith(".ngc"))


class Tester:
    def __init__(self, owlint, folder):
        from formats.json_reports import check_gitlab, check_rdjson
        from formats.lines import check_gcc, check_github, check_grouped
        from formats.sarif import check_sarif
        from formats.xml_reports import check_checkstyle, check_junit
        self.checks = {"sarif": check_sarif, "github": check_github, "gitlab": check_gitlab, "checkstyle": check_checkstyle,
                       "junit": check_junit, "rdjson": check_rdjson, "gcc": check_gcc, "grouped": check_grouped}
        self.owlint = owlint
        self.folder = folder
        self.problems = []
        self.reports = 0
        self.sarif_files = []
        rules = subprocess.run([owlint, "rules", "--format", "json"], capture_output=True, check=True).stdout
        self.catalogue = json.loads(rules)

    def say(self, where, problems):
        self.problems.extend("%s: %s" % (where, problem[:LONGEST]) for problem in problems[:FEW])
        if len(problems) > FEW:
            self.problems.append("%s: %d more like these" % (where, len(problems) - FEW))

    def ask(self, name, folder, arguments, stdin=None):
        argv = [self.owlint, "check", "--isolated", "--format", name, *arguments]
        done = subprocess.run(argv, cwd=folder, input=stdin, capture_output=True)
        return done.returncode, done.stdout, done.stderr

    def read(self, what, folder, arguments, paths, stdin=None):
        """The run as JSON tells it."""
        status, output, errors = self.ask("json", folder, [*arguments, *paths], stdin)
        problems = []
        report = strict_json(output.decode("utf-8"), problems) if status in (0, 1) else None
        self.say(what + ", json", problems if report else ["exit status %d: %s" % (status, errors.decode("utf-8", "replace")[:300])])
        if report is None:
            return None, status
        run = Run(report, folder, [] if stdin is not None else paths, stdin, self.catalogue)
        self.say(what + ", json", ["not the path of a file: %r" % path for path in run.lost_paths()])
        return run, status

    def run(self, what, folder, arguments, paths, stdin=None, validate=False):
        """All formats of one run; returns the run and what each format said."""
        run, status = self.read(what, folder, arguments, paths, stdin)
        outputs = {}
        for name, check in self.checks.items() if run else ():
            where = "%s, %s" % (what, name)
            has, output, errors = self.ask(name, folder, [*arguments, *paths], stdin)
            self.reports += 1
            if has != status:
                self.say(where, ["exit status %d, with json %d: %s" % (has, status, errors.decode("utf-8", "replace")[:300])])
                continue
            outputs[name] = output
            self.say(where, check(output, run))
        if validate and "sarif" in outputs:
            self.sarif_files.append(os.path.join(self.folder, "report-%d.sarif" % len(self.sarif_files)))
            with open(self.sarif_files[-1], "wb") as f:
                f.write(outputs["sarif"])
        return run, outputs

    # --- the kinds of runs ---

    def own_programs(self, every):
        files = programs(*ALL)
        if every == 1:
            self.run("all programs", ROOT, [], ALL, validate=True)
        else:
            self.run("one program in %d" % every, ROOT, [], files[::every], validate=True)
        # Schemas take long: a part of the programs has every form that these findings may have.
        for arguments in (["--feature", "0x20"], ["--extend-select", "OW", "--linuxcnc", "all"]):
            self.run("every fifth program %s" % arguments, ROOT, arguments, files[::5], validate=True)
        for path in files[::max(1, len(files) // 12)]:
            self.run(path, ROOT, [], [path])

    def hostile(self, root):
        run, outputs = self.run("hostile", root, ["--extend-select", "OW"], ["shop"], validate=True)
        for part in ("{0}", "](", "\ufffe", "::error::", "\xff"):
            if run and not any(part in finding["message"] for finding in run.findings):
                self.say("hostile", ["no message quotes %r" % part])
        if run and not any(other["path"] != finding["path"] for finding in run.findings for other in finding["related"]):
            self.say("hostile", ["no finding has a place in another file"])
        self.run("hostile, absolute", root, [], [os.path.join(root, b"shop")])
        self.run("hostile, from below", os.path.join(root, b"shop", "unter ordner&".encode()), [], [".."], validate=True)
        self.run("hostile, with ./", root, [], ["./shop/calls", "shop/../clean"])
        again = os.path.join(root, b"shop", b"calls", b"helper.ngc")
        self.run("hostile, named twice", root, [], ["shop/calls", "./shop/calls", again])
        self.run("with an INI", root, ["--ini", "maschine/machine ü&.ini"], ["shop/calls"], validate=True)
        named = ["--stdin-filename", "{0} a&b:<c>%0A.ngc"]
        self.run("standard input", root, named, ["-"], stdin=scratch.LABEL + b" if [1]\n", validate=True)
        self.run("standard input without a name", root, [], ["-"], stdin=scratch.SAMPLE)
        self.run("nothing found", root, [], ["clean"], validate=True)
        self.run("no files", root, ["--allow-empty"], ["nothing"], validate=True)
        return outputs

    def options(self, root, outputs):
        """Colours are for people, --output writes the same bytes, threads change nothing."""
        for name, output in outputs.items():
            base = ["--extend-select", "OW", "shop"]
            colored = self.ask(name, root, ["--color", "always", *base])[1]
            file = os.path.join(self.folder, "output")
            if self.ask(name, root, ["--output", file, *base])[1]:
                self.say("%s --output" % name, ["something on standard output"])
            with open(file, "rb") as f:
                others = {"--color always": ANSI.sub(b"", colored) if name == "grouped" else colored,
                          "--jobs 1": self.ask(name, root, ["--jobs", "1", *base])[1],
                          "--output": f.read()}
            for option, other in others.items():
                if other != output:
                    self.say("%s %s" % (name, option), ["not the same report"])

    def fingerprints(self):
        """Lines put in above a finding, and another folder, leave its fingerprint as it is; GitLab shows it as new otherwise."""
        def prints(folder):
            said = {name: self.ask(name, folder, ["p.ngc"])[1] for name in ("sarif", "gitlab")}
            try:
                results = json.loads(said["sarif"])["runs"][0]["results"]
                return ([(r["ruleId"], r["partialFingerprints"]["owlint/v1"]) for r in results],
                        [(i["check_name"], i["fingerprint"]) for i in json.loads(said["gitlab"])])
            except (ValueError, KeyError) as error:
                self.say("fingerprints", [repr(error)])
                return None
        compared = 0
        files = programs("tests/programs")
        samples = {"equal findings twice": scratch.SAMPLE + scratch.SAMPLE}
        for path in files[::max(1, len(files) // 40)]:
            with open(os.path.join(ROOT, path), "rb") as f:
                samples[path] = f.read()
        for path, program in samples.items():
            # Above a first % there is nothing that LinuxCNC reads.
            cut = program.find(b"\n") + 1 if program.lstrip().startswith(b"%") else 0
            for name, text in (("before", program), ("after", program[:cut] + b"(one)\n\n( two )\n" + program[cut:])):
                scratch.write(os.path.join(os.fsencode(self.folder), name.encode(), b"p.ngc"), text)
            before, after = (prints(os.path.join(self.folder, name)) for name in ("before", "after"))
            if before is None or after is None:
                continue
            if [code for code, _ in before[0]] == [code for code, _ in after[0]]:
                compared += len(before[0])
                if before != after:
                    self.say("fingerprints of %s" % path, ["other ones after lines were put in: %s, %s" % (before, after)])
        if compared < 15:
            self.say("fingerprints", ["only %d were compared" % compared])

    def broken(self):
        """The checks themselves: what is made wrong must be found."""
        scratch.write(os.path.join(os.fsencode(self.folder), b"broken", b"sample.ngc"), scratch.SAMPLE)
        run, outputs = self.run("sample", os.path.join(self.folder, "broken"), [], ["sample.ngc"], validate=True)
        if run and not (any(f["fixes"] for f in run.findings) and any(f["related"] for f in run.findings)):
            self.say("sample", ["it has no fix, or no other place"])
        made = 0
        for name, output in outputs.items():
            if self.checks[name](output, run):
                continue  # wrong as it is, which has been said
            for what, data in broken.broken(name, output):
                made += 1
                if not self.checks[name](data, run):
                    self.say("the check of %s" % name, ["finds nothing in a report %s" % what])
        return made

    def validator(self):
        from formats.sarif import multitool, multitool_missing
        missing = multitool_missing()
        if not missing and self.sarif_files:
            self.say("SARIF validator", multitool(self.sarif_files, self.folder))
            odd = os.path.join(self.folder, "odd.sarif")
            run = {"tool": {"driver": {"name": "x"}}, "results": [{"message": {"text": "a"}, "ruleIndex": 3}]}
            with open(odd, "w", encoding="utf-8") as f:
                json.dump({"version": "2.1.0", "runs": [run]}, f)
            if not multitool([odd], self.folder):
                self.say("SARIF validator", ["it finds nothing in a wrong report"])
        return missing


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--every", type=int, default=1, metavar="N", help="only one program in N")
    options = parser.parse_args(argv)
    try:
        import fastjsonschema  # noqa: F401
        import jsonschema  # noqa: F401
        import lxml  # noqa: F401
    except ImportError as error:
        print("formats_check.py: skipped, %s: python3-fastjsonschema, python3-jsonschema and python3-lxml are needed" % error)
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        tester = Tester(os.path.abspath(options.owlint), os.path.realpath(folder))
        root = scratch.make(tester.folder)
        tester.own_programs(options.every)
        outputs = tester.hostile(root)
        tester.options(root, outputs)
        tester.fingerprints()
        made = tester.broken()
        missing = tester.validator()
    print("\n".join(tester.problems[:MOST]) if tester.problems else "all reports are valid")
    print("%d reports, %d wrong ones made of them, %d problems" % (tester.reports, made, len(tester.problems)))
    if missing:
        print("not checked with the SARIF validator: %s" % missing)
    return 1 if tester.problems else SKIPPED if missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
