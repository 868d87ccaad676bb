#!/usr/bin/python3
"""Does owlint print what README.md and docs/*.md say it prints?

usage: docs_check.py --owlint build/release/owlint [--update] [DOCUMENT...]

What a document may say, each fence and comment at the beginning of its line:

```console                 `$ COMMAND` lines, each followed by what a terminal then shows: standard output and standard error.
                           `…` alone on a line stands for any lines, or none.  A last line `[exit 1]` says with which
                           status the command ends; without it the status must be 0.  A command whose line ends in a
                           backslash goes on in the next one.
<!-- files: a.ngc, b.ngc --> the next fenced blocks, as many as there are names, are the contents of these files.
                           A file below `wrong/` must stop, hang or move otherwise than the one of that name below `right/`, which
                           must run, and owlint must find nothing in it; of a folder there, its `program.ngc`.
<!-- owlint.toml -->       the next block, marked ```toml, must be accepted by owlint as its configuration.

All other blocks are left alone.  A document's files and commands come in their order and share one scratch folder, in which
`corpus/` is the repository's, `./dev lint` is `owlint check`, and `~/owlint` is the repository; it is shown as /home/you/shop.
Each command has a shell of its own: a `cd` holds for its line only.

--update writes what was printed into the documents, in place of outputs that differ; a `…` in those is lost.
"""
import argparse
import difflib
import glob
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "interpreter"))
import rs274  # noqa: E402

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
ANY = "…"
HOME = "/home/you"            # what documents call the home folder
EXIT = re.compile(r"\[exit (\d+)\]$")
MARK = re.compile(r"<!--\s*(?:files:\s*(?P<files>[^>]*?)|(?P<toml>owlint\.toml))\s*-->$")


class Block:
    def __init__(self, info, first, lines, name=None, is_configuration=False):
        self.info = info          # what stands behind the fence
        self.first = first        # index of the first line inside it
        self.lines = lines
        self.name = name          # of the file whose contents it is
        self.is_configuration = is_configuration


def parse(lines):
    """The fenced blocks of a document, and complaints about marks that say nothing."""
    blocks, problems = [], []
    names, toml, marked_at = [], False, 0
    at = 0
    while at < len(lines):
        line = lines[at]
        at += 1
        mark = MARK.match(line)
        if mark:
            if names or toml:
                problems.append((marked_at, "no block follows this comment"))
            names = [n.strip() for n in (mark["files"] or "").split(",") if n.strip()]
            toml, marked_at = bool(mark["toml"]), at
            continue
        fence = re.match(r"(`{3,})\s*([^`]*)$", line)
        if not fence:
            if re.match(r"\s+```\s*console", line):
                problems.append((at, "a console block that is indented is not run: begin it at the margin"))
            continue
        first = at
        while at < len(lines) and not re.match(r"`{%d,}\s*$" % len(fence[1]), lines[at]):
            at += 1
        block = Block(fence[2].strip(), first, lines[first:at])
        at += 1
        block.name = names.pop(0) if names else None
        block.is_configuration, toml = toml, False
        if block.is_configuration and block.info != "toml":
            problems.append((first, "the block behind <!-- owlint.toml --> is marked ```toml"))
        blocks.append(block)
    if names or toml:
        problems.append((marked_at, "no block follows this comment"))
    return blocks, problems


class Step:
    """A command with the output that a document shows for it."""

    def __init__(self, first, command):
        self.first = first        # index of the command's first line
        self.command = command
        self.shown = []
        self.output_at = first + 1


def steps(block):
    found, problems = [], []
    at = 0
    while at < len(block.lines):
        line = block.lines[at]
        if line.startswith("$ "):
            step = Step(block.first + at, line[2:])
            while step.command.endswith("\\") and at + 1 < len(block.lines):
                at += 1
                step.command += "\n" + block.lines[at]
            step.output_at = block.first + at + 1
            found.append(step)
        elif found:
            found[-1].shown.append(line)
        else:
            problems.append((block.first + at + 1, "a console block begins with a `$ ` line"))
            break
        at += 1
    return found, problems


def agrees(shown, real):
    """Whether lines are as shown, where `…` is any number of lines."""
    text = "".join(line + "\n" for line in real)
    pattern = "".join(r"(?:.*\n)*?" if line == ANY else re.escape(line) + "\n" for line in shown)
    return re.fullmatch(pattern, text) is not None


