#include "analyzer/syntax/codes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace owlint {
namespace {

using enum Release;
using enum GGroup;

constexpr GCode kGCodes[] = {
#define MOTION(name, tenths, since, axes, leaves, title) \
  {tenths, kMotion, since, Motion::name, GCode::axes, GCode::leaves, title},
#define G_CODE(name, tenths, group, since, title) \
  {tenths, group, since, Motion::kNone, GCode::kFree, GCode::kEarlier, title},
#include "analyzer/syntax/codes.def"
};

constexpr MCode kMCodes[] = {
#define M_CODE(name, number, group, title) {number, MGroup::group, title},
#include "analyzer/syntax/codes.def"
};

constexpr double kNone = -std::numeric_limits<double>::infinity();
constexpr char small(char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter; }

constexpr WordRow kWords[] = {
#define WORD(letter, number, least, below, repeated, name, title) \
  {small(letter), NumberKind::number, least, below, WordRow::repeated, name, title},
#include "analyzer/syntax/codes.def"
};

constexpr uint8_t kNoRow = 255;
constexpr int kTenths = 1000;
constexpr int kUserFirst = code::kM100, kUserLast = 199;

constexpr auto kGRows = [] {
  std::array<uint8_t, kTenths> rows{};
  rows.fill(kNoRow);
  uint8_t row = 0;
  for (const GCode& code : kGCodes) rows[static_cast<size_t>(code.tenths)] = row++;
  return rows;
}();

constexpr auto kMRows = [] {
  std::array<uint8_t, kUserLast + 1> rows{};
  rows.fill(kNoRow);
  uint8_t row = 0;
  for (const MCode& code : kMCodes) rows[static_cast<size_t>(code.number)] = row++;
  for (size_t number = kUserFirst; number <= kUserLast; ++number) rows[number] = rows[kUserFirst];
  return rows;
}();

constexpr size_t kMotions = static_cast<size_t>(Motion::kRemapped);
static_assert(static_cast<size_t>(Motion::kNone) < 64);
static_assert(std::size(kGCodes) - kMotions <= 64 && std::size(kMCodes) <= 64);

constexpr CodeSet set_of_g(size_t row) {
  const Motion motion = kGCodes[row].motion;
  if (motion != Motion::kNone) return {set_of(motion), 0, 0, 0};
  return {0, uint64_t{1} << (row - kMotions), 0, 0};
}

/// The codes and words of a list as codes.def writes them. A code that the table lacks does not compile.
constexpr CodeSet parse(std::string_view list) {
  CodeSet set;
  while (!list.empty()) {
    const size_t end = std::min(list.find(' '), list.size());
    const std::string_view name = list.substr(0, end);
    list.remove_prefix(std::min(end + 1, list.size()));
    if (name.size() == 1) {
      set.words |= 1U << letter_index(small(name[0]));
      continue;
    }
    size_t number = 0;
    bool tenths = false;
    for (const char c : name.substr(1)) {
      if (c == '.') {
        tenths = true;
      } else {
        number = number * 10 + static_cast<size_t>(c - '0');
      }
    }
    if (name[0] == 'G') {
      set = set | set_of_g(kGRows[tenths ? number : number * 10]);
    } else {
      set.m |= uint64_t{1} << kMRows[number];
    }
  }
  return set;
}

constexpr uint32_t letters_of(std::string_view capitals) {
  uint32_t set = 0;
  for (const char letter : capitals) set |= 1U << letter_index(small(letter));
  return set;
}
constexpr uint32_t letters_of(char capital) { return 1U << letter_index(small(capital)); }

/// What a later release adds to a row.
struct Newer {
  Release since;
  CodeSet codes;
  const char* message;  ///< null: the same
};
constexpr Newer newer(Release since, std::string_view codes, const char* message) {
  return {since, parse(codes), message};
}
constexpr Newer kSame{k2_8, {}, nullptr};

constexpr LineCheck refused(bool ever, char letter, std::string_view codes, std::string_view also,
                            const char* message) {
  LineCheck check{ever ? LineCheck::kRefused : LineCheck::kNever, letters_of(letter), parse(codes), message};
  check.also = parse(also);
  return check;
}

constexpr LineCheck unused(LineCheck::Kind kind, Release release, char letter, std::string_view codes,
                           const char* message, const Newer& more) {
  LineCheck check{kind, letters_of(letter), parse(codes), message};
  if (release < more.since) return check;
  check.codes = check.codes | more.codes;
  if (more.message != nullptr) check.message = more.message;
  return check;
}

constexpr LineCheck limited(char letter, std::string_view codes, LineCheck::Test test, double least, double most,
                            const char* message) {
  LineCheck check{LineCheck::kValue, letters_of(letter), parse(codes), message};
  check.test = test;
  check.least = least;
  check.most = most == kNone ? -kNone : most;
  return check;
}

constexpr auto checks_of(Release release) {
  return std::to_array<LineCheck>({
#define REFUSED(letter, since, codes, also, message) refused(release >= (since), letter, codes, also, message),
#define UNUSED(letter, codes, message, newer) unused(LineCheck::kUnused, release, letter, codes, message, newer),
#define UNUSED_UNLESS_MINUS_ONE(letter, codes, message, newer) \
  unused(LineCheck::kUnusedUnlessMinusOne, release, letter, codes, message, newer),
#define VALUE(letter, codes, test, least, most, message) limited(letter, codes, LineCheck::test, least, most, message),
#define MISSING(letters, codes, message) LineCheck{LineCheck::kMissing, letters_of(letters), parse(codes), message},
#include "analyzer/syntax/codes.def"
  });
}

constexpr std::array kChecks{checks_of(k2_8), checks_of(k2_9), checks_of(k2_9_9), checks_of(k2_10)};

/// A word that is unused or has limits is seen by its letter, a word that is missing or refused by the code.
constexpr CheckTriggers triggers_of(std::span<const LineCheck> checks) {
  CheckTriggers out{};
  for (const LineCheck& check : checks) {
    if (check.kind == LineCheck::kMissing || check.kind == LineCheck::kRefused) {
      out.codes = out.codes | check.codes;
    } else if (check.kind != LineCheck::kNever) {
      out.letters |= check.letters;
    }
  }
  return out;
}
constexpr std::array kTriggers{triggers_of(kChecks[0]), triggers_of(kChecks[1]), triggers_of(kChecks[2]),
                               triggers_of(kChecks[3])};
static_assert(kChecks.size() == kReleases);

constexpr auto kWordRows = [] {
  std::array<uint8_t, kLetters> rows{};
  rows.fill(kNoRow);
  uint8_t row = 0;
  for (const WordRow& word : kWords) rows[static_cast<size_t>(letter_index(word.letter))] = row++;
  return rows;
}();

/// As the processor converts: the smallest for all that does not fit.
int32_t to_int(double value) {
  return value > -2147483649.0 && value < 2147483648.0 ? static_cast<int32_t>(value)
                                                       : std::numeric_limits<int32_t>::min();
}

/// The whole number that `value` exceeds by less than `slack`, or falls short of by less.
bool to_whole(double value, double slack, int32_t* result) {
  *result = to_int(std::floor(value));
  const double rest = value - *result;
  if (rest > 1 - slack) {
    *result = to_int(std::ceil(value));
    return true;
  }
  return rest <= slack;
}

}  // namespace

