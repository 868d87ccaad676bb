#!/usr/bin/python3
"""Every JSON report of fixtures and corpus must be valid by the schema that owlint ships; so must a baseline be, and the
schema of owlint.toml must take for right and wrong what owlint does.

usage: schema_check.py --owlint build/release/owlint

Needs Debian's python3-jsonschema; without it ctest shows the test as not run.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import tomllib

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
SKIPPED = 77
RUNS = ([], ["--feature", "0x20"], ["--extend-select", "OW"], ["--linuxcnc", "2.10"])


def wrong_reports(validator):
    """Changes after which a report must not be valid any more: a schema that allows everything is none."""
    position = {"line": 1, "column": 1, "offset": 0}
    finding = {"code": "OW104", "rule": "if-label-reused", "severity": "error", "message": "m", "start": position,
               "end": position, "reach": "always", "stops": True, "related": [], "fixes": []}
    report = {"schema": "owlint-report-1", "tool": {"name": "owlint", "version": "0.1.0"},
              "files": [{"path": "p.ngc", "findings": [finding]}],
              "summary": {"files": 1, "errors": 1, "warnings": 0, "infos": 0}}
    if not validator.is_valid(report):
        yield "a minimal report is not valid: %s" % next(validator.iter_errors(report)).message
    for key in report:
        if validator.is_valid({k: v for k, v in report.items() if k != key}):
            yield "a report without `%s` is valid" % key
    for key in finding:
        less = {k: v for k, v in finding.items() if k != key}
        if validator.is_valid({**report, "files": [{"path": "p.ngc", "findings": [less]}]}):
            yield "a finding without `%s` is valid" % key
    for key, value in (("severity", "fatal"), ("reach", "often"), ("code", "X1"), ("stops", "yes"),
                       ("start", {**position, "line": 0}), ("end", {"line": 1})):
        if validator.is_valid({**report, "files": [{"path": "p.ngc", "findings": [{**finding, key: value}]}]}):
            yield "a finding with `%s` %r is valid" % (key, value)


CONFIGURATIONS = (
    (True, ""), (True, 'ini = "a.ini"'), (True, 'linuxcnc = "all"'), (True, "feature = 32"), (True, 'feature = "0x20"'), (True, "find-ini = false"), (True, 'sub-path = ["."]'),
    (True, 'select = ["OW1", "OW304"]\nignore = []\nextend-select = ["OW311"]'), (True, '[severity]\nOW315 = "off"'),
    (True, '[[overrides]]\nfiles = ["old/*"]\nignore = ["OW3"]\n[overrides.severity]\nOW2 = "info"'),
    (False, "ini = 5"), (False, 'sub-path = "."'), (False, 'sub-path = [""]'), (False, 'linuxcnc = "3.0"'), (False, "feature = -1"), (False, 'feature = "x"'), (False, 'find-ini = "no"'), (False, 'selekt = ["OW1"]'),
    (False, 'select = "OW1"'), (False, 'select = ["X1"]'), (True, 'select = ["ow1", "if-label-reused"]'), (True, '[severity]\nif-label-reused = "off"'), (False, 'select = ["if label reused"]'),
    (True, 'fail-on = "warning"'), (False, 'fail-on = "off"'), (True, 'exclude = ["old/", "*.bak"]\ninclude = ["*.txt"]'), (False, 'exclude = "old"'), (False, 'include = [""]'), (False, '[severity]\nOW315 = "fatal"'), (False, '[[overrides]]\nignore = ["OW3"]'),
    (False, '[[overrides]]\nfiles = []'), (False, '[[overrides]]\nfiles = ["a"]\nini = "a.ini"'), (False, "[overrides]"),
)


def wrong_configurations(owlint, validator):
    """Where owlint and the schema do not agree, or not on what is expected."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "owlint.toml")
        for right, text in CONFIGURATIONS:
            with open(path, "w", encoding="utf-8") as f:
                f.write(text)
            taken = subprocess.run([owlint, "config", "--check", path], capture_output=True).returncode == 0
            valid = validator.is_valid(tomllib.loads(text))
            if (taken, valid) != (right, right):
                yield "owlint.toml %r: owlint says %s, the schema %s" % (text, taken, valid)


def undocumented_keys(validator):
    """Keys without a description in the schema, or without a heading in docs/configuration.md; headings of no key."""
    def keys(schema):
        for key, value in schema.get("properties", {}).items():
            if not value.get("description"):
                yield key, "has no description in the schema"
            yield key, None
            yield from keys(value.get("items", {}))
    with open(os.path.join(ROOT, "docs", "configuration.md"), encoding="utf-8") as f:
        headings = set(re.findall(r"^#+ `([^`]+)`$", f.read(), re.M))
    named = set()
    for key, problem in keys(validator.schema):
        named.add(key)
        if problem or key not in headings:
            yield "owlint.toml: `%s` %s" % (key, problem or "has no heading in docs/configuration.md")
    for key in headings - named:
        yield "docs/configuration.md has `%s`, which the schema does not" % key


def wrong_baselines(owlint, validator):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "known.json")
        subprocess.run([owlint, "check", "--isolated", "--quiet", "--extend-select", "OW", "--baseline", path, "--update-baseline", os.path.join(ROOT, "tests", "programs")],
                       capture_output=True, check=True)
        with open(path, encoding="utf-8") as f:
            baseline = json.load(f)
    if len(baseline["findings"]) < 300:
        yield "a baseline of %d findings" % len(baseline["findings"])
    for error in validator.iter_errors(baseline):
        yield "baseline: %s" % error.message[:200]
    for wrong in ({}, {**baseline, "schema": "x"}, {**baseline, "findings": [{"file": "a"}]}, {**baseline, "findings": [{**baseline["findings"][0], "count": 1}]}):
        if validator.is_valid(wrong):
            yield "a wrong baseline is valid"


def validator_of(jsonschema, name):
    with open(os.path.join(ROOT, "share", "owlint-%s-1.schema.json" % name), encoding="utf-8") as f:
        schema = json.load(f)
    kind = jsonschema.validators.validator_for(schema)
    kind.check_schema(schema)
    return kind(schema)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    options = parser.parse_args(argv)
    try:
        import jsonschema
    except ImportError:
        print("schema_check.py: skipped, python3-jsonschema is not installed")
        return SKIPPED
    validator = validator_of(jsonschema, "report")
    config = validator_of(jsonschema, "config")
    problems = [*wrong_reports(validator), *wrong_configurations(options.owlint, config), *undocumented_keys(config),
                *wrong_baselines(options.owlint, validator_of(jsonschema, "baseline"))]
    files = findings = 0
    for more in RUNS:
        argv = [options.owlint, "check", "--isolated", "--format", "json", *more,
                os.path.join(ROOT, "tests", "programs"), os.path.join(ROOT, "corpus")]
        report = json.loads(subprocess.run(argv, capture_output=True).stdout)
        files += len(report["files"])
        counted = {"error": 0, "warning": 0, "info": 0}
        for file in report["files"]:
            findings += len(file["findings"])
            for finding in file["findings"]:
                counted[finding["severity"]] += 1
        summary = report["summary"]
        if [summary[k] for k in ("errors", "warnings", "infos")] != list(counted.values()):
            problems.append("the summary %s is not what was found: %s" % (summary, counted))
        for error in validator.iter_errors(report):
            problems.append("%s: %s at %s" % (" ".join(more), error.message[:200], "/".join(map(str, error.absolute_path))))
    print("\n".join(problems[:20]) if problems else "all reports are valid")
    print("%d files, %d findings, %d problems" % (files, findings, len(problems)))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
