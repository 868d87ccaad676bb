// Fixtures: programs in tests/programs that carry what owlint is expected to say.
//
//   ; asks: the question that the program answers
//   ; options: command line options, if it needs some
//   ; expect: OW104 7:1-7:8 error always stops
//   ; expect: nothing
//
// The lines are anywhere in the program, or, where they would change it, in `<program>.expect` without the `; `.
// An expectation is a finding's code, place, severity, reach, and whether the interpreter stops there or runs on; in a
// bundle (bundle.h) the file comes first where it is not the program.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace owlint::test {

struct Fixture {
  std::string path;
  std::string folder;  ///< the code of the rule that it is about
  std::string asks;
  std::string options;
  std::vector<std::string> expected;  ///< sorted as owlint sorts
  std::string lines_in;               ///< the file that holds these lines
  bool bundle = false;                ///< several files in one, see bundle.h
};

/// All fixtures, sorted by path.
std::vector<Fixture> all_fixtures();

/// A finding of the JSON report in the form of an expectation; `nothing` when there is none.
std::vector<std::string> expectations(const nlohmann::json& findings);

/// Whether an expectation, which may lack the columns, is met by what was found.
bool meets(const std::string& expected, const std::string& found);

/// Rewrites a fixture's expectations and leaves all other bytes as they are.
void rewrite(const Fixture& fixture, const std::vector<std::string>& found);

/// Rewrites the expectations of all fixtures until nothing changes any more (fewer or more of them move the lines
/// below); how many were not as found.
size_t update_fixtures();

/// Checks all fixtures, those with the same options in one run: their findings, in the order of `fixtures`.
std::vector<nlohmann::json> check_fixtures(const std::vector<Fixture>& fixtures);

/// All fixtures with what is found in them. Checked once in a process: test cases with the tag [fixtures] share it.
struct CheckedFixtures {
  std::vector<Fixture> fixtures;
  std::vector<nlohmann::json> findings;
};
const CheckedFixtures& checked_fixtures();

}  // namespace owlint::test
