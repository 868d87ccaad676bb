#!/usr/bin/python3
"""What LinuxCNC's own interpreter does with a program, for one list of choices.

usage: oracle.py [--warnonly] [--choices 0110…] PROGRAM.ngc...

Prints for each program: outcome (ok, error, crash, hang), line, rule codes, message, and the choices taken as
line=value.  A program's unknown values are written `#[1000+#99]` (a condition) or `#[3000+#99]` (a repeat count), with
any number for 1000 to 2999 and 3000 to 4999; for the interpreter they become named parameters whose reading takes the
next choice (see plugin/namedparams.py), so the same condition can come out differently each time it is evaluated.

The interpreter runs in a child process (`gcode.parse`, about 0.3 ms a program), which is forked again when a program
crashes it or does not end.  The child works in a folder of its own with a parameter file that cannot be written:
the interpreter saves its parameters after each program by renaming a new file over the old one, and the next program
would start from them.  (Never name a device there: as root, that replaces /dev/null by a file.)

One thing is not seen: a first line longer than 252 characters counts as an empty program here.

Without a tool table any `T` word crashes the interpreter.  `Interpreter(record=True)` has the three tools and nine axes of
the stand-alone rs274, and gives in `Run.calls` what the machine was told to do: moves, feeds, dwells, offsets, tool
changes, messages and comments.  (Spindle, coolant and outputs are not handed on by `gcode.parse`.)
"""
import argparse
import atexit
import ctypes
import mmap
import multiprocessing
import os
import re
import shutil
import signal
import struct
import sys
import tempfile
import traceback
from dataclasses import dataclass, replace

try:
    import gcode
except ImportError as error:
    print("%s: needs LinuxCNC's Python module (Debian package linuxcnc-uspace, /usr/bin/python3)" % error, file=sys.stderr)
    sys.exit(2)

import bundle
from messages import EOF, FILE_LACKS_SUB, call_line, codes_of, renumbered, warned_lines

HERE = os.path.dirname(os.path.abspath(__file__))
CPU_LIMIT_S = 0.05          # of its own processor time: what a busy machine adds in the kernel makes no hang; 150 usual runs
RUNS_PER_CHILD = 3000       # gcode.parse loses about 5 kB a run
MAX_NOTES = 64
PADDING = 99                # lines put before a program when warnings are read: all its lines have three digits then
# The interpreter does not say in which file it stopped: each called file begins behind so many lines and bytes more than
# the one before, so that the place tells.
FILE_LINES = 100
FILE_PAD = (";" + "-" * 98 + "\n") * FILE_LINES
WARNINGS_READ = 30_000      # from the start and the end of what an endless loop has printed

FROM_BEFORE = "(run before)"     # a comment to owlint; the interpreter may find global names there from here on
_FROM_BEFORE = re.compile(re.escape(FROM_BEFORE), re.IGNORECASE)
_TOKEN = re.compile(r"#\[([1-4])\d\d\d\+#99\]")


@dataclass(frozen=True)
class Run:
    """One run: how it ended, where, and the choices it took as (line, arity, value)."""
    outcome: str                    # ok, error, crash, hang
    line: int                       # 0 where there is none: ok, end of file, hang, crash without a warning
    codes: frozenset
    message: str
    trace: tuple
    warned: tuple = ()              # OWORD_WARNONLY: the lines warned about
    calls: tuple = ()               # with `record`: what the machine was told, a text for each call
    in_files: bool = False          # the program calls files

    @property
    def words(self):
        """The message with the line numbers of its file: called files begin behind FILE_LINES lines each."""
        return renumbered(self.message, lambda line: line % FILE_LINES) if self.in_files else self.message

    @property
    def choices(self):
        return bytes(value for _, _, value in self.trace)


def _left_by_program(text):
    """The global names that a run of this program can leave behind for the next one."""
    squeezed = re.sub(r"[ \t]", "", text).lower()
    return "".join(name for name in ("_g", "_h") if "#<%s>=" % name in squeezed or "exists[#<%s>]" % name in squeezed)


def for_interpreter(text):
    """The program with its unknown values replaced by choices; lines stay where they are."""
    return _TOKEN.sub(lambda m: "#<_choice>" if m.group(1) in "12" else "#<_count>", _FROM_BEFORE.sub("#99=#<_before%s>" % _left_by_program(text), text))


