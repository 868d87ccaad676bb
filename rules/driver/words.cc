#include "rules/driver/words.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "analyzer/syntax/known_line.h"
#include "analyzer/syntax/questions.h"
#include "analyzer/text/characters.h"

namespace owlint::rules {
namespace {

/// The letter that an interpreter's message is about; 0 if it names none.
char letter_in(std::string_view message) {
  const auto small = [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); };
  constexpr std::string_view kInCycle = "Cannot put an a";
  if (message.starts_with("Cannot put a")) return message.starts_with(kInCycle) ? 'a' : message[kInCycle.size() - 2];
  if (message.starts_with("G-code out of range")) return 'g';
  constexpr std::string_view kNegative = "Negative ";  // the letter follows, or `spindle speed`, or `tool id`
  if (message.starts_with(kNegative) && message.size() > kNegative.size()) return message[kNegative.size()];
  if (message.size() < 3 || message[1] != ' ' || message.find(" missing ") != std::string_view::npos) return 0;
  return small(message[0]);
}

constexpr std::string_view kAxisWords = "xyzabcuvw@^";

/// Whether a text is empty, a comment, or begins with a letter and what may be its value.
bool begins_word(std::string_view text) {
  const auto skip_blanks = [&] { text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size())); };
  skip_blanks();
  if (text.empty() || text[0] == '(' || text[0] == ';') return true;
  if (!is_small_letter(static_cast<char>(std::tolower(static_cast<unsigned char>(text[0]))))) return false;
  const bool may_begin_to = text[0] == 't' || text[0] == 'T';
  text.remove_prefix(1);
  // `GO XO`: an O stands for a zero there, too. `GO TO 20` is a jump.
  if (!may_begin_to && !text.empty() && (text[0] == 'o' || text[0] == 'O'))
    return text.size() == 1 || std::string_view(" \t\r.0123456789").find(text[1]) != std::string_view::npos;
  skip_blanks();
  return !text.empty() && std::string_view("0123456789.+-#[").find(text[0]) != std::string_view::npos;
}

}  // namespace

std::vector<WrittenWord> words_of(const Source& source, Span line) {
  WordReader reader(source.slice(line), line.begin);
  std::vector<WrittenWord> words;
  while (std::optional<WrittenWord> word = reader.next()) words.push_back(*word);
  return words;
}

const WrittenWord* WordStop::find(char wanted) const {
  const auto found = std::ranges::find(line, wanted, &WrittenWord::letter);
  return found == line.end() ? nullptr : &*found;
}

std::string shown(const Source& source, Span span) {
  constexpr size_t kMost = 40;
  std::string out;
  bool in_comment = false;
  bool in_name = false;  // which is shown as the program writes it
  for (const char c : source.slice(span)) {
    if (c == '(') in_comment = true;
    if (c == '<' && !in_comment) in_name = true;
    if (!in_comment && c != '\t' && c != '\r' && (c != ' ' || in_name))
      out += in_name ? c : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (c == ')') in_comment = false;
    if (c == '>') in_name = false;
  }
  if (out.size() <= kMost) return out;
  size_t cut = kMost - 1;
  while (cut > 0 && (static_cast<unsigned char>(out[cut]) & 0xC0) == 0x80) --cut;  // within a character of UTF-8
  return out.substr(0, cut) + "…";
}

std::optional<LineError> word_error(const Program& program, const FlowStop& stop) {
  if (stop.further != nullptr) return *stop.further;
  const Syntax& syntax = program.syntax;
  const Statement& s = program.at(stop.statement);
  if (s.kind == LineKind::kMachineCheck) return syntax.errors[s.first];
  if (s.kind == LineKind::kUserCode)
    return LineError{stop.kind, s.keyword_span(), stop.interpreter, {}, kNoExpr, 0, 0, 0};
  const Statement* const asks = s.kind == LineKind::kModeLine ? &s : mode_line_of(syntax, stop.statement);
  // A computed number that is refused comes before a mistake further on.
  if (const LineError* error = syntax.error(s);
      error != nullptr && (error->kind == stop.kind || s.kind == LineKind::kModeLine))
    return *error;
  if (asks == nullptr) {
    const auto items = syntax.items_of(s);
    if (stop.kind != StopKind::kNumberOutOfRange || stop.words.word >= items.size()) return std::nullopt;
    const Item& item = items[stop.words.word];
    return LineError{stop.kind, s.span(item.from, item.to), stop.interpreter, {}, kNoExpr, 0, 0, 0};
  }
  const auto words = syntax.words_of(*asks);
  const auto span_of = [&](uint8_t word, Span none) {
    return word < words.size() ? s.span(words[word].from, words[word].to) : none;
  };
  LineError error;
  error.kind = stop.kind;
  error.span = span_of(stop.words.word, s.whole());
  error.message = stop.interpreter;
  error.other = span_of(stop.words.other, Span{});
  return error;
}

