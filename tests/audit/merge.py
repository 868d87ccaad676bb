#!/usr/bin/python3
"""Is a job of several shards the same as a single run? By hand, by GNU parallel, and by a job array of Slurm.

usage: merge.py --owlint build/release/owlint [--files N]
What is not installed is left out, and said.
"""
import os
import shutil

import cluster
from support import arguments, check, export, findings, last_run, main, make_shop, part, program_text, query, run, write

CONTENTS = "SELECT path, hash, bytes, lines, problem FROM program ORDER BY path"
KNOWN = "SELECT path, kind, subject, name, answer FROM rests_on JOIN fact ON fact.id = fact JOIN file ON file.id = file ORDER BY 1, 2, 3, 4, 5"


def shard(owlint, shop, folder, number, count, *options):
    store = "%s/part%d.db" % (folder, number)
    run(owlint, "audit", shop, "-q", "--shard", "%d/%d" % (number, count), "--store", store, *options)
    return store


def same(owlint, a, b, what):
    for form in ("json", "csv", "jsonl", "sarif", "junit"):
        check(export(owlint, a, form) == export(owlint, b, form), "%s: %s differs" % (what, form))
    check(query(a, CONTENTS) == query(b, CONTENTS), what + ": other programs")
    known = KNOWN.replace("rests_on JOIN fact ON fact.id = fact JOIN file ON file.id = file", "rests_on JOIN fact ON fact.id = rests_on.fact JOIN file ON file.id = rests_on.file")
    check(query(a, known) == query(b, known), what + ": other dependencies")
    for column in ("files", "errors", "warnings", "infos"):
        check(last_run(a)[column] == last_run(b)[column], "%s: %s" % (what, column))
    print(what + ": the same as a single run")


def refusals(owlint, shop, folder, stores):
    def refused(words, *merged):
        done = run(owlint, "audit", "merge", *merged, "--store", folder + "/refused.db", statuses=(2,))
        check(words in done.stderr, "`%s` is not said: %s" % (words, done.stderr))

    refused("2/3 missing", stores[0], stores[2])
    refused("twice", *stores, stores[1])
    refused("no shard's", folder + "/single.db")
    refused("there is no store", folder + "/none.db")
    other = folder + "/other"
    os.makedirs(other)
    refused("different jobs", stores[0], shard(owlint, shop, other, 2, 3, "--ignore", "OW3"))
    refused("different jobs", stores[0], shard(owlint, shop, other, 2, 4))


def test(options, folder):
    owlint, shop, single = options.owlint, folder + "/shop", folder + "/single.db"
    make_shop(shop, options.files)
    run(owlint, "audit", shop, "-q", "--store", single)
    stores = [shard(owlint, shop, folder, number, 3) for number in (1, 2, 3)]
    merged = folder + "/merged.db"
    run(owlint, "audit", "merge", *reversed(stores), "--store", merged)
    same(owlint, merged, single, "three shards")
    refusals(owlint, shop, folder, stores)
    # What was merged is known to a run without shards, and to the next merge.
    run(owlint, "audit", shop, "-q", "--store", merged)
    check(last_run(merged)["analysed"] == 0, "after merging, %d programs are analysed again" % last_run(merged)["analysed"])
    write(part(shop, 1), program_text(1).replace("o100 endwhile", "o101 endwhile"))
    os.remove(part(shop, 10))
    for store in (single, merged):
        if store == merged:
            stores = [shard(owlint, shop, folder, number, 3) for number in (1, 2, 3)]
            run(owlint, "audit", "merge", *stores, "--store", merged)
        else:
            run(owlint, "audit", shop, "-q", "--store", single)
    check((last_run(merged)["new"], last_run(merged)["gone"]) == (last_run(single)["new"], last_run(single)["gone"]), "merging tells other news")
    same(owlint, merged, single, "after changes")

    if shutil.which("parallel"):
        os.makedirs(folder + "/parallel")
        cluster.parallel(owlint, shop, folder + "/parallel")
        run(owlint, "audit", "merge", *cluster.stores(folder + "/parallel"), "--store", folder + "/by-parallel.db")
        same(owlint, folder + "/by-parallel.db", single, "GNU parallel")
    else:
        print("GNU parallel is not here: left out")
    if cluster.has_slurm():
        os.makedirs(folder + "/slurm")
        cluster.slurm(owlint, shop, folder + "/slurm")
        run(owlint, "audit", "merge", *cluster.stores(folder + "/slurm"), "--store", folder + "/by-slurm.db")
        same(owlint, folder + "/by-slurm.db", single, "a job array of Slurm")
    else:
        print("Slurm is not here: left out")


if __name__ == "__main__":
    main(test, arguments(__doc__, files=400))