const GCode* g_code(int tenths, Release release) {
  if (tenths < 0 || tenths >= kTenths) return nullptr;
  const uint8_t row = kGRows[static_cast<size_t>(tenths)];
  return row == kNoRow || kGCodes[row].since > release ? nullptr : &kGCodes[row];
}

const MCode* m_code(int number) {
  if (number < 0 || number > kUserLast) return nullptr;
  const uint8_t row = kMRows[static_cast<size_t>(number)];
  return row == kNoRow ? nullptr : &kMCodes[row];
}

const WordRow* word_row(char letter) {
  const int index = letter_index(letter);
  if (index < 0 || index >= kLetters) return nullptr;
  const uint8_t row = kWordRows[static_cast<size_t>(index)];
  return row == kNoRow ? nullptr : &kWords[row];
}

std::span<const GCode> g_codes() { return kGCodes; }
std::span<const MCode> m_codes() { return kMCodes; }
std::span<const WordRow> word_rows() { return kWords; }

std::string g_name(int tenths) {
  std::string name = "G" + std::to_string(tenths / 10);
  if (tenths % 10 != 0) name += "." + std::to_string(tenths % 10);
  return name;
}

std::string m_name(int number) { return "M" + std::to_string(number); }

std::string motion_name(Motion motion) {
  if (motion == Motion::kNone) return "no motion";
  if (motion == Motion::kRemapped) return "a remapped code";
  return g_name(kGCodes[static_cast<size_t>(motion)].tenths);
}

CodeSet set_of(const GCode& code) { return set_of_g(static_cast<size_t>(&code - kGCodes)); }
CodeSet set_of(const MCode& code) { return {0, 0, uint64_t{1} << (&code - kMCodes), 0}; }

std::span<const LineCheck> line_checks(Release release) { return kChecks[static_cast<size_t>(release)]; }
const CheckTriggers& check_triggers(Release release) { return kTriggers[static_cast<size_t>(release)]; }

MotionSet all_modes() {
  static const MotionSet modes = [] {
    MotionSet set = set_of(Motion::kNone);
    for (const GCode& code : g_codes()) {
      if (code.group == GGroup::kMotion && code.leaves == GCode::kItself) set |= set_of(code.motion);
    }
    return set;
  }();
  return modes;
}

const char* refused_number(char letter, double value) {
  constexpr int32_t kTenthsEnd = 1000;
  const WordRow& row = *word_row(letter);
  int32_t whole = 0;
  if (row.number == NumberKind::kInteger) {
    if (!word_integer(value, &whole)) return "Non integer value for integer";
    value = whole;
  } else if (row.number == NumberKind::kTenths) {
    if (!g_tenths(value, &whole) || whole >= kTenthsEnd) return "G-code out of range";
    value = whole;
  }
  return value < row.least ? row.below : nullptr;
}

bool refuses_numbers(char letter) {
  const WordRow& row = *word_row(letter);
  return row.number == NumberKind::kInteger || row.number == NumberKind::kTenths || row.below != nullptr;
}

bool word_integer(double value, int32_t* result) { return to_whole(value, 0.0001, result); }
bool g_tenths(double value, int32_t* result) { return to_whole(value * 10, 0.001, result); }
int32_t nearest_integer(double value) { return to_int(value < 0 ? value - 0.5 : value + 0.5); }

}  // namespace owlint
