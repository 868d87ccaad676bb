"""LinuxCNC's stand-alone interpreter, one program at a time.

Slower than oracle.py, but it is the program that a machinist can run, and it obeys an INI on its own.  The parameter
file is always one in a scratch folder: rs274 renames over whatever it is given.  So is the home folder: the tool table
lies there in memory that runs share, and one that starts shortens it under another, which then dies of a bus error.
"""
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
from dataclasses import dataclass, field

CPU_LIMIT_S = 1             # of processor time: a busy machine makes no hang
WALL_LIMIT_S = 60
STDERR_READ = 20_000
HANG_SAYS = 120             # characters kept of the warnings of an endless loop
MODES = {"default": None, "warnonly": "OWORD_WARNONLY = 1\n", "mask": "FEATURES = 0x20\nFEATURE = 0x20\n"}
# What it says of a REMAP or another entry that it cannot use, then it goes on; and what it prints beside a message.
_GOES_ON = re.compile(r"REMAP BUG=|^unrecognized option '.*\d+:REMAP = |^invalid \[RS274NGC\]\w+ in INI file|"
                      r"^inifile: error: File contains ambiguous|^num_spindles =")
AT_FILE_END = re.compile(r"File ended|EOF in file|Failed to find sub")

available = shutil.which("rs274") is not None


@dataclass(frozen=True)
class Outcome:
    """How a program ended."""
    kind: str               # ok, error, crash, hang
    line: int = 0           # 0 where the interpreter does not say
    message: str = ""       # its error, or its warnings in one line
    x: str = ""             # the X of its last rapid move
    # The line that was read last, as it is printed behind an error.
    text: str = field(default="", compare=False)


def run(path, mode="default", block_delete=False):
    """Run the program at `path` -> its Outcome."""
    path = os.path.abspath(path)
    return _outcome(path, *_run(path, mode, block_delete))


def canonical(path):
    """Run the program at `path` -> (exit status, all that it tells the machine)."""
    with tempfile.TemporaryDirectory(prefix="owlint-rs274-") as folder:
        done = subprocess.run(["rs274", "-g", os.path.abspath(path)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd=folder,
                              env={**os.environ, "HOME": folder},
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (CPU_LIMIT_S, CPU_LIMIT_S + 1)), check=False)
    return done.returncode, done.stdout


def _run(path, mode, block_delete):
    """-> (exit status, what it printed on standard error, the X of its last rapid move)"""
    with tempfile.TemporaryDirectory(prefix="owlint-rs274-") as folder:
        argv = ["rs274", "-g"] + ["-b"] * block_delete
        where = folder
        if mode in ("machine", "files"):    # the program's own folder has the INI, or the files that it calls
            where = os.path.dirname(path)
            argv += ["-i", "machine.ini"] if mode == "machine" else []
        elif MODES[mode]:
            parameters = os.path.join(folder, "p.var")
            open(parameters, "w").close()
            ini = os.path.join(folder, "machine.ini")
            with open(ini, "w") as f:
                f.write("[RS274NGC]\nPARAMETER_FILE = %s\n%s" % (parameters, MODES[mode]))
            argv += ["-i", ini]
        with open(os.path.join(folder, "out"), "w+b") as out, open(os.path.join(folder, "err"), "w+b") as err:
            process = subprocess.Popen(argv + [path], stdin=subprocess.DEVNULL, stdout=out, stderr=err, cwd=where,
                                       env={**os.environ, "HOME": folder})
            resource.prlimit(process.pid, resource.RLIMIT_CPU, (CPU_LIMIT_S, CPU_LIMIT_S + 1))
            resource.prlimit(process.pid, resource.RLIMIT_CORE, (0, 0))
            try:
                status = process.wait(WALL_LIMIT_S)
            except subprocess.TimeoutExpired:
                process.kill()
                status = process.wait()
            text = os.pread(err.fileno(), STDERR_READ, 0).decode("latin-1")
            size = os.fstat(out.fileno()).st_size
            canon = os.pread(out.fileno(), 4000, max(0, size - 4000)).decode("latin-1")
    moves = re.findall(r"STRAIGHT_TRAVERSE\((-?[\d.]+)", canon)
    return status, text.replace("executing", "", 1).strip(), moves[-1] if moves else ""


def _outcome(path, status, text, x):
    lines = "\n".join(line for line in text.split("\n") if not _GOES_ON.search(line)).lstrip("\n").split("\n")
    message = lines[0].replace(path, "PROGRAM").strip()
    if status in (-signal.SIGXCPU, -signal.SIGKILL):
        return Outcome("hang", 0, message[:HANG_SAYS])
    if status < 0:
        return Outcome("crash", _last_line(message), message)
    if status == 0:
        return Outcome("ok", 0, message, x)
    said = re.match(r"(\d+): ", message)
    line = int(said.group(1)) if said else 0
    if not line and len(lines) > 1 and not AT_FILE_END.search(message):
        line = _line_of(path, lines[1])
    return Outcome("error", line, message, x, lines[1].strip() if len(lines) > 1 else "")


def _last_line(message):
    """The line of the last warning before a crash."""
    said = re.findall(r"(?:^|[^\d])(\d+): (?:undefined|duplicate|no matching|not in)", message)
    return int(said[-1]) if said else 0


def _line_of(path, text):
    """The interpreter prints the line that it had read; its number, where no other line reads alike."""
    with open(path, "rb") as f:
        lines = [line.decode("latin-1").strip() for line in f.read().split(b"\n")]
    hits = [number for number, line in enumerate(lines, 1) if line == text.strip()]
    return hits[0] if len(hits) == 1 and text.strip() else 0
