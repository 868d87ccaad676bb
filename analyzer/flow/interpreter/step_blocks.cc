// The transfer functions of loops and branches. An `endwhile` goes back to its `while`, where the condition is asked again.
#include <cmath>

#include <fmt/format.h>

#include "analyzer/flow/interpreter/step.h"
#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

// --- loops ---

void AbstractMachine::Step::repeat(Truth truth, double number) {
  const Definers::Set set = m.definers_.get(entry());
  take_apart(set, here);
  const State before = state;
  bool own = set.undefined;
  for (const StatementId line : set.lines) {
    if (line == here) {
      own = true;
      continue;
    }
    state = before;
    if (!documented(
            StopKind::kDuplicateLoop,
            at_line("duplicate O-word label: '" + line_text() + "' - defined in line " + std::to_string(line_of(line))),
            line))
      continue;
    set_entry(Definers::one(line));
    state.skip = kNoLabel;
    if (kind_of(line) == Keyword::kRepeat) {
      count_passes(truth, number);  // both use the first one's count
    } else {
      go(state, here + 1);  // measured: the count that other blocks have never runs out
    }
  }
  if (!own) return;
  state = before;
  define_here();
  state.skip = kNoLabel;
  count_passes(truth, number);
}

/// Decides on the next pass of a `repeat` whose entry is in the table.
void AbstractMachine::Step::count_passes(Truth truth, double number) {
  const int left = state.counts.of(label);
  if (left >= 0 && !state.looped) hazard(HazardKind::kStaleRepeatCount);
  const auto enter = [&](int remaining) {
    State in = state;
    in.skip = kNoLabel;
    in.counts.set(label, remaining);
    go(std::move(in), here + 1, Branch::kTrue);
  };
  const auto pass_by = [&] {
    State after = state;
    after.counts.set(label, RepeatCounts::kNotRunning);
    after.skip = label;
    go(std::move(after), here + 1, Branch::kFalse);
  };
  const bool fresh = left < 0 || left == kAnyCount;
  if (fresh && !std::isnan(number)) {
    double written = 0;
    const bool literal = literal_value(m.program_.syntax.exprs, value(0), &written);
    const bool odd =
        number < 0 || std::fabs(number - std::nearbyint(number)) > kEqualTolerance || (literal && number == 0);
    if (odd) out.hazard(state, HazardReport::of_passes(HazardKind::kRepeatCount, fmt::format("{:.6g}", number)));
  }
  if (fresh) {
    if (truth == Truth::kOpen) {
      enter(kManyLeft);
      pass_by();
    } else {
      const double times = std::nearbyint(number);  // measured: 2.5 passes are 2, 3.5 are 4
      if (times > 0) {
        enter(times - 1 <= m.limits_.counted_passes ? static_cast<int>(times) - 1 : kManyLeft);
      } else {
        pass_by();
      }
    }
  }
  if (left < 0) return;
  decided = left <= m.limits_.counted_passes;
  if (left == kManyLeft || left == kAnyCount) {
    if (!fresh || truth != Truth::kOpen) {
      enter(kManyLeft);
      pass_by();
    }
  } else if (left > 0) {
    enter(left - 1);
  } else {
    pass_by();
  }
}

