#!/usr/bin/python3
"""Begins a rule: its file, and a program for and one against it.

usage: new_rule.py CODE NAME    for example OW220 label-too-long

Writes rules/owNxx_*/ow220_label_too_long.cc and tests/programs/OW220/{finding,nothing}.ngc.  The catalogue takes the rule up by
itself.  A `…` stands for what is still to be written, and the tests fail while one is there.

Exit status: 0 written; 2 the code or the name cannot be used.
"""
import glob
import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
GROUPS = {"0": "kLinter", "1": "kAbortList", "2": "kBlocks", "3": "kLine", "4": "kFiles", "5": "kHazards", "6": "kDataFlow",
          "7": "kWords", "8": "kModes", "9": "kGeometry"}

RULE = """// {code} {name}: …
// Depends on: …
#include "rules/driver/stops.h"

namespace owlint::rules::{space} {{
namespace {{

// …: this check finds nothing until code_of() gives the rule a StopKind (CONTRIBUTING.md, "Add a rule about a stop"). A rule
// about anything else has another one.
void check(const Input& in, Reporter& out) {{
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {{
    Finding& f = out.add(in.program.at(stop.statement).head_span(), "…");
    f.help = "…";
    return &f;
  }});
}}

}}  // namespace

extern const Rule kRule{{
    .code = "{code}",
    .name = "{name}",
    .summary = "…",
    .group = Group::{group},
    .level = Severity::kError,
    .page = {{
        .what = R"(…)",
        .why = R"(…)",
        .bad = R"(…
)",
        .good = R"(…
)",
        .fix = R"(…)",
        .level_reason = "…",
        .interpreter = "…",
        .options = "",
    }},
    .check = check,
}};

}}  // namespace owlint::rules::{space}
"""


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as f:
        f.write(text)
    print(os.path.relpath(path, ROOT))


def main(argv):
    if len(argv) != 2 or not re.fullmatch(r"OW\d{3}", argv[0]) or not re.fullmatch(r"[a-z][a-z0-9]*(-[a-z0-9]+)*", argv[1]):
        print(__doc__.split("\n\n")[1], file=sys.stderr)
        return 2
    code, name = argv
    folders = glob.glob(os.path.join(ROOT, "rules", "ow%sxx_*" % code[2]))
    taken = glob.glob(os.path.join(ROOT, "rules", "*", code.lower() + "_*")) + glob.glob(os.path.join(ROOT, "rules", "*", "ow*_" + name.replace("-", "_") + ".cc"))
    if len(folders) != 1 or taken:
        print("%s is there already" % os.path.relpath(taken[0], ROOT) if taken else "no folder for this code below rules/", file=sys.stderr)
        return 2
    write(os.path.join(folders[0], "%s_%s.cc" % (code.lower(), name.replace("-", "_"))), RULE.format(code=code, name=name, space=code.lower(), group=GROUPS[code[2]]))
    programs = os.path.join(ROOT, "tests", "programs", code)
    write(os.path.join(programs, "finding.ngc"), "; asks: …?\n; expect: %s 3:1-3:3 error always stops\nM2\n" % code)
    write(os.path.join(programs, "nothing.ngc"), "; asks: …?\n; expect: nothing\nM2\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
