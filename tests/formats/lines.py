"""Formats of lines: GitHub's workflow commands, gcc's messages, and findings grouped by file.

Workflow commands: docs.github.com/actions/reference/workflow-commands-for-github-actions; which characters are escaped, and
that columns of several lines are refused, is in ActionCommand.cs and ActionCommandManager.cs of github.com/actions/runner.
gcc: "Formatting Error Messages" in the GNU Coding Standards.
"""
import re

from formats.run import check_path, same, says, text_of

COMMANDS = {"error": "error", "warning": "warning", "notice": "info"}
PROPERTIES = ("file", "line", "endLine", "col", "endColumn", "title")
COMMAND = re.compile(r"::(error|warning|notice) ([^:]*)::(.*)", re.S)
# What a line of a group looks like; two blanks at least before it.
GROUPED = re.compile(r"( {2,})(\d+):(\d+) +(error|warning|info) +(OW\d{3}) +(.*)")
ANSI = re.compile(rb"\x1b\[[0-9;]*m")


def _unescaped(text, allowed, problems):
    """Takes escapes back; one that GitHub does not know, or a bare %, is a problem."""
    known = {code: chr(int(code[1:], 16)) for code in allowed}
    for escape in re.findall(r"%.{0,2}", text, re.S):
        if escape not in known:
            problems.append("not an escape here: %r in %r" % (escape, text))
    return re.sub("|".join(known), lambda m: known[m.group()], text)


def check_github(output, run):
    problems = []
    text = text_of(output, problems)
    if text is None:
        return problems
    found = []
    expected = []
    lines = text.split("\n")[:-1]
    for line, finding in zip(lines, run.findings):
        match = COMMAND.fullmatch(line)
        if match is None:
            problems.append("not a workflow command: %r" % line)
            continue
        pairs = [pair.split("=", 1) for pair in match[2].split(",")]
        names = [pair[0] for pair in pairs]
        if any(len(pair) != 2 or not pair[1] for pair in pairs) or len(set(names)) != len(names) or not set(names) <= set(PROPERTIES):
            problems.append("odd properties: %r" % match[2])
            continue
        has = {name: _unescaped(value, ("%25", "%0D", "%0A", "%3A", "%2C"), problems) for name, value in pairs}
        numbers = [has[name] for name in PROPERTIES[1:5] if name in has]
        if not {"file", "line", "endLine", "title"} <= set(has) or any(not re.fullmatch("[1-9][0-9]*", n) for n in numbers):
            problems.append("a property is missing, or is no number: %r" % match[2])
            continue
        if not re.fullmatch(r"OW\d{3}( .*)?", has["title"]):
            problems.append("the title does not begin with the code: %r" % has["title"])
        if not says(_unescaped(match[3], ("%25", "%0D", "%0A"), problems), finding["message"]):
            problems.append("%r does not say %r" % (match[3], finding["message"]))
        begin, end = finding["start"], finding["end"]
        one_line = begin["line"] == end["line"]
        found.append((check_path(run, has["file"], problems), has["title"][:5], COMMANDS[match[1]], *(has.get(n) for n in PROPERTIES[1:5])))
        expected.append((run.key(finding["path"]), finding["code"], finding["severity"], str(begin["line"]), str(end["line"]),
                         str(begin["column"]) if one_line else None, str(end["column"]) if one_line else None))
    if len(lines) != len(run.findings):
        problems.append("%d commands for %d findings" % (len(lines), len(run.findings)))
    same(found, expected, "command", problems)
    return problems


def check_gcc(output, run):
    """The lines are known but for the path: whether that is relative."""
    problems = []
    text = text_of(output, problems)
    if text is None:
        return problems
    lines = text.split("\n")[:-1]
    if len(lines) != len(run.findings):
        problems.append("%d lines for %d findings" % (len(lines), len(run.findings)))
    for line, finding in zip(lines, run.findings):
        level = "note" if finding["severity"] == "info" else finding["severity"]
        rest = ":%d:%d: %s: %s [%s]" % (finding["start"]["line"], finding["start"]["column"], level, finding["message"], finding["code"])
        if not line.endswith(rest):
            problems.append("%r does not end in %r" % (line, rest))
        elif check_path(run, line[:-len(rest)], problems) != run.key(finding["path"]):
            problems.append("%r is not about %r" % (line, finding["path"]))
    return problems


def check_grouped(output, run):
    problems = []
    text = text_of(output, problems)
    if text is None:
        return problems
    found = []
    headings = []
    for line in text.split("\n"):
        match = GROUPED.fullmatch(line)
        if match is not None and headings:
            found.append((headings[-1], match[5], match[4], int(match[2]), int(match[3]), match[6]))
        elif line and not line.startswith(" "):
            headings.append(check_path(run, line, problems))
        elif line:
            problems.append("neither a file nor a finding: %r" % line)
    files = [run.key(file["path"]) for file in run.report["files"] if file["findings"]]
    same(headings, files, "heading", problems)
    same(found, [(run.key(f["path"]), f["code"], f["severity"], f["start"]["line"], f["start"]["column"], f["message"])
                 for f in run.findings], "line", problems)
    return problems
