// Idioms in labels: a zero and the letter O in each other's place, and a sign behind the label or in the keyword.
#include <algorithm>

#include "analyzer/syntax/known_line.h"
#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

/// The keyword that a text is, with nothing but brackets or a comment behind it.
Keyword whole_keyword(std::string_view text) {
  const Keyword keyword = keyword_of(text);
  if (keyword == Keyword::kUnknown) return keyword;
  const std::string_view behind = text.substr(spelling(keyword).size());
  return behind.empty() || !is_small_letter(behind[0]) ? keyword : Keyword::kUnknown;
}

/// A number with the letter O in place of a zero, and the keyword behind it.
struct MixedLabel {
  size_t from = 0, to = 0;  ///< without the letter of the O-word
  Keyword keyword = Keyword::kUnknown;
  std::string number;
};

std::optional<MixedLabel> mixed_label(std::string_view text) {
  const size_t letter = text.find('o');
  if (letter == std::string_view::npos) return std::nullopt;
  MixedLabel label;
  label.from = label.to = letter + 1;
  while (label.to < text.size() && (is_digit(text[label.to]) || text[label.to] == 'o')) ++label.to;
  label.number = text.substr(label.from, label.to - label.from);
  label.keyword = whole_keyword(text.substr(label.to));
  if (label.keyword == Keyword::kUnknown || label.number.find('o') == std::string::npos ||
      std::ranges::none_of(label.number, is_digit))
    return std::nullopt;
  std::ranges::replace(label.number, 'o', '0');
  return label;
}

/// `100` of `00100`.
std::string without_zeros(std::string label) {
  label.erase(0, std::min(label.find_first_not_of('0'), label.size() - 1));
  return label;
}

/// Whether an O-word with this label is elsewhere in the program.
bool has_label(const RefusedLine& line, const std::string& label) {
  const NameId id = line.program.syntax.names.find(without_zeros(label));
  return id != kNoName && std::ranges::any_of(line.program.by_label[id], [&](StatementId other) {
           return other != line.id && !line.program.at(other).is(Keyword::kBare);
         });
}

}  // namespace

NameId mistyped_label(const Program& program, StatementId id) {
  const Statement& s = program.at(id);
  const LineError* const error = program.syntax.error(s);
  if (error == nullptr || s.kind != LineKind::kOWord || s.length > kLineLimit || s.nul) return kNoName;
  const bool forgotten = error->kind == StopKind::kLabelForgotten;
  if (error->kind != StopKind::kKeywordUnknown && !forgotten) return kNoName;
  LineText line;
  line.assign(program.source->slice(s.whole()), s.offset);
  const std::string_view text = line.text().substr(0, std::min(line.text().find_first_of("(;"), line.size()));
  if (!forgotten) {
    const std::optional<MixedLabel> label = mixed_label(text);
    return label ? program.syntax.names.find(without_zeros(label->number)) : kNoName;
  }
  // `N100 100 if`: behind the blank.
  size_t to = text.find('n') + 1;
  size_t from = to;
  for (; to < text.size() && is_digit(text[to]); ++to) {
    if (line.offset(to) > line.offset(to - 1) + 1) from = to;
  }
  return from == text.find('n') + 1
      ? kNoName
      : program.syntax.names.find(without_zeros(std::string(text.substr(from, to - from))));
}

/// `o1o0 endif`, `o1OO if [1]`: the letter O typed for a zero.
bool has_letter_in_label(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kKeywordUnknown && line.kind() != StopKind::kLabelWord) return false;
  const std::optional<MixedLabel> label = mixed_label(line.text.text().substr(0, line.end));
  if (!label || label->from > line.at + 1) return false;
  const bool known = has_label(line, label->number);
  if (!known && line.kind() == StopKind::kLabelWord) return false;  // perhaps a name without `< >`
  f.message = "the label has the letter `O` in place of a zero";
  f.help = "write `o" + label->number + " " + std::string(spelling(label->keyword)) + "`";
  line.propose(f, f.help, {line.put(label->from, label->to, label->number)},
               known && label->keyword != Keyword::kSub && label->keyword != Keyword::kEndsub);
  return true;
}

std::string label_meant(const RefusedLine& line, Keyword keyword) {
  constexpr size_t kMost = 1000;  // mistakes that are looked through
  const Program& p = line.program;
  const BlockId block = p.block_of[line.id];
  if (block != kNoBlock && p.blocks[block].opener != line.id) return p.label_text(p.blocks[block].label);
  const StatementId sub = p.regions[p.region_of[line.id]].opener;
  if ((keyword == Keyword::kEndsub || keyword == Keyword::kReturn) && sub != kNoStatement &&
      p.at(sub).is(Keyword::kSub))
    return p.label_at(sub);
  const Index& index = line.in.index;
  if (index.openers.size() + index.subs.size() > kMost) return {};
  for (const auto& [label, opener] : index.openers) {
    if (opener == line.id) return p.label_text(label.second);
  }
  for (const auto& [label, opener] : index.subs) {
    if (opener == line.id) return p.label_text(label);
  }
  return {};
}

