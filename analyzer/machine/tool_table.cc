#include "analyzer/machine/tool_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_set>

#include "analyzer/text/characters.h"

namespace owlint {
namespace {

// Measured: the rest after this many bytes counts as a line of its own, and there are this many places besides the spindle.
constexpr size_t kLongestRow = 255;
constexpr size_t kMostPlaces = 1000;

constexpr size_t kSpindle = 0;

constexpr std::string_view kAxes = "xyzabcuvw";

bool is_hex_digit(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// What follows a word's letter.
struct Number {
  explicit Number(std::string_view text) {
    digits = text.substr(std::min(text.find_first_not_of(" \t\r\n\v\f"), text.size()));
    negative = digits.starts_with('-');
    if (negative || digits.starts_with('+')) digits.remove_prefix(1);
  }
  char first() const { return digits.empty() ? '\0' : digits[0]; }

  bool negative;
  std::string_view digits;  ///< and what follows them, which does not matter
};

/// Measured: what is too large wraps around, and beyond 64 bits it is -1 or 0.
std::optional<int32_t> integer_in(std::string_view text) {
  const Number number(text);
  if (!is_digit(number.first())) return std::nullopt;
  int64_t value = 0;
  const char* const begin = number.digits.data();
  const auto [end, problem] = std::from_chars(begin, begin + number.digits.size(), value);
  if (problem == std::errc::result_out_of_range) return number.negative ? 0 : -1;
  return static_cast<int32_t>(number.negative ? -value : value);
}

/// A number as scanf() reads it: with `0x`, `inf` and `nan`.
std::optional<double> real_in(std::string_view text) {
  Number number(text);
  const bool hexadecimal = number.digits.starts_with("0x") || number.digits.starts_with("0X");
  if (hexadecimal) number.digits.remove_prefix(2);
  const char first = number.first();
  if (first == '-' || (hexadecimal && !is_hex_digit(first) && first != '.')) return std::nullopt;
  double value = 0;
  const char* const begin = number.digits.data();
  const char* const stop = begin + number.digits.size();
  const auto [end, problem] =
      std::from_chars(begin, stop, value, hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (problem == std::errc::invalid_argument && !hexadecimal) return std::nullopt;  // `0x.` is 0
  // On one line, only an exponent makes a number that large or that small.
  if (problem == std::errc::result_out_of_range)
    value = std::find(begin, end, '-') == end ? std::numeric_limits<double>::infinity() : 0;
  // Who begins with `infi` has to write `infinity`.
  else if (std::isinf(value) && end == begin + 3 && end != stop && (*end == 'i' || *end == 'I'))
    return std::nullopt;
  return number.negative ? -value : value;
}

class TableReader {
 public:
  TableReader(std::string_view bytes, ToolChanger changer) : bytes_(bytes), changer_(changer), places_(1) {}

  void run() {
    uint32_t number = 1;
    for (size_t at = 0; at < bytes_.size();) {
      const std::string_view text = bytes_.substr(at, kLongestRow);
      const size_t feed = text.find('\n');
      const bool ended = feed != std::string_view::npos;
      const size_t size = ended ? feed + 1 : text.size();
      read_line(text.substr(0, size), number);
      at += size;
      number += ended ? 1 : 0;
    }
  }

  std::vector<ToolLine> lines() && { return std::move(lines_); }

  ToolTable table() const {
    ToolTable table;
    std::unordered_set<int32_t> known = {ToolRow::kNoNumber};
    if (changer_ == ToolChanger::kFixed) known.insert(0);  // the empty spindle, whatever the table has
    const auto add = [&](const ToolRow& row) {
      if (known.insert(row.number).second) table.rows.push_back(row);
    };
    std::for_each(places_.begin() + 1, places_.end(), add);
    add(places_[kSpindle]);  // measured: looked at last
    return table;
  }

 private:
  struct Line {
    ToolRow row;
    size_t place = kSpindle;
    ToolLine said;
  };

  void read_line(std::string_view text, uint32_t number) {
    text = text.substr(0, text.find('\0'));
    text = text.substr(0, text.find(';'));
    if (text.size() <= 1) return;  // measured, whatever the byte is; a line of two blanks empties the spindle
    Line line;
    line.row.line = number;
    bool valid = true;
    // Only blanks separate words; a tab is part of one.
    for (size_t at = text.find_first_not_of(' '); at < text.size() && text[at] != '\n';
         at = text.find_first_not_of(' ', at)) {
      const std::string_view word = text.substr(at, text.find(' ', at) - at);
      at += word.size();
      const bool good = read_word(word, &line);
      if (!good && valid) line.said.bad = span_of(word);
      if (line.said.hidden.end == 0) line.said.hidden = hidden_in(word);
      valid = good && valid;  // behind a bad word, P still takes a place
    }
    line.row.has_offset = std::ranges::any_of(line.row.offset, [](double offset) { return offset != 0; });
    line.row.span = span_of(text);
    note(line, valid);
    if (!valid) return;
    if (line.place >= places_.size()) places_.resize(line.place + 1);
    places_[line.place] = line.row;
  }

  void note(const Line& line, bool valid) {
    if (line.row.span.begin == line.row.span.end) return;
    lines_.push_back(line.said);
    lines_.back().row = line.row;
    lines_.back().skipped = !valid && !line.said.no_place;
  }

  /// What a word has behind a tab and looks like one of its own.
  Span hidden_in(std::string_view word) const {
    const size_t tab = word.find('\t', 1);
    if (tab == std::string_view::npos) return {};
    const size_t first = word.find_first_not_of("\t\r", tab);
    if (first == std::string_view::npos || first + 1 >= word.size()) return {};
    const bool letter = std::string_view("tpdxyzabcuvwijqTPDXYZABCUVWIJQ").find(word[first]) != std::string_view::npos;
    return letter && Number(word.substr(first + 1)).first() != '\0' ? span_of(word.substr(first)) : Span{};
  }

  bool read_word(std::string_view word, Line* line) {
    const char letter = small_letters(word.substr(0, 1))[0];
    if (letter == 't' || letter == 'p' || letter == 'q') {
      const std::optional<int32_t> number = integer_in(word.substr(1));
      if (!number) return false;
      line->said.has_tool = line->said.has_tool || letter == 't';
      if (letter == 'p') return take_place(*number, line);
      (letter == 't' ? line->row.number : line->row.orientation) = *number;
      return true;
    }
    const size_t axis = kAxes.find(letter);
    if (axis == std::string_view::npos && letter != 'd' && letter != 'i' && letter != 'j') return false;
    const std::optional<double> number = real_in(word.substr(1));
    if (!number) return false;
    if (letter == 'd') line->row.diameter = *number;
    if (axis != std::string_view::npos) line->row.offset[axis] = *number;
    return true;
  }

  /// P is the place only for a random changer; otherwise each P takes the next one.
  bool take_place(int32_t pocket, Line* line) {
    line->row.pocket = pocket;
    line->said.has_pocket = true;
    line->said.no_place = changer_ == ToolChanger::kRandom ? pocket < 0 || static_cast<size_t>(pocket) > kMostPlaces
                                                           : taken_ == kMostPlaces;
    if (changer_ == ToolChanger::kRandom) {
      if (line->said.no_place) return false;
      line->place = static_cast<size_t>(pocket);
      return true;
    }
    if (line->said.no_place) return false;
    line->place = ++taken_;
    return true;
  }

  /// Without blanks at both ends.
  Span span_of(std::string_view text) const {
    constexpr std::string_view kBlanks = " \t\r\n\v\f";
    const size_t begin = static_cast<size_t>(text.data() - bytes_.data());
    const size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {begin, begin};
    return {begin + first, begin + text.find_last_not_of(kBlanks) + 1};
  }

  std::string_view bytes_;
  ToolChanger changer_;
  std::vector<ToolRow> places_;
  std::vector<ToolLine> lines_;
  size_t taken_ = 0;
};

}  // namespace

const ToolRow* ToolTable::find(int32_t number) const {
  const auto found = std::ranges::find(rows, number, &ToolRow::number);
  return found == rows.end() ? nullptr : &*found;
}

ToolTable read_tool_table(std::string_view bytes, ToolChanger changer) {
  TableReader reader(bytes, changer);
  reader.run();
  return reader.table();
}

std::vector<ToolLine> read_tool_lines(std::string_view bytes, ToolChanger changer) {
  TableReader reader(bytes, changer);
  reader.run();
  return std::move(reader).lines();
}

}  // namespace owlint
