// An interpreter of lines of words for tests, as far as modes go.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "analyzer/syntax/mode_run.h"
#include "support/word_lines.h"

namespace owlint::test {

/// An interpreter with the modes that may be in effect.
struct Interpreter {
  MachineWords machine = kAlone;
  ModeState state = ModeState::started();
  std::vector<ModeFault> faults{};

  /// One line, its words separated by blanks. Its faults replace those of the line before.
  bool line(const std::string& text) {
    WordLine words(machine);
    REQUIRE_FALSE(read(words, text));
    faults.clear();
    const bool runs = ModeRun(machine, words).run(&state, &faults);
    const auto certain = std::ranges::count_if(faults, [](const ModeFault& fault) { return fault.fault.certain; });
    CHECK(certain == (runs ? 0 : 1));
    return runs;
  }
  /// Lines separated by ` / `. The message of the last line if it certainly stops; of one before, with its number.
  std::string program(const std::string& text) {
    size_t number = 0;
    for (size_t at = 0; at < text.size();) {
      const size_t end = std::min(text.find(" / ", at), text.size());
      ++number;
      const bool runs = line(text.substr(at, end - at));
      const bool last = end == text.size();
      if (!runs) return (last ? "" : std::to_string(number) + ": ") + faults.back().fault.message;
      at = end + 3;
    }
    return "";
  }
  /// The possible faults of a line.
  std::string doubts(const std::string& text) {
    line(text);
    std::string all;
    for (const ModeFault& fault : faults) {
      all += (all.empty() ? "" : "; ");
      all += fault.fault.certain ? "certain: " : fault.believed ? "believed: " : "";
      all += fault.fault.message;
    }
    return all;
  }
};

inline std::string stop_of(const std::string& text, const MachineWords& machine = kAlone) {
  return Interpreter{.machine = machine}.program(text);
}

/// An interpreter in the modes behind one of two programs.
inline Interpreter either(const std::string& one, const std::string& other) {
  Interpreter first, second;
  REQUIRE(first.program(one).empty());
  REQUIRE(second.program(other).empty());
  first.state = join(first.state, second.state);
  return first;
}

struct Row {
  const char* program;
  const char* message;
};

template <size_t kCount>
void check(const Row (&rows)[kCount], const MachineWords& machine = kAlone) {
  for (const Row& row : rows) {
    INFO(row.program);
    CHECK(stop_of(row.program, machine) == row.message);
  }
}

}  // namespace owlint::test
