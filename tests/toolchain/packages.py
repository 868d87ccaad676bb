#!/usr/bin/python3
"""What is installed works: into a prefix, as a library for other programs, and as a Debian package.

usage: packages.py --build build/release

Installs into temporary folders only.  The .deb goes into a root that has nothing else, is run there, and taken out again.
Manual pages and completions are read by the programs that they are for, as far as these are here.
"""
import argparse
import glob
import os
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BAD = os.path.join(ROOT, "corpus", "keyslots-copied-label.ngc")

problems = []


def check(good, what):
    if not good:
        problems.append(what)
        print("wrong: %s" % what)


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options)


def files_below(folder):
    return sorted(os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names)


def installed(build, prefix):
    done = run("cmake", "--install", build, "--prefix", prefix)
    check(done.returncode == 0, "cmake --install: " + done.stderr)
    owlint = os.path.join(prefix, "bin", "owlint")
    check(run(owlint, "--version").stdout.startswith("owlint "), "--version")
    check(run(owlint, BAD).returncode == 1, "the installed program finds nothing")
    for path in ("share/owlint/owlint-report-1.schema.json", "share/owlint/owlint-config-1.schema.json", "share/owlint/owlint-baseline-1.schema.json",
                 "share/doc/owlint/rules/OW104.md", "include/owlint.h"):
        check(os.path.isfile(os.path.join(prefix, path)), "not installed: " + path)
    commands = [line.split()[0] for line in run(owlint, "--help").stdout.split("Commands:")[1].split("\n\n")[0].splitlines() if line.startswith("  ") and line[2] != " "]
    check(len(commands) >= 7, "commands: %s" % commands)
    for page in ["owlint"] + ["owlint-" + command for command in commands]:
        check(os.path.isfile(os.path.join(prefix, "share/man/man1/%s.1" % page)), "no manual page " + page)
    return commands


def readable(prefix, commands):
    for page in glob.glob(os.path.join(prefix, "share/man/man1/*.1")):
        if shutil.which("groff"):
            done = run("groff", "-man", "-ww", "-Tutf8", "-z", page)
            check(done.returncode == 0 and not done.stderr, "%s: %s" % (page, done.stderr))
    for shell, path in (("bash", "bash-completion/completions/owlint"), ("zsh", "zsh/vendor-completions/_owlint"), ("fish", "fish/vendor_completions.d/owlint.fish")):
        if shutil.which(shell):
            done = run(shell, "-n", os.path.join(prefix, "share", path))
            check(done.returncode == 0, "%s: %s" % (path, done.stderr))
    bash = os.path.join(prefix, "share/bash-completion/completions/owlint")

    def offered(*words):
        script = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _owlint; printf "%s\\n" "${COMPREPLY[@]}"'
        return run("bash", "-c", script, "bash", bash, *words).stdout.split()

    check(set(commands) <= set(offered("owlint", "")), "bash does not offer the commands")
    check(offered("owlint", "check", "--format", "sa") == ["sarif"], "bash does not offer values")
    check("--baseline" in offered("owlint", "check", "--b"), "bash does not offer options")
    check(offered("owlint", "check", "--select", "OW104") == ["OW104"], "bash does not offer codes")
    check(offered("owlint", "check", "--select", "ow104") == ["OW104"], "bash does not offer codes for small letters")
    check(offered("owlint", "check", "--ignore", "OW1,if-label") == ["OW1,if-label-reused"], "bash does not offer names behind a comma")
    check(offered("owlint", "explain", "if-part") == ["if-part-mismatch"], "bash does not offer rules to explain")
    check(offered("owlint", "check", "--severity", "OW104", "=", "w") == ["warning"], "bash does not offer severities")
    check(offered("owlint", "check", "--fail-on", "=", "w") == ["warning"], "bash does not offer values behind `=`")
    check(offered("owlint", "check", "--linuxcnc", "2.1") == ["2.10"], "bash does not offer versions")
    check(offered("owlint", "audit", "export", "--format", "sa") == ["sarif"], "bash does not offer values of a command's command")
    check({"list", "show"} <= set(offered("owlint", "audit", "")), "bash does not offer a command's commands")
    check(offered("owlint", "--fix", "--format", "sa") == ["sarif"], "bash offers nothing where `check` is left out")
    if shutil.which("fish"):
        fish = os.path.join(prefix, "share/fish/vendor_completions.d/owlint.fish")

        def by_fish(line):
            done = run("fish", "--no-config", "-c", "source $argv[1]; complete -C $argv[2]", fish, line)
            return [offer.split("\t")[0] for offer in done.stdout.splitlines()]

        check(by_fish("owlint check --format sa") == ["sarif"], "fish does not offer values")
        check(by_fish("owlint check --select OW104") == ["OW104"], "fish does not offer codes")
        check(by_fish("owlint check --ignore OW1,if-label") == ["OW1,if-label-reused"], "fish does not offer names behind a comma")
        check("OW104=warning" in by_fish("owlint check --severity OW104=w"), "fish does not offer severities")
        check(by_fish("owlint explain if-part") == ["if-part-mismatch"], "fish does not offer rules to explain")


