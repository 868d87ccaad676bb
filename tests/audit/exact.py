#!/usr/bin/python3
"""Which programs are analysed again, by name: random changes of a shop, and after each of them the programs that must be analysed, and none
that need not; and the findings of a fresh check and of a fresh store.

usage: exact.py --owlint build/release/owlint [--files N] [--steps N] [--seed N]
"""
import os
import random
import re
import shutil

from support import arguments, check, checked, export, findings, last_run, main, query, run, write

FOLDERS = ("first", "subs", "last")  # the search path; nothing of it is audited but `subs`
NAMES = ["s%d" % number for number in range(30)]
ANALYSED = "SELECT path FROM analysis JOIN file ON file.id = analysis.file WHERE analysis.run = (SELECT max(id) FROM run)"
# New and gone as the fingerprints of single findings say; moved ones are neither.
PRINTS = "SELECT fingerprint FROM finding WHERE until IS NULL"
FAULTS = ("", "", "", "o900 if [1]\no901 endif\n", "o900 while [#30 LT 2]\n  #30=[#30+1]\no900 endwhile\no900 if [1]\no900 endif\n", "o<nowhere> call\n", "G1 X[1\n")


def calls_of(path):
    """The names that a file calls."""
    with open(path, encoding="utf-8") as file:
        return set(re.findall(r"o<(\w+)> call", file.read()))


