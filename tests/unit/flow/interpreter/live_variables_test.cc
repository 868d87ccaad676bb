// What is forgotten of a state because no run reads it: a parameter that is read after all must never be.
#include <catch2/catch.hpp>

#include "support/analysis.h"

using namespace owlint;
using namespace owlint::flow;

namespace {

/// A program whose every parameter has a value; asks which are left.
struct Living {
  explicit Living(const std::string& text)
      : source(text),
        structure(*source.program),
        outcomes(source.program->syntax, limits, pool),
        live(*source.program, structure, outcomes, limits) {
    const Names& names = source.program->syntax.names;
    for (uint32_t number = 1; number < 40; ++number) set(number, number >= kFirstGlobalNumber);
    for (NameId name = 0; name < names.size(); ++name) {
      const bool global = is_global_name(names.text(name));
      set((global ? kGlobalNames : kLocalNames) + name, global);
    }
  }
  void set(uint32_t key, bool global) { (global ? all.globals : all.locals).set(pool, key, kUnknown); }

  static bool has(const Parameters& p, uint32_t number) {
    return (number < kFirstGlobalNumber ? p.locals : p.globals).get(number) != 0;
  }
  bool has(const Parameters& p, const char* text) const {
    const NameId name = source.program->syntax.names.find(text);
    return (is_global_name(text) ? p.globals.get(kGlobalNames + name) : p.locals.get(kLocalNames + name)) != 0;
  }
  Parameters before(StatementId line) {
    Parameters p = all;
    live.keep_before(line, p, pool);
    return p;
  }
  NameId sub(const char* name) const { return source.program->syntax.names.find(name); }

  Limits limits;
  PersistentMap::Pool pool;
  test::LinkedText source;
  Structure structure;
  RememberedConditions outcomes;
  LiveVariables live;
  Parameters all;
};

}  // namespace

TEST_CASE("what is assigned before it is read is dead", "[live]") {
  Living living(
      "#<a> = 1\n"          // 0
      "#<b> = #<a>\n"       // 1
      "#<a> = #<b>\n"       // 2
      "#9 = [#<a> + #2]\n"  // 3
      "M2\n");
  CHECK_FALSE(living.has(living.before(0), "a"));
  CHECK(living.has(living.before(1), "a"));
  CHECK_FALSE(living.has(living.before(1), "b"));
  CHECK_FALSE(living.has(living.before(2), "a"));
  CHECK(living.has(living.before(2), "b"));
  CHECK(Living::has(living.before(0), 2));
  CHECK_FALSE(Living::has(living.before(0), 3));
}

TEST_CASE("a condition behind the branch that was taken is read, too", "[live]") {
  Living living(
      "o1 if [#<a> EQ 1]\n"      // 0
      "  #5 = 1\n"               // 1
      "o1 elseif [#<b> EQ 2]\n"  // 2
      "o1 else\n"                // 3
      "  o2 while [#<c>]\n"      // 4
      "    o2 break\n"           // 5
      "  o2 endwhile\n"          // 6
      "o1 endif\n"               // 7
      "M2\n");
  CHECK_FALSE(living.has(living.before(1), "a"));
  CHECK(living.has(living.before(1), "b"));
  CHECK(living.has(living.before(2), "b"));
  CHECK_FALSE(living.has(living.before(3), "b"));
  CHECK(living.has(living.before(5), "c"));
  CHECK_FALSE(living.has(living.before(7), "c"));
}

TEST_CASE("a call reads what its sub reads, and what comes behind one call is live behind the sub", "[live]") {
  Living living(
      "o<s> sub\n"                  // 0
      "  #<_out> = #<_in>\n"        // 1
      "o<s> endsub\n"               // 2
      "#<_in> = 1\n"                // 3
      "o<s> call\n"                 // 4
      "#9 = [#<_out> + #<_own>]\n"  // 5
      "#<_in> = 2\n"                // 6
      "o<s> call\n"                 // 7
      "#9 = #<_late>\n"             // 8
      "M2\n");
  const Parameters call = living.before(4);
  CHECK(living.has(call, "_in"));
  CHECK_FALSE(living.has(call, "_out"));
  CHECK(living.has(call, "_own"));
  CHECK(living.has(call, "_late"));
  CHECK_FALSE(living.has(living.before(7), "_own"));
  Parameters entry = living.all;
  living.live.keep_at_entry(living.sub("s"), entry, living.pool);
  CHECK(living.has(entry, "_in"));
  CHECK_FALSE(living.has(entry, "_out"));
  Parameters exit = living.all;
  living.live.keep_at_exit(living.sub("s"), exit, living.pool);
  CHECK_FALSE(living.has(exit, "_in"));
  CHECK(living.has(exit, "_out"));
  CHECK(living.has(exit, "_own"));
}

TEST_CASE("a computed number may be any, and the value of a sub that is defined is always read", "[live]") {
  Living living(
      "o<s> sub\n"                 // 0
      "o<s> endsub [#<shown>]\n"   // 1
      "#33 = 1\n"                  // 2
      "#9 = [#[#<which>] + #4]\n"  // 3
      "#5 = 1\n"                   // 4
      "M2\n");
  const Parameters p = living.before(3);
  CHECK(living.has(p, "which"));
  CHECK(Living::has(p, 4));
  CHECK(Living::has(p, 5));
  CHECK(Living::has(p, 33));
  CHECK_FALSE(Living::has(living.before(4), 33));
  CHECK(living.has(living.before(4), "shown"));
}

TEST_CASE("where a run may leave a block by any line, nothing is forgotten", "[live]") {
  Living living(
      "o1 if [#<a>]\n"  // 0
      "#<b> = 1\n"
      "M2\n");
  CHECK(living.has(living.before(1), "a"));
  CHECK(living.has(living.before(1), "b"));
}
