// README's section "Limits" tells users some of the budgets of the flow analysis: each figure is the one that is used.
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "analyzer/flow/limits.h"

using owlint::flow::Limits;

namespace {

/// README as one line, so that a sentence may be broken anywhere.
std::string readme() {
  std::ifstream file(OWLINT_SOURCE "/README.md");
  std::string text;
  for (std::string word; file >> word;) text += word + " ";
  return text;
}

/// 250,000
std::string with_commas(size_t number) {
  std::string out = std::to_string(number);
  for (auto at = static_cast<ptrdiff_t>(out.size()) - 3; at > 0; at -= 3) out.insert(static_cast<size_t>(at), ",");
  return out;
}

}  // namespace

TEST_CASE("README names the limits that are used", "[limits]") {
  const std::string text = readme();
  REQUIRE(text.find("## Limits") != std::string::npos);
  const Limits limits;
  const auto& precise = limits.levels.front();
  const auto& last_followed = limits.levels[limits.levels.size() - 2];
  for (const std::string& sentence :
       {fmt::format("more than {} lines with O-words or parameters", with_commas(limits.followed_statements)),
        fmt::format("more than {} steps", with_commas(last_followed.steps)),
        fmt::format("more than {} such lines, owlint does not report unused values",
                    with_commas(limits.data_flow_statements)),
        fmt::format("at most {} different combinations of values at a line", precise.states),
        fmt::format("at most {} calls of a sub with different values", precise.contexts),
        fmt::format("it checks the first {} calculations that use the arguments", limits.fallible_operations),
        fmt::format("at most {} subs are possible", limits.computed_candidates)}) {
    INFO(sentence);
    CHECK(text.find(sentence) != std::string::npos);
  }
}

TEST_CASE("the levels of precision only fall, and the last one has no end", "[limits]") {
  const Limits limits;
  CHECK(limits.levels.back().steps == UINT64_MAX);
  for (size_t i = 1; i < limits.levels.size(); ++i) {
    CHECK(limits.levels[i].steps > limits.levels[i - 1].steps);
    CHECK(limits.levels[i].states <= limits.levels[i - 1].states);
    CHECK(limits.levels[i].contexts <= limits.levels[i - 1].contexts);
  }
}
