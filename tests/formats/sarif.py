"""SARIF 2.1.0: docs.oasis-open.org/sarif/sarif/v2.1.0. The numbers in brackets are sections of the standard."""
import functools
import json
import os
import re
import shlex
import subprocess
from urllib.parse import unquote_to_bytes

from formats.json_reports import schema_of
from formats.run import Schema, by_schema, printable, same, says, strict_json, text_of

HERE = os.path.dirname(os.path.abspath(__file__))
MULTITOOL = os.path.join(HERE, "node_modules", "@microsoft", "sarif-multitool")
STANDARD = os.path.join(MULTITOOL + "-linux", "sarif-2.1.0.json")
LEVELS = {"error": "error", "warning": "warning", "info": "note"}
MARK = 3  # bytes of a byte order mark


def plain(text):
    """Text in a message (3.11.5, 3.11.6): braces are written twice, and brackets must not make a link."""
    return text.replace("{", "{{").replace("}", "}}").replace("](", "\\](")


@functools.lru_cache(maxsize=None)
def _standard_schema():
    """The official schema, as the validator's package ships it; None without the package."""
    if not os.path.exists(STANDARD):
        return None
    with open(STANDARD, encoding="utf-8-sig") as f:
        return Schema(json.load(f))


def _path_of(location, run, problems):
    """The bytes of the path that an artifactLocation names (3.4, 3.10)."""
    uri = location["uri"]
    if not re.fullmatch(r"(?:[A-Za-z0-9/._~!$&'()*+,;=:@-]|%[0-9A-Fa-f]{2})+", uri):
        problems.append("not a URI: %r" % uri)
    absolute = uri.startswith("file:///")
    segments = (uri[len("file:///"):] if absolute else uri).split("/")
    if any(segment in ("", ".", "..") for segment in segments):
        problems.append("an empty segment, or one of dots: %r" % uri)
    if not absolute and ":" in segments[0]:
        problems.append("reads as a scheme: %r" % uri)
    if absolute == ("uriBaseId" in location):
        problems.append("a relative URI has a base, an absolute one has none: %r" % location)
    path = unquote_to_bytes(uri[len("file://"):]) if absolute else os.path.join(run.folder, unquote_to_bytes(uri))
    if absolute and run.below(printable(path)):
        problems.append("a file below the root, but absolute: %r" % uri)
    return path


def _region(run, path, start, end):
    """Text regions count as if a byte order mark were not there (3.30.2)."""
    def column(position):
        marked = position["line"] == 1 and run.begins_with_mark(path)
        return max(1, position["column"] - 1) if marked else position["column"]
    return {"startLine": start["line"], "startColumn": column(start), "endLine": end["line"], "endColumn": column(end)}


def _wanted_path(run, shown):
    raw = run.raw(shown)
    return os.fsencode(run.key(shown)) if raw is None else raw


def _place(location, run, problems):
    physical = location["physicalLocation"]
    return _path_of(physical["artifactLocation"], run, problems), physical["region"], location.get("message", {}).get("text")


def _wanted_place(run, entry):
    return _wanted_path(run, entry["path"]), _region(run, entry["path"], entry["start"], entry["end"]), plain(entry["message"])


def _check_rules(rules, catalogue, problems):
    same([rule["id"] for rule in rules], [rule["code"] for rule in catalogue], "rules", problems)
    for rule, known in zip(rules, catalogue):
        wanted = {"name": known["name"], "level": LEVELS[known["severity"]], "enabled": known["default"]}
        configuration = rule["defaultConfiguration"]
        has = {"name": rule["name"], "level": configuration["level"], "enabled": configuration.get("enabled", True)}
        if has != wanted:
            problems.append("%s is %r, in the catalogue %r" % (rule["id"], has, wanted))
        parts = {"shortDescription": (rule["shortDescription"]["text"], [known["summary"]]),
                 "fullDescription": (rule["fullDescription"]["text"], [known["what"]]),
                 "help.text": (rule["help"]["text"], [known["fix"]]),
                 "help.markdown": (rule["help"]["markdown"], [known["bad"], known["good"], known["fix"]])}
        for name, (text, words) in parts.items():
            for wanted in words:
                doubled = wanted.strip().replace("{", "{{").replace("}", "}}")
                if (doubled if name == "help.markdown" else plain(wanted.strip())) not in text:
                    problems.append("%s of %s does not say %r" % (name, rule["id"], wanted[:60]))
        # What is not code must not be HTML (3.11.4.2).
        prose = re.sub(r"(?ms)^```.*?^```|`[^`]*`", "", rule["help"]["markdown"])
        if re.search(r"<[A-Za-z/!]", prose):
            problems.append("HTML in the help of %s" % rule["id"])


def _check_fixes(result, finding, run, problems):
    path = finding["path"]
    found = []
    for fix in result.get("fixes", []):
        change = fix["artifactChanges"][0]
        edits = [(r["deletedRegion"], r.get("insertedContent", {}).get("text", "")) for r in change["replacements"]]
        found.append((fix["description"]["text"], _path_of(change["artifactLocation"], run, problems), edits))
    expected = []
    for fix in finding["fixes"]:
        edits = []
        for edit in fix["edits"]:
            region = _region(run, path, edit["start"], edit["end"])
            if run.begins_with_mark(path) and edit["start"]["offset"] < MARK:
                region = {"byteOffset": edit["start"]["offset"], "byteLength": edit["end"]["offset"] - edit["start"]["offset"]}
            edits.append((region, edit["text"]))
        expected.append((plain(fix["title"]), _wanted_path(run, path), edits))
    same(found, expected, "fix", problems)