class Folder:
    """The scratch folder of a document."""

    def __init__(self, owlint, home):
        self.home = home
        self.path = os.path.join(home, "shop")
        tools = os.path.join(home, ".tools")
        os.makedirs(self.path)
        os.makedirs(tools)
        os.symlink(os.path.abspath(owlint), os.path.join(tools, "owlint"))
        os.symlink(ROOT, os.path.join(home, "owlint"))
        os.symlink(os.path.join(ROOT, "corpus"), os.path.join(self.path, "corpus"))
        self.write("dev", '#!/bin/sh\n[ "$1" = lint ] || exit 70\nshift\nexec owlint check "$@"\n')
        os.chmod(os.path.join(self.path, "dev"), 0o755)
        self.write("../.gitconfig", "[user]\n  name = Shop\n  email = shop@example.invalid\n[init]\n  defaultBranch = main\n")
        kept = {k: v for k, v in os.environ.items() if not k.startswith(("GIT_", "XDG_"))}
        self.env = {**kept, "PATH": tools + os.pathsep + os.environ.get("PATH", os.defpath), "HOME": home, "LC_ALL": "C.UTF-8",
                    "GIT_CONFIG_NOSYSTEM": "1", "TERM": "dumb"}

    def write(self, name, text):
        path = os.path.join(self.path, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as f:
            f.write(text)

    def run(self, command, folder="."):
        """The lines that a terminal shows, a last one with the status if that is not 0."""
        done = subprocess.run(["bash", "-c", command], cwd=os.path.join(self.path, folder), env=self.env, timeout=120,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        lines = done.stdout.decode("utf-8", "replace").replace(self.home, HOME).splitlines()
        return lines + ["[exit %d]" % done.returncode] if done.returncode else lines

    def confirm(self, right):
        """What the interpreter and owlint have against a right program, or do not have against the wrong one."""
        wrong = "wrong/" + right.split("/", 1)[1]
        printed = self.run("owlint check " + os.path.basename(right), os.path.dirname(right))
        if printed != ["nothing found in 1 file"]:
            yield "owlint finds something in %s:\n  %s" % (right, "\n  ".join(printed))
        if not rs274.available:
            return
        paths = [os.path.join(self.path, name) for name in (right, wrong)]
        outcomes = [rs274.run(path, "files") for path in paths]
        if outcomes[0].kind != "ok":
            yield "%s does not run: %s" % (right, outcomes[0].message)
        if outcomes[1].kind == "ok" and self.moves(paths[0]) == self.moves(paths[1]):
            yield "%s runs and moves as %s does" % (wrong, right)

    def moves(self, path):
        folder = os.path.dirname(path)
        done = subprocess.run(["rs274", "-g", os.path.basename(path)], stdin=subprocess.DEVNULL, capture_output=True, cwd=folder, env=self.env, timeout=60)
        return re.findall(r"(?:STRAIGHT|ARC)_\w+\([^)]*\)", done.stdout.decode("latin-1"))

    def refusal(self, toml):
        """What owlint has against a configuration. An INI that it names is there."""
        with tempfile.TemporaryDirectory(dir=self.home) as folder:
            self.write(os.path.join(folder, "owlint.toml"), toml)
            self.write(os.path.join(folder, "p.ngc"), "M2\n")
            ini = re.search(r'^ini\s*=\s*"([^"]+)"', toml, re.M)
            if ini and not re.search(r"^/|\.\.", ini[1]):
                self.write(os.path.join(folder, ini[1]), "[RS274NGC]\n")
            lines = self.run("owlint check p.ngc", folder)
        return lines if lines[-1:] == ["[exit 2]"] else []


class Document:
    def __init__(self, path, lines=None):
        self.path = path
        self.name = os.path.relpath(path, ROOT) if lines is None else path
        if lines is None:
            with open(path, encoding="utf-8") as f:
                lines = f.read().split("\n")
        self.lines = lines
        self.problems = []
        self.other_outputs = 0    # how many of the problems are fixed by --update
        self.commands = self.configurations = 0
        self.rights = []          # (line, name) of files below right/
        self.unmarked = []        # lines of blocks that look as if they were meant to be run

    def complain(self, line, message):
        self.problems.append("%s:%d: %s" % (self.name, line, message))

    def check(self, owlint):
        """Runs the document; returns its lines with the outputs as they are."""
        blocks, problems = parse(self.lines)
        for line, message in problems:
            self.complain(line, message)
        changes = []
        with tempfile.TemporaryDirectory(prefix="owlint-docs-") as top:
            folder = Folder(owlint, os.path.realpath(top))
            for block in blocks:
                if block.name is not None:
                    folder.write(block.name, "".join(line + "\n" for line in block.lines))
                elif block.info == "console":
                    changes += self.run(block, folder)
                elif any(line.startswith("$ ") for line in block.lines):
                    self.unmarked.append(block.first)
                if block.name is not None and block.name.startswith("right/"):
                    self.rights.append((block.first, block.name))
                if block.is_configuration:
                    self.configurations += 1
                    refused = folder.refusal("".join(line + "\n" for line in block.lines))
                    if refused:
                        self.complain(block.first, "owlint does not accept this configuration:\n  " + "\n  ".join(refused))
            for line, name in self.rights:
                if name.count("/") == 1 or name.endswith("/program.ngc"):
                    for complaint in folder.confirm(name):
                        self.complain(line, complaint)
        updated = list(self.lines)
        for begin, end, new in reversed(changes):
            updated[begin:end] = new
        return updated

    def run(self, block, folder):
        found, problems = steps(block)
        for line, message in problems:
            self.complain(line, message)
        changes = []
        for step in found:
            self.commands += 1
            real = folder.run(step.command)
            if agrees(step.shown, real):
                continue
            self.other_outputs += 1
            diff = difflib.unified_diff(step.shown, real, "in the document", "printed", lineterm="")
            self.complain(step.first + 1, "`%s` prints something else:\n  %s" % (step.command, "\n  ".join(diff)))
            changes.append((step.output_at, step.output_at + len(step.shown), real))
        return changes


def own_faults(owlint):
    """A check that accepts everything is none: documents that must be refused, and some that must not."""
    console = ["```console", "$ printf 'a\\nb\\nc\\n'; exit 1", *"abc", "[exit 1]", "```"]
    bad_toml = ["<!-- owlint.toml -->", "```toml", 'ignroe = ["OW3"]', "```"]
    for right, what, lines in (
            (True, "a right output", console),
            (True, "`…` for some lines", [*console[:2], ANY, "c", "[exit 1]", "```"]),
            (True, "`…` for no line", [*console[:2], "a", ANY, "b", "c", "[exit 1]", "```"]),
            (False, "a wrong line", [*console[:3], "x", *console[4:]]),
            (False, "a line too few", [*console[:4], *console[5:]]),
            (False, "no status", console[:5] + console[6:]),
            (False, "another status", [*console[:5], "[exit 2]", "```"]),
            (False, "a status that is not there", ["```console", "$ true", "[exit 1]", "```"]),
            (False, "a wrong configuration", bad_toml),
            (True, "a configuration that is not marked", bad_toml[1:]),
            (False, "a file without a block", ["<!-- files: a.ngc, b.ngc -->", "```ngc", "M2", "```"]),
            (True, "files", ["<!-- files: d/a.ngc, b.ngc -->", "```ngc", "A", "```", "", "```", "B", "```", "```console", "$ cat d/a.ngc b.ngc", "A", "B", "```"])):
        document = Document("(%s)" % what, lines)
        updated = document.check(owlint)
        if bool(document.problems) == right:
            yield "%s is %s" % (what, "refused: " + document.problems[0] if right else "accepted")
        if lines[0] == "```console":
            again = Document("(%s, updated)" % what, updated)
            again.check(owlint)
            if again.problems:
                yield "%s is still refused after --update" % what


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("documents", nargs="*", metavar="DOCUMENT")
    options = parser.parse_args(argv)
    problems = ["docs_check.py itself: " + fault for fault in own_faults(options.owlint)]
    paths = options.documents or [os.path.join(ROOT, "README.md"), *sorted(glob.glob(os.path.join(ROOT, "docs", "*.md")))]
    commands = configurations = updated = fixed = 0
    for path in map(os.path.abspath, paths):
        document = Document(path)
        lines = document.check(options.owlint)
        commands += document.commands
        configurations += document.configurations
        for line in document.unmarked:
            print("%s:%d: note: a block with a `$ ` line that is not marked ```console and so not run" % (document.name, line))
        if options.update and lines != document.lines:
            with open(path, "w", encoding="utf-8") as f:
                f.write("\n".join(lines))
            updated += 1
            fixed += document.other_outputs
        problems += document.problems
    print("\n\n".join(problems) if problems else "owlint prints what the documents show")
    print("%d documents, %d commands, %d configurations, %d problems%s" %
          (len(paths), commands, configurations, len(problems), ", %d updated" % updated if options.update else ""))
    return 1 if len(problems) > fixed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
