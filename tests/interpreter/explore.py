"""Takes a program through its runs: every list of choices that leads somewhere new.

The choices of a run form a path in a tree: each unknown value that the interpreter reads is a node.  `Explorer` walks
that tree: a run shows all nodes along its path, and every value not taken there is a run still to be made.  Values that
were never taken after the same previous choice come first, then the short ones in random order.  When nothing is left,
the exploration is `complete`: there is no other run (loops end after `LIMIT` readings, see plugin/namedparams.py).
"""
import heapq
import random
from collections import Counter, deque

TAIL = 48       # random values after the chosen beginning; more than the plugin takes
HANG_COST = 10  # an endless run takes as long as many others, and seldom leads anywhere

ONES_FOR_EVER = b"\xff"   # every condition true, every count 1: see plugin/namedparams.py


class Explorer:
    """All that is known about one program's runs."""

    def __init__(self, interpreter, text, seed=0, block_delete=False):
        self.interpreter = interpreter
        self.text = text
        self.block_delete = block_delete
        self.rng = random.Random(seed)
        self.ends = {}                  # (outcome, codes, line) -> a Run that ended so, the one with the fewest choices
        self.said = {}                  # the same -> what the runs said that ended so
        self.hung_after = set()         # lines warned about in runs that never ended
        self.outcomes = Counter()
        self.runs = 0
        self._fresh = deque([b"", ONES_FOR_EVER])
        self._stale = []
        self._seen = set()

    @property
    def complete(self):
        return not self._fresh and not self._stale

    def explore(self, budget, patience):
        """Up to `budget` runs, fewer when `patience` of them in a row show nothing new."""
        idle = 0
        while budget > 0 and idle < patience and not self.complete:
            known = len(self.ends), len(self._seen)
            budget -= self._step()
            idle = 0 if known != (len(self.ends), len(self._seen)) else idle + 1

    def search(self, budget, done):
        """Up to `budget` more runs, until `done()`."""
        while budget > 0 and not self.complete and not done():
            budget -= self._step()

    def _step(self):
        """One run: -> its cost."""
        start = self._fresh.popleft() if self._fresh else heapq.heappop(self._stale)[1]
        bias = self.rng.choice((0.0, 0.15, 0.4, 0.6, 0.85))
        tail = bytes(self.rng.choice((1, 2)) if self.rng.random() < bias else 0 for _ in range(TAIL))
        if not self.runs or start == ONES_FOR_EVER:
            tail = b""
        run = self.interpreter.run(self.text, start + tail, self.block_delete)
        self.runs += 1
        if start == ONES_FOR_EVER and run.outcome == "hang":
            # A loop of the program's own may do that too: it only bears out a claim, it is no stop to be predicted.
            self.hung_after.update(run.warned)
            self._branch(run, 0)
            return HANG_COST
        self.outcomes[run.outcome] += 1
        end = (run.outcome, run.codes, run.line)
        if end not in self.ends or len(run.trace) < len(self.ends[end].trace):
            self.ends[end] = run
        self.said.setdefault(end, set()).add(run.words)
        if run.outcome == "hang":
            self.hung_after.update(run.warned)
        self._branch(run, len(start))
        return HANG_COST if run.outcome == "hang" else 1

    def _branch(self, run, start):
        """Note the values that the run took from its `start`-th choice on, and queue those it did not."""
        taken = run.choices
        before = None
        for at, (line, arity, value) in enumerate(run.trace):
            if at >= start:
                self._seen.add((before, line, value))
                for other in range(arity):
                    if other != value:
                        self._queue(taken[:at] + bytes((other,)), (before, line, other))
            before = (line, value)

    def _queue(self, choices, step):
        if step in self._seen:
            heapq.heappush(self._stale, (len(choices) + 8 * self.rng.random(), choices))
        else:
            self._seen.add(step)
            self._fresh.append(choices)
