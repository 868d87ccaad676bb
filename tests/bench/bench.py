#!/usr/bin/python3
"""Times owlint against programs that only read their input, and against itself on ten times as much.

usage: bench.py --owlint build/release/owlint [--runs 5] [--json FILE] [--readme FILE] [--scale F] [--dynamic OWLINT] [--simdjson PROGRAM]

Makes its inputs in a temporary folder, then times everything in turn, in one session: each figure is a ratio of medians,
with the files in the page cache and one thread where nothing else is said. Prints the table as Markdown and writes it as
JSON. Nothing here passes or fails; the last column says what we want. --scale 0.01 makes everything smaller, to try it.
--readme: the file whose table between `<!-- bench -->` and `<!-- end -->` is rewritten. --dynamic: a program linked dynamically,
to compare the start. --simdjson: json_reference.cc, as a measure of what vectors can do.
"""
import argparse
import json
import os
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import cam
import inputs

MOTION, STYLE, DENSE, FILES = 1024, 256, 100, 20_000  # MiB, MiB, MB, files
STYLES = (
    ("arcs", "\n", "G2 and G3 by their center on %d %% of the lines, each radius checked" % (100 * cam.ARCS), "at most 8 x"),
    ("numbered", "\n", "line numbers, and `G01` on each line", "at most 3 x"),
    ("commented", "\n", "comments on 20 % of the lines", ""),
    ("straight", "\r\n", "line ends of Windows", "at most 3 x"),
    ("incremental", "\n", "in G91", ""),
    ("drilling", "\n", "drilling cycles of 48 holes", ""),
    ("fusion", "\n", "as Fusion writes it", ""),
    ("pcb2gcode", "\n", "as pcb2gcode writes it", ""),
    ("freecad", "\n", "as FreeCAD writes it", ""),
)
GROWTH = (
    ("dense O-words", "MB", inputs.dense, (1, 10, 100)),
    ("nested `if`", "deep", inputs.nested, (1_000, 10_000, 100_000, 1_000_000)),
    ("labels in one scope", "labels", inputs.labels, (1_000, 10_000, 100_000, 1_000_000)),
    ("subs that call the next", "subs", inputs.chain, (1_000, 10_000, 100_000, 1_000_000)),
    ("subs called one by one", "subs", inputs.fan, (1_000, 10_000, 100_000, 1_000_000)),
    ("calls of one sub", "calls", inputs.calls, (1_000, 10_000, 100_000, 1_000_000)),
    ("one label on many paths", "blocks", inputs.redefined, (1_000, 10_000)),
    ("subs that call twice", "deep", inputs.doubling, (9, 90)),
    ("one line", "MB", inputs.long_line, (1, 10, 100)),
)