def pad(text):
    """The program with PADDING blank lines before it, or after its first `%`."""
    first, newline, rest = text.partition("\n")
    percent = first.strip() == "%"
    return first + newline + "\n" * PADDING + rest if percent else "\n" * PADDING + text


def scratch():
    """Where temporary files are cheapest."""
    return "/dev/shm" if os.access("/dev/shm", os.W_OK) else tempfile.gettempdir()


def write_ini(folder, warnonly):
    """An INI with the plugin; the parameter file lies in a folder that does not exist, on purpose."""
    path = os.path.join(folder, "warnonly.ini" if warnonly else "default.ini")
    plugin = os.path.join(HERE, "plugin")
    with open(path, "w") as f:
        f.write("[RS274NGC]\nSUBROUTINE_PATH = subs\nPARAMETER_FILE = %s/absent/p.var\n%s[PYTHON]\nTOPLEVEL = %s/toplevel.py\n"
                "PATH_PREPEND = %s\n" % (folder, "OWORD_WARNONLY = 1\n" if warnonly else "", plugin, plugin))
    return path


def _make_canon(folder, record=None):
    """The callbacks that gcode.parse wants: a machine without tools that ignores all motion, or writes it to `record`."""
    tool = (-1,) + (0.0,) * 12 + (0,)

    def ignore(*_):
        pass

    def writer(name):
        # At once, not when the run is over: a crash would take it away.
        return lambda *values: os.write(record, ("%s %s\n" % (name, " ".join(map(repr, values)))).encode())

    class Canon:
        parameter_file = os.path.join(folder, "absent", "p.var")
        block_delete = False
        get_tool = staticmethod({pocket: tool for pocket in range(1100)}.__getitem__)   # asked 1001 times a run

        def get_external_angular_units(self): return 1.0
        def get_external_length_units(self): return 1.0
        def get_axis_mask(self): return 7 if record is None else 511
        def get_block_delete(self): return self.block_delete
        def check_abort(self): return False

        def __getattr__(self, name):
            if name.startswith("_"):
                raise AttributeError(name)
            # The lines are no part of what the machine does.
            setattr(self, name, ignore if record is None or name == "next_line" else writer(name))
            return getattr(self, name)

    return Canon()


def _make_tool_table(folder):
    """Tools 1 to 3, as the stand-alone rs274 has them.  The library keeps them in a file that lies in the home folder."""
    os.environ["HOME"] = folder
    ctypes.CDLL("libtooldata.so.0")["_Z17tool_mmap_creatorPK13EMC_TOOL_STATi"](None, 0)
    with open(os.path.join(folder, ".tool.mmap"), "r+b") as f:
        f.seek(8)                                   # behind a mutex: the last index, and whether the changer is random
        f.write(struct.pack("II", 3, 0))
        for tool in (1, 2, 3):
            f.seek(16 + 112 * tool)
            f.write(struct.pack("II", tool, tool))  # number and pocket; sizes are asked of the canon


