#!/usr/bin/python3
"""Every JSON report of fixtures and corpus must be valid by the schema that owlint ships.

usage: schema_check.py --owlint build/test/owlint [--schema share/owlint-report-1.schema.json]

Needs Debian's python3-jsonschema; without it ctest shows the test as not run.
"""
import argparse
import json
import os
import subprocess
import sys

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


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--schema", default=os.path.join(ROOT, "share", "owlint-report-1.schema.json"))
    options = parser.parse_args(argv)
    try:
        import jsonschema
    except ImportError:
        print("schema_check.py: skipped, python3-jsonschema is not installed")
        return SKIPPED
    with open(options.schema, encoding="utf-8") as f:
        schema = json.load(f)
    kind = jsonschema.validators.validator_for(schema)
    kind.check_schema(schema)
    validator = kind(schema)
    problems = list(wrong_reports(validator))
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