void AbstractMachine::Step::while_(Truth truth) {
  const Definers::Set set = m.definers_.get(entry());
  take_apart(set, here);
  const State before = state;
  const auto as = [&](uint32_t packed, StatementId opener) {
    state = before;
    set_entry(packed);
    state.skip = kNoLabel;
    const bool pre_test = opener == here || kind_of(opener) == Keyword::kWhile;
    if (pre_test) {
      if (truth != Truth::kFalse) go(state, here + 1, Branch::kTrue);
      if (truth != Truth::kTrue) {
        state.skip = label;
        go(state, here + 1, Branch::kFalse);
      }
      return;
    }
    const uint8_t breaking = state.flags.breaking;
    if (truth != Truth::kFalse && (breaking & kNo) != 0) {
      State again = state;
      again.flags.breaking = kNo;
      go(std::move(again), opener, Branch::kTrue);
    }
    if ((breaking & kStale) != 0 && truth != Truth::kFalse)
      out.hazard(before, HazardReport::of(HazardKind::kStaleBreak));
    if ((breaking & (kYes | kStale)) != 0) {  // ends whatever the condition
      State out_of_loop = state;
      out_of_loop.flags.breaking = kNo;
      go(std::move(out_of_loop), here + 1);
    }
    if (truth != Truth::kTrue && (breaking & kNo) != 0) {
      state.flags.breaking = kNo;
      go(state, here + 1, Branch::kFalse);
    }
  };
  if (set.undefined) as(Definers::one(here), here);
  for (const StatementId line : set.lines) {
    state = before;
    if (line != here && kind_of(line) != Keyword::kDo) {
      if (!documented(StopKind::kDuplicateLoop,
                      at_line("duplicate O-word label: '" + line_text() + "' - defined in line " +
                              std::to_string(line_of(line))),
                      line))
        continue;
    }
    as(Definers::one(line), line);
  }
}

/// `endwhile`, `endrepeat`.
void AbstractMachine::Step::end_loop() {
  const Keyword opener = opener_of(s.keyword);
  if (!require_defined(StopKind::kWrongEnd)) return;
  const State before = state;
  for (const StatementId line : m.definers_.get(entry()).lines) {
    state = before;
    set_entry(Definers::one(line));
    if (kind_of(line) != opener) {
      if (!documented(
              StopKind::kWrongEnd,
              at_line("no matching label: '" + line_text() + "' (found '" + std::string(spelling(kind_of(line))) +
                      "' in line " + std::to_string(line_of(line)) + ")"),
              line))
        continue;
    }
    end_loop_at(line);
  }
}

void AbstractMachine::Step::end_loop_at(StatementId opener) {
  if (!skipping) return go(std::move(state), opener);
  state.skip = kNoLabel;
  const uint8_t continuing = state.flags.continuing;
  if ((continuing & kNo) != 0) {
    State after = state;
    after.flags.continuing = kNo;
    go(std::move(after), here + 1);
  }
  // Behind a condition that is false, the loop only asks once more.
  const bool by_break = (state.flags.breaking & (kYes | kStale)) != 0;
  if ((continuing & kStale) != 0 && (s.is(Keyword::kEndrepeat) || by_break)) hazard(HazardKind::kStaleContinue);
  if ((continuing & (kYes | kStale)) != 0) {
    state.flags.continuing = kNo;
    go(std::move(state), opener);
  }
}

/// `break`, `continue`.
void AbstractMachine::Step::jump() {
  if (!require_defined(StopKind::kNotALoop)) return;
  const State before = state;
  const bool is_break = s.keyword == Keyword::kBreak;
  for (const StatementId line : m.definers_.get(entry()).lines) {
    state = before;
    set_entry(Definers::one(line));
    const Keyword kind = kind_of(line);
    if (kind != Keyword::kWhile && kind != Keyword::kDo) {
      if (!documented(StopKind::kNotALoop,
                      at_line("no matching while/do label: '" + line_text() + "' (found '" +
                              std::string(spelling(kind)) + "' in line " + std::to_string(line_of(line)) + ")"),
                      line))
        continue;
    }
    if (is_break) {
      if (skipping && kind == Keyword::kDo && (state.flags.continuing & (kYes | kStale)) != 0) {
        hazard(HazardKind::kContinueMeetsBreak);
      }
      // The `while` that closes a `do` clears the flag; `endwhile` leaves it set.
      if (m.reads_break_) state.flags.breaking = kind == Keyword::kDo ? kYes : kStale;
    } else if (!skipping) {
      state.flags.continuing = kind == Keyword::kDo ? kStale : kYes;
    }
    state.skip = label;
    go(state, here + 1);
  }
}

// --- if ---

