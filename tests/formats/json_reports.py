"""GitLab's code quality report and reviewdog's diagnostics: small formats of JSON."""
import functools
import json
import os

from formats.run import Schema, by_schema, check_path, same, says, strict_json, text_of

HERE = os.path.dirname(os.path.abspath(__file__))
GITLAB_SEVERITIES = {"error": "critical", "warning": "minor", "info": "info"}
BRANCH = "when "  # so begins what is said of a decision on the way to a finding


@functools.lru_cache(maxsize=None)
def schema_of(name):
    with open(os.path.join(HERE, name), encoding="utf-8") as f:
        return Schema(json.load(f))


def _valid(output, schema, problems):
    text = text_of(output, problems, "\t\n\x7f")  # JSON need not escape DEL
    value = None if text is None else strict_json(text, problems)
    return value if value is not None and by_schema(schema_of(schema), value, problems) else None


def check_gitlab(output, run):
    problems = []
    issues = _valid(output, "gitlab.schema.json", problems)
    if issues is None:
        return problems
    prints = [issue["fingerprint"] for issue in issues]
    twice = {p for p in prints if prints.count(p) > 1} if len(set(prints)) != len(prints) else set()
    if twice:
        problems.append("fingerprints that are there twice, of which GitLab shows one: %r" % sorted(twice)[:3])
    for issue, finding in zip(issues, run.findings):
        if not says(issue["description"], finding["message"]):
            problems.append("%r does not say %r" % (issue["description"], finding["message"]))
    found = [(check_path(run, issue["location"]["path"], problems), issue["check_name"][:5], issue["severity"],
              issue["location"]["lines"]["begin"], issue["location"]["lines"]["end"]) for issue in issues]
    same(found, [(run.key(f["path"]), f["code"], GITLAB_SEVERITIES[f["severity"]], f["start"]["line"], f["end"]["line"])
                 for f in run.findings], "issue", problems)
    return problems


def check_rdjson(output, run):
    problems = []
    report = _valid(output, "rdjson.schema.json", problems)
    if report is None:
        return problems

    def span(path, start, end):
        return run.byte_place(path, start), run.byte_place(path, end)

    def span_of(spot):
        return tuple((spot[at]["line"], spot[at]["column"]) for at in ("start", "end"))

    diagnostics = report["diagnostics"]
    found = []
    expected = []
    for diagnostic, finding in zip(diagnostics, run.findings):
        path = finding["path"]
        if not says(diagnostic["message"], finding["message"]):
            problems.append("%r does not say %r" % (diagnostic["message"], finding["message"]))
        location = diagnostic["location"]
        shown = check_path(run, location["path"], problems)
        found.append((shown, diagnostic["code"]["value"], diagnostic["severity"], span_of(location["range"])))
        expected.append((run.key(path), finding["code"], finding["severity"].upper(), span(path, finding["start"], finding["end"])))
        # A suggestion is one replacement, and several are alternatives: a fix of several edits has no place there.
        fixes = [fix["edits"][0] for fix in finding["fixes"] if len(fix["edits"]) == 1]
        same([(span_of(s["range"]), s["text"]) for s in diagnostic.get("suggestions", [])],
             [(span(path, edit["start"], edit["end"]), edit["text"]) for edit in fixes], "suggestion", problems)
        related = [(run.key(r["path"]), r["message"], span(r["path"], r["start"], r["end"]))
                   for r in finding["related"] if not r["message"].startswith(BRANCH)]
        same([(check_path(run, r["location"]["path"], problems), r["message"], span_of(r["location"]["range"]))
              for r in diagnostic.get("relatedLocations", [])], related, "related location", problems)
    if len(diagnostics) != len(run.findings):
        problems.append("%d diagnostics for %d findings" % (len(diagnostics), len(run.findings)))
    same(found, expected, "diagnostic", problems)
    order = ["INFO", "WARNING", "ERROR"]
    worst = max((d["severity"] for d in diagnostics), key=order.index, default=None)
    if "severity" in report and worst is not None and report["severity"] != worst:
        problems.append("the severity of all is %r, the worst is %r" % (report["severity"], worst))
    return problems
