"""Runs owlint over programs and gives its findings by file name."""
import json
import os
import shutil
import subprocess

import bundle

MACHINE = "[TRAJ]\nCOORDINATES = X Y Z A B C\n"    # the axes of rs274 as it stands


class LinterFailed(Exception):
    """owlint did not give a report."""


def by_path(report):
    """-> {path: findings} of a report.  A finding that stands for the same mistake in other places is in each of them."""
    found = {file["path"]: list(file["findings"]) for file in report["files"]}
    for path, findings in [(path, list(findings)) for path, findings in found.items()]:
        for finding in findings:
            for place in finding.get("related", ()) if finding["code"] != "OW208" else ():     # OW208: claims.said_by
                if place["message"] == "here as well":
                    # Of the other places it is not said whether every run gets there.
                    reach = "never" if finding["reach"] == "never" else "maybe"
                    there = {**finding, "start": place["start"], "end": place["end"], "reach": reach, "related": []}
                    found.setdefault(place.get("path", path), []).append(there)
    return found


class Linter:
    """`machine` is an INI file to make: with one, owlint knows that there is no search path beyond the folder."""

    def __init__(self, program, warnonly=False, machine=None, arguments=()):
        self.command = [os.path.abspath(program), "check", "--isolated", "--format", "json", *arguments]
        if machine:
            with open(machine, "w", encoding="ascii") as f:
                f.write(MACHINE)
            self.command += ["--ini", machine]
        if warnonly:
            self.command += ["--feature", "0x20"]

    def check(self, folder, programs):
        """Write `programs` (name -> text) into `folder`, lint them all at once: name -> its findings."""
        if not programs:
            return {}  # owlint refuses a folder without programs
        os.makedirs(folder, exist_ok=True)
        if any(bundle.is_bundle(text) for text in programs.values()):
            return self._check_bundles(folder, programs)
        for name, text in programs.items():
            with open(os.path.join(folder, name), "w", encoding="latin-1", newline="") as f:
                f.write(text)
        report = self._run(self.command + [folder], folder)
        findings = {name: [] for name in programs}
        for path, found in by_path(report).items():
            findings[os.path.basename(path)] = found
        for name in programs:
            os.remove(os.path.join(folder, name))
        return findings

    def _run(self, command, folder):
        try:
            done = subprocess.run(command, capture_output=True, timeout=300, cwd=folder)
            report = json.loads(done.stdout) if done.returncode in (0, 1) else None
        except (OSError, subprocess.TimeoutExpired, ValueError) as error:
            raise LinterFailed("%s: %s" % (" ".join(self.command), error)) from error
        if report is None:
            raise LinterFailed("exit status %d of %s\n%s" % (done.returncode, " ".join(self.command),
                                                            done.stderr.decode("utf-8", "replace")[-2000:]))
        return report

    def _check_bundles(self, folder, programs):
        """Each in a folder of its own, with an INI there; lines are those of the bundle."""
        parts = {name: bundle.split(text) for name, text in programs.items()}
        for name, files in parts.items():
            bundle.write(os.path.join(folder, name), files)
            with open(os.path.join(folder, name, "machine.ini"), "w", encoding="ascii") as f:
                f.write(MACHINE + "[RS274NGC]\nSUBROUTINE_PATH = subs\n")
        at = self.command.index("--ini") if "--ini" in self.command else len(self.command)
        command = self.command[:at] + self.command[at + 2:]     # each has its own INI instead
        report = self._run(command + [os.path.join(name, bundle.MAIN) for name in programs], folder)
        findings = {name: [] for name in programs}
        for file in report["files"]:
            name, _, path = file["path"].partition("/")
            first = parts[name].get(path, (0, ""))[0]
            for finding in file["findings"]:
                for place in [finding] + finding.get("consequences", []):
                    for end in ("start", "end"):
                        place[end]["line"] += first
                if path in parts[name]:
                    findings[name].append(finding)
        for name in programs:
            shutil.rmtree(os.path.join(folder, name))
        return findings
