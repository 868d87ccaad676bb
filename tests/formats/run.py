"""A run of owlint as `--format json` tells it: what the other formats of the same run are held against."""
import codecs
import json
import os
import re

_CONTROLS = re.compile("[\0-\x1f\x7f]")

codecs.register_error("as-latin-1", lambda error: (chr(error.object[error.start]), error.start + 1))


def as_utf8(data):
    """Bytes as owlint writes them into JSON: what is not UTF-8 is taken for Latin-1."""
    return data.decode("utf-8", "as-latin-1")


def printable(data):
    """Bytes as owlint shows them: control characters are U+FFFD besides."""
    return visible(as_utf8(data))


def visible(text):
    return "".join("\ufffd" if (c < " " and c != "\t") or c == "\x7f" else c for c in text)


def text_of(output, problems, allowed="\t\n"):
    """The output as text; it must be UTF-8 without byte order mark, and without control characters."""
    try:
        text = output.decode("utf-8")
    except UnicodeDecodeError as error:
        problems.append("not UTF-8: %s" % error)
        return None
    if text.startswith("\ufeff"):
        problems.append("begins with a byte order mark")
    odd = sorted(set(_CONTROLS.findall(text)) - set(allowed))
    if odd:
        problems.append("control characters in it: %r" % odd)
    if text and not text.endswith("\n"):
        problems.append("the last line does not end")
    return text


def strict_json(text, problems):
    """JSON of RFC 8259 where no object has a name twice, no number is NaN, and no escape leaves half a character."""
    def pairs(entries):
        names = [name for name, _ in entries]
        if len(set(names)) != len(names):
            problems.append("an object has a name twice: %r" % names)
        return dict(entries)

    def constant(name):
        problems.append("not a JSON number: %s" % name)

    try:
        value = json.loads(text, object_pairs_hook=pairs, parse_constant=constant)
        json.dumps(value, ensure_ascii=False).encode("utf-8")
    except ValueError as error:
        problems.append("not JSON: %s" % error)
        return None
    return value


class Schema:
    """A JSON schema: compiled, since large reports are held against it; what is wrong with one is then said by jsonschema."""

    def __init__(self, schema):
        import fastjsonschema
        import jsonschema
        kind = jsonschema.validators.validator_for(schema, jsonschema.Draft7Validator)
        kind.check_schema(schema)
        self._explaining = kind(schema)
        self._invalid = fastjsonschema.JsonSchemaException
        formats = {name: lambda _: True for name in ("uri", "uri-reference", "date-time", "uuid")}  # the checks know more of these
        self._accept = fastjsonschema.compile(schema, formats=formats, use_default=False)

    def errors(self, value):
        """-> [what is wrong with it, and where]"""
        try:
            self._accept(value)
            return []
        except self._invalid as error:
            found = sorted(self._explaining.iter_errors(value), key=lambda e: list(map(str, e.absolute_path)))
            said = ["%s at /%s" % (e.message[:200], "/".join(map(str, e.absolute_path))) for e in found]
            return said or [str(error)]


def by_schema(schema, value, problems, most=3):
    """Adds what the schema has against a value."""
    errors = schema.errors(value)
    problems += ["by its schema: " + error for error in errors[:most]]
    return not errors


def same(found, expected, what, problems):
    """Adds the first difference of two lists of places."""
    if len(found) != len(expected):
        problems.append("%d %s instead of %d" % (len(found), what, len(expected)))
    for number, (have, want) in enumerate(zip(found, expected)):
        if have != want:
            problems.append("%s %d is %r, by --format json %r" % (what, number, have, want))
            return


class Run:
    """What `--format json` says, the folder it was said in, the files that it speaks of, and the rules there are."""

    def __init__(self, report, folder, paths, stdin=None, catalogue=()):
        self.folder = os.fsencode(folder)
        self.report = report
        self.stdin = stdin
        self.catalogue = catalogue
        self.findings = [{**finding, "path": file["path"]} for file in report["files"] for finding in file["findings"]]
        self.paths = [file["path"] for file in report["files"]]
        self.written = set()  # the paths in full, as JSON has them
        self._raw = {}
        for path in map(os.fsencode, paths):
            below = [os.path.join(at, name) for at, _, names in os.walk(os.path.join(self.folder, path)) for name in names]
            for raw in below or [os.path.join(self.folder, path)]:
                self._raw[self.key(printable(raw))] = os.path.normpath(raw)
                self.written.add(as_utf8(os.path.normpath(raw)))

    def key(self, shown):
        """One text for one file, whether its path is given from the root or from the folder of the run."""
        return visible(os.path.normpath(os.path.join(as_utf8(self.folder), shown)))

    def lost_paths(self):
        """What `--format json` calls a file and is not its path."""
        whole = [os.path.normpath(os.path.join(as_utf8(self.folder), path)) for path in self.paths]
        return [path for path in whole if self.stdin is None and path not in self.written and not os.path.exists(path)]

    def below(self, shown):
        """Whether a file lies in the folder of the run: CI services want such paths without the folder."""
        return self.key(shown).startswith(printable(self.folder).rstrip("/") + "/")

    def raw(self, shown):
        """The bytes of a path on the disk; None for standard input."""
        key = self.key(shown)
        raw = self._raw.get(key, os.fsencode(key))
        return raw if self.stdin is None or os.path.exists(raw) else None

    def content(self, shown):
        raw = self.raw(shown)
        if raw is None:
            return self.stdin
        with open(raw, "rb") as f:
            return f.read()

    def begins_with_mark(self, shown):
        return self.content(shown).startswith(codecs.BOM_UTF8)

    def byte_place(self, shown, position):
        """Line and column of a JSON position, the column in bytes."""
        return position["line"], position["offset"] - (self.content(shown).rfind(b"\n", 0, position["offset"]) + 1) + 1


def check_path(run, shown, problems):
    """A path below the folder of the run is shown without that folder."""
    if run.below(shown) and shown.startswith(("/", "./")):
        problems.append("a path below the folder of the run is not relative to it: %r" % shown)
    return run.key(shown)


def says(text, message):
    """Whether a text begins with the finding's message; what LinuxCNC says and how to fix it may come after it."""
    return text == message or (text.startswith(message) and text[len(message)] in "\n;")
