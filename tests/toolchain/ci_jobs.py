"""The examples of CI jobs in docs/ci.md, for pre_commit.py: their form, and that their commands do what is said of them.

A job's commands are run as its server would, except for the build of owlint: the program is put where the cache would
have it.
"""
import json
import os
import re
import subprocess
import sys
import xml.etree.ElementTree

try:
    import yaml
except ImportError:
    yaml = None

HERE = os.path.dirname(os.path.abspath(__file__))
DOCUMENT = os.path.normpath(os.path.join(HERE, "..", "..", "docs", "ci.md"))
sys.path.insert(0, os.path.join(HERE, ".."))
import docs_check  # noqa: E402  (the Markdown of the documents is read there)

GOOD = "o100 if [#1 EQ 1]\n  G0 X1\no100 endif\nM2\n"
BAD = GOOD.replace("o100 endif", "o110 endif")


def blocks():
    with open(DOCUMENT, encoding="utf-8") as f:
        return docs_check.parse(f.read().split("\n"))[0]


def example(name):
    """The YAML that docs/ci.md shows as this file."""
    found = ["\n".join(block.lines) for block in blocks() if block.name == name]
    if len(found) != 1:
        raise RuntimeError("docs/ci.md shows %d files %s" % (len(found), name))
    return yaml.safe_load(found[0])


class Programs:
    """What a server's checkout looks like, with owlint where the cache would put it."""

    def __init__(self, bench, name, content):
        self.bench = bench
        self.path = os.path.join(bench.folder, name)
        for folder in (".owlint", "programs"):
            os.makedirs(os.path.join(self.path, folder))
        os.symlink(bench.owlint, os.path.join(self.path, ".owlint", "owlint"))
        with open(os.path.join(self.path, "programs", "slot.ngc"), "w", encoding="utf-8") as f:
            f.write(content)

    def run(self, script):
        return self.bench.run(["sh", "-e", "-c", script], self.path)

    def report(self, name):
        with open(os.path.join(self.path, name), encoding="utf-8") as f:
            return f.read()


def expect_script(bench, what, script):
    """A script that is not run here is at least one that the shell can read."""
    done = subprocess.run(["sh", "-n"], input=re.sub(r"\$\{\{.*?\}\}", "x", script).encode(), capture_output=True)
    bench.expect(done.returncode == 0, what + ": not a shell script", done.stderr.decode())


def expect_keys(bench, what, node, needed, allowed=()):
    keys = set(node) if isinstance(node, dict) else set()
    bench.expect(set(needed) <= keys <= {*needed, *allowed}, "%s: keys %s" % (what, sorted(map(str, keys))))
    return bool(set(needed) <= keys)


def check_step(bench, what, step):
    if "uses" in step:
        expect_keys(bench, what, step, ["uses"], ["name", "id", "with", "if"])
        bench.expect(re.fullmatch(r"[\w-]+/[\w/-]+@v\d+", step["uses"]), "%s: uses %s" % (what, step["uses"]))
    elif expect_keys(bench, what, step, ["run"], ["name", "id", "if"]):
        expect_script(bench, what, step["run"])


def github(bench):
    job_file = example(".github/workflows/owlint.yml")
    # YAML 1.1, which PyYAML reads, takes the key `on` for a truth value; GitHub does not.
    if not expect_keys(bench, "GitHub", job_file, ["name", True, "jobs", "env"]):
        return
    job = job_file["jobs"]["owlint"]
    expect_keys(bench, "GitHub, job", job, ["runs-on", "container", "permissions", "steps"])
    for i, step in enumerate(job["steps"]):
        check_step(bench, "GitHub, step %d" % (i + 1), step)
    cached = [s["with"]["path"] for s in job["steps"] if s.get("uses", "").startswith("actions/cache@")]
    bench.expect(cached == [".owlint"], "GitHub: the cache holds %s" % cached)
    command = job["steps"][-1]["run"]
    status, output = Programs(bench, "github-bad", BAD).run(command)
    bench.expect(status == 1 and re.search(r"^::error file=programs/slot\.ngc,line=3,.*OW106", output, re.M),
                 "GitHub: `%s` ends with %d" % (command, status), output)
    status, output = Programs(bench, "github-good", GOOD).run(command)
    bench.expect(status == 0 and "::" not in output, "GitHub: `%s` on a good program ends with %d" % (command, status), output)


def code_scanning(bench):
    steps = example("steps-for-code-scanning.yml")
    for i, step in enumerate(steps):
        check_step(bench, "code scanning, step %d" % (i + 1), step)
    programs = Programs(bench, "scanning", BAD)
    status, output = programs.run(steps[0]["run"])
    bench.expect(status == 1, "code scanning: status %d" % status, output)
    run = json.loads(programs.report(steps[1]["with"]["sarif_file"]))["runs"][0]
    bench.expect([r["ruleId"] for r in run["results"]] == ["OW106"], "code scanning: the report holds %s" % run["results"])
    bench.expect(steps[1].get("if") == "always()", "code scanning: nothing is reported when the check fails")


def gitlab(bench):
    jobs = example(".gitlab-ci.yml")
    if not expect_keys(bench, "GitLab", jobs, ["owlint"]):
        return
    job = jobs["owlint"]
    expect_keys(bench, "GitLab, job", job, ["image", "variables", "cache", "before_script", "script", "artifacts"])
    expect_script(bench, "GitLab, before_script", "\n".join(job["before_script"]))
    bench.expect(job["cache"]["paths"] == [".owlint/"], "GitLab: the cache holds %s" % job["cache"]["paths"])
    bench.expect(job["artifacts"]["when"] == "always", "GitLab: nothing is reported when the check fails")
    script = "\n".join(job["script"])
    report = job["artifacts"]["reports"]["codequality"]
    for name, content, wanted in (("gitlab-bad", BAD, ["OW106"]), ("gitlab-good", GOOD, [])):
        programs = Programs(bench, name, content)
        # With owlint in the cache, what is run before the script builds nothing.
        status, output = programs.run("\n".join(job["before_script"]) + "\n" + script)
        bench.expect(status == len(wanted) and all("slot.ngc:3:1: error" in output for _ in wanted),
                     "GitLab: status %d on %s" % (status, name), output)
        issues = json.loads(programs.report(report))
        bench.expect([i["check_name"][:5] for i in issues] == wanted and all(i["location"]["path"] == "programs/slot.ngc" for i in issues),
                     "GitLab: the report holds %s" % issues)


def other_servers(bench):
    """The last command of the document."""
    command = [line for block in blocks() if block.info == "sh" for line in block.lines if "--format junit" in line]
    programs = Programs(bench, "junit", BAD)
    status, output = programs.run(command[0].replace("owlint check", ".owlint/owlint check"))
    bench.expect(status == 1, "JUnit: status %d" % status, output)
    root = xml.etree.ElementTree.fromstring(programs.report("owlint.xml"))
    bench.expect(root.get("failures") == "1", "JUnit: %s failures" % root.get("failures"))


def check(bench):
    formats = subprocess.run([bench.owlint, "check", "--help"], capture_output=True).stdout.decode()
    for job, needed in ((github, "github"), (code_scanning, "sarif"), (gitlab, "gitlab"), (other_servers, "junit")):
        if needed in formats:
            job(bench)
        else:
            bench.expect(False, "docs/ci.md shows `--format %s`, which this owlint does not have" % needed)
