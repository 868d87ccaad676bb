#!/usr/bin/python3
"""Is analysed anew what has changed, and nothing else? And is what comes out what a fresh check finds?

usage: incremental.py --owlint build/release/owlint [--files N]
"""
import os
import shutil

from support import SUBS, arguments, callers, check, checked, export, findings, last_run, main, make_shop, part, program_text, run, sub_text, write


class Shop:
    def __init__(self, owlint, folder, programs):
        self.owlint, self.root, self.store = owlint, folder + "/shop", folder + "/shop.db"
        self.programs = programs
        make_shop(self.root, programs)

    def audit(self, what, analysed, options=(), new=0, gone=0):
        """A run; what it analysed, and that its findings are those of a fresh check and of a fresh store."""
        run(self.owlint, "audit", self.root, "--store", self.store, "--ini", self.root + "/machine.ini", "-q", *options)
        row = last_run(self.store)
        check(row["analysed"] == analysed, "%s: %d programs were analysed, not %d" % (what, row["analysed"], analysed))
        check((row["new"], row["gone"]) == (new, gone), "%s: %d new and %d gone, not %d and %d" % (what, row["new"], row["gone"], new, gone))
        found = findings(export(self.owlint, self.store))
        fresh = self.store + ".fresh"
        run(self.owlint, "audit", self.root, "--store", fresh, "--ini", self.root + "/machine.ini", "-q", *options)
        check(found == findings(export(self.owlint, fresh)), what + ": a fresh store has other findings")
        os.remove(fresh)
        direct = checked(self.owlint, self.root, *options)
        check({k: v for k, v in found.items() if v} == {k: v for k, v in direct.items() if v}, what + ": `owlint check` finds something else")
        print("%-50s %6d analysed, %d new, %d gone" % (what, analysed, new, gone))

    def change_sub(self, number, text):
        write("%s/subs/shared%d.ngc" % (self.root, number), text)


def test(options, folder):
    shop = Shop(options.owlint, folder, options.files)
    all_files = options.files + SUBS
    faulty = len(range(0, options.files, 10))
    shop.audit("first run", all_files)
    shop.audit("nothing changed", 0)
    os.utime(part(shop.root, 3))
    shop.audit("a file is touched", 0)
    shop.change_sub(1, sub_text(1) + "(changed)\n")
    shop.audit("a shared sub is changed", callers(options.files, 1))
    shop.change_sub(2, sub_text(2).replace("endif", "endiff"))
    shop.audit("a shared sub becomes faulty", callers(options.files, 2), new=1)
    shop.change_sub(2, sub_text(2))
    shop.audit("it is fixed", callers(options.files, 2), gone=1)
    # The folder `more` comes behind `subs`: what is added there hides nothing, but is one answer more to who asks for all.
    write(shop.root + "/f0000/shared3.ngc", sub_text(3))
    shop.audit("a file of that name, not on the search path", 1)
    os.remove(shop.root + "/f0000/shared3.ngc")
    shop.audit("and taken away", 0)
    shutil.move(shop.root + "/subs/shared4.ngc", shop.root + "/more/shared4.ngc")
    shop.audit("a sub is moved along the search path", callers(options.files, 4))
    write(part(shop.root, 5), "(one more line)\n" + program_text(5))
    write(part(shop.root, 10), "(one more line)\n" + program_text(10))
    shop.audit("lines move", 2)
    write(part(shop.root, options.files), program_text(options.files).replace("o100 endwhile", "o101 endwhile"))
    shop.audit("a new faulty program", 1, new=2 if options.files % 10 == 0 else 1)
    os.remove(part(shop.root, options.files))
    shop.audit("it is deleted", 0, gone=2 if options.files % 10 == 0 else 1)
    shutil.move(shop.root + "/f0000", shop.root + "/g0000")
    shop.audit("a folder is moved", min(options.files, 100))
    shutil.move(shop.root + "/g0000", shop.root + "/f0000")
    shop.audit("and back", min(options.files, 100))
    write(shop.root + "/f0001/owlint.toml" if options.files > 100 else shop.root + "/owlint.toml", "ignroe = []\n")
    run(shop.owlint, "audit", shop.root, "--store", shop.store, "--ini", shop.root + "/machine.ini", "-q", statuses=(2,))
    check(last_run(shop.store)["gone"] > 0, "programs that cannot be checked keep their findings")
    os.remove(shop.root + "/f0001/owlint.toml" if options.files > 100 else shop.root + "/owlint.toml")
    run(shop.owlint, "audit", shop.root, "--store", shop.store, "--ini", shop.root + "/machine.ini", "-q")
    shop.audit("a wrong configuration, and it is fixed", 0)
    shop.audit("another option", all_files, ("--ignore", "OW104"), gone=faulty)
    shop.audit("and back", all_files, new=faulty)
    os.mkdir(folder + "/macros")
    more = ("--sub-path", folder + "/macros")
    shop.audit("another folder for called files", all_files, more)
    shutil.move(shop.root + "/more/shared4.ngc", folder + "/macros/shared4.ngc")
    shop.audit("a sub is moved there", callers(options.files, 4) - 1, more)  # it is no program of the shop any more
    shutil.move(folder + "/macros/shared4.ngc", shop.root + "/more/shared4.ngc")
    with open(shop.root + "/machine.ini", "a", encoding="utf-8") as ini:
        ini.write("FEATURES = 0\n")
    shop.audit("the INI is changed", all_files, new=0)
    lathe = "[EMC]\nVERSION = 1.1\n[RS274NGC]\nOWORD_NARGS = %s\n"
    write(shop.root + "/lathe.ini", lathe % "YES")
    shop.audit("an INI that no program uses", 0, new=1)
    write(shop.root + "/lathe.ini", lathe % "1")
    shop.audit("it is fixed", 0, gone=1)


if __name__ == "__main__":
    options = arguments(__doc__, files=600)
    main(test, options)