def _texts(value):
    """The texts of all messages; what a fix puts in is none."""
    if isinstance(value, dict):
        for name, child in value.items():
            if name == "text":
                yield child
            elif name != "insertedContent":
                yield from _texts(child)
    elif isinstance(value, list):
        for child in value:
            yield from _texts(child)


def _check_result(result, finding, run, problems):
    if not says(result["message"]["text"], plain(finding["message"])):
        problems.append("%r does not say %r" % (result["message"]["text"], plain(finding["message"])))
    for text in _texts(result):
        if re.search("[{}]", text.replace("{{", "").replace("}}", "")) or re.search(r"(?<!\\)\]\(", text):
            problems.append("a placeholder or a link that is none: %r" % text)
    flow = result["codeFlows"][0]["threadFlows"][0]["locations"] if "codeFlows" in result else []
    steps = [_place(step["location"], run, problems) for step in flow]
    here = _place(result["locations"][0], run, problems)
    if steps and steps.pop()[:2] != here[:2]:
        problems.append("the last step of a flow is not the finding: %r" % finding["message"])
    related = [_place(spot, run, problems) for spot in result.get("relatedLocations", [])]
    ids = [spot["id"] for spot in result.get("relatedLocations", []) if "id" in spot]
    if len(set(ids)) != len(ids):
        problems.append("related locations with one id: %r" % ids)
    same(related + steps, [_wanted_place(run, entry) for entry in finding["related"]], "related location or step", problems)
    _check_fixes(result, finding, run, problems)
    return (*here[:2], result["ruleId"], result["level"])


def check_sarif(output, run):
    problems = []
    text = text_of(output, problems)
    report = None if text is None else strict_json(text, problems)
    if report is None or not by_schema(schema_of("sarif.schema.json"), report, problems):
        return problems
    if _standard_schema() is not None:
        by_schema(_standard_schema(), report, problems)
    told = report["runs"][0]
    driver = told["tool"]["driver"]
    if driver["version"] != run.report["tool"]["version"]:
        problems.append("version %r, by --format json %r" % (driver["version"], run.report["tool"]["version"]))
    _check_rules(driver["rules"], run.catalogue, problems)
    root = unquote_to_bytes(told["originalUriBaseIds"]["%SRCROOT%"]["uri"][len("file://"):])
    if root != run.folder.rstrip(b"/") + b"/":
        problems.append("the root is %r, the folder of the run %r" % (root, run.folder))
    found = []
    prints = set()
    for result, finding in zip(told["results"], run.findings):
        found.append(_check_result(result, finding, run, problems))
        if [rule["id"] for rule in driver["rules"]][result["ruleIndex"]:][:1] != [result["ruleId"]]:
            problems.append("ruleIndex %d does not fit %s" % (result["ruleIndex"], result["ruleId"]))
        identity = (found[-1][0], result["ruleId"], result["partialFingerprints"]["owlint/v1"])
        if identity in prints:
            problems.append("two findings of one rule and file with one fingerprint: %r" % (identity,))
        prints.add(identity)
    if len(told["results"]) != len(run.findings):
        problems.append("%d results for %d findings" % (len(told["results"]), len(run.findings)))
    same(found, [(*_wanted_place(run, f)[:2], f["code"], LEVELS[f["severity"]]) for f in run.findings], "result", problems)
    return problems


# The validator would ask the network for each URI.
OFFLINE = {"SARIF2006.UrisShouldBeReachable.Options": {"RuleEnabled": "Disabled"}}


def _start(*arguments):
    """Runs the validator by way of its package's script, which hands the arguments to a shell."""
    environment = {**os.environ, "DOTNET_SYSTEM_GLOBALIZATION_INVARIANT": "1"}
    argv = ["node", os.path.join(MULTITOOL, "bin.js"), *map(shlex.quote, arguments)]
    return subprocess.run(argv, capture_output=True, env=environment)


def multitool_missing():
    """Why Microsoft's validator cannot run; empty if it can."""
    program = os.path.join(MULTITOOL + "-linux", "Sarif.Multitool")
    if not os.path.exists(program):
        return "the npm package @microsoft/sarif-multitool is not installed (npm ci in tests/formats)"
    if not os.access(program, os.X_OK):
        os.chmod(program, 0o755)  # the package's install script does that, and npm may be told not to run it
    try:
        return "" if _start("--version").returncode == 0 else "it does not run on this machine"
    except OSError as error:
        return "node: %s" % error


def multitool(files, folder):
    """Errors and warnings of the SARIF SDK's own validator: by the standard's rules, and by those of GitHub's code scanning."""
    answer = os.path.join(folder, "validated.json")
    settings = os.path.join(folder, "validator.json")
    with open(settings, "w", encoding="utf-8") as f:
        json.dump(OFFLINE, f)
    done = _start("validate", *files, "--config", settings, "--output", answer, "--log", "ForceOverwrite", "--rule-kind", "Sarif;Ghas")
    if done.returncode != 0 or not os.path.exists(answer):
        return ["the validator failed: %s" % (done.stdout + done.stderr).decode("utf-8", "replace")[-500:]]
    with open(answer, encoding="utf-8-sig") as f:
        told = json.load(f)["runs"][0]
    problems = []
    for result in told.get("results", []):
        where = result["locations"][0]["physicalLocation"] if result.get("locations") else {}
        problems.append("%s: %s, line %s: %s" % (result["ruleId"], os.path.basename(where.get("artifactLocation", {}).get("uri", "?")),
                                                 where.get("region", {}).get("startLine", "?"), json.dumps(result["message"])[:300]))
    return problems
