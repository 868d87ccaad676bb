#!/usr/bin/python3
"""Does owlint with sanitizers say the same as the optimised one, and does nothing trip a sanitizer?

usage: sanitized.py --owlint build/release/owlint --sanitized build/sanitize/owlint

Both check each second fixture, with the files that it brings, the corpus and the seeds of the fuzz targets, and run further commands over
some of them: status and output are the same, byte for byte.  A session of the language server opens some of them.  `./dev sanitize` without --quick runs the
C++ tests with sanitizers besides.
"""
import argparse
import concurrent.futures
import json
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "tests", "interpreter"))
import bundle  # noqa: E402

SHOWN = 3000        # characters of what a sanitizer says
OPENED = 24         # programs of the session of the language server
EVERY = 40          # of the fixtures, for commands that take one file
OF_RULE = 2         # each second fixture of a rule is checked: `./dev sanitize` without --quick sees all
CHECKS = (["--extend-select", "OW"], ["--linuxcnc", "all", "--format", "sarif"], ["--feature", "0x20", "--format", "grouped"], ["--diff"])
ONE_FILE = (["graph", "--format", "json"], ["modes"], ["extents", "--format", "json"], ["debug-flow"])


def gather(folder):
    """Writes the programs below a folder -> the paths of those that can be given to a command, from there."""
    programs = []
    for at, _, names in os.walk(os.path.join(ROOT, "tests", "programs")):
        for name in sorted(n for n in names if n.endswith(".ngc"))[::OF_RULE]:
            with open(os.path.join(at, name), encoding="latin-1", newline="") as f:
                text = f.read()
            own = os.path.join("programs", os.path.basename(at), name[:-4])
            files = bundle.split(text) if bundle.is_bundle(text) else {name: (0, text)}
            bundle.write(os.path.join(folder, own), files)
            programs.append(os.path.join(own, next(iter(files))))
    shutil.copytree(os.path.join(ROOT, "corpus"), os.path.join(folder, "corpus"))
    for at, _, names in os.walk(os.path.join(ROOT, "tests", "fuzz", "corpus")):
        for number, name in enumerate(sorted(names)):
            shutil.copy(os.path.join(at, name), os.path.join(folder, "programs", "seed-%s-%d.ngc" % (os.path.basename(at), number)))
    return sorted(programs)


def session(folder, programs):
    """What an editor sends that opens programs and asks about their words."""
    messages = [("initialize", {"processId": None, "rootUri": "file://" + folder, "capabilities": {}}, 1), ("initialized", {}, 0)]
    for path in programs:
        with open(os.path.join(folder, path), encoding="latin-1", newline="") as f:
            text = f.read()
        uri = "file://" + os.path.join(folder, path)
        document = {"textDocument": {"uri": uri}}
        place = {**document, "position": {"line": min(3, text.count("\n")), "character": 2}}
        messages.append(("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": "gcode", "version": 1, "text": text}}, 0))
        for method, params in (("documentSymbol", document), ("foldingRange", document), ("hover", place), ("completion", place), ("definition", place),
                               ("references", {**place, "context": {"includeDeclaration": True}}),
                               ("formatting", {**document, "options": {"tabSize": 2, "insertSpaces": True}})):
            messages.append(("textDocument/" + method, params, len(messages) + 1))
        messages.append(("textDocument/didClose", document, 0))
    messages += [("shutdown", None, len(messages) + 1), ("exit", None, 0)]
    out = b""
    for method, params, number in messages:
        body = json.dumps({"jsonrpc": "2.0", "method": method, **({"params": params} if params is not None else {}), **({"id": number} if number else {})})
        out += b"Content-Length: %d\r\n\r\n%s" % (len(body.encode()), body.encode())
    return out


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--sanitized", required=True)
    options = parser.parse_args(argv)
    builds = [os.path.abspath(options.owlint), os.path.abspath(options.sanitized)]
    problems, commands = [], 0
    with tempfile.TemporaryDirectory(prefix="owlint-sanitized-") as folder:
        folder = os.path.realpath(folder)
        programs = gather(folder)

        def compare(arguments, stdin=b"", answers=bytes):
            nonlocal commands
            commands += 1
            done = [subprocess.run([build, *arguments], cwd=folder, input=stdin, capture_output=True) for build in builds]
            what = " ".join(arguments)
            if done[0].returncode != done[1].returncode or done[1].returncode not in (0, 1, 2):
                problems.append("%s: status %d, with sanitizers %d\n%s" % (
                    what, done[0].returncode, done[1].returncode, done[1].stderr.decode("utf-8", "replace")[-SHOWN:]))
            elif answers(done[0].stdout) != answers(done[1].stdout):
                problems.append("%s: not the same output" % what)

        compare(["check", "--isolated", *CHECKS[0], "programs", "corpus"])
        for arguments in CHECKS[1:]:
            compare(["check", "--isolated", *arguments, *programs[::3], "corpus"])
        compare(["fmt", "--isolated", "--diff", "programs", "corpus"])
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(compare, [[*command, path] for command in ONE_FILE for path in programs[::EVERY]]))
        compare(["lsp"], session(folder, programs[::max(1, len(programs) // OPENED)]), lambda output: sorted(output.split(b"Content-Length: ")))
        for number, build in enumerate(builds):
            store = os.path.join(folder, "store%d" % number)
            done = subprocess.run([build, "audit", "--isolated", "--store", store, "programs", "corpus"], cwd=folder, capture_output=True)
            commands += 1
            if done.returncode not in (0, 1):
                problems.append("audit: status %d\n%s" % (done.returncode, done.stderr.decode("utf-8", "replace")[-SHOWN:]))
    print("\n".join(problems) if problems else "with sanitizers as without")
    print("%d programs, %d commands" % (len(programs), commands))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