class Shop:
    def __init__(self, options, folder):
        self.owlint, self.root, self.store = options.owlint, folder + "/shop", folder + "/shop.db"
        self.chance = random.Random(options.seed)
        self.number = 0
        self.options = ()
        self.names_asked, self.files_read = {}, {}
        for name in FOLDERS:
            os.makedirs("%s/%s" % (self.root, name))
        write(self.root + "/machine.ini", "[RS274NGC]\nSUBROUTINE_PATH = %s\n" % ":".join(FOLDERS))
        for name in NAMES:
            write(self.sub("subs", name), self.sub_text(name))
        for _ in range(options.files):
            self.add_program()

    # ---- what there is ----

    def sub(self, folder, name):
        return "%s/%s/%s.ngc" % (self.root, folder, name)

    def sub_text(self, name):
        """Subs call those with higher numbers, so that there is no recursion, but chains."""
        higher = NAMES[NAMES.index(name) + 1:]
        called = self.chance.sample(higher, min(len(higher), self.chance.choice((0, 0, 1, 1, 2))))
        fault = self.chance.choice(("", "", "", "  G1 X[1\n"))
        return "o<%s> sub\n%s%s  G1 X%03d\no<%s> endsub\nM2\n" % (name, "".join("  o<%s> call [1]\n" % c for c in called), fault, self.chance.randrange(1000), name)

    def programs(self):
        return sorted(os.path.join(at, name) for at, _, names in os.walk(self.root + "/programs") for name in names if name.endswith(".ngc"))

    def audited(self):
        return self.programs() + sorted(self.sub("subs", name) for name in NAMES if os.path.exists(self.sub("subs", name)))

    def resolved(self, name):
        return next((path for path in (self.root + "/%s.ngc" % name, *(self.sub(folder, name) for folder in FOLDERS)) if os.path.exists(path)), None)

    def remember(self):
        """What the analyses of this moment rest on: names that were looked for, and files that were read."""
        self.names_asked, self.files_read = {}, {}
        for path in self.audited():
            names, files, todo = set(), {path}, [path]
            while todo:
                for name in calls_of(todo.pop()) - names:
                    names.add(name)
                    found = self.resolved(name)
                    if found and found not in files:
                        files.add(found)
                        todo.append(found)
            self.names_asked[path], self.files_read[path] = names, files

    def readers(self, path):
        return {one for one, files in self.files_read.items() if path in files}

    def askers(self, name):
        return {one for one, names in self.names_asked.items() if name in names}

    def nameless(self):
        """Those that call what is nowhere: what owlint proposes instead hangs on all names that there are."""
        return {one for one, names in self.names_asked.items() if any(self.resolved(name) is None for name in names)}

    def any_name(self):
        return self.chance.choice(NAMES)

    # ---- changes: each gives what must be analysed; where that is a pair, the second says what else may be ----

    def nothing(self):
        return set()

    def touch(self):
        os.utime(self.chance.choice(self.audited()), (1_000_000_000, self.chance.randrange(1_000_000_000)))
        return set()

    def add_program(self):
        called = self.chance.sample(NAMES, self.chance.choice((0, 1, 1, 2, 3)))
        path = "%s/programs/f%d/p%d.ngc" % (self.root, self.number // 100, self.number)
        self.number += 1
        write(path, "(part %d)\n%s%sM2\n" % (self.number, "".join("o<%s> call [1]\n" % name for name in called), self.chance.choice(FAULTS)))
        return {path}

    def delete_program(self):
        os.remove(self.chance.choice(self.programs()))
        return set()

    def line_above(self):
        path = self.chance.choice(self.programs())
        with open(path, encoding="utf-8") as file:
            text = file.read()
        write(path, "(one more)\n" + text)
        return {path}

    def change_sub(self):
        path = self.sub("subs", self.any_name())
        if not os.path.exists(path):
            return set()
        write(path, self.sub_text(os.path.basename(path)[:-4]))
        with open(path, "a", encoding="utf-8") as file:
            file.write("(%d)\n" % self.chance.randrange(10**9))
        return self.readers(path)

    def change_sub_in_secret(self):
        """As many bytes, and the time as before: only the inode's own time tells."""
        path = self.sub("subs", self.any_name())
        if not os.path.exists(path):
            return set()
        info = os.stat(path)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        other = re.sub(r"  G1 X(\d+)", lambda m: "  G1 X%03d" % ((int(m[1]) + 1) % 1000), text)
        write(path, other)
        os.utime(path, ns=(info.st_atime_ns, info.st_mtime_ns))
        return self.readers(path)

    def comes_or_goes(self, name, path):
        """A file on the search path. Where the name then leads to the same file as before, those that call it may be analysed or not."""
        before, nameless = self.resolved(name), self.nameless()
        if os.path.exists(path):
            os.remove(path)
        else:
            write(path, self.sub_text(name))
        moved = self.askers(name) if self.resolved(name) != before else set()
        return moved, self.askers(name) | nameless | self.nameless()

    def shadow(self):
        """Another file of that name, earlier or later on the search path, or the one that there was taken away."""
        name = self.any_name()
        return self.comes_or_goes(name, self.sub(self.chance.choice(("first", "last")), name))

    def sub_goes_or_comes(self):
        name = self.any_name()
        path = self.sub("subs", name)
        must, may = self.comes_or_goes(name, path)
        return (must | {path}, may) if os.path.exists(path) else (must - {path}, may - {path})

    def move_folder(self):
        folder = os.path.dirname(self.chance.choice(self.programs()))
        self.number += 1
        shutil.move(folder, "%s/programs/moved%d" % (self.root, self.number))
        return set(self.programs()) - set(self.names_asked)

    def other_options(self):
        self.options = () if self.options else ("--ignore", "OW3")
        return set(self.audited())

    def change_ini(self):
        with open(self.root + "/machine.ini", "a", encoding="utf-8") as file:
            file.write("PARAMETER_FILE = %d.var\n" % self.chance.randrange(10**9))
        return set(self.audited())

    def configuration(self, text='ignore = ["OW106"]\n'):
        """An owlint.toml comes or goes in a folder: its programs have other settings."""
        folder = os.path.dirname(self.chance.choice(self.programs()))
        path = folder + "/owlint.toml"
        if os.path.exists(path):
            os.remove(path)
        else:
            write(path, text)
        return {program for program in self.programs() if os.path.dirname(program) == folder}

    # ---- after each ----

    def audit(self, what, expected):
        before = sorted(query(self.store, PRINTS)) if os.path.exists(self.store) else []
        common = (self.root + "/programs", self.root + "/subs", "--ini", self.root + "/machine.ini", *self.options)
        run(self.owlint, "audit", *common, "--store", self.store, "-q", statuses=(0, 1, 2))
        analysed = {path for (path,) in query(self.store, ANALYSED)}
        row = last_run(self.store)
        if expected is not None:  # None: only the findings are foreseen
            must, may = expected if isinstance(expected, tuple) else (expected, set())
            check(must <= analysed <= must | may,
                  "%s: analysed without need: %s; not analysed: %s" % (what, sorted(analysed - must - may)[:5], sorted(must - analysed)[:5]))
            check(row["analysed"] == len(analysed), "%s: the run says %d analysed, the store %d" % (what, row["analysed"], len(analysed)))
        fresh = self.store + ".fresh"
        run(self.owlint, "audit", *common, "--store", fresh, "-q", statuses=(0, 1, 2))
        found = findings(export(self.owlint, self.store))
        check(found == findings(export(self.owlint, fresh)), what + ": a fresh store has other findings: %s" % different(found, findings(export(self.owlint, fresh))))
        direct = findings(run(self.owlint, "check", *common, "--format", "json", statuses=(0, 1, 2)).stdout)
        check(some(found) == some(direct), "%s: `owlint check` finds something else: %s" % (what, different(found, direct)))
        check(query(self.store, "SELECT path, hash, bytes, lines FROM program ORDER BY path") == query(fresh, "SELECT path, hash, bytes, lines FROM program ORDER BY path"), what + ": other programs than in a fresh store")
        os.remove(fresh)
        now = sorted(query(self.store, PRINTS))
        if before and row["id"] > 1:
            new, gone = less(now, before), less(before, now)
            check((row["new"], row["gone"]) == (new, gone), "%s: %d new and %d gone, not %d and %d" % (what, row["new"], row["gone"], new, gone))
        return len(analysed), sum(map(len, found.values()))


def some(found):
    return {path: those for path, those in found.items() if those}


def different(a, b):
    return sorted(path for path in some(a).keys() | some(b).keys() if a.get(path) != b.get(path))[:5]


def less(left, right):
    """How many of a list are left when those of another are taken from it."""
    right = list(right)
    count = 0
    for one in left:
        if one in right:
            right.remove(one)
        else:
            count += 1
    return count


def test(options, folder):
    shop = Shop(options, folder)
    shop.audit("first run", set(shop.audited()))
    changes = (shop.nothing, shop.touch, shop.add_program, shop.delete_program, shop.line_above, shop.change_sub, shop.change_sub_in_secret, shop.shadow,
               shop.sub_goes_or_comes, shop.move_folder, shop.other_options, shop.change_ini, shop.configuration)
    for step in range(options.steps):
        shop.remember()
        change = changes[step] if step < len(changes) else shop.chance.choice(changes)
        analysed, found = shop.audit("step %d, %s" % (step, change.__name__), change())
        print("%3d %-22s %5d analysed, %5d findings" % (step, change.__name__, analysed, found))
    # Programs whose owlint.toml is wrong are not checked, and have no findings; when it is mended they have them again.
    broken = os.path.dirname(shop.programs()[0]) + "/owlint.toml"
    write(broken, "ignroe = []\n")
    shop.audit("an owlint.toml is wrong", None)
    shop.audit("it still is", set())
    os.remove(broken)
    shop.audit("it is taken away", None)
    print("after %d changes, seed %d: analysed is what has to be, and the findings are those of a fresh check" % (options.steps, options.seed))


if __name__ == "__main__":
    main(test, arguments(__doc__, files=300, steps=40, seed=1))
