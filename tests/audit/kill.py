#!/usr/bin/python3
"""Does a store outlive whatever happens to the audits that write it?

usage: kill.py --owlint build/release/owlint [--kills N] [--files N]
"""
import os
import random
import resource
import signal
import sqlite3
import subprocess
import time

from support import SUBS, arguments, check, export, last_run, main, make_shop, query, run


def sound(owlint, store):
    """How many analyses a store has, after it has proved sound."""
    check(query(store, "PRAGMA integrity_check") == [("ok",)], "the store is damaged")
    run(owlint, "audit", "list", "--store", store, statuses=(0,))
    return query(store, "SELECT count(*) FROM analysis")[0][0]


def killed(options, folder, shop):
    """Kills at random moments; what was stored stays, and in the end all is as if nothing had happened."""
    chance = random.Random(11)
    store = folder + "/killed.db"
    command = [options.owlint, "audit", shop, "--store", store, "--jobs", "1", "-q"]
    started = time.monotonic()
    run(options.owlint, "audit", shop, "--store", folder + "/whole.db", "--jobs", "1", "-q")
    usual = time.monotonic() - started
    stored = interrupted = 0
    for number in range(options.kills):
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as audit:
            try:
                audit.wait(chance.uniform(0, usual * (0.15 if number % 4 else 1.1)))
            except subprocess.TimeoutExpired:
                audit.send_signal(signal.SIGINT if number % 5 == 0 else signal.SIGKILL)
                interrupted += 1
                check(audit.wait() in (-signal.SIGINT, -signal.SIGKILL, 0, 1), "the status after a signal is %s" % audit.returncode)
        if not os.path.exists(store) or not query(store, "SELECT count(*) FROM sqlite_master WHERE name = 'analysis'")[0][0]:
            continue
        now = sound(options.owlint, store)
        check(now >= stored, "%d analyses were stored, now there are %d" % (stored, now))
        stored = now
        if number % 40 == 39:  # from the beginning, so that later kills meet work as well
            for end in ("", "-wal", "-shm"):
                if os.path.exists(store + end):
                    os.remove(store + end)
            stored = 0
    run(*command)
    row = last_run(store)
    check(row["analysed"] + stored >= row["files"] and row["state"] == "complete", "the last run is not whole")
    if stored == options.files + SUBS:
        check(row["analysed"] == 0, "%d programs were analysed again" % row["analysed"])
    for form in ("json", "csv", "sarif"):
        check(export(options.owlint, store, form) == export(options.owlint, folder + "/whole.db", form), form + ": not what an undisturbed run finds")
    print("%d kills, %d of them in the middle: the store opens after each, and ends as if there had been none" % (options.kills, interrupted))


def full(options, folder, shop):
    """No space: as a limit for the size of files, which SQLite meets in the same way."""
    store = folder + "/full.db"
    for size in (20_000, 100_000, 200_000):
        def limit(most=size):
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
        done = run(options.owlint, "audit", shop, "--store", store, "--jobs", "1", statuses=(2,), preexec_fn=limit)
        check(store in done.stderr, "the message does not name the store: " + done.stderr)
    before = sound(options.owlint, store) if query(store, "SELECT count(*) FROM sqlite_master")[0][0] else 0
    run(options.owlint, "audit", shop, "--store", store)
    check(last_run(store)["analysed"] == options.files + SUBS - before, "what was stored before the disk was full is analysed again")
    check(export(options.owlint, store) == export(options.owlint, folder + "/whole.db"), "after a full disk something else is found")
    print("full disk: a message, and the store goes on from there (%d analyses were kept)" % before)


def at_once(options, folder, shop):
    store = folder + "/busy.db"
    command = [options.owlint, "audit", shop, "--store", store, "--jobs", "1", "-q"]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as first:
        while not (os.path.exists(store) and os.path.getsize(store) > 0):
            time.sleep(0.005)
        os.kill(first.pid, signal.SIGSTOP)
        done = run(*command, statuses=(2,))
        check("another audit" in done.stderr, "the second audit says: " + done.stderr)
        with subprocess.Popen(command + ["--wait"], stdout=subprocess.DEVNULL) as second:
            os.kill(first.pid, signal.SIGCONT)
            check(first.wait() == 1 and second.wait() == 1, "one of two audits did not come to its end")
    check([row[0] for row in query(store, "SELECT state FROM run")] == ["complete", "complete"], "two runs are not complete")
    print("two audits at once: the second one gets a message, or waits")


def no_stores(options, folder, shop):
    def refused(store, words, **more):
        done = run(options.owlint, "audit", shop, "--store", store, statuses=(2,), **more)
        check(words in done.stderr and store in done.stderr, "%s: %s" % (store, done.stderr))

    with open(folder + "/text", "w", encoding="utf-8") as file:
        file.write("my own notes\n" * 100)
    refused(folder + "/text", "is not an owlint store")
    with open(folder + "/text", encoding="utf-8") as file:
        check(file.read() == "my own notes\n" * 100, "a text file was changed")
    refused(folder, "directory")
    os.mkfifo(folder + "/pipe")
    refused(folder + "/pipe", "not a file")
    refused("/dev/null", "not a file")
    refused(folder + "/none/at/all.db", "No such file")
    with sqlite3.connect(folder + "/other.db") as db:
        db.execute("CREATE TABLE mine (a)")
    refused(folder + "/other.db", "not an owlint store")
    run(options.owlint, "audit", shop, "--store", folder + "/newer.db", "-q")
    with sqlite3.connect(folder + "/newer.db") as db:
        db.execute("PRAGMA user_version = 99")
    refused(folder + "/newer.db", "newer owlint")
    with open(folder + "/newer.db", "r+b") as file:
        file.seek(4096)
        file.write(b"\xff" * 8192)
    done = run(options.owlint, "audit", "list", "--store", folder + "/newer.db", statuses=(2,))
    check("newer.db" in done.stderr, done.stderr)
    print("what is no store is left alone")


def test(options, folder):
    shop = folder + "/shop"
    make_shop(shop, options.files, motion=200)
    killed(options, folder, shop)
    full(options, folder, shop)
    at_once(options, folder, shop)
    no_stores(options, folder, shop)


if __name__ == "__main__":
    main(test, arguments(__doc__, kills=20, files=500))