void AbstractMachine::Step::if_(Truth truth) {
  const Definers::Set set = m.definers_.get(entry());
  take_apart(set, here);
  const State before = state;
  const auto as = [&](StatementId opener) {
    state = before;
    set_entry(Definers::one(opener));
    if (opener == here)
      state.counts.set(
          label,
          RepeatCounts::kNotRunning);  // it makes its own entry again each time, and leaves the entries of others
    if (truth != Truth::kFalse) {
      State in = state;
      in.flags.executed = kYes;
      in.skip = kNoLabel;
      go(std::move(in), here + 1, Branch::kTrue);
    }
    if (truth != Truth::kTrue) {
      state.flags.executed = kNo;
      state.skip = label;
      go(state, here + 1, Branch::kFalse);
    }
  };
  const bool own = set.undefined || std::ranges::find(set.lines, here) != set.lines.end();
  if (own) as(here);
  for (const StatementId line : set.lines) {
    if (line == here) continue;
    state = before;
    if (documented(StopKind::kDuplicateIf,
                   at_line("duplicate O-word label - already defined in line " + std::to_string(line_of(line)) + ": '" +
                           line_text() + "'"),
                   line)) {
      as(line);
    }
  }
}

void AbstractMachine::Step::else_(Truth truth) {
  if (!require_defined(StopKind::kNotAnIf)) return;
  const State before = state;
  for (const StatementId line : m.definers_.get(entry()).lines) {
    state = before;
    set_entry(Definers::one(line));
    if (kind_of(line) != Keyword::kIf) {
      if (!documented(
              StopKind::kNotAnIf,
              at_line("no matching 'if' label: '" + line_text() + "' (found '" + std::string(spelling(kind_of(line))) +
                      "' in line " + std::to_string(line_of(line)) + ")"),
              line))
        continue;
    }
    const uint8_t executed = state.flags.executed;
    if ((executed & kYes) != 0) {
      State past = state;
      past.flags.executed = kYes;
      past.skip = label;
      go(std::move(past), here + 1);
    }
    if ((executed & kNo) == 0) continue;
    state.flags.executed = kNo;
    if (s.keyword == Keyword::kElse) {
      if (skipping) {
        state.flags.executed = kYes;
        state.skip = kNoLabel;
      }
      go(state, here + 1);
      continue;
    }
    if (truth != Truth::kTrue) go(state, here + 1, Branch::kFalse);
    if (truth != Truth::kFalse) {
      state.flags.executed = kYes;
      state.skip = kNoLabel;
      go(state, here + 1, Branch::kTrue);
    }
  }
}

void AbstractMachine::Step::endif() {
  if (!require_defined(StopKind::kNotAnIf)) return;
  const State before = state;
  for (const StatementId line : m.definers_.get(entry()).lines) {
    state = before;
    set_entry(Definers::one(line));
    if (kind_of(line) != Keyword::kIf) {
      if (!documented(StopKind::kNotAnIf,
                      at_line("no matching label: '" + m.full_text(label) + "' (found '" +
                              std::string(spelling(kind_of(line))) + "' in line " + std::to_string(line_of(line)) +
                              "): '" + line_text() + "'"),
                      line))
        continue;
    }
    state.skip = kNoLabel;
    state.flags.executed = kYes;
    go(state, here + 1);
  }
}

bool AbstractMachine::Step::require_defined(StopKind) {
  const Definers::Set set = m.definers_.get(entry());
  take_apart(set);
  if (set.undefined) {
    const std::string message = at_line("undefined O-word label: '" + line_text() + "'");
    if (documented(StopKind::kLabelUndefined, message)) crash(StopKind::kLabelUndefined, message);
  }
  if (set.lines.empty()) return false;
  set_entry(m.definers_.without_undefined(entry()));
  return true;
}

/// Under FEATURE 0x20 the interpreter goes on with a label that it does not have, and crashes.
void AbstractMachine::Step::crash(StopKind kind, std::string message) {
  out.hazard(state, HazardReport::of_error(HazardKind::kCrash, kind, std::move(message)));
}

}  // namespace owlint::flow