std::string capital(char letter) { return {static_cast<char>(std::toupper(static_cast<unsigned char>(letter)))}; }

WordStop word_stop(const Input& in, const FlowStop& stop) {
  const Program& p = in.program;
  const Source& source = *p.source;
  const Statement& s = p.at(stop.statement);
  WordStop out;
  out.line = words_of(source, s.whole());
  if (const auto error = word_error(in.program, stop)) {
    out.span = error->span;
    out.other = error->other;
  } else {
    const char letter = letter_in(stop.interpreter);
    auto about = std::ranges::find(out.line, letter, &WrittenWord::letter);
    if (about == out.line.end() && stop.kind == StopKind::kAxisWords)
      about = std::ranges::find_if(out.line,
                                   [](const auto& w) { return kAxisWords.find(w.letter) != std::string_view::npos; });
    out.span = about != out.line.end() ? about->span
        : out.line.empty()             ? s.whole()
                                       : Span{out.line.front().span.begin, out.line.back().span.end};
  }
  // The parser may have stopped at a word's letter.
  const auto word = std::ranges::find(out.line, out.span.begin, [](const WrittenWord& w) { return w.span.begin; });
  if (word != out.line.end() && word->span.end >= out.span.end) {
    out.span = word->span;
    out.letter = word->letter;
    out.value = word->value;
  }
  out.word = shown(source, out.span);
  out.other_word = shown(source, out.other);
  return out;
}

void relate_word(Finding& finding, const WordStop& stop) {
  if (stop.other.end > stop.other.begin)
    finding.related.push_back({stop.other, "`" + stop.other_word + "` is here", nullptr});
}

void relate_first_mistake(const Input& in, const FlowStop& further, Finding& finding) {
  FlowStop first = further;
  first.further = nullptr;
  Span word = word_stop(in, first).span;
  const auto error = word_error(in.program, first);
  if (error->kind == StopKind::kNumberMissing) word.end = word.begin + 1;  // without the letter that is in its place
  finding.related.push_back({word, "LinuxCNC stops at `" + shown(*in.program.source, word) + "` first", nullptr});
}

bool runs_with(const Program& program, const Statement& statement, const Edit& edit) {
  std::string line(program.source->slice({statement.offset, edit.span.begin}));
  line.append(edit.text).append(program.source->slice({edit.span.end, statement.end()}));
  if (statement.block_delete) line.erase(0, line.find('/') + 1);
  return surely_runs(line);
}

Fix without_word(const Program& program, const Statement& statement, Span word, const std::string& shown) {
  // With the blanks before it.
  const std::string_view before = program.source->slice({statement.offset, word.begin});
  const size_t last = before.find_last_not_of(" \t");
  if (last != std::string_view::npos) word.begin = statement.offset + last + 1;
  Edit edit{word, ""};
  const bool good = runs_with(program, statement, edit);
  return {"remove `" + shown + "`", good, {std::move(edit)}, true};
}

std::string spoken(const CodeSet& codes, Release release, std::string_view joint) {
  std::vector<int> g;
  for (const GCode& code : g_codes()) {
    if (code.since <= release && codes.meets(set_of(code))) g.push_back(code.tenths);
  }
  std::vector<int> m;
  for (const MCode& code : m_codes()) {
    if (codes.meets(set_of(code))) m.push_back(code.number);
  }
  std::ranges::sort(g);
  std::ranges::sort(m);
  std::vector<std::string> parts;
  const auto add = [&](const std::vector<int>& numbers, int step, auto name) {
    for (size_t i = 0; i < numbers.size();) {
      size_t last = i;
      while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + step) ++last;
      if (last < i + 2) last = i;
      parts.push_back(last == i ? name(numbers[i]) : name(numbers[i]) + " to " + name(numbers[last]));
      i = last + 1;
    }
  };
  add(g, 10, g_name);
  add(m, 1, m_name);
  const auto user = std::ranges::find(parts, "M100");
  if (user != parts.end()) *user = "M100 to M199";
  for (int letter = 0; letter < kLetters; ++letter) {
    if ((codes.words >> letter & 1U) == 0) continue;
    constexpr std::string_view kSigns = "@^$";
    constexpr int kPlain = 26;
    const char c = letter < kPlain ? static_cast<char>('A' + letter) : kSigns[static_cast<size_t>(letter - kPlain)];
    parts.push_back(std::string("the word ") + c);
  }
  std::string out;
  for (size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) out += i + 1 == parts.size() ? fmt::format(" {} ", joint) : ", ";
    out += parts[i];
  }
  return out;
}

