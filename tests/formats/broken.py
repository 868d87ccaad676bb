"""Reports that are wrong, made from right ones: a check that lets one of them pass is none."""
import copy
import json
import re

PLACES = {"startLine", "startColumn", "endLine", "endColumn", "line", "column", "begin", "end", "ruleIndex"}

# Names that may be absent, and texts that may be any; `*` stands for an element of an array.
OPTIONAL = {
    "sarif": {"runs/*/tool/driver/semanticVersion", "runs/*/tool/driver/rules/*/helpUri", "runs/*/tool/driver/rules/*/properties",
              "runs/*/tool/driver/rules/*/properties/tags", "runs/*/tool/driver/rules/*/defaultConfiguration/enabled",
              "runs/*/results/*/properties", "runs/*/results/*/properties/reach", "runs/*/results/*/properties/stops",
              "runs/*/results/*/locations/*/logicalLocations", "runs/*/results/*/relatedLocations/*/id",
              "runs/*/results/*/codeFlows/*/threadFlows/*/locations/*/importance"},
    "gitlab": set(),
    "rdjson": {"severity", "source/url", "diagnostics/*/source", "diagnostics/*/source/url", "diagnostics/*/code/url"},
}
ANY_TEXT = {"fullyQualifiedName", "kind"}


def _nodes(value, path=()):
    yield path, value
    for key, child in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
        yield from _nodes(child, path + (key,))


def _changed(report, path, change):
    other = copy.deepcopy(report)
    at = other
    for key in path[:-1]:
        at = at[key]
    change(at, path[-1])
    return json.dumps(other, ensure_ascii=False, indent=2).encode() + b"\n"


def _add(at, key):
    at[key] += 7


def _other_text(at, key):
    at[key] = "?" if isinstance(at, dict) else 1


def _strange(at, key):
    at[key]["strange"] = 1


