#!/usr/bin/python3
"""A disk that is full for a while: what has been written before and after fits together.

usage: space.py --owlint build/release/owlint
Space is a limit for the size of files here, which can be raised while the audit runs.
"""
import os
import resource
import signal
import subprocess

from support import SUBS, arguments, callers, cases, check, export, last_run, make_shop, query, run, sub_text, until, write

PROGRAMS = 400
KNOWN = ("SELECT path, kind, subject, name, answer FROM rests_on JOIN fact ON fact.id = rests_on.fact JOIN file ON file.id = rests_on.file "
         "ORDER BY 1, 2, 3, 4, 5")
LOOSE = {"analyses of no file": "SELECT count(*) FROM analysis WHERE file NOT IN (SELECT id FROM file)",
         "dependencies on no fact": "SELECT count(*) FROM rests_on WHERE fact NOT IN (SELECT id FROM fact)",
         "dependencies of no file": "SELECT count(*) FROM rests_on WHERE file NOT IN (SELECT id FROM file)"}


def space_comes_back(options, folder):
    """Writing fails in the middle of a run, then there is space again. Whatever that run has still written, the next ones must not
    be led astray: in the end each program rests on what it rests on in a new store, and a sub that changes has all its callers
    analysed."""
    shop, store, whole = folder + "/shop", folder + "/full.db", folder + "/whole.db"
    make_shop(shop, PROGRAMS, motion=4000)  # enough work that there is some left when there is space again

    def little():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, resource.RLIM_INFINITY))

    run(options.owlint, "audit", shop, "--store", whole, "-q")
    met = 0
    # Where in the run the limit is met decides what goes wrong: several places.
    for most in (100_000, 140_000, 200_000, 300_000):
        remove(store)
        with subprocess.Popen([options.owlint, "audit", shop, "--store", store, "--jobs", "1"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=little) as audit:
            until(lambda: audit.poll() is not None or (os.path.exists(store + "-wal") and os.path.getsize(store + "-wal") > most - 4200), "a full disk")
            if audit.poll() is None:
                # The limit is reached, not yet met: it is when the log does not grow while the audit computes.
                spent(audit.pid, 0.15)
                try:
                    resource.prlimit(audit.pid, resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
                except ProcessLookupError:
                    pass
            words = audit.stderr.read().decode()
            status = audit.wait()
        check(status in (1, 2), "status %s: %s" % (status, words))
        if status == 2:
            met += 1
            check(store in words, "the message does not name the store: " + words)
        for what, sql in LOOSE.items():
            number = query(store, sql)[0][0]
            check(number == 0, "limit %d: after a disk that was full for a while the store has %d %s" % (most, number, what))
        run(options.owlint, "audit", shop, "--store", store, "-q")
        check(export(options.owlint, store) == export(options.owlint, whole), "limit %d: other findings than in a new store" % most)
        known, right = set(query(store, KNOWN)), set(query(whole, KNOWN))
        check(known == right, "limit %d: %d of %d dependencies are wrong: a change of what programs call is not seen for them, as %s" % (most, len(right - known), len(right), sorted(known - right)[:1]))
        write("%s/subs/shared1.ngc" % shop, sub_text(1) + "(changed for %d)\n" % most)
        run(options.owlint, "audit", shop, "--store", store, "-q")
        check(last_run(store)["analysed"] == callers(PROGRAMS, 1), "limit %d: a sub has changed, and %d programs are analysed, not %d" % (most, last_run(store)["analysed"], callers(PROGRAMS, 1)))
        run(options.owlint, "audit", shop, "--store", whole, "-q")
    check(met > 0, "the disk was never full")
    return "the store is sound, %d times, and %d programs rest on what they should" % (met, PROGRAMS + SUBS)


def no_space_at_all(options, folder):
    """A real file system that is full, where one can be mounted: SQLite says something else there than for a limit."""
    shop, disk = folder + "/shop", folder + "/disk"
    make_shop(shop, PROGRAMS, motion=20)
    os.makedirs(disk)
    if os.getuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=400k", "tmpfs", disk], capture_output=True, check=False).returncode != 0:
        return "left out, nothing can be mounted here"
    try:
        done = run(options.owlint, "audit", shop, "--store", disk + "/shop.db", "-q", statuses=(2,))
        check("no space left" in done.stderr and disk + "/shop.db" in done.stderr, "a full disk: " + done.stderr)
        check(query(disk + "/shop.db", "PRAGMA integrity_check") == [("ok",)], "the store is damaged")
        run(options.owlint, "audit", "list", "--store", disk + "/shop.db", statuses=(0,))
        # Nor may the page of an audit be left half written: a report on a full disk is an error, and the former one stays.
        subprocess.run(["mount", "-o", "remount,size=50m", disk], check=True)
        run(options.owlint, "audit", shop, "--store", disk + "/shop.db", "-q")
        run(options.owlint, "audit", shop, "--store", folder + "/whole.db", "-q")
        check(export(options.owlint, disk + "/shop.db") == export(options.owlint, folder + "/whole.db"), "with space, other findings than in a new store")
        with open(disk + "/filler", "wb") as filler:
            try:
                while True:
                    filler.write(bytes(65536))
                    filler.flush()
            except OSError:
                pass
        for form in ("csv", "json"):
            done = run(options.owlint, "audit", "export", "--store", disk + "/shop.db", "--format", form, "--output", disk + "/report", statuses=(2,))
            check(done.stderr, "no word of a report that could not be written")
    finally:
        subprocess.run(["umount", "--lazy", disk], check=True)
    return "said, and the store goes on when there is space"


def spent(pid, seconds):
    """Waits until a process has used that much more processor time, or is over."""
    def used():
        try:
            with open("/proc/%d/stat" % pid, encoding="utf-8") as file:
                fields = file.read().rsplit(")", 1)[1].split()
        except OSError:
            return None
        return None if fields[0] == "Z" else (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    start = used()
    until(lambda: start is None or used() is None or used() >= start + seconds, "that a process computes")


def remove(store):
    for end in ("", "-wal", "-shm"):
        if os.path.exists(store + end):
            os.remove(store + end)


if __name__ == "__main__":
    cases((space_comes_back, no_space_at_all), arguments(__doc__))