class Interpreter:
    """Runs programs one after the other; `run` never raises for anything that a program does."""

    def __init__(self, warnonly=False, base=None, record=False, cpu_limit=CPU_LIMIT_S):
        self.warnonly = warnonly
        self.cpu_limit = cpu_limit
        self.runs = 0
        self.folder = tempfile.mkdtemp(prefix="owlint-oracle-", dir=base or scratch())
        atexit.register(self._remove, os.getpid())
        self.ini = write_ini(self.folder, warnonly)
        self.program = os.path.join(self.folder, "program")     # no .ngc: no call can find it as a file
        self.called = {}        # files that the program calls, as they lie in the folder
        self.firsts = [0]       # by file: the line of the bundle before its first
        with open(os.path.join(self.folder, "notes"), "w+b") as notes:
            notes.truncate(4 * (MAX_NOTES + 1))
            self.notes = mmap.mmap(notes.fileno(), 0)
        self.messages = open(os.path.join(self.folder, "stderr"), "w+b", buffering=0)
        self.record = open(os.path.join(self.folder, "calls"), "w+b", buffering=0) if record else None
        self.child = 0
        self.pipe = None
        self.left = 0

    def run(self, text, choices=b"", block_delete=False):
        """Run `text` (as owlint sees it) with these choices; with `block_delete` lines that begin with `/` are skipped."""
        run = self._run(text, choices, block_delete)
        return replace(run, calls=self._calls()) if self.record else run

    def _calls(self):
        size = os.fstat(self.record.fileno()).st_size
        return tuple(os.pread(self.record.fileno(), size, 0).decode("utf-8", "replace").split("\n")[:-1])

    def _run(self, text, choices, block_delete):
        self.runs += 1
        files = self._lay_out(text)
        text = for_interpreter(pad(text) if self.warnonly else files[bundle.MAIN][1])
        data = text.encode("latin-1", "replace")
        killed, failed, message, offset = self._ask(data, bytes(choices), block_delete)
        if killed:
            return self._died(killed)
        warned = self._warnings()[0]
        if not failed:
            return Run("ok", 0, frozenset(), "", self._trace(), warned)
        if self.warnonly:
            message = renumbered(message, lambda line: line - PADDING)
        codes = codes_of(message)
        call = call_line(message)
        line = 0 if EOF in codes or FILE_LACKS_SUB in codes else self._line(call) if call and self.called else \
            call or self._line_at(data, offset)
        return Run("error", line, codes, message, self._trace(), warned, in_files=bool(self.called))

    def _lay_out(self, text):
        """Put the files that the program calls where it finds them: -> its parts as in bundle.split"""
        files = bundle.split(text) if bundle.is_bundle(text) else {bundle.MAIN: (0, text)}
        called = {name: part for name, part in files.items() if name != bundle.MAIN}
        called = {name: (first, FILE_PAD * number + for_interpreter(part))
                  for number, (name, (first, part)) in enumerate(called.items(), 1)}
        if called != self.called:
            for name in self.called:
                os.remove(os.path.join(self.folder, name))
            bundle.write(self.folder, called)
            self.called = called
        self.firsts = [first for first, _ in files.values()]
        return {bundle.MAIN: files[bundle.MAIN], **called}

    def close(self):
        self._stop()
        self._remove(os.getpid())

    # -- the parent's side

    def _ask(self, data, choices, block_delete):
        """Let a child run the program: -> (the signal that killed it or 0, whether it failed, its message, where its last line starts)"""
        if not self.child or not self.left:
            self._stop()
            self._start()
        self.left -= 1
        self.pipe.send((data, choices, block_delete))
        try:
            if not self.pipe.poll(20):
                os.kill(self.child, signal.SIGVTALRM)
            return 0, *self.pipe.recv()
        except (EOFError, ConnectionError):
            _, status = os.waitpid(self.child, 0)
            self.child = 0
        if not os.WIFSIGNALED(status):      # not the interpreter's doing
            raise RuntimeError(os.pread(self.messages.fileno(), WARNINGS_READ, 0).decode("latin-1"))
        return os.WTERMSIG(status), True, "", 0

    def _died(self, killed):
        outcome = "hang" if killed in (signal.SIGVTALRM, signal.SIGKILL) else "crash"
        warned, codes = self._warnings()
        if outcome == "hang":
            return Run(outcome, 0, frozenset(), "", self._trace(), warned)
        return Run(outcome, warned[-1] if warned else 0, codes, "signal %d" % killed, self._trace(), warned)

    def _line(self, number):
        """A line as the interpreter counts it -> as the program does (a `%` is never the line meant)."""
        if self.called:
            return self.firsts[number // FILE_LINES] + number % FILE_LINES
        return number - PADDING if self.warnonly else number

    def _line_at(self, data, offset):
        """The line that begins `offset` bytes into the file that was read last."""
        file = offset // len(FILE_PAD) if self.called else 0
        read = list(self.called.values())[file - 1][1].encode("latin-1", "replace") if file else data
        return self._line(read.count(b"\n", 0, offset) + 1)

    def _warnings(self):
        """-> (the lines warned about, the last one last, each once; the codes of the last one)"""
        if not self.warnonly:
            return (), frozenset()
        size = os.fstat(self.messages.fileno()).st_size
        text = os.pread(self.messages.fileno(), WARNINGS_READ, 0)
        if size > 2 * WARNINGS_READ:
            text += os.pread(self.messages.fileno(), WARNINGS_READ, size - WARNINGS_READ)
        numbers, codes = warned_lines(text.decode("latin-1"))
        return tuple(reversed(dict.fromkeys(self._line(n) for n in reversed(numbers)))), codes

    def _trace(self):
        count = min(struct.unpack_from("I", self.notes, 0)[0], MAX_NOTES)
        notes = (struct.unpack_from("HBB", self.notes, 4 * (i + 1)) for i in range(count))
        return tuple((self._line(line), arity, value) for line, arity, value in notes)

    def _start(self):
        ours, theirs = multiprocessing.Pipe()
        sys.stdout.flush()
        sys.stderr.flush()
        child = os.fork()
        if not child:
            try:
                ours.close()
                self._serve(theirs)
            except BaseException:
                traceback.print_exc()
            finally:
                sys.stderr.flush()
                os._exit(3)
        theirs.close()
        self.child, self.pipe, self.left = child, ours, RUNS_PER_CHILD

    def _stop(self):
        if self.child:
            self.pipe.close()
            os.waitpid(self.child, 0)
            self.child = 0

    def _remove(self, owner):
        if os.getpid() == owner:
            shutil.rmtree(self.folder, ignore_errors=True)

    # -- the child's side

    def _serve(self, pipe):
        """Answer requests until the parent closes the pipe.  Never returns."""
        signal.signal(signal.SIGVTALRM, signal.SIG_DFL)
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        os.chdir(self.folder)
        os.environ["INI_FILE_NAME"] = self.ini      # read anew by each gcode.parse
        os.dup2(self.messages.fileno(), 1)
        os.dup2(self.messages.fileno(), 2)
        sys.path.insert(0, os.path.join(HERE, "plugin"))
        import namedparams
        canon = _make_canon(self.folder, self.record and self.record.fileno())
        if self.record:
            _make_tool_table(self.folder)

        def note(position, line, arity, value):
            struct.pack_into("HBB", self.notes, 4 * (position + 1), line, arity, value)
            struct.pack_into("I", self.notes, 0, position + 1)

        namedparams.NOTE = note
        written = None
        while True:
            try:
                data, choices, canon.block_delete = pipe.recv()
            except EOFError:
                os._exit(0)
            if data != written:
                with open(self.program, "wb") as f:
                    f.write(data)
                written = data
            namedparams.CHOICES, namedparams.TAKEN = choices, 0
            struct.pack_into("I", self.notes, 0, 0)
            for file in filter(None, (self.messages, self.record)):
                file.seek(0)
                file.truncate()
            signal.setitimer(signal.ITIMER_VIRTUAL, self.cpu_limit)
            try:
                result, _ = gcode.parse(self.program, canon, "", "")
                failed = result > gcode.MIN_ERROR
                message = gcode.strerror(result) if failed else ""
            except Exception as error:              # a callback failed: not the program's doing, but say so
                failed, message = True, "python: %r" % (error,)
            signal.setitimer(signal.ITIMER_VIRTUAL, 0)
            pipe.send((failed, message.replace(self.program, "PROGRAM"), self._offset() if failed else 0))

    @staticmethod
    def _offset():
        """Where the line that was read last starts.  The line that gcode.parse returns is no use after an error in a
        sub: the interpreter has unwound its calls by then and it is that of the outermost call."""
        import interpreter
        return interpreter.this.blocks[0].offset


def main(argv, start=Interpreter):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--choices", default="")
    parser.add_argument("--warnonly", action="store_true")
    options = parser.parse_args(argv)
    interpreter = start(options.warnonly)
    for path in options.programs:
        with open(path, encoding="latin-1", newline="") as f:
            run = interpreter.run(f.read(), bytes(int(c) for c in options.choices))
        print(os.path.basename(path), run.outcome, run.line, "|".join(sorted(run.codes)), run.message,
              " ".join("%d=%d" % (line, value) for line, _, value in run.trace), sep="\t")
    interpreter.close()


if __name__ == "__main__":
    main(sys.argv[1:])