/// `o100: if [1]`, `o100, if [1]`, `o100-endif`, `o100 _if [1]`.
bool has_sign_behind_label(const RefusedLine& line, Finding& f) {
  const std::string_view rest = line.rest();
  if (line.kind() != StopKind::kKeywordUnknown || rest.empty() ||
      std::string_view(":,-_./").find(rest[0]) == std::string_view::npos)
    return false;
  const Keyword keyword = whole_keyword(rest.substr(1));
  if (keyword == Keyword::kUnknown) return false;
  const std::string sign(rest.substr(0, 1));
  f.message = "a `" + sign + "` between the label and its keyword";
  f.help = "remove the `" + sign + "`";
  line.propose(f, f.help, {line.put(line.at, line.at + 1, line.apart(line.at + 1) ? "" : " ")},
               keyword != Keyword::kSub && keyword != Keyword::kEndsub);
  return true;
}

/// `o100 else-if [1]`, `o100 end-if`, `o100 end_while`.
bool divides_keyword(const RefusedLine& line, Finding& f) {
  const bool behind = line.kind() == StopKind::kTrailingText && line.statement.keyword_to == line.statement.rest_from;
  if (!behind && line.kind() != StopKind::kKeywordUnknown) return false;
  const size_t from = line.at - (behind ? line.keyword_text().size() : 0);
  const std::string_view text = line.text.text().substr(0, line.end);
  const size_t to = std::min(text.find('[', from), text.size());
  std::string word(text.substr(from, to - from));
  std::erase_if(word, [](char c) { return std::string_view("-_./").find(c) != std::string_view::npos; });
  const Keyword keyword = keyword_of(word);
  if (to - from == word.size() || spelling(keyword) != word) return false;
  const bool takes_value = keyword == Keyword::kElseif;
  if (takes_value != (to < text.size())) return false;
  const std::string right = line.program.label_at(line.id) + " " + word;
  f.message = "`" + line.written(from, to) + "` is not the keyword `" + word + "`";
  f.help = "write `" + right + (takes_value ? " " + line.written(to, line.end) : "") + "`";
  line.propose(f, "write `" + word + "`", {{{line.text.offset(from), line.text.span(to - 1, to).end}, word}},
               !takes_value && keyword != Keyword::kEndsub);
  return true;
}

/// `o1 if [#1 EQ 1]:`, `o1 else: G0 X1`.
bool ends_with_colon(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kTrailingText || !line.rest().starts_with(":") || line.has_keyword(Keyword::kBare) ||
      line.has_keyword(Keyword::kCall))
    return false;
  const std::string behind = line.at + 1 < line.end ? line.written(line.at + 1, line.end) : std::string();
  f.message = "a `:` after `" + line.program.head(line.id) + "`: LinuxCNC has a block without it";
  f.help = "remove the `:`";
  if (!behind.empty()) {
    f.help += ", and write `" + behind.substr(behind.find_first_not_of(" \t")) + "` on a line of its own";
    return true;
  }
  line.propose(f, f.help, {line.put(line.at, line.at + 1, "")}, true);
  return true;
}

/// `0100 endfi`: a zero in place of the letter, and a keyword with a slip.
bool begins_with_zero(const RefusedLine& line, Finding& f) {
  const size_t first = line.statement.block_delete ? 1 : 0;
  if (line.kind() != StopKind::kBadCharacter || line.at != first || !line.rest().starts_with("0")) return false;
  const std::string_view rest = line.rest();
  const size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
  const std::string_view behind = rest.substr(digits);
  const std::string word(
      behind.substr(0, std::min(behind.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), behind.size())));
  if (digits < 2 || word.size() < 2) return false;
  const std::string near = nearest(word, {kKeywordSpellings.begin(), kKeywordSpellings.end()});
  if (near.empty()) return false;
  const std::string right = "o" + line.written(line.at + 1, line.at + digits) + " " + near;
  f.message = "this O-word begins with the digit zero instead of the letter O";
  f.help = "write `" + right + "`";
  line.propose(f, f.help, {line.put(line.at, line.at + digits + word.size(), right)}, false);
  return true;
}

