#include "rules/driver/idioms.h"

#include <algorithm>

#include "analyzer/syntax/known_line.h"

namespace owlint::rules {
namespace {

// The first one that fits is taken.
constexpr Idiom kIdioms[] = {
    comes_before_percent,
    quotes_name,
    prints_text,
    has_thousands_mark,
    quotes_text,
    has_look_alike,
    has_letter_for_digit,
    has_exponent_in_parameter,
    begins_with_zero,
    has_letter_in_label,
    has_sign_behind_label,
    divides_keyword,
    numbers_block_delete,
    continues_with_if,
    names_sub_arguments,
    ends_with_colon,
    jumps,
    loops_as_fanuc,
    says_then,
    ends_as_shell,
    jumps_behind_keyword,
    has_percent,
    has_other_comment,
    has_braces,
    has_two_brackets,
    has_comment_inside,
    brackets_behind_keyword,
    tests_behind_do,
    has_not_before_bracket,
    rounds_brackets,
    repeats_until,
    passes_without_brackets,
    passes_words,
    divides_arguments,
    calls_without_keyword,
    calls_by_name,
    names_contour,
    lacks_letter,
    lacks_label,
    has_label_behind,
    labels_with_word,
    has_words_behind_label,
    misspells_keyword,
    has_letters_in_number,
    has_exponent,
    is_no_number,
    has_unit,
    assigns_word_as_siemens,
    moves_as_heidenhain,
    is_other_controllers_word,
    assigns_to_word,
    changes_in_place,
    lacks_bracket_of_number,
    names_in_other_brackets,
    has_comma,
    calls_in_value,
    calls_m98_in_value,
    names_arguments,
    has_comment_in_value,
    calls_function_in_round,
    calls_function_behind_letter,
    has_checksum,
    has_slash_inside,
    computes_across_comment,
    computes_without_brackets,
    assigns_otherwise,
    lacks_equal,
    lacks_value,
    brackets_whole_word,
    lacks_letter_of_value,
    lacks_closing_bracket,
    assigns_twice,
    assigns_to_number,
    names_without_brackets,
    names_half_bracketed,
    names_without_number_sign,
    has_other_operator,
    compares_nothing,
    has_dollar,
    names_axis,
    has_other_function,
    has_odd_sign,
    is_other_word,
};

}  // namespace

RefusedLine::RefusedLine(const Input& input, StatementId statement_id)
    : program(input.program),
      in(input),
      statement(program.at(statement_id)),
      id(statement_id),
      error(*program.syntax.error(statement)) {
  text.assign(program.source->slice(statement.whole()), statement.offset);
  while (at < text.size() && text.offset(at) < error.span.begin) ++at;
  end = std::min(text.text().find_first_of("(;", at), text.size());
}

std::string RefusedLine::written(size_t from, size_t to) const {
  return std::string(program.source->slice(text.span(from, to)));
}

std::string_view RefusedLine::first_word() const {
  const std::string_view behind = rest();
  return behind.substr(0, std::min(behind.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), behind.size()));
}

bool RefusedLine::is_parameter(std::string_view name) const {
  constexpr size_t kMost = 20'000;  // values of a program that are asked: the name may be the label of a sub only
  const NameId id_of_name = program.syntax.names.find(name);
  if (id_of_name == kNoName) return false;
  const auto first_items = std::span(program.syntax.items).first(std::min(kMost, program.syntax.items.size()));
  if (std::ranges::find(first_items, id_of_name, &Item::target_name) != first_items.end()) return true;
  const size_t values = std::min<size_t>(kMost, program.syntax.exprs.size());
  for (ExprId value = 0; value < values; ++value) {
    if (program.syntax.exprs[value].op == Operator::kNamed && program.syntax.exprs[value].name() == id_of_name)
      return true;
  }
  return false;
}

bool RefusedLine::ends_do() const {
  BlockId block = program.open_above(program.region_of[id], id);
  while (block != kNoBlock && program.blocks[block].label != statement.label) block = program.blocks[block].parent;
  return block != kNoBlock && program.blocks[block].kind == Keyword::kDo;
}

void RefusedLine::propose(Finding& f, std::string title, std::vector<Edit> edits, bool surely_meant) const {
  std::ranges::stable_sort(edits, {}, [](const Edit& e) { return e.span.begin; });
  std::string line;
  uint64_t done = statement.offset;
  for (const Edit& edit : edits) {
    line.append(program.source->slice({done, edit.span.begin})).append(edit.text);
    done = edit.span.end;
  }
  line.append(program.source->slice({done, statement.end()}));
  if (statement.block_delete) line.erase(0, line.find('/') + 1);
  const bool safe = surely_meant && surely_runs(line) && calls_known_subs(in, line);
  f.fixes = {{std::move(title), safe, std::move(edits), true}};
}

bool calls_known_subs(const Input& in, const std::string& line) {
  const Program& p = in.program;
  const Syntax syntax = scan(*Source::own("", line + "\n"));
  return std::ranges::all_of(syntax.statements, [&](const Statement& s) {
    if (!s.calls() || s.label == kNoName) return true;
    const std::string& name = syntax.names.text(s.label);
    const NameId label = p.syntax.names.find(name);
    if (label != kNoName && in.index.subs.contains(label)) return true;
    const auto lines = label == kNoName ? std::span<const StatementId>() : p.by_label[label];
    return std::ranges::any_of(lines, [&](StatementId id) { return p.at(id).opens_sub(); }) ||
        in.linked.search_path().find(name).has_value();
  });
}

void explain_idiom(const Input& in, StatementId statement, Finding& finding) {
  const LineError* error = in.program.syntax.error(in.program.at(statement));
  // Longer lines are not looked into, nor is what a NUL or a carriage return makes of a line.
  const Statement& s = in.program.at(statement);
  if (error == nullptr || error->kind == StopKind::kLineTooLong || s.nul || s.inner_cr || s.length > kLineLimit) return;
  const RefusedLine line(in, statement);
  Finding explained;
  for (const Idiom idiom : kIdioms) {
    if (!idiom(line, explained)) continue;
    finding.message = std::move(explained.message);
    finding.help = std::move(explained.help);
    finding.fixes = std::move(explained.fixes);
    return;
  }
}

}  // namespace owlint::rules
