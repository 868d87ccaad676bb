#include "rules/driver/positions.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace owlint::rules {
namespace {

/// Codes whose axis words are no way that the machine goes.
constexpr std::string_view kNoMoves = "G10 G28 G28.1 G30 G30.1 G43.1 G43.2 G52 G92";

bool may_be_deleted(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t");
  return first != std::string_view::npos && text[first] == '/';
}

/// Whether runs may come from elsewhere, or have been elsewhere, before the line.
bool joins_other_lines(const Program& program, uint32_t line) {
  const auto& statements = program.syntax.statements;
  for (auto s = std::ranges::lower_bound(statements, line, {}, &Statement::line);
       s != statements.end() && s->line == line; ++s) {
    if (s->kind == LineKind::kOWord || s->calls() || s->has_m99() || s->kind == LineKind::kUserCode ||
        s->kind == LineKind::kRemap || s->kind == LineKind::kPercent || s->kind == LineKind::kProgramEnd)
      return true;
  }
  return false;
}

}  // namespace

std::string number_text(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

int telling_decimals(double a, double b) {
  constexpr int kMost = 9;
  int decimals = 4;
  while (decimals < kMost && number_text(a, decimals) == number_text(b, decimals)) ++decimals;
  return decimals;
}

std::string length(double value, bool inch, int decimals) {
  return number_text(value, decimals) + (!inch ? " mm" : value > 1 ? " inches" : " inch");
}

void add_start(Finding& finding) {
  constexpr std::string_view kStart = ", on a machine that starts at X0 Y0 Z0 without offsets";
  if (!finding.message.ends_with(kStart)) finding.message += kStart;
  finding.unproven = true;
}

void note_start(const FlowStop& stop, Finding& finding) {
  if (stop.words.from_start) add_start(finding);
}

bool relate_distance(const Input& in, const FlowStop& stop, Finding& finding) {
  if (find_word(words_of(*in.program.source, in.program.at(stop.statement).whole()), "G90") != nullptr) return false;
  const std::optional<Setter> setter = setter_of(in, stop, "G91");
  if (!setter || setter->restores()) return false;
  relate_setter(in, finding, setter);
  return true;
}

std::optional<Span> words_above(const Input& in, StatementId statement, std::string_view letters) {
  constexpr uint32_t kMostLines = 200;
  const Program& program = in.program;
  const Source& source = *program.source;
  const uint32_t first = program.at(statement).line;
  const uint32_t last = first > kMostLines ? first - kMostLines : 0;
  for (uint32_t line = first - 1; line > last; --line) {
    const Span text = source.line(line);
    if (may_be_deleted(source.slice(text)) || joins_other_lines(program, line)) return std::nullopt;
    const std::vector<WrittenWord> words = words_of(source, text);
    std::optional<Span> found;
    for (const WrittenWord& word : words) {
      if (letters.find(word.letter) == std::string_view::npos) continue;
      if (!found) found = word.span;
      found->end = word.span.end;
    }
    if (!found) continue;
    if (find_word(words, kNoMoves) != nullptr) return std::nullopt;
    return found;
  }
  return std::nullopt;
}

}  // namespace owlint::rules
