// The fast path of the scanner finds the same lines whatever vectors it runs with.
#include <random>

#include <catch2/catch.hpp>

#include "analyzer/syntax/bulk.h"
#include "support/files.h"

using namespace owlint;

namespace {

/// Every place where skipping through a whole text stops, again and again from the next line on.
std::vector<Passed> walk(const std::string& bytes, Passed (*pass)(std::string_view, size_t)) {
  std::vector<Passed> out;
  for (size_t at = 0; at < bytes.size();) {
    out.push_back(pass(bytes, at));
    const size_t feed = bytes.find('\n', out.back().next);
    at = feed == std::string::npos ? bytes.size() : feed + 1;
  }
  return out;
}

struct EveryTarget {
  ~EveryTarget() { choose_bulk_variant(nullptr); }
  template <typename Check>
  void each(const Check& check) const {
    for (const BulkVariant& variant : bulk_variants()) {
      choose_bulk_variant(&variant);
      check(variant.name);
    }
  }
};

std::string random_text(std::mt19937& random, size_t length) {
  // Mostly what motion is made of, so that lines are skipped; lines of all lengths around a block and the limit.
  static const std::string kUsual = "GXYZFgxyz 0123456789.-+\t\r\n\n\n";
  std::string text;
  const int strange = static_cast<int>(random() % 60);
  while (text.size() < length) {
    const auto kind = static_cast<int>(random() % 1000);
    if (kind < strange) {
      text += static_cast<char>(random() % 256);
    } else if (kind > 990) {
      text += std::string(random() % 300, " X1\n"[random() % 3]) + '\n';
    } else if (kind > 800) {
      text += "G1 X10.5 Y-3\n";
    } else {
      text += kUsual[random() % kUsual.size()];
    }
  }
  return text;
}

}  // namespace

TEST_CASE("every kind of vector passes over the same lines as single bytes", "[bulk]") {
  REQUIRE_FALSE(bulk_variants().empty());
  const EveryTarget targets;
  targets.each([](std::string_view target) {
    INFO("target " << target);
    std::mt19937 random(12345);
    size_t different = 0;
    for (int i = 0; i < 100'000; ++i) {
      const std::string text = random_text(random, random() % 400);
      if (walk(text, pass_plain_lines) == walk(text, pass_plain_lines_scalar)) continue;
      if (++different == 1) UNSCOPED_INFO("first difference in text " << i << ":\n" << text);
    }
    CHECK(different == 0);
  });
}

TEST_CASE("files are passed over alike by every kind of vector", "[bulk]") {
  const EveryTarget targets;
  std::vector<std::string> files;
  for (const char* folder : {"tests/programs", "corpus", "tests/interpreter/called"}) {
    for (const std::string& path : test::files_below(test::repository(folder))) files.push_back(test::read_file(path));
  }
  REQUIRE(files.size() > 400);
  targets.each([&](std::string_view target) {
    INFO("target " << target);
    for (const std::string& bytes : files) CHECK(walk(bytes, pass_plain_lines) == walk(bytes, pass_plain_lines_scalar));
  });
}

TEST_CASE("what may matter is never passed over", "[bulk]") {
  const auto stops_at = [](const std::string& text) { return pass_plain_lines(text, 0).next; };
  for (const char* line :
       {"o100 sub", "  O1 if [1]", "G1 X1 (o)", "M2", "m30", "%", "N10 M98 P1", "/G0 X1", "#1=2", "G0 X[1]", "100 sub",
        " 5", "sub", "if [1]", "G1 X1\rG0", "\xEF\xBB\xBFG1", "G1 X\xE4", "G0 X1 ; c", "$(x)"}) {
    INFO(line);
    CHECK(stops_at(std::string("G1 X1\n") + line + "\nG1 X2\n") == 6);
  }
  CHECK(stops_at(std::string("G1 X1\nX") + std::string(252, '1') + "\nG1\n") == 6);
  CHECK(stops_at(std::string("G1 X1\nX") + std::string(251, '1') + "\nG1\n") == 6 + 253 + 3);
  for (const char* line : {"G1 X1 Y-2.5", "  X1", "", "  \t", "N10 G1 X1", "X1\r", "G1X1Y1", "F500 $1"}) {
    INFO(line);
    const std::string text = std::string("G1 X1\n") + line + "\nG1 X2\n";
    CHECK(stops_at(text) == text.size());
  }
}
