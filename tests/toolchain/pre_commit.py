#!/usr/bin/python3
"""Do the git hooks stop a commit of a faulty program, and no other? Do the CI jobs of docs/ci.md do what they say?

usage: pre_commit.py --owlint build/release/owlint

Real commits in scratch repositories, with each of the three hooks: `owlint-system` and `owlint` of pre-commit, set up with
the configuration that docs/ci.md shows, and the plain hook share/hooks/pre-commit.  Then the examples of CI jobs in docs/ci.md
(ci_jobs.py).

Nothing leaves the scratch folder: git may only use local paths, and what `./dev` would need for a build fails.  Needs
git and Debian's pre-commit (with python3-yaml); without them ctest shows the test as not run.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

import ci_jobs

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SKIPPED = 77

GOOD = "o100 if [#1 EQ 1]\n  G0 X1\no100 endif\nM2\n"
BAD = GOOD.replace("o100 endif", "o110 endif")
CALLS_PROBE = "o<probe> call [1]\nM2\n"
PROBE = "o<probe> sub\n  G0 X#1\no<probe> endsub\n"
BAD_PROBE = "o<probe> sub\n  G0 X[#1\no<probe> endsub\n"
INI = "[RS274NGC]\nSUBROUTINE_PATH = subs\n"


def put(path, content, mode=0o644):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as f:
        f.write(content)
    os.chmod(path, mode)


def path_without(name, path):
    return os.pathsep.join(d for d in path.split(os.pathsep) if not os.path.exists(os.path.join(d, name)))


class Bench:
    """The scratch folder: the hooks' repository, an environment without the user's settings, and what went wrong."""

    def __init__(self, owlint, folder):
        self.folder = folder
        self.owlint = os.path.abspath(owlint)
        self.shops = self.expected = 0
        self.problems = []
        # A build would be seen here, and fail.
        self.built = os.path.join(folder, "built")
        stubs = os.path.join(folder, "stubs")
        for name in ("cmake", "apt-get", "sudo"):
            put(os.path.join(stubs, name), "#!/bin/sh\necho \"$0 $*\" >>'%s'\nexit 1\n" % self.built, 0o755)
        tools = os.path.join(folder, "tools")
        os.makedirs(tools)
        os.symlink(self.owlint, os.path.join(tools, "owlint"))
        path = os.environ.get("PATH", os.defpath)
        self.path = os.pathsep.join((tools, stubs, path))
        self.path_without_owlint = os.pathsep.join((stubs, path_without("owlint", path)))
        kept = {k: v for k, v in os.environ.items() if not k.startswith(("GIT_", "PRE_COMMIT", "XDG_"))}
        nowhere = "http://127.0.0.1:9"
        self.env = {**kept, "HOME": os.path.join(folder, "home"), "PRE_COMMIT_HOME": os.path.join(folder, "pre-commit"),
                    "PATH": self.path, "LC_ALL": "C.UTF-8", "GIT_CONFIG_NOSYSTEM": "1", "GIT_ALLOW_PROTOCOL": "file",
                    "http_proxy": nowhere, "https_proxy": nowhere}
        put(os.path.join(folder, "home", ".gitconfig"),
            "[user]\n  name = Shop\n  email = shop@example.invalid\n[init]\n  defaultBranch = main\n")
        self.hooks = os.path.join(folder, "hooks")
        self.make_hooks()

    def run(self, argv, cwd, **env):
        done = subprocess.run(argv, cwd=cwd, env={**self.env, **env}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=120)
        return done.returncode, done.stdout.decode("utf-8", "replace")

    def must(self, argv, cwd):
        status, output = self.run(argv, cwd)
        if status != 0:
            raise RuntimeError("%s: status %d\n%s" % (" ".join(argv), status, output))
        return output.strip()

    def make_hooks(self):
        """What a clone of owlint is to pre-commit, but with the program in it."""
        for name in ("analyzer", "rules"):
            shutil.copytree(os.path.join(ROOT, name), os.path.join(self.hooks, name))
        for name in ("dev", "CMakeLists.txt", ".pre-commit-hooks.yaml"):
            shutil.copy2(os.path.join(ROOT, name), self.hooks)
        os.makedirs(os.path.join(self.hooks, "build", "release"))
        shutil.copy(self.owlint, os.path.join(self.hooks, "build", "release", "owlint"))
        for argv in (["init", "-q"], ["add", "-A", "-f"], ["commit", "-q", "-m", "hooks"]):
            self.must(["git", *argv], self.hooks)
        self.commit_of_hooks = self.must(["git", "rev-parse", "HEAD"], self.hooks)

    def as_if_built(self):
        """A clone's files get their times in the order of their names, and the program must not be older than `rules/`."""
        clones = self.env["PRE_COMMIT_HOME"]
        programs = [os.path.join(clones, name, "build", "release", "owlint") for name in os.listdir(clones)]
        programs = [program for program in programs if os.path.exists(program)]
        self.expect(len(programs) == 1, "pre-commit has %d clones of the hooks" % len(programs))
        for program in programs:
            os.utime(program)

    def expect(self, right, what, output=""):
        self.expected += 1
        if not right:
            self.problems.append(what + "\n" + re.sub("(?m)^(?=.)", "    ", output))


