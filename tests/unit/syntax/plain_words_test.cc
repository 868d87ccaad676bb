// The numbers of plain lines are the doubles next to what is written, wherever they stand; and words are found behind comments.
#include <cstdlib>
#include <random>
#include <string>

#include <catch2/catch.hpp>

#include "analyzer/syntax/plain_words.h"

using namespace owlint;

TEST_CASE("numbers of plain words are what strtod reads", "[bulk]") {
  std::mt19937 random(5);
  const auto digits = [&](size_t most) {
    std::string out;
    for (size_t count = random() % (most + 1); count > 0; --count) out += static_cast<char>('0' + random() % 10);
    return out;
  };
  for (int i = 0; i < 200'000; ++i) {
    const size_t most = i % 3 == 0 ? 20 : 9;
    std::string text = std::vector<std::string>{"", "-", "+"}[random() % 3] + digits(most);
    if (random() % 4 != 0) text += "." + digits(most);
    if (text.find_first_of("0123456789") == std::string::npos) text += "7";
    const double expected = std::strtod(text.c_str(), nullptr);
    // With bytes of other words behind it, and at the end of all bytes.
    for (const std::string& bytes : {text + "Y12.5 Z-0.125 (a comment)\n", text + "\n"}) {
      const double found = plain_number(bytes.data(), bytes.data() + bytes.size());
      if (found == expected) continue;
      INFO(bytes);
      REQUIRE(found == expected);
    }
  }
}

TEST_CASE("words of many lines are found by vectors as they are one by one", "[bulk]") {
  std::mt19937 random(7);
  std::string bytes;
  for (int i = 0; i < 5'000; ++i) {
    for (const char* word : {"N12", "G01", "X-1.5", "y 2.25", "Z.5", "(X9 of y8)", "I-3", "j4.", "F300", "         "}) {
      if (random() % 2 == 0) bytes += word;
    }
    if (random() % 5 == 0) bytes += "; X5 (y)";
    bytes += random() % 3 == 0 ? "\r\n" : "\n";
  }
  for (const ByteClassifier& by : byte_classifiers()) {
    PlainWordReader reader(&by);
    PlainWords expected, found;
    for (size_t at = 0; at < bytes.size();) {
      if (random() % 10 == 0) at = bytes.rfind('\n', random() % bytes.size()) + 1;  // also from elsewhere
      if (at == bytes.size()) break;
      const size_t next = read_plain_words(bytes, at, &expected);
      REQUIRE(reader.read(bytes, at, &found) == next);
      REQUIRE(found.letters == expected.letters);
      REQUIRE(found.code == expected.code);
      for_letters(found.letters, [&](size_t letter) { REQUIRE(found.texts[letter] == expected.texts[letter]); });
      if (random() % 1000 == 0) break;
      at = next;
    }
  }
}

TEST_CASE("words are found wherever they stand", "[bulk]") {
  std::mt19937 random(6);
  for (int i = 0; i < 20'000; ++i) {
    std::string line;
    uint32_t letters = 0;
    std::array<double, kLetters> values{};
    for (const char letter : {'x', 'Y', 'z', 'A', 'f', 'I', 'j'}) {
      if (random() % 3 == 0) line += std::vector<std::string>{" ", "\t  ", "(X9 of y8)", "            "}[random() % 4];
      if (random() % 2 == 0) continue;
      const double value = static_cast<double>(random() % 100'000) / 64;
      line += letter + std::to_string(value);
      const char small = letter < 'a' ? static_cast<char>(letter + ('a' - 'A')) : letter;
      letters |= letter_set({&small, 1});
      values[letter_index(small)] = value;
    }
    if (random() % 3 == 0) line += "; X5 (y)";
    const std::string bytes = line + "\nX1\n";
    PlainWords words;
    const size_t next = read_plain_words(bytes, 0, &words);
    words.convert(letters);
    INFO(line);
    REQUIRE(next == line.size() + 1);
    REQUIRE(words.letters == letters);
    REQUIRE(words.values == values);
  }
}