def _json(output, name):
    """Without each name, with another number, with a name more, with other texts; one change of each kind is enough for an array."""
    report = json.loads(output)
    seen = set()
    for path, value in _nodes(report):
        shape = "/".join("*" if isinstance(key, int) else key for key in path)
        if not path or shape in seen:
            continue
        seen.add(shape)
        if isinstance(path[-1], str) and shape not in OPTIONAL[name]:
            yield "without " + shape, _changed(report, path, lambda at, key: at.pop(key))
        if path[-1] in PLACES and isinstance(value, int):
            yield "with another " + shape, _changed(report, path, _add)
        if isinstance(value, dict):
            yield "with a strange name in " + shape, _changed(report, path, _strange)
        if isinstance(value, str) and path[-1] not in ANY_TEXT:
            yield "with another text in " + shape, _changed(report, path, _other_text)
    first = re.search(rb'"(message|description)": ', output)
    yield "with a name twice", output[:first.start()] + first.group() + b"1, " + output[first.start():]
    yield "cut off", output[:len(output) // 2]
    yield "with something after it", output + b"{}\n"
    results = ("diagnostics",) if name == "rdjson" else ("runs", 0, "results") if name == "sarif" else ()
    for what, change in (("a finding less", lambda found: found.pop()), ("a finding twice", lambda found: found.append(found[0]))):
        yield "with " + what, _changed([report], (0, *results), lambda at, key: change(at[key]))[1:].strip().rstrip(b"]")


def _sarif(output):
    yield from _json(output, "sarif")
    text = output.decode()
    for what, old, new in (("a placeholder", "label `o100`", "label {0} `o100`"), ("a link", "label `o100`", "[label](3) `o100`"),
                           ("a URI with a blank", 'sample.ngc"', 'sam ple.ngc"'), ("a URI with dots", '"uri": "', '"uri": "../'),
                           ("another root", "file:///", "file:///x/"),
                           ("bytes in a region", '"startLine": ', '"byteOffset": 1, "startLine": ')):
        yield "with " + what, text.replace(old, new, 1).encode()
    rules = ("runs", 0, "tool", "driver", "rules")
    yield "with the rules in another order", _changed(json.loads(output), rules, lambda at, key: at[key].reverse())


def _gitlab(output):
    yield from _json(output, "gitlab")
    yield "with one fingerprint twice", re.sub(rb'"fingerprint": "[^"]*"', b'"fingerprint": "0123456789abcdef"', output)


def _rdjson(output):
    yield from _json(output, "rdjson")
    yield "with columns of code points", output.replace(b'"column": 6', b'"column": 5')


def _text(output, pairs):
    text = output.decode()
    lines = text.split("\n")
    yield "without a line", "\n".join(lines[1:]).encode()
    yield "with a line twice", "\n".join([lines[0], *lines]).encode()
    yield "with something after it", output + b"1 error\n"
    yield "without its last line end", output.rstrip(b"\n")
    for old, new in pairs:
        yield "%r instead of %r" % (new, old), re.sub(old, new, text, count=1, flags=re.S).encode()


def _github(output):
    return _text(output, [
        ("::error", "::fatal"), ("::error", " error"), ("file=", "file=x"), ("sample", "/sample"), (",line=", ",line=9"),
        (",endLine=", ",endline="), (r",col=\d+", ""), (r"col=\d+", "col=1,col=1"), (",endColumn=", ",endColumn=9"),
        (",endColumn=", ",endColumn=-"), (",title=[^:]*", ""), (",title=", ",title=a:b"), (",title=", ",title=a%b"), ("OW103", "OW104"),
        ("::label", "::%label"), ("::label", "::lable"), ("::label", "::la\r\nbel")])


def _gcc(output):
    return _text(output, [(": error: ", ": fatal: "), (r":(\d+): ", r":9\1: "), (r" \[OW", " (OW"), ("sample", "sampel"),
                          ("label", "\x1b[1mlabel"), ("label", "lable")])


def _grouped(output):
    return _text(output, [("error", "fatal"), (r"(\d+):", r"9\1:"), ("sample", "sampel"), ("\n +", "\n"), ("label", "lable"),
                          ("OW103", "OW104")])


def _xml(output):
    text = output.decode()
    declaration = text[:text.index("?>") + 2]
    for what, old, new in (
            ("an open element", "</file>", ""), ("an open element", "</failure>", ""),
            ("a bare &", "label", "la&bel"), ("a bare <", "label", "la<bel"), ("an unknown entity", "label", "&auml;label"),
            ("a control character", "label", "\x01label"), ("a reference to one", "label", "&#1;label"),
            ("a forbidden code point", "label", "\ufffelabel"), ("another text", 'message="', 'message="?'),
            ("another line", ' line="', ' line="9'), ("another column", ' column="', ' column="9'),
            ("an unknown severity", '"error"', '"fatal"'), ("an attribute more", ' line="', ' strange="" line="'),
            ("another code", "OW103", "OW104"), ("another file", "sample.ngc", "sampel.ngc"), ("a wrong count", ' tests="', ' tests="1'),
            ("a wrong count", ' failures="', ' failures="1'), ("errors", ' errors="0"', ' errors="1"'), ("no declaration", declaration, ""),
            ("another encoding", "UTF-8", "ISO-8859-1"), ("a document type", "?>", '?><!DOCTYPE x [<!ENTITY a "b">]>')):
        yield "with " + what, text.replace(old, new, 1).encode()
    yield "not UTF-8", output.replace(b"label", b"la\xfcbel", 1)
    yield "with a byte order mark", b"\xef\xbb\xbf" + output
    yield "without a finding", re.sub(r"<(error|testcase)\b.*?(/>|</testcase>)", "", text, count=1, flags=re.S).encode()


MAKERS = {"sarif": _sarif, "github": _github, "gitlab": _gitlab, "checkstyle": _xml, "junit": _xml, "rdjson": _rdjson, "gcc": _gcc,
          "grouped": _grouped}


def broken(name, output):
    """What is wrong, and the report; a change that changes nothing in this format is left out."""
    return ((what, data) for what, data in MAKERS[name](output) if data != output)
