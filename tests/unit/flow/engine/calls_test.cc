// Calls: their contexts, callers and exits.
#include <catch2/catch.hpp>

#include "support/analysis.h"

using namespace owlint;
using namespace owlint::flow;

namespace {

const std::string kProgram =
    "o<s> sub\n"         // 0
    "o1 if [#1 EQ 1]\n"  // 1
    "o1 endif\n"         // 2
    "o<s> endsub\n"      // 3
    "o<s> call [1]\n"    // 4
    "o<s> call [2]\n"    // 5
    "M2\n";

struct Calling : test::Engine {
  explicit Calling(const Limits& given = {}) : test::Engine(kProgram, given) { calls.begin({}, false); }

  /// A call at a line with one argument.
  ContextId call(StatementId line, double argument, int repeats = 1) {
    State at;
    at.position = line;
    at.record = trace.add({kNoRecord, line, Branch::kNone, true, false});
    State entry = at;
    const ValueId passed = machine.evaluator().values().intern(argument);
    machine.evaluator().pass(entry.parameters, std::span(&passed, 1));
    entry.position = 0;
    calls.call(at, entry, {source.program->syntax.names.find("s"), 1, false, 1, false}, repeats);
    last = take();
    return last.context;
  }
  /// The call in that context comes to its end.
  void leave(ContextId context) {
    State end = last;
    end.context = context;
    end.position = 3;
    end.record = trace.add({last.record, 3, Branch::kNone, true, false});
    REQUIRE(calls.leave(end));
  }
  State take() {
    REQUIRE_FALSE(worklist.empty());
    return worklist.take();
  }

  State last;
};

}  // namespace

TEST_CASE("calls that begin alike share a context, others do not", "[engine]") {
  Calling calling;
  const ContextId one = calling.call(4, 1);
  CHECK(one != 0);
  CHECK(calling.call(5, 1) == one);
  CHECK(calling.call(5, 2) != one);
  CHECK(calling.calls[one].callers.size() == 2);
  CHECK(calling.calls.joined_states() == 0);
}

TEST_CASE("an exit comes back to all callers, and to those that call later", "[engine]") {
  Calling calling;
  const ContextId one = calling.call(4, 1);
  CHECK(calling.worklist.empty());
  calling.leave(one);
  const State after = calling.take();
  CHECK(after.position == 5);
  CHECK(after.context == 0);
  CHECK(after.flags.returned == kYes);
  calling.leave(one);  // an equal exit is known
  CHECK(calling.worklist.empty());
  CHECK(calling.call(5, 1) == one);
  CHECK(calling.take().position == 6);
}

TEST_CASE("the call that led to a line is known", "[engine]") {
  Calling calling;
  const ContextId one = calling.call(4, 1);
  CHECK(calling.calls.call_of(calling.source.linked, one, 2) == 4);
  CHECK(calling.calls.call_of(calling.source.linked, 0, 5) == kNoStatement);
  CHECK_FALSE(calling.calls.recursion_comes_back(one));
}

TEST_CASE("beyond the limit, calls with other values share a joined context", "[engine]") {
  Calling calling(test::at_most(1, 1));
  const ContextId first = calling.call(4, 1);
  const ContextId second = calling.call(4, 2);
  const ContextId third = calling.call(5, 3);
  CHECK(second != first);
  CHECK(third == second);
  CHECK(calling.calls.joined_states() == 2);
  CHECK(calling.calls[second].joined_entry != nullptr);
}

TEST_CASE("a counted repetition calls again from the same line", "[engine]") {
  Calling calling;
  const ContextId one = calling.call(4, 1, 3);
  calling.leave(one);
  // No sub is in the label table here, so there is nothing to call again: no run goes on.
  CHECK(calling.worklist.empty());
  const ContextId other = calling.call(4, 1, 100);  // more than are counted: the line may run again
  CHECK(other == one);
  CHECK(calling.take().position == 4);
  CHECK(calling.take().position == 5);
}

TEST_CASE("exits that are joined are one exit", "[engine]") {
  Calling calling(test::at_most(1, 1));
  const ContextId one = calling.call(4, 1);
  const auto leave_with = [&](uint8_t executed) {
    calling.last.flags.executed = executed;
    calling.leave(one);
  };
  leave_with(kNo);
  CHECK(calling.take().position == 5);
  leave_with(kYes);  // the first one that is joined
  CHECK(calling.take().position == 5);
  leave_with(kStale);
  CHECK(calling.take().flags.executed == (kYes | kStale));
  CHECK(calling.calls[one].exits.size() == 2);
  leave_with(kYes | kStale);  // is in the joined one
  CHECK(calling.worklist.empty());
}

TEST_CASE("a call comes back to the last join of its callers only", "[engine]") {
  Calling calling;
  const ContextId one = calling.call(4, 1);
  const auto call_with = [&](uint8_t breaking, bool joined) {
    State at;
    at.position = 5;
    at.joined = joined;
    at.flags.breaking = breaking;
    at.record = calling.trace.add({kNoRecord, 5, Branch::kNone, true, false});
    State entry;
    const ValueId passed = calling.machine.evaluator().values().intern(1.0);
    calling.machine.evaluator().pass(entry.parameters, std::span(&passed, 1));
    calling.calls.call(at, entry, calling.calls[one].info, 1);
    CHECK(calling.take().context == one);
    return calling.calls[one].callers.size();
  };
  CHECK(call_with(kNo, true) == 2);
  CHECK(call_with(kNo | kYes, true) == 2);
  CHECK(calling.calls[one].callers.back().state.flags.breaking == (kNo | kYes));
  CHECK(call_with(kNo | kStale, true) == 3);  // does not hold what the one before does
  CHECK(call_with(kNo, false) == 4);
}