namespace {

/// `N10 if [1]` … `N30 endif`: one label for the lines of a block that have a line number in its place. All are changed
/// together: line numbers rise, and no two of these lines have the same.
bool label_block(const RefusedLine& line, Finding& f) {
  constexpr StatementId kLargest = 2000;  // a block that is corrected as a whole
  const Program& p = line.program;
  const BlockId id = p.block_of[line.id];
  const Block& block = p.blocks[id];
  const std::string label = p.label_text(block.label);
  const StatementId end = block.end == kNoStatement ? block.mistaken_end : block.end;
  f.help = "write `" + label + " " + line.keyword_text() + "`";
  if (line.id != block.opener) {
    f.help += ", for the block on line " + std::to_string(p.at(block.opener).line);
  }
  if (end == kNoStatement || end - block.opener > kLargest || end < line.id) return true;
  std::vector<Edit> edits;
  bool free = true;  // no line of another block has the label
  for (StatementId at = block.opener; at <= end; ++at) {
    const LineError* const error = p.syntax.error(p.at(at));
    const bool numbered =
        error != nullptr && error->kind == StopKind::kLabelForgotten && p.at(at).kind == LineKind::kOWord;
    if (p.block_of[at] == id && numbered) edits.push_back({p.at(at).label_span(), label});
  }
  for (const StatementId at : p.by_label[block.label]) free = free && p.block_of[at] == id;
  line.propose(f, "write the label `" + label + "`", {{line.statement.label_span(), label}}, free);
  f.fixes[0].title += edits.size() > 1 ? " on all lines of the block" : "";
  f.fixes[0].edits = std::move(edits);
  return true;
}

/// `IF [#1 EQ 2] G0 X1`: a block on one line, without its label.
bool tests_and_acts(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const size_t open = line.at + line.keyword_text().size();
  if (!line.has_keyword(Keyword::kIf) || open >= text.size() || text[open] != '[') return false;
  const std::optional<size_t> behind = behind_bracket(text, open);
  if (!behind || *behind >= line.end) return false;
  const std::string act = line.written(*behind, line.end);
  if (surely_refused(act)) return false;
  const std::string label = with_free_label(line.in, "o100 ");
  f.help = "write `" + label + "if " + line.written(open, *behind) + "`, `" + act + "` and `" + label +
      "endif` on three lines";
  return true;
}

}  // namespace

/// `endif`, `N100 sub`: a keyword without its label.
bool lacks_label(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kLabelForgotten) return false;
  const Program& p = line.program;
  const std::string word = line.keyword_text();
  if (line.statement.kind == LineKind::kOWord) {  // the line number was read in place of the label
    const size_t number = line.text.text().find('n');
    size_t second = number + 2;
    while (second < line.at && !line.apart(second)) ++second;
    if (second < line.at) {  // `N100 100 if`
      const std::string right = "o" + line.written(second, line.at);
      f.message = "the letter `o` is missing before the label";
      f.help = "write `" + right + " " + word + "`";
      const uint64_t begin = line.text.offset(second);
      line.propose(f, "write the letter `o`", {{{begin, begin}, "o"}}, !bounds_sub(line.statement));
      return true;
    }
    f.message =
        "the `o…` label is missing before `" + word + "`: `" + line.written(number, line.at) + "` is a line number";
    f.help = "write `" + p.head(line.id) + "`";
    if (p.block_of[line.id] != kNoBlock) return label_block(line, f);
    line.propose(f, "write `o` instead of `N`", {line.put(number, number + 1, "o")}, !bounds_sub(line.statement));
    return true;
  }
  f.message = "the `o…` label is missing before `" + word + "`";
  const std::string below = label_meant(line, line.statement.keyword);
  const bool begins = opens_block(line.statement.keyword) && p.block_of[line.id] == kNoBlock;
  f.help = "write the label first: `" +
      (!below.empty() ? below
           : begins   ? free_label_for(line.in)
                      : "o100") +
      " " + word + "`" + (begins && below.empty() ? ", and the same label on all lines of the block" : "");
  if (below.empty() && tests_and_acts(line, f)) return true;
  const BlockId block = p.block_of[line.id];
  const Region& region = p.regions[p.region_of[line.id]];
  const bool of_sub = line.has_keyword(Keyword::kEndsub) || line.has_keyword(Keyword::kReturn);
  const StatementId opener = block != kNoBlock ? p.blocks[block].opener : of_sub ? region.opener : kNoStatement;
  if (opener == kNoStatement) {
    if ((line.has_keyword(Keyword::kSub) && below.empty()) || line.has_keyword(Keyword::kCall))
      f.help = "write the label first: `o<name> " + word + "`";
    return true;
  }
  const std::string label = p.label_at(opener);
  f.help =
      "write `" + label + " " + word + "`, for `" + p.head(opener) + "` on line " + std::to_string(p.at(opener).line);
  relate(f, p, opener, "`" + p.head(opener) + "` begins here");
  const bool ends = block != kNoBlock && p.blocks[block].mistaken_end == line.id;
  line.propose(f, "write the label `" + label + "`", {line.put(line.at, line.at, label + " ")}, ends);
  return true;
}

}  // namespace owlint::rules
