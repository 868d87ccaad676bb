"""The XML formats: Checkstyle's and JUnit's."""
import os
import re

from formats.run import check_path, same, says, text_of

HERE = os.path.dirname(os.path.abspath(__file__))
DECLARATION = re.compile(r'<\?xml version="1\.0" encoding="[Uu][Tt][Ff]-8"\?>\n?<')


def xml_text(text):
    """What XML 1.0 can carry of a text: two code points are forbidden in it, and a tab in an attribute is read as a blank."""
    return re.sub("[\ufffe\uffff]", "\ufffd", text).replace("\t", " ")


def _path(run, shown, problems):
    return xml_text(check_path(run, shown, problems))


def _root(output, schema, problems):
    from lxml import etree
    text = text_of(output, problems)
    if text is None:
        return None
    if not DECLARATION.match(text):
        problems.append("the XML declaration is missing or odd: %r" % text[:60])
    parser = etree.XMLParser(recover=False, resolve_entities=False, no_network=True, load_dtd=False)
    try:
        root = etree.fromstring(output, parser)
    except etree.XMLSyntaxError as error:
        problems.append("not XML: %s" % error)
        return None
    if root.getroottree().docinfo.doctype:
        problems.append("has a document type")
    kind = etree.XMLSchema(etree.parse(os.path.join(HERE, schema)))
    if not kind.validate(root):
        problems.extend("by its schema: %s" % error for error in list(kind.error_log)[:3])
        return None
    return root


def check_checkstyle(output, run):
    problems = []
    root = _root(output, "checkstyle.xsd", problems)
    if root is None:
        return problems
    files = [_path(run, file.get("name"), problems) for file in root]
    same(files, [xml_text(run.key(path)) for path in run.paths], "file", problems)
    found = []
    errors = [(file, error) for file in root for error in file]
    for (file, error), finding in zip(errors, run.findings):
        if not says(xml_text(error.get("message")), xml_text(finding["message"])):
            problems.append("%r does not say %r" % (error.get("message"), finding["message"]))
    for file, error in errors:
        found.append((xml_text(run.key(file.get("name"))), error.get("source")[len("owlint."):], error.get("severity"),
                      int(error.get("line")), int(error.get("column"))))
    same(found, [(xml_text(run.key(f["path"])), f["code"], f["severity"], f["start"]["line"], f["start"]["column"])
                 for f in run.findings], "error", problems)
    return problems


def _check_counts(element, tests, problems):
    failed = [test for test in tests if len(test)]
    wanted = {"tests": len(tests), "failures": len(failed), "errors": 0}
    for name, number in wanted.items():
        if int(element.get(name)) != number:
            problems.append("%s of %r is %s, not %d" % (name, element.get("name"), element.get(name), number))


def check_junit(output, run):
    problems = []
    root = _root(output, "junit.xsd", problems)
    if root is None:
        return problems
    same([_path(run, suite.get("name"), problems) for suite in root], [xml_text(run.key(path)) for path in run.paths], "suite", problems)
    _check_counts(root, [test for suite in root for test in suite], problems)
    found = []
    for suite in root:
        _check_counts(suite, list(suite), problems)
        for test in suite:
            if _path(run, test.get("file"), problems) != xml_text(run.key(suite.get("name"))):
                problems.append("a test of %r has the file %r" % (suite.get("name"), test.get("file")))
            if len(test):
                found.append((suite, test))
            elif len(suite) != 1 or test.get("line") is not None:
                problems.append("a test without finding, but not the only one of its file, or with a line: %r" % test.get("name"))
    expected = []
    for f in run.findings:
        line, column = f["start"]["line"], f["start"]["column"]
        expected.append((xml_text(run.key(f["path"])), f["code"], f["severity"], str(line), "%d:%d" % (line, column)))
    have = []
    for (suite, test), finding in zip(found, run.findings):
        failure = test[0]
        if xml_text(failure.get("message")) != xml_text(finding["message"]):
            problems.append("%r is not %r" % (failure.get("message"), finding["message"]))
        if xml_text(finding["message"]) not in xml_text(failure.text):
            problems.append("the text of a failure does not say %r: %r" % (finding["message"], failure.text))
        code = re.search(r"OW\d{3}", test.get("name") + " " + test.get("classname"))
        place = re.search(r"\d+:\d+", test.get("name"))
        have.append((xml_text(run.key(suite.get("name"))), code and code.group(), failure.get("type"), test.get("line"),
                     place and place.group()))
    if len(found) != len(run.findings):
        problems.append("%d failures for %d findings" % (len(found), len(run.findings)))
    same(have, expected[:len(have)], "failure", problems)
    return problems
