"""Named parameters that stand for outcomes nobody can know before the run.

The interpreter calls a function of this module each time a program reads the parameter of that name.  Every reading
takes the next number of `CHOICES`, so one list of numbers is one run.  Past the end of the list, and from the
`LIMIT`-th reading on, the value is 0: a loop on an unknown condition always ends. A list that ends with `ONES` goes on
with 1 for ever instead: so an endless loop is seen that needs a condition to stay true.

`#<_choice>` is a condition (0 or 1), `#<_count>` a repeat count (0, 1 or 2).  Reading `#<_before_g_h>` decides whether a
run before this one has set `#<_g>` and `#<_h>`.
With the stand-alone `rs274` the list is given in the environment: CHOICES=0110.
"""
import os

LIMIT = 40
ONES = 255
CHOICES = [int(c) for c in os.environ.get("CHOICES", "")]
TAKEN = 0
NOTE = None      # called with (position, line, arity, value) for each reading, when set


def _take(interp, arity):
    global TAKEN
    if CHOICES and CHOICES[-1] == ONES:
        value = CHOICES[TAKEN] % arity if TAKEN < len(CHOICES) - 1 else 1
    else:
        value = CHOICES[TAKEN] % arity if TAKEN < min(len(CHOICES), LIMIT) else 0
    if NOTE is not None and TAKEN < LIMIT:
        NOTE(TAKEN, interp.sequence_number, arity, value)
    TAKEN += 1
    return float(value)


def _choice(self):
    return _take(self, 2)


def _left(interp, names):
    """Whether these global names are there, and with what values."""
    if _take(interp, 2):
        for name in names:
            interp.params[name] = (1.0, 0.0, -2.0, 6.0)[int(_take(interp, 4))]
    return 0.0


def _before(self):
    return 0.0


def _before_g(self):
    return _left(self, ("_g",))


def _before_h(self):
    return _left(self, ("_h",))


def _before_g_h(self):
    return _left(self, ("_g", "_h"))


def _count(self):
    return _take(self, 3)