class Bench:
    def __init__(self, options, folder):
        self.owlint, self.runs, self.folder, self.scale = options.owlint, options.runs, folder, options.scale
        self.dynamic, self.simdjson = options.dynamic, options.simdjson
        self.rows = []

    def write_texts(self, name, texts):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="ascii", newline="") as f:
            f.writelines(texts)
        return path

    def write(self, name, lines):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="ascii") as f:
            for line in lines:
                f.write(line + "\n")
        return path

    def check(self, *paths, jobs=1, program=None):
        return [program or self.owlint, "check", "--isolated", "--no-find-ini", "--quiet", "--jobs", str(jobs), *paths]

    def time(self, commands, runs=None):
        """Runs the commands in turn: -> their median seconds."""
        measured = [[] for _ in commands]
        for round_ in range((runs or self.runs) + 1):
            for command, times in zip(commands, measured):
                seconds = spawn(command, (1, 2))
                if round_ > 0:  # the first one only fills the page cache
                    times.append(seconds)
        return [statistics.median(times) for times in measured]

    def add(self, what, figure, ratio, wanted, **more):
        self.rows.append({"input": what, "figure": figure, "ratio": round(ratio, 3), "wanted": wanted, **more})
        print("| %s | %s | %s |" % (what, figure, wanted), flush=True)

    def small_size(self, size):
        return max(1, int(size * self.scale))

    # --- the table ---

    def motion(self):
        size = self.small_size(MOTION)
        path = self.write("motion.ngc", inputs.motion(size))
        wc, one, two = self.time([["wc", "-l", path], self.check(path), self.check(path, jobs=2)])
        memory = max(peak_memory(self.check(path)), peak_memory(self.check(path, jobs=2)))
        what = "%d MiB of CAM motion, 20 O-word blocks in it" % size
        self.add(what, "%.2f x `wc -l` (%.3f s), %.0f MiB of memory" % (one / wc, one, memory), one / wc, "at most 3.0 x, 64 MiB",
                 seconds=one, reference_seconds=wc, memory_mib=memory)
        self.add("the same, `--jobs 2`", "%.2f x `wc -l`" % (two / wc), two / wc, "at most 1.6 x", seconds=two, reference_seconds=wc)
        os.remove(path)

    def styles(self):
        """What CAM systems write, each against `wc -l`."""
        size = self.small_size(STYLE)
        for style, line_end, what, wanted in STYLES:
            path = self.write_texts("style.ngc", cam.program(style, size, line_end))
            wc, owlint = self.time([["wc", "-l", path], self.check(path)])
            memory = peak_memory(self.check(path))
            self.add("%d MiB: %s" % (size, what), "%.2f x `wc -l`, %.0f MiB of memory" % (owlint / wc, memory), owlint / wc, wanted, seconds=owlint,
                     reference_seconds=wc, memory_mib=memory)
            os.remove(path)

    def json_reference(self):
        if not self.simdjson:
            return
        size = self.small_size(STYLE)
        motion = self.write("motion.ngc", inputs.motion(size))
        reference = self.write_texts("reference.json", inputs.json_texts(size))
        simdjson, owlint = self.time([[self.simdjson, reference], self.check(motion)])
        speeds = [os.path.getsize(path) / seconds for path, seconds in ((motion, owlint), (reference, simdjson))]
        self.add("%d MiB of CAM motion; simdjson parses %d MiB of JSON" % (size, size), "%.2f x the bytes per second of simdjson" % (speeds[0] / speeds[1]),
                 speeds[0] / speeds[1], "at least 0.5 x", seconds=owlint, reference_seconds=simdjson)
        os.remove(motion)
        os.remove(reference)

    def dense(self):
        path = self.write("dense.ngc", inputs.dense(self.small_size(DENSE)))
        seconds, = self.time([self.check(path)])
        memory = peak_memory(self.check(path))
        speed = os.path.getsize(path) / seconds / 1e6
        self.add("%d MB of dense O-words" % self.small_size(DENSE), "%.0f MB/s, %.0f MiB of memory" % (speed, memory), speed, "at least 100 MB/s",
                 seconds=seconds, memory_mib=memory)
        os.remove(path)

    def interpreter(self):
        if shutil.which("rs274") is None:
            return
        path = self.write("part.ngc", inputs.motion(self.small_size(12)))
        rs274, owlint = self.time([["rs274", "-g", path], self.check(path)], 3)
        self.add("12 MiB of CAM motion: `rs274 -g` runs it, owlint checks it", "%.0f x as fast" % (rs274 / owlint), rs274 / owlint, "", seconds=owlint,
                 reference_seconds=rs274)

    def files(self):
        count = self.small_size(FILES)
        tree = os.path.join(self.folder, "shop")
        for number in range(count):
            self.write("shop/%03d/p%05d.ngc" % (number // 100, number), inputs.small(number))
        wc = ["sh", "-c", "find '%s' -name '*.ngc' -print0 | xargs -0 wc -l" % tree]
        reference, owlint = self.time([wc, self.check(tree, jobs=2)])
        memory = peak_memory(self.check(tree, jobs=2))
        self.add("%d files of 4 KiB, `--jobs 2`" % count, "%.2f x `find ... \\| xargs wc -l` (%.2f s)" % (owlint / reference, owlint), owlint / reference,
                 "at most 2 x", seconds=owlint, reference_seconds=reference, memory_mib=memory)
        shutil.rmtree(tree)

    def start(self):
        path = self.write("twenty.ngc", inputs.twenty_lines())
        commands = [["cat", path], self.check(path)]
        if self.dynamic:
            commands.append(self.check(path, program=self.dynamic))
        measured = self.time(commands, 100)
        cat, owlint = measured[:2]
        self.add("one program of 20 lines", "%.2f x `cat` (%.2f ms)" % (owlint / cat, owlint * 1e3), owlint / cat, "at most 5 x", seconds=owlint,
                 reference_seconds=cat)
        if self.dynamic:
            dynamic = measured[2]
            self.add("the same, linked dynamically", "%.2f x `cat`" % (dynamic / cat), dynamic / cat, "", seconds=dynamic, reference_seconds=cat)

    def growth(self):
        for name, unit, make, sizes in GROWTH:
            sizes = [max(1, int(size * self.scale)) for size in sizes] if self.scale < 1 and sizes[-1] > 1000 else sizes
            paths = [self.write("growth%d.ngc" % i, make(size)) for i, size in enumerate(sizes)]
            times = self.time([self.check(path) for path in paths], 3)
            steps = [later / earlier for earlier, later in zip(times, times[1:])]
            self.add("%s: %s %s" % (name, ", ".join("{:,}".format(size) for size in sizes), unit),
                     "%s s: steps of %s" % (", ".join("%.3f" % t for t in times), ", ".join("%.1f x" % s for s in steps)), max(steps), "at most 11 x",
                     seconds=times)
            for path in paths:
                os.remove(path)


def spawn(command, quiet):
    """-> seconds"""
    streams = [(os.POSIX_SPAWN_OPEN, fd, os.devnull, os.O_WRONLY, 0) for fd in quiet]
    program = shutil.which(command[0])
    started = time.perf_counter()
    os.waitpid(os.posix_spawn(program, command, os.environ, file_actions=streams), 0)
    return time.perf_counter() - started


def peak_memory(command):
    """In MiB, as GNU time tells it: asked from here, this process's own memory would be counted."""
    with tempfile.NamedTemporaryFile("r") as answer:
        spawn(["time", "-f", "%M", "-o", answer.name, *command], (1, 2))
        return int(answer.read().split()[-1]) / 1024


def rewrite_table(path, rows):
    table = ["| input | figure | wanted |", "|---|---|---|"]
    table += ["| %s | %s | %s |" % (row["input"], row["figure"], row["wanted"]) for row in rows]
    with open(path, encoding="utf-8") as f:
        before, rest = f.read().split("<!-- bench -->\n")
    behind = rest[rest.index("<!-- end -->"):]
    with open(path, "w", encoding="utf-8") as f:
        f.write(before + "<!-- bench -->\n" + "\n".join(table).replace(" x ", " × ").replace(" x,", " ×,") + "\n" + behind)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--owlint", required=True)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--scale", type=float, default=1.0)
    parser.add_argument("--dynamic", metavar="OWLINT")
    parser.add_argument("--simdjson", metavar="PROGRAM")
    parser.add_argument("--readme", metavar="FILE")
    options = parser.parse_args()
    version = subprocess.run([options.owlint, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    with tempfile.TemporaryDirectory(prefix="owlint-bench-") as folder:
        bench = Bench(options, folder)
        print("| input | figure | wanted |\n|---|---|---|")
        for part in (bench.motion, bench.styles, bench.json_reference, bench.dense, bench.interpreter, bench.files, bench.start, bench.growth):
            part()
        if options.readme:
            rewrite_table(options.readme, bench.rows)
        if options.json:
            report = {"schema": "owlint-bench-1", "version": version, "processor": platform.processor() or platform.machine(),
                      "cores": os.cpu_count(), "runs": options.runs, "rows": bench.rows}
            with open(options.json, "w", encoding="utf-8") as f:
                json.dump(report, f, indent=2)
            print("written to %s" % options.json, file=sys.stderr)


if __name__ == "__main__":
    main()