class Shop:
    """A repository of programs with one of the hooks."""

    def __init__(self, bench, case, kind, args=()):
        self.bench, self.kind, self.title = bench, kind, "%s, %s" % (kind, case.__name__.replace("_", " "))
        bench.shops += 1
        self.path = os.path.join(bench.folder, "shop %d" % bench.shops, "programs")
        os.makedirs(self.path)
        self.git("init", "-q")
        # The hook that is built from the sources must do without an owlint that is installed.
        self.env = {"PATH": bench.path_without_owlint} if kind == "owlint" else {}
        if kind == "plain":
            shutil.copy(os.path.join(ROOT, "share", "hooks", "pre-commit"), os.path.join(self.path, ".git", "hooks"))
            return
        config = ci_jobs.example(".pre-commit-config.yaml")
        config["repos"][0].update(repo=bench.hooks, rev=bench.commit_of_hooks)
        config["repos"][0]["hooks"][0].update(id=kind, args=list(args))
        self.before({".pre-commit-config.yaml": json.dumps(config)})  # JSON is YAML, too
        bench.must(["pre-commit", "install", "--install-hooks"], self.path)
        bench.as_if_built()

    def git(self, *argv):
        return self.bench.must(["git", *argv], self.path)

    def write(self, name, content):
        put(os.path.join(self.path, name), content)

    def stage(self, files):
        for name, content in files.items():
            self.write(name, content)
        self.git("add", "--", *files)

    def before(self, files):
        """What came into the repository when there was no hook."""
        self.stage(files)
        self.git("commit", "-q", "--no-verify", "-m", "before")

    def commit(self, passes, shown=(), hidden=(), argv=("-m", "work"), folder=".", what="", **env):
        """Commits. What should happen is known: whether it passes, and what is or is not on the screen."""
        folder = os.path.join(self.path, folder)
        head = ["git", "rev-parse", "-q", "--verify", "HEAD"]
        before = self.bench.run(head, folder)
        status, output = self.bench.run(["git", "commit", *argv], folder, **self.env, **env)
        moved = self.bench.run(head, folder) != before
        title = "%s%s" % (self.title, ": " + what if what else "")
        self.bench.expect((status == 0) == passes and moved == passes,
                          "%s: status %d, HEAD %s" % (title, status, "moves" if moved else "stays"), output)
        for text in shown:
            self.bench.expect(text in output, "%s: `%s` is not on the screen" % (title, text), output)
        for text in hidden:
            self.bench.expect(text not in output, "%s: `%s` is on the screen" % (title, text), output)
        left = [name for _, folders, _ in os.walk(os.path.join(self.path, ".git")) for name in folders if name.startswith("owlint")]
        self.bench.expect(not left, "%s: left in .git: %s" % (title, left))

    def expect_content(self, name, content):
        with open(os.path.join(self.path, name), encoding="utf-8") as f:
            self.bench.expect(f.read() == content, "%s: %s in the folder is not what it was" % (self.title, name))


# ---- with all three ----

def bad_then_fixed(shop):
    shop.stage({"slot.ngc": BAD, "notes.txt": BAD})
    shop.commit(False, ["slot.ngc:3:1: error", "OW106", "write `o100 endif`"], ["notes.txt"])
    shop.stage({"slot.ngc": GOOD})
    shop.commit(True, hidden=["OW106"], what="fixed")
    shop.git("rm", "-q", "slot.ngc")
    shop.commit(True, what="deleted")


