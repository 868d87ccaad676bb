#!/usr/bin/python3
"""Does --watch tell of a mistake when it is saved, and when it is fixed?

usage: watch.py --owlint build/release/owlint
"""
import os
import queue
import signal
import subprocess
import threading

from support import arguments, check, last_run, main, query, write

GOOD = "o100 if [1]\no100 endif\nM2\n"
BAD = "o100 if [1]\no101 endif\nM2\n"
PATIENCE = 60


def test(options, folder):
    shop, store = folder + "/shop", folder + "/shop.db"
    write(shop + "/a.ngc", GOOD)
    audit = subprocess.Popen([options.owlint, "audit", shop, "--store", store, "--watch", "--color", "never"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    lines = queue.Queue()
    threading.Thread(target=lambda: [lines.put(line) for line in audit.stdout], daemon=True).start()
    seen = []

    def until(words):
        while True:
            try:
                seen.append(lines.get(timeout=PATIENCE))
            except queue.Empty:
                check(False, "`%s` is not said: %s" % (words, "".join(seen)))
            if words in seen[-1]:
                return

    try:
        until("0 errors")
        write(shop + "/a.ngc", BAD)
        until("new: ")
        until("OW106")
        write(shop + "/a.ngc", GOOD)
        until("gone: ")
        write(shop + "/later/folder/b.ngc", BAD)
        until("new: ")
        until("OW106")
        os.remove(shop + "/later/folder/b.ngc")
        until("gone: ")
        runs = query(store, "SELECT count(*) FROM run")[0][0]
        check(runs >= 5, "%d runs" % runs)
    finally:
        audit.send_signal(signal.SIGINT)
        audit.wait(PATIENCE)
    check(audit.returncode in (0, 1), "the status at the end is %s" % audit.returncode)
    check(last_run(store)["state"] == "complete", "the last run is not complete")
    print("--watch tells what is new and what is gone, in new folders too, and ends in order")


if __name__ == "__main__":
    main(test, arguments(__doc__))
