"""Programs of several files in one text, as in tests/support/bundle.h: a line `; file: NAME` begins the file NAME.

Line numbers of a bundle are those of the text, so that a place in any of its files is one number.
"""
import os
import re

MAIN = "program.ngc"
_MARK = re.compile(r"^; file: (.*?)\r?$")


def split(text):
    """-> {name: (number of the line before its first, text)}, the program first"""
    files, name, first, lines = {}, MAIN, 0, []
    rows = text.split("\n")
    for number, row in enumerate(rows, 1):
        mark = _MARK.match(row)
        if mark:
            files.setdefault(name, (first, "".join(line + "\n" for line in lines)))
            name, first, lines = mark.group(1), number, []
        else:
            lines.append(row)
    files.setdefault(name, (first, "\n".join(lines)))
    return files


def is_bundle(text):
    return "\n; file: " in text


def write(folder, files, change=lambda text: text):
    """Write {name: (_, text)} below a folder."""
    for name, (_, text) in files.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="latin-1", newline="") as f:
            f.write(change(text))
