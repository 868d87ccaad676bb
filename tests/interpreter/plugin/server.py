"""Inside the stand-alone `rs274`: makes one start of it enough for many runs (stand_alone.py).

`rs274` loads its plugin when the interpreter has been set up and before it opens the program.  At this point `serve` forks once
for each request, and each child goes on as an `rs274` that was just started.
"""
import ctypes
import mmap
import os
import signal
import struct
from multiprocessing.connection import Connection

WALL_LIMIT_S = 20

_at_exit = None     # must outlive the process


def serve():
    """Answer requests until the other side closes; returns in the children only."""
    requests, replies = (Connection(int(fd)) for fd in os.environ["SERVE"].split())
    # The tools lie in memory that the children share.
    tools = open(os.path.join(os.environ["HOME"], ".tool.mmap"), "r+b", buffering=0)
    as_started = tools.read()
    while True:
        try:
            choices, limit = requests.recv()
        except EOFError:
            os._exit(0)
        os.pwrite(tools.fileno(), as_started, 0)
        os.lseek(2, 0, os.SEEK_SET)
        os.truncate(2, 0)
        child = os.fork()
        if not child:
            return _begin(choices, limit, replies)
        _, status = os.waitpid(child, 0)
        if os.WIFSIGNALED(status):      # else it has answered by itself
            replies.send((os.WTERMSIG(status), True, 0, 0))


def _begin(choices, limit, replies):
    import namedparams
    with open("notes", "r+b") as file:
        notes = mmap.mmap(file.fileno(), 0)

    def note(position, line, arity, value):
        struct.pack_into("HBB", notes, 4 * (position + 1), line, arity, value)
        struct.pack_into("I", notes, 0, position + 1)

    def at_exit(status, _):
        import interpreter
        this = interpreter.this
        replies.send((0, status != 0, this.blocks[0].offset, this.sequence_number))

    global _at_exit
    _at_exit = ctypes.CFUNCTYPE(None, ctypes.c_int, ctypes.c_void_p)(at_exit)
    ctypes.CDLL(None).on_exit(_at_exit, None)
    namedparams.CHOICES, namedparams.NOTE = choices, note
    signal.signal(signal.SIGVTALRM, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_VIRTUAL, limit)
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.alarm(WALL_LIMIT_S)
