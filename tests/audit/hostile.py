#!/usr/bin/python3
"""Names and contents that somebody made to do harm: each program once, and as text in every export and in the page.

usage: hostile.py --owlint build/release/owlint
"""
import csv
import io
import json
import os
import re
import xml.etree.ElementTree as xml

from support import arguments, check, export, main, query, run, write

CONTENT = b"(</script><script>alert(2)</script><!-- ]]> \xe2\x80\xae \xff)\no<x\"><img src=x onerror=alert(3)> if [1]\no1 endif\n(=cmd|'/c calc'!A1)\nM2\n"
NAMES = ["<script>alert(1)<", "a\nb", "tab\there", "quote\"'`&amp;", "back\\slash", "-dash", "=cmd|calc", "\u202egcn", "%s%n", " blank ", "emoji\U0001f600"]
FORMATS = ("gcc", "json", "jsonl", "sarif", "github", "gitlab", "checkstyle", "junit", "rdjson", "csv")


def make(shop):
    """-> how many programs there are"""
    for name in NAMES:
        write("%s/%s.ngc" % (shop, name), CONTENT)
    with open(os.fsencode(shop) + b"/latin-\xe4\xff.ngc", "wb") as file:
        file.write(CONTENT)
    contents = {"empty": b"", "nul": b"o1 if [1]\0\nM2\n", "mark": b"\xef\xbb\xbfo1 if [1]\nM2\n", "long": b"o1 if [" + b"1+" * 100_000 + b"1]\nM2\n", "cr": b"o1 if [1]\rM2\r"}
    for name, content in contents.items():
        write("%s/%s.ngc" % (shop, name), content)
    deep = shop
    while len(deep) < 3800:
        deep += "/" + "x" * 200
    write(deep + "/deep.ngc", CONTENT)
    count = len(NAMES) + 1 + len(contents) + 1
    # What is no program, or one that is there already.
    os.symlink(shop, shop + "/loop")
    os.symlink(shop + "/empty.ngc", shop + "/again.ngc")
    os.symlink("/nowhere", shop + "/dangling.ngc")
    os.mkfifo(shop + "/fifo.ngc")
    write(shop + "/.hidden/h.ngc", CONTENT)
    write(shop + "/.dot.ngc", CONTENT)
    write(shop + "/.gitignore", "*.nc\n!kept.nc\nold/\n")
    write(shop + "/.owlintignore", "**/drafts/**\n")
    for name in ("left.nc", "old/o.ngc", "a/drafts/b/d.ngc"):
        write(shop + "/" + name, CONTENT)
    write(shop + "/kept.nc", CONTENT)
    # Links lead out of the shop, too, each folder once.
    write(shop + "-elsewhere/e.ngc", CONTENT)
    os.symlink(shop + "-elsewhere", shop + "/link1")
    os.symlink(shop + "-elsewhere", shop + "/link2")
    return count + 2


def test(options, folder):
    shop, store, page = folder + "/shop", folder + "/shop.db", folder + "/page.html"
    os.makedirs(shop)
    count = make(shop)
    has_page = "without npm" not in run(options.owlint, "audit", shop, "--store", folder + "/none.db", "--report", page, statuses=(1, 2)).stderr
    run(options.owlint, "audit", shop, "--store", store, "-q", statuses=(1,))
    paths = [path for (path,) in query_bytes(store)]
    check(len(paths) == count and len(set(paths)) == count, "%d programs, not %d: %s" % (len(paths), count, paths))
    there = {os.path.join(at, name) for at, _, names in os.walk(os.fsencode(shop), followlinks=False) for name in names}
    for path in paths:
        check(path in there or b"/link" in path, "no such file: %r" % path)
    expected = None
    for form in FORMATS:
        text = export(options.owlint, store, form)
        check("\x1b" not in text and "\x00" not in text, form + " has control characters")
        number = strictly(form, text)
        if number is not None:
            expected = expected or number
            check(number == expected, "%s has %d findings, not %d" % (form, number, expected))
    run(options.owlint, "audit", "show", "--store", store, statuses=(0,))
    if has_page:
        with open(page, encoding="utf-8") as file:
            text = file.read()
        check("alert(" not in text.split("</script>", 1)[1] or "alert(1)" not in text, "the page holds what a program says as markup")
        check(len(re.findall(r"<script", text)) < 40, "the page has scripts of others")
    print("%d hostile programs, %d findings: text everywhere%s" % (count, expected, "" if has_page else " (built without the page)"))


def query_bytes(store):
    import sqlite3
    with sqlite3.connect(store) as db:
        db.text_factory = bytes
        return db.execute("SELECT path FROM program").fetchall()


def strictly(form, text):
    """How many findings a report has, as strict parsers read it; nothing where a format does not tell all."""
    if form == "json":
        return sum(len(file["findings"]) for file in json.loads(text)["files"])
    if form == "jsonl":
        return len([json.loads(line) for line in text.splitlines() if line])
    if form == "sarif":
        return len(json.loads(text)["runs"][0]["results"])
    if form == "gitlab":
        return len(json.loads(text))
    if form == "rdjson":
        return len(json.loads(text)["diagnostics"])
    if form == "checkstyle":
        return len(xml.fromstring(text.encode()).findall(".//error"))
    if form == "junit":
        xml.fromstring(text.encode())
        return None
    if form == "csv":
        rows = list(csv.reader(io.StringIO(text, newline=""), strict=True))
        check(all(len(row) == len(rows[0]) for row in rows), "csv: rows of different length")
        check(not any(cell[:1] in "=+-@" and cell for row in rows for cell in row if not cell.isdigit()), "csv: a cell that is a formula")
        return len(rows) - 1
    return None


if __name__ == "__main__":
    main(test, arguments(__doc__))