def embedded(prefix, folder):
    done = run("cmake", "-S", os.path.join(ROOT, "examples"), "-B", folder, "-DCMAKE_PREFIX_PATH=" + prefix)
    check(done.returncode == 0, "the examples: " + done.stderr)
    done = run("cmake", "--build", folder)
    check(done.returncode == 0, "the examples: " + done.stdout)
    for program in ("check_c", "check_cc"):
        done = run(os.path.join(folder, program), BAD)
        check(done.returncode == 1 and done.stdout == "line 33: label `o130` is already used for an `if` on line 16 [OW104]\n", "%s: %s" % (program, done.stdout))
        check(run(os.path.join(folder, program), os.path.join(ROOT, "corpus", "bolt-circle-ngcgui.ngc")).returncode == 0, program)


def package(build, folder):
    done = run("cpack", "-B", folder, cwd=build)
    check(done.returncode == 0, "cpack: " + done.stdout + done.stderr)
    deb, = glob.glob(os.path.join(folder, "*.deb"))
    root = os.path.join(folder, "root")
    admin = os.path.join(root, "var/lib/dpkg")
    os.makedirs(os.path.join(admin, "updates"))
    os.makedirs(os.path.join(admin, "info"))
    for name in ("status", "available"):
        open(os.path.join(admin, name), "w").close()
    dpkg = ("dpkg", "--root=" + root, "--force-not-root", "--log=/dev/null")
    done = run(*dpkg, "-i", deb)
    check(done.returncode == 0, "dpkg -i: " + done.stderr)
    there = [path for path in files_below(root) if path.startswith("usr/")]
    owlint = os.path.join(root, "usr/bin/owlint")
    check(os.path.isfile(owlint) and run(owlint, BAD).returncode == 1, "the packaged program")
    # Nothing but the kernel is needed in a root that has nothing else.
    if os.geteuid() == 0:
        shutil.copy(BAD, root)
        done = run("chroot", root, "/usr/bin/owlint", os.path.basename(BAD))
        check(done.returncode == 1 and "OW104" in done.stdout, "in a clean root: " + done.stderr)
    check(run(*dpkg, "-r", "owlint").returncode == 0, "dpkg -r")
    left = [path for path in files_below(root) if path.startswith("usr/")]
    check(not left, "left behind: %s" % left)
    return len(there)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", required=True)
    build = os.path.abspath(parser.parse_args().build)
    with tempfile.TemporaryDirectory() as folder:
        prefix = os.path.join(folder, "prefix")
        commands = installed(build, prefix)
        readable(prefix, commands)
        embedded(prefix, os.path.join(folder, "examples"))
        count = package(build, os.path.join(folder, "deb"))
    print("%d commands, %d files in the package, %d problems" % (len(commands), count, len(problems)))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
