"""Runs owlint over programs and gives its findings by file name."""
import json
import os
import subprocess


class LinterFailed(Exception):
    """owlint did not give a report."""


class Linter:
    """`machine` is an INI file to make: with one, owlint knows that there is no search path beyond the folder."""

    def __init__(self, program, warnonly=False, machine=None, arguments=()):
        self.command = [os.path.abspath(program), "check", "--isolated", "--format", "json", *arguments]
        if machine:
            with open(machine, "w", encoding="ascii") as f:
                f.write("[RS274NGC]\n")
            self.command += ["--ini", machine]
        if warnonly:
            self.command += ["--feature", "0x20"]

    def check(self, folder, programs):
        """Write `programs` (name -> text) into `folder`, lint them all at once: name -> its findings."""
        os.makedirs(folder, exist_ok=True)
        for name, text in programs.items():
            with open(os.path.join(folder, name), "w", encoding="latin-1", newline="") as f:
                f.write(text)
        try:
            done = subprocess.run(self.command + [folder], capture_output=True, timeout=300, cwd=folder)
            report = json.loads(done.stdout) if done.returncode in (0, 1) else None
        except (OSError, subprocess.TimeoutExpired, ValueError) as error:
            raise LinterFailed("%s: %s" % (" ".join(self.command), error)) from error
        if report is None:
            raise LinterFailed("exit status %d of %s\n%s" % (done.returncode, " ".join(self.command),
                                                            done.stderr.decode("utf-8", "replace")[-2000:]))
        findings = {name: [] for name in programs}
        for file in report["files"]:
            findings[os.path.basename(file["path"])] = file["findings"]
        for name in programs:
            os.remove(os.path.join(folder, name))
        return findings
