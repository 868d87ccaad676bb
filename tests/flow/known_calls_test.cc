// An editor's checks remember what calls of subs came to. What they find must be what a fresh check of the same text
// finds, to the last word, however the text changes between them.
#include <sstream>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "analyzer/flow/engine/known_calls.h"
#include "analyzer/report/report.h"
#include "rules/driver/lint.h"
#include "support/damage.h"

using namespace owlint;

namespace {

std::string report(const std::string& text, flow::KnownCalls* known, uint64_t* recalled) {
  LintOptions options;
  options.extend_select = {"OW"};
  options.known_calls = known;
  const FileReport file = lint(Source::own("known.ngc", text), {}, options);
  if (recalled != nullptr) *recalled += file.effort.recalled;
  std::ostringstream out;
  write_json(out, {file});
  return out.str();
}

bool check_alike(const std::string& text, flow::KnownCalls& known, uint64_t* recalled) {
  const std::string fresh = report(text, nullptr, nullptr);
  const std::string remembered = report(text, &known, recalled);
  if (fresh == remembered) return true;
  INFO(text);
  CHECK(remembered == fresh);
  return false;
}

/// Subs with blocks, constants and mistakes, and a main program that calls them in blocks of its own.
std::string many_subs(std::mt19937& random) {
  const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  const auto condition = [&] {
    const char* const left[] = {"#1", "#2", "#<n>", "#<_g>", "#31", "#3"};
    const char* const tests[] = {"GT", "EQ", "LT", "NE"};
    return fmt::format("[{} {} {}]", left[below(6)], tests[below(4)], below(4));
  };
  std::string out;
  int label = 100;
  const auto body = [&](auto&& self, int depth, int lines, bool in_sub, int subs) -> void {
    for (; lines > 0; --lines) {
      const int k = label++;
      switch (below(depth > 2 ? 6 : 13)) {
        case 0: out += fmt::format("#<n> = {}\n", below(4)); break;
        case 1: out += "#<n> = [#<n> + 1]\n"; break;
        case 2: out += fmt::format("#{} = [#{} * 2]\n", 1 + below(3), 1 + below(3)); break;
        case 3: out += below(4) == 0 ? fmt::format("#<_g> = {}\n", below(3)) : "G0 X[#1]\n"; break;
        case 4: out += below(4) == 0 ? "#31 = [#31 + 1]\n" : "G0 Z[#<n>]\n"; break;
        case 5:
          if (subs > 0) out += fmt::format("o<s{}> call [{}] [#500]\n", below(subs), below(4));
          break;
        case 6:
        case 7:
          out += fmt::format("o{} if {}\n", k, condition());
          self(self, depth + 1, 1 + below(2), in_sub, subs);
          if (below(2) == 0) {
            out += fmt::format("o{} else\n", k);
            self(self, depth + 1, 1 + below(2), in_sub, subs);
          }
          out += fmt::format("o{} endif\n", k);
          break;
        case 8:
        case 9:
          out += fmt::format("o{} while {}\n", k, condition());
          self(self, depth + 1, 1 + below(2), in_sub, subs);
          if (below(3) == 0) out += fmt::format("o{} {}\n", k, below(2) == 0 ? "break" : "continue");
          out += fmt::format("#<n> = [#<n> - 1]\no{} endwhile\n", k);
          break;
        case 10:
          out += fmt::format("o{} repeat [{}]\n", k, below(2) == 0 ? "#2" : "2");
          self(self, depth + 1, 1 + below(2), in_sub, subs);
          out += fmt::format("o{} endrepeat\n", k);
          break;
        case 11:
          if (below(3) == 0) out += fmt::format("o{} do\n#<n> = 1\no{} while {}\n", k, k, condition());
          break;
        case 12:
          if (below(in_sub ? 4 : 12) == 0) out += fmt::format("o<s{}> return\n", below(5));
          break;
      }
    }
  };
  for (int sub = 0; sub < 5; ++sub) {
    label = below(3) == 0 ? 100 : label;
    out += fmt::format("o<s{}> sub\n#<n> = #1\n", sub);
    body(body, 0, 3 + below(4), true, below(3) == 0 ? sub : 0);
    out += fmt::format("o<s{}> endsub\n", sub);
  }
  out += "#<n> = 1\n#<_g> = 1\n";
  body(body, 0, 6, false, 5);
  for (int sub = 0; sub < 5; ++sub) out += fmt::format("o<s{}> call [{}] [2]\n", sub, sub);
  return out + "M2\n";
}

}  // namespace

TEST_CASE("remembered calls change no finding while fixtures and corpus are edited", "[known]") {
  std::mt19937 random(20261124);
  const auto all = test::all_programs();
  for (int i = 0; i < 250; ++i) {
    std::string text = all[std::uniform_int_distribution<size_t>(0, all.size() - 1)(random)].second;
    flow::KnownCalls known;
    for (int edit = 0; edit < 8; ++edit) {
      if (!check_alike(text, known, nullptr)) break;
      text = test::damaged(text, random);
    }
  }
}

TEST_CASE("remembered calls change no finding while programs of many subs are edited", "[known]") {
  constexpr int kPrograms = OWLINT_PATIENCE == 1 ? 460 : 115;  // sanitizers see the same code many times as it is
  std::mt19937 random(7);
  uint64_t recalled = 0;
  for (int i = 0; i < kPrograms; ++i) {
    const std::string whole = many_subs(random);
    std::string text = whole;
    flow::KnownCalls known;
    for (int edit = 0; edit < 10; ++edit) {
      if (!check_alike(text, known, &recalled)) break;
      text = test::damaged(edit % 3 == 2 ? whole : text, random);
    }
  }
  // Calls of subs that set or need modes which are followed are not remembered.
  CHECK(recalled > kPrograms / 5);
}
