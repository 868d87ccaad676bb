#!/usr/bin/python3
"""How long an audit takes: of LinuxCNC's programs and sample configurations, and of these with made-up ones beside them.

usage: bench.py --owlint build/release/owlint [--files N]

Prints the first run, the second one without changes beside `find` with times and reading the store, and the one after a shared
sub has changed. Medians of five where nothing changes.
"""
import glob
import os
import statistics
import subprocess
import time

from support import SUBS, arguments, callers, check, last_run, main, make_shop, run, sub_text, write

LINUXCNC = ["/usr/share/linuxcnc/ncfiles", *glob.glob("/usr/share/doc/linuxcnc/examples/sample-configs")]


def timed(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def median(work, times=5):
    return statistics.median(timed(work) for _ in range(times))


def audit(owlint, store, *paths):
    return lambda: run(owlint, "audit", *paths, "--store", store, "-q")


def measure(owlint, store, what, *paths):
    first = timed(audit(owlint, store, *paths))
    files = last_run(store)["files"]
    time.sleep(2.1)  # files younger than two seconds are compared by their bytes
    run(owlint, "audit", *paths, "--store", store, "-q")
    second = median(audit(owlint, store, *paths))
    check(last_run(store)["analysed"] == 0, "%d programs are analysed again" % last_run(store)["analysed"])
    find = median(lambda: subprocess.run(["find", *paths, "-printf", "%p %s %T@ %C@\n"], stdout=subprocess.DEVNULL, check=True))
    sql = "SELECT path, stamp, hash, settings FROM file ORDER BY path; SELECT * FROM fact"
    reading = median(lambda: subprocess.run(["sqlite3", store, sql], stdout=subprocess.DEVNULL, check=True))
    print("%s: %d programs; first run %.2f s, second %.3f s; find %.3f s, reading the store %.3f s; second / (find + reading) %.2f, second / find %.2f"
          % (what, files, first, second, find, reading, second / (find + reading), second / find))


def test(options, folder):
    there = [path for path in LINUXCNC if os.path.isdir(path)]
    if there:
        measure(options.owlint, folder + "/linuxcnc.db", "LinuxCNC's own", *there)
    shop, store = folder + "/shop", folder + "/shop.db"
    make_shop(shop, options.files, motion=100)
    time.sleep(2.1)
    measure(options.owlint, store, "with made-up ones", *there, shop)
    write("%s/subs/shared1.ngc" % shop, sub_text(1) + "(changed)\n")
    third = timed(audit(options.owlint, store, *there, shop))
    analysed = last_run(store)["analysed"]
    check(analysed == callers(options.files, 1), "%d are analysed, not the callers" % analysed)
    print("after one of %d shared subs has changed: %d analysed, which are it and its callers, %.2f s" % (SUBS, analysed, third))


if __name__ == "__main__":
    main(test, arguments(__doc__, files=50_000))
