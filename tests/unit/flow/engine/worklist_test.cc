// States wait in the order of their lines.
#include <catch2/catch.hpp>

#include "analyzer/flow/engine/precision.h"
#include "analyzer/flow/engine/worklist.h"

using namespace owlint::flow;

TEST_CASE("the foremost line comes first, and at one line what was added first", "[engine]") {
  Worklist list;
  CHECK(list.empty());
  const auto add = [&](owlint::StatementId position, ContextId context) {
    State state;
    state.position = position;
    state.context = context;
    list.add(std::move(state));
  };
  add(7, 0);
  add(3, 1);
  add(3, 2);
  CHECK(list.position() == 3);
  CHECK(list.take().context == 1);
  add(5, 3);  // takes the place of the one that has gone
  CHECK(list.take().context == 2);
  CHECK(list.take().position == 5);
  CHECK(list.take().position == 7);
  CHECK(list.empty());
}

TEST_CASE("precision falls as steps are counted, and stays at the last level", "[engine]") {
  Limits limits;
  limits.levels = {{{10, 8, 8}, {20, 4, 4}, {30, 2, 2}, {UINT64_MAX, 1, 1}}};
  Precision precision(limits, false);
  CHECK(precision.lasts(9));
  CHECK_FALSE(precision.lasts(10));
  precision.count(9);
  CHECK(precision.now().states == 8);
  precision.count(1);
  CHECK(precision.now().states == 4);
  precision.count(15);  // over a level
  CHECK(precision.level() == 2);
  CHECK_FALSE(precision.coarse());
  precision.count(1'000'000);
  CHECK(precision.coarse());
  CHECK(precision.steps() == 1'000'025);
  CHECK(Precision(limits, true).coarse());
}