def bad_beside(shop):
    shop.before({"old.ngc": BAD})
    shop.write("draft.ngc", BAD)
    shop.stage({"slot.ngc": GOOD})
    shop.commit(True, hidden=["OW106", "old.ngc", "draft.ngc"])
    shop.stage({"notes.txt": "no program"})
    shop.commit(True, hidden=["OW106"], what="no program staged")


def staged_counts(shop):
    shop.stage({"slot.ngc": GOOD})
    shop.write("slot.ngc", BAD)
    shop.commit(True, what="good as staged, bad in the folder")
    shop.expect_content("slot.ngc", BAD)
    shop.git("add", "slot.ngc")
    shop.write("slot.ngc", GOOD)
    shop.commit(False, ["slot.ngc:3:1: error", "OW106"], what="bad as staged, good in the folder")
    shop.expect_content("slot.ngc", GOOD)


def called_beside(shop):
    shop.before({"probe.ngc": PROBE})
    shop.stage({"main.ngc": CALLS_PROBE})
    shop.commit(True, hidden=["OW208"])


def called_through_ini(shop):
    shop.before({"mill.ini": INI, "subs/probe.ngc": PROBE})
    shop.write("subs/probe.ngc", BAD_PROBE)
    shop.stage({"main.ngc": CALLS_PROBE})
    shop.commit(True, hidden=["OW208", "OW303"], what="the called file is broken in the folder only")
    # The other way round, or the above would also pass if calls were not followed.
    shop.git("add", "subs/probe.ngc")
    shop.git("commit", "-q", "--no-verify", "-m", "broken")
    shop.stage({"main.ngc": "; 2\n" + CALLS_PROBE})
    shop.commit(False, ["subs/probe.ngc:2:", "OW303"], ["OW208"], what="the called file is broken")
    shop.git("rm", "-q", "subs/probe.ngc")
    shop.commit(False, ["main.ngc:2:1: error", "OW208"], what="the called file is gone")


def names(shop):
    odd = ["Fräsen groß/Nut 1 für Müller.ngc", "a 'quoted' \"name\" $HOME.ngc", "sub folder/x.NGC", "y.Nc", "z.TAP", "v.cNc", "w.GCode"]
    shop.stage(dict.fromkeys(odd, BAD))
    shop.commit(False, ["%s:3:1: error" % name for name in odd])
    shop.stage(dict.fromkeys(odd, GOOD))
    shop.commit(True, hidden=["OW106"], what="fixed")


# ---- with those of pre-commit ----

def untracked_file_is_called(shop):
    shop.before({"mill.ini": INI})
    shop.write("subs/probe.ngc", PROBE)
    shop.stage({"main.ngc": CALLS_PROBE})
    shop.commit(True, hidden=["OW208"])


def options_in_the_configuration(shop):
    shop.stage({"slot.ngc": GOOD + "G0 Z5\n"})
    shop.commit(False, ["slot.ngc:5:1: warning", "OW316"])


# ---- with the plain hook ----

def untracked_file_is_missing(shop):
    shop.before({"mill.ini": INI})
    shop.write("subs/probe.ngc", PROBE)
    shop.stage({"main.ngc": CALLS_PROBE})
    shop.commit(False, ["main.ngc:1:1: error", "OW208"])
    shop.git("add", "subs")
    shop.commit(True, hidden=["OW208"], what="added")


def settings_as_staged(shop):
    shop.before({"mill.ini": INI, "subs/probe.ngc": PROBE, "owlint.toml": 'ini = "mill.ini"\nignore = ["OW106"]\n'})
    shop.write("mill.ini", INI.replace("subs", "elsewhere"))
    shop.write("owlint.toml", "")
    shop.stage({"main.ngc": CALLS_PROBE, "slot.ngc": BAD})
    shop.commit(True, hidden=["OW208", "OW106"])
    shop.stage({"owlint.toml": 'ignroe = ["OW106"]\n', "main.ngc": "; 2\n" + CALLS_PROBE})
    shop.commit(False, ["owlint.toml", "ignroe"], what="a configuration that is wrong")


