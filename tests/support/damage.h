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

}  // namespace owlint::test
