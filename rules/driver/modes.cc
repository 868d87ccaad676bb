#include "rules/driver/modes.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace owlint::rules {
namespace {

constexpr std::string_view kPlaceWords = "xyzabcuvw@^";

/// Whether a word is the one that a name means.
bool is_meant(const WrittenWord& word, std::string_view name) {
  const bool axis = kPlaceWords.find(word.letter) != std::string_view::npos;
  if (name == "*") return axis;
  if (capital(word.letter)[0] != name[0]) return false;
  if (name.size() == 1) return true;
  double number = 0;
  std::from_chars(name.data() + 1, name.data() + name.size(), number);
  constexpr double kNear = 0.01;
  return word.value && std::abs(*word.value - number) < kNear;
}

/// The word that a stop is about is `word`.
void set_word(const Source& source, const WrittenWord& word, WordStop& stop) {
  stop.span = word.span;
  stop.letter = word.letter;
  stop.value = word.value;
  stop.word = shown(source, word.span);
}

}  // namespace

const Said* said_of(std::span<const Said> rows, std::string_view interpreter) {
  const auto found = std::ranges::find_if(
      rows, [&](const Said& row) { return interpreter.find(row.interpreter) != std::string::npos; });
  return found == rows.end() ? nullptr : &*found;
}

const WrittenWord* find_word(const std::vector<WrittenWord>& line, std::string_view names) {
  while (!names.empty()) {
    const std::string_view name = names.substr(0, names.find(' '));
    const auto found = std::ranges::find_if(line, [&](const WrittenWord& word) { return is_meant(word, name); });
    if (found != line.end()) return &*found;
    names.remove_prefix(std::min(name.size() + 1, names.size()));
  }
  return nullptr;
}

WordStop word_stop(const Input& in, const FlowStop& stop, std::string_view names) {
  WordStop out = word_stop(in, stop);
  const Statement& s = in.program.at(stop.statement);
  if (const WrittenWord* word = find_word(out.line, names))
    set_word(*in.program.source, *word, out);
  else if (out.line.empty())
    out.span = s.head_span();
  return out;
}

std::string subject(const WordStop& stop) { return stop.letter == 0 ? "this line" : "`" + stop.word + "`"; }

/// Of a stop that several modes decide the line above the last one that set any of them; not beyond an O-word.
std::optional<Setter> setter_above(Setter setter, std::string_view names) {
  constexpr uint32_t kMostLines = 1000;
  const Source& source = *setter.program->source;
  for (uint32_t left = kMostLines; setter.line > 1 && left > 0; --left) {
    const Span span = source.line(--setter.line);
    const std::string_view text = source.slice(span);
    const size_t first = text.find_first_not_of(" \t/");
    if (first != std::string_view::npos && (text[first] == 'o' || text[first] == 'O')) return std::nullopt;
    const std::vector<WrittenWord> line = words_of(source, span);
    if (const WrittenWord* word = find_word(line, names)) {
      setter.span = word->span;
      setter.word = shown(source, word->span);
      return setter;
    }
  }
  return std::nullopt;
}

std::optional<Setter> setter_of(const Input& in, const FlowStop& stop, std::string_view names, bool own) {
  const Statement& stops = in.program.at(stop.statement);
  const bool known = stop.set_in != nullptr;
  Setter out{
      .program = known ? stop.set_in : &in.program, .line = known ? stop.set_line : stops.line, .span = {}, .word = {}};
  out.on_line = out.program == &in.program && out.line == stops.line;
  if (out.on_line && !own) return std::nullopt;
  const Source& source = *out.program->source;
  out.span = source.line(out.line);
  const std::vector<WrittenWord> line = words_of(source, out.span);
  if (const WrittenWord* word = find_word(line, names)) {
    out.span = word->span;
    out.word = shown(source, word->span);
    return out;
  }
  if (!known || out.on_line) return std::nullopt;
  // M72, or the end of a sub behind M73.
  if (const WrittenWord* restore = find_word(line, "M72")) out.span = restore->span;
  if (line.empty() || find_word(line, "M72") != nullptr) return out;
  return setter_above(out, names);
}

std::string where(const Input& in, const Setter& setter) {
  if (setter.on_line) return "on this line";
  std::string words = "on line " + std::to_string(setter.line);
  if (setter.program != &in.program) words += " of " + file_name(*setter.program->source);
  return words;
}

void relate_setter(const Input& in, Finding& finding, const std::optional<Setter>& setter, std::string_view what) {
  if (!setter) return;
  std::string message =
      setter->restores() ? "the mode is restored here" : "`" + setter->word + "` " + std::string(what);
  const bool here = setter->program == &in.program;
  finding.related.push_back({setter->span, std::move(message), here ? nullptr : setter->program->source});
}

Finding& add_said(const Input& in, Reporter& out, const FlowStop& stop, std::span<const Said> rows) {
  const Said* said = said_of(rows, stop.interpreter);
  const WordStop at = word_stop(in, stop, said == nullptr ? "" : said->about);
  const std::string_view message = said == nullptr ? "cannot be carried out here" : said->message;
  Finding& f = out.add(at.span, subject(at) + " " + std::string(message));
  if (said != nullptr) f.help = said->help;
  f.interpreter = stop.interpreter;
  return f;
}

Fix with_code(Span word, const std::string& code) {
  return {"write `" + code + "`", false, {{{word.begin, word.begin}, code + " "}}};
}

}  // namespace owlint::rules
