// Programs that somebody is in the middle of changing.
#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace owlint::test {

/// Name and text of every program of the corpus and of the fixtures that are one file.
std::vector<std::pair<std::string, std::string>> all_programs();

/// The text with a few lines deleted, doubled or moved.
std::string damaged(const std::string& text, std::mt19937& random);

/// Calls `check(name, text)` with damaged copies of all_programs(), 4,000 for each seed.
template <typename Check>
void for_damaged_programs(unsigned seed, const Check& check) {
  std::mt19937 random(seed);
  const auto all = all_programs();
  for (int i = 0; i < 4000; ++i) {
    const auto& [name, text] = all[std::uniform_int_distribution<size_t>(0, all.size() - 1)(random)];
    check(name, damaged(text, random));
  }
}

}  // namespace owlint::test
