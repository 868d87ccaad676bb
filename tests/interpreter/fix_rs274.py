#!/usr/bin/python3
"""`owlint check --fix` changes nothing that `rs274` puts out, byte for byte, of programs that ran.

usage: fix_rs274.py --owlint build/release/owlint

All programs of the corpus and of the fixtures that are one file, as the stand-alone interpreter runs them, and with all
safe fixes of all rules made. fix.py does the same with many runs of random programs, in process.
"""
import argparse
import glob
import os
import shutil
import subprocess
import sys
import tempfile

import rs274

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
SKIPPED = 77


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--every", type=int, default=1, help="only every Nth program")
    options = parser.parse_args()
    owlint = os.path.abspath(options.owlint)
    if not rs274.available:
        print("skipped: rs274 is not here")
        return SKIPPED
    paths = sorted(glob.glob(os.path.join(ROOT, "corpus", "*.ngc")) + glob.glob(os.path.join(ROOT, "tests", "programs", "*", "*.ngc")))[::options.every]
    with tempfile.TemporaryDirectory() as folder:
        # Alone in its folder each, so that none is the called file of another.
        copies = []
        for number, path in enumerate(paths):
            os.makedirs(os.path.join(folder, str(number)))
            copies.append(shutil.copy(path, os.path.join(folder, str(number))))
        subprocess.run([owlint, "check", "--isolated", "--no-find-ini", "--extend-select", "OW", "--fix-only", "--quiet", *copies], check=True)
        changed = ran = different = 0
        for path, copy in zip(paths, copies):
            with open(path, "rb") as before, open(copy, "rb") as after:
                text = after.read()
                if before.read() == text:
                    continue
            changed += 1
            shutil.copy(path, copy)  # under one name: messages and offsets tell it
            first = rs274.canonical(copy)
            if first[0] != 0:
                continue
            ran += 1
            with open(copy, "wb") as fixed:
                fixed.write(text)
            if rs274.canonical(copy) != first:
                different += 1
                print("different: %s" % path)
    print("%d programs, %d of them fixed, %d of these ran, %d differ" % (len(paths), changed, ran, different))
    return 1 if different or not ran else 0


if __name__ == "__main__":
    sys.exit(main())
