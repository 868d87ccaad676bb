#!/usr/bin/python3
"""What the stand-alone `rs274` does with a program, for one list of choices: oracle.py with another judge.

usage: stand_alone.py [--choices 0110…] PROGRAM.ngc...      prints the same as oracle.py

The Python module `gcode` begins with a feed, in inches, and knows neither tools nor what a machine was told.  So where modes
decide, `rs274` itself has to run the programs.  It is started once, and forks for each run (plugin/server.py): a run takes about
3 ms, and begins as a start of `rs274` does.
"""
import os
import re
import struct
import subprocess
import sys
from dataclasses import replace
from multiprocessing.connection import Pipe

from bodies import places_of
from oracle import WARNINGS_READ, Interpreter, main

_CONTOUR = re.compile(r"(?i)[^(;]*g\s*7\s*[012]\s*(\.|\D|$)")


class StandAlone(Interpreter):
    """Runs programs one after the other, each in an `rs274` that has run nothing before."""

    def __init__(self, warnonly=False, base=None):
        self.servers = {}       # by block delete: (process, its requests, its replies)
        self.written = None
        self.last = 0           # the line that was begun last, in its file
        super().__init__(warnonly, base)
        os.mkdir(os.path.join(self.folder, "subs"))     # the path is looked for at the start

    def run(self, text, choices=b"", block_delete=False):
        run = super().run(text, choices, block_delete)
        if run.outcome != "error":
            return run
        # In a line of its own that restores modes, or in a contour, it has another place.
        line = self._line(self.last)
        if run.message.startswith("M7x: restore_settings"):
            return replace(run, line=restores(text, line))
        begun = text.split("\n")[max(0, line - 1):line]
        return replace(run, line=line) if run.line and begun and _CONTOUR.match(begun[0]) else run

    def _ask(self, data, choices, block_delete):
        if data != self.written:
            with open(self.program, "wb") as f:
                f.write(data)
            self.written = data
        if block_delete not in self.servers:
            self.servers[block_delete] = self._serve_runs(block_delete)
        _, requests, replies = self.servers[block_delete]
        struct.pack_into("I", self.notes, 0, 0)
        requests.send((choices, self.cpu_limit))
        try:
            killed, failed, offset, self.last = replies.recv()
        except EOFError:
            raise RuntimeError(self._said()) from None
        # Behind the message stands the line that was read last.
        message = self._said().split("\n")[0].replace(self.program, "PROGRAM") if failed and not killed else ""
        return killed, failed, message, offset

    def _said(self):
        return os.pread(self.messages.fileno(), WARNINGS_READ, 0).decode("latin-1")

    def _serve_runs(self, block_delete):
        wanted, requests = Pipe(duplex=False)
        replies, given = Pipe(duplex=False)
        ends = wanted.fileno(), given.fileno()
        process = subprocess.Popen(["rs274", "-g", *["-b"] * block_delete, "-i", self.ini, self.program], cwd=self.folder,
                                   env=dict(os.environ, HOME=self.folder, SERVE="%d %d" % ends), pass_fds=ends,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=self.messages)
        wanted.close()
        given.close()
        return process, requests, replies

    def _stop(self):
        for process, requests, replies in self.servers.values():
            requests.close()
            process.wait()
            replies.close()
        self.servers = {}


def restores(text, line):
    """The line that restores modes, where it is known that this one does, or is the call of a sub that does at its end."""
    places = places_of(text)
    called = next((place.label for place in places if place.row + 1 == line and place.keyword == "call"), None)
    begins = [place.row + 1 for place in places if place.label == called and place.keyword == "sub"]
    ends = [place.row + 1 for place in places if place.label == called and place.keyword == "endsub"]
    if begins and not ends:
        rows = text.split("\n")
        ends = [row for row in range(begins[0] + 1, len(rows) + 1) if re.search(r"(?i)m\s*99", rows[row - 1])]
    return ends[0] if ends else line


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], StandAlone))