def ini_elsewhere(shop):
    shop.write("../machines/mill.ini", INI)
    shop.write("../machines/subs/probe.ngc", PROBE)
    shop.stage({"main.ngc": CALLS_PROBE, "owlint.toml": 'ini = "../machines/mill.ini"\n'})
    shop.commit(False, ["cannot read the INI"], what="named by owlint.toml with `..`")
    shop.git("config", "owlint.ini", os.path.join(shop.path, "..", "machines", "mill.ini"))
    shop.commit(True, hidden=["OW208"])


def ini_above(shop):
    shop.write("../mill.ini", INI.replace("subs", "macros"))
    shop.write("../macros/probe.ngc", PROBE)
    shop.stage({"main.ngc": CALLS_PROBE})
    shop.commit(True, hidden=["OW208"])


def names_like_options(shop):
    shop.stage({"-x.ngc": BAD, "--ini.ngc": BAD, "line\nend.ngc": BAD})
    shop.commit(False, ["-x.ngc:3:1: error", "--ini.ngc:3:1: error", "end.ngc:3:1: error"])


def ways_to_commit(shop):
    shop.before({"a.ngc": GOOD, "b.ngc": GOOD, "deep/c.ngc": GOOD})
    shop.write("a.ngc", BAD)
    shop.commit(False, ["a.ngc:3:1: error"], argv=("-a", "-m", "all"), what="git commit -a")
    shop.write("b.ngc", GOOD + "; b\n")
    shop.commit(True, hidden=["OW106"], argv=("-m", "one", "b.ngc"), what="git commit FILE, another is bad")
    shop.commit(False, ["a.ngc:3:1: error"], argv=("-m", "one", "a.ngc"), what="git commit FILE")
    shop.git("checkout", "-q", "--", "a.ngc")
    shop.stage({"deep/c.ngc": BAD})
    shop.commit(False, ["deep/c.ngc:3:1: error"], folder="deep", what="from a folder below")
    tree = os.path.join(shop.path, "..", "tree")
    shop.git("worktree", "add", "-q", tree)
    put(os.path.join(tree, "a.ngc"), BAD)
    shop.commit(False, ["a.ngc:3:1: error"], argv=("-a", "-m", "there"), folder=tree, what="in a linked worktree")
    put(os.path.join(tree, "a.ngc"), GOOD + "; a\n")
    shop.commit(True, argv=("-a", "-m", "there"), folder=tree, what="in a linked worktree, fixed")


def without_owlint(shop):
    shop.stage({"slot.ngc": GOOD})
    shop.commit(False, ["owlint is not on PATH"], PATH=shop.bench.path_without_owlint)


def run_case(bench, case, kind, args=()):
    try:
        case(Shop(bench, case, kind, args))
    except RuntimeError as trouble:  # what comes after a step that went wrong has no footing
        bench.expect(False, "%s, %s: not to its end: %s" % (kind, case.__name__, trouble))


def all_cases(bench):
    everywhere = (bad_then_fixed, bad_beside, staged_counts, called_beside, called_through_ini, names)
    for kind in ("owlint-system", "owlint"):
        for case in (*everywhere, untracked_file_is_called):
            run_case(bench, case, kind)
        run_case(bench, options_in_the_configuration, kind, ("--fail-on", "warning"))
    for case in (*everywhere, untracked_file_is_missing, settings_as_staged, ini_elsewhere, ini_above, names_like_options,
                 ways_to_commit, without_owlint):
        run_case(bench, case, "plain")
    status, output = bench.run(["pre-commit", "validate-manifest", os.path.join(ROOT, ".pre-commit-hooks.yaml")], bench.folder)
    bench.expect(status == 0, ".pre-commit-hooks.yaml is not valid", output)
    bench.expect(not os.path.exists(bench.built), "`./dev lint` wanted to build")


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--owlint", required=True)
    options = parser.parse_args(argv)
    missing = [name for name in ("git", "pre-commit") if shutil.which(name) is None]
    if missing or ci_jobs.yaml is None:
        print("pre_commit.py: skipped, not installed: %s" % " ".join(missing or ["python3-yaml"]))
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="owlint-hooks-") as folder:
        bench = Bench(options.owlint, os.path.realpath(folder))
        all_cases(bench)
        ci_jobs.check(bench)
    print("\n".join(bench.problems) if bench.problems else "the hooks stop what they should, and nothing else")
    print("%d repositories, %d expectations, %d problems" % (bench.shops, bench.expected, len(bench.problems)))
    return 1 if bench.problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