std::string_view what_both_do(GGroup group) {
  switch (group) {
    case GGroup::kNonModal: return "each of them is the one action of its line";
    case GGroup::kMotion: return "both say how the tool moves";
    case GGroup::kPlane: return "both choose the plane";
    case GGroup::kDistance: return "both say whether positions are absolute or incremental";
    case GGroup::kArcDistance: return "both say how arc centers are given";
    case GGroup::kFeedMode: return "both say what the feed rate means";
    case GGroup::kUnits: return "both choose the unit";
    case GGroup::kCutterCompensation: return "both set cutter compensation";
    case GGroup::kToolLength: return "both set the tool length offset";
    case GGroup::kRetract: return "both say where cycles retract to";
    case GGroup::kCoordinateSystem: return "both choose the coordinate system";
    case GGroup::kPathControl: return "both say how exactly the path is followed";
    case GGroup::kSpindleMode: return "both say what the spindle speed means";
    case GGroup::kDiameter: return "both say whether X is a diameter or a radius";
    case GGroup::kOffsets: return "both change the G92 offset";
  }
  return "both do the same kind of thing";
}

std::string_view what_both_do(MGroup group) {
  switch (group) {
    case MGroup::kStop: return "both stop or end the program";
    case MGroup::kInputsOutputs: return "both are about an input or output";
    case MGroup::kToolChange: return "both change the tool";
    case MGroup::kSpindle: return "LinuxCNC takes one code for the spindle or the saved modes per line";
    case MGroup::kCoolant: return "LinuxCNC takes one coolant code per line";
    case MGroup::kOverrides: return "LinuxCNC takes one code for overrides per line";
    case MGroup::kUser: return "LinuxCNC runs one program of the machine's own per line";
    case MGroup::kCall: return "both call a sub";
  }
  return "both do the same kind of thing";
}

bool writes_o_for_zero(const Program& program, const Statement& s, const LineError& error, uint64_t* at) {
  const std::string_view line = program.source->slice(s.whole());
  const auto is_o = [](char c) { return c == 'o' || c == 'O'; };
  const auto small = [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); };
  if (error.span.begin < s.offset) return false;
  size_t from = error.span.begin - s.offset;
  if (from >= line.size() || s.keyword != Keyword::kUnknown) return false;
  if (is_o(line[from])) {
    // `X1O`, right behind a digit, and no label behind it that more than one digit would make.
    const char before = from == 0 ? ' ' : line[from - 1];
    if (error.kind != StopKind::kWordBefore || (!is_digit(before) && before != '.')) return false;
  } else {
    // `GO X1`: a word's letter and an O.
    const bool kind = error.kind == StopKind::kWordUnreadable || error.kind == StopKind::kNumberMissing ||
        error.kind == StopKind::kNumberMalformed;
    if (!kind || !is_small_letter(small(line[from])) || from + 1 >= line.size() || !is_o(line[from + 1])) return false;
    ++from;
  }
  // Behind it a digit, a point, nothing, or another word with its number, which may have that mistake, too; not text: `MOD 2`,
  // `GO TO 20`.
  const size_t other = line.find_first_not_of("oO", from);
  const std::string_view behind = line.substr(std::min(other, line.size()));
  const char next = behind.empty() ? ' ' : small(behind[0]);
  if (is_small_letter(next) && (behind.size() < 2 || is_small_letter(small(behind[1])) || behind[1] == ' '))
    return false;
  if (small_letters(line.substr(from - 1)).starts_with("mod")) return false;
  if (!is_digit(next) && next != '.' && !begins_word(behind)) return false;
  *at = s.offset + from;
  return true;
}

bool writes_letter_for_one(const Program& program, const Statement& s, const LineError& error) {
  const bool kind = error.kind == StopKind::kWordUnreadable || error.kind == StopKind::kNumberMissing;
  if (!kind || error.span.begin < s.offset) return false;
  const std::string text = small_letters(program.source->slice({error.span.begin, s.end()}));
  return text.size() > 1 && (text[0] == 'g' || text[0] == 'm') && (text[1] == 'l' || text[1] == 'i') &&
      (text.size() == 2 || !is_small_letter(text[2]));
}

}  // namespace owlint::rules
