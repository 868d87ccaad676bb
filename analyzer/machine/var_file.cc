#include "analyzer/machine/var_file.h"

#include <charconv>

#include "analyzer/text/characters.h"

namespace owlint {
namespace {

constexpr size_t kLongestVarLine = 255;
constexpr int64_t kMaxNumber = 5601;

constexpr std::string_view kVarBlanks = " \t\r\n\v\f";

/// Where the text goes on behind blanks.
size_t behind_blanks(std::string_view text, size_t at) {
  const size_t found = text.find_first_not_of(kVarBlanks, at);
  return found == std::string_view::npos ? text.size() : found;
}

/// Whether scanf() finds a number there.
bool begins_number(std::string_view text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  if (text.starts_with('.')) text.remove_prefix(1);
  const std::string word = small_letters(text.substr(0, 3));
  return (!text.empty() && is_digit(text[0])) || word == "nan" || word == "inf";
}

std::optional<VarRow> row_of(std::string_view text, uint64_t offset, uint32_t line) {
  const size_t begin = behind_blanks(text, 0);
  size_t end = begin;
  if (end < text.size() && (text[end] == '+' || text[end] == '-')) ++end;
  const size_t digits = end;
  while (end < text.size() && is_digit(text[end])) ++end;
  if (end == digits) return std::nullopt;
  VarRow row;
  row.line = line;
  row.span = {offset + begin, offset + end};
  const std::string_view number = text.substr(text[begin] == '+' ? begin + 1 : begin, end - begin);
  if (std::from_chars(number.data(), number.data() + number.size(), row.number).ec != std::errc{}) row.number = -1;
  row.fraction = end < text.size() && text[end] == '.';
  if (!begins_number(text.substr(behind_blanks(text, end)))) return std::nullopt;
  return row;
}

}  // namespace

VarFile read_var_file(std::string_view bytes) {
  VarFile file;
  uint32_t line = 1;
  for (size_t at = 0; at < bytes.size();) {
    const std::string_view piece = bytes.substr(at, kLongestVarLine);
    const size_t feed = piece.find('\n');
    const bool ended = feed != std::string_view::npos;
    const std::string_view text = piece.substr(0, feed);
    if (const std::optional<VarRow> row = row_of(text.substr(0, text.find('\0')), at, line)) {
      const bool outside = row->number < 1 || row->number > kMaxNumber;
      if (outside || (!file.rows.empty() && row->number <= file.rows.back().number)) {
        file.problem = {outside ? VarProblem::Kind::kOutOfRange : VarProblem::Kind::kOutOfOrder, *row,
                        file.rows.empty() ? VarRow{} : file.rows.back()};
        return file;
      }
      file.rows.push_back(*row);
    }
    at += text.size() + (ended ? 1 : 0);
    line += ended ? 1 : 0;
  }
  return file;
}

}  // namespace owlint
