// The catalogue: every rule, in the order of the codes. Its list is made from the names of the rules' files (cmake/rules.cmake).
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "rules/driver/stops.h"

namespace owlint {
namespace rules {

#define OWLINT_RULE(code)  \
  namespace code {         \
  extern const Rule kRule; \
  }
#include "generated/catalogue.inc"
#undef OWLINT_RULE

}  // namespace rules

namespace {

constexpr std::array<std::string_view, 10> kGroupTitles = {"comments for owlint",
                                                           "LinuxCNC's documented O-word errors",
                                                           "blocks and calls",
                                                           "the line",
                                                           "files and machine configuration",
                                                           "hazards",
                                                           "parameters",
                                                           "words of a line",
                                                           "the machine's modes",
                                                           "geometry"};

std::string capital_letters(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return out;
}

bool begins_as_code(std::string_view text) { return capital_letters(text.substr(0, 2)) == "OW"; }

}  // namespace

std::string_view group_title(Group group) { return kGroupTitles[static_cast<size_t>(group)]; }

const std::vector<const Rule*>& catalogue() {
  using namespace rules;
  static const std::vector<const Rule*> all = {
#define OWLINT_RULE(code) &code::kRule,
#include "generated/catalogue.inc"
#undef OWLINT_RULE
  };
  return all;
}

const Rule* find_rule(std::string_view code_or_name) {
  const std::string wanted = small_letters(code_or_name);
  for (const Rule* rule : catalogue()) {
    if (wanted == small_letters(rule->code) || wanted == rule->name) return rule;
  }
  return nullptr;
}

const Rule& rule_of(const Finding& finding) {
  return **std::ranges::lower_bound(catalogue(), finding.code, {}, &Rule::code);
}

bool known_prefix(std::string_view prefix) {
  return std::ranges::any_of(catalogue(), [prefix](const Rule* rule) { return rule->code.starts_with(prefix); });
}

std::string code_meant(std::string_view text) {
  if (const Rule* rule = find_rule(text)) return std::string(rule->code);
  const std::string prefix = capital_letters(text);
  return prefix.starts_with("OW") && known_prefix(prefix) ? prefix : std::string();
}

std::string unknown_rule(std::string_view text) {
  const std::string_view near = nearest_rule(text);
  return fmt::format("there is no rule `{}`{}", text,
                     near.empty() ? "; `owlint rules` lists them" : fmt::format(", did you mean `{}`?", near));
}

std::optional<std::string> suppressed_code(std::string_view word, bool first) {
  if (std::string code = code_meant(word); !code.empty()) return code;
  const bool like_code = begins_as_code(word) && word.find_first_of("0123456789") != std::string_view::npos;
  const bool like_name = word.find('-') != std::string_view::npos && !nearest_rule(word).empty();
  if (first || like_code || like_name) return like_code ? capital_letters(word) : std::string(word);
  return std::nullopt;
}

std::string_view nearest_rule(std::string_view text) {
  std::vector<std::string> candidates;
  const bool code = begins_as_code(text);
  for (const Rule* rule : catalogue())
    candidates.emplace_back(code ? small_letters(rule->code) : std::string(rule->name));
  const std::string near = rules::nearest(small_letters(text), candidates);
  const Rule* rule = near.empty() ? nullptr : find_rule(near);
  if (rule == nullptr) return {};
  return code ? rule->code : rule->name;
}

Finding& Reporter::add(Span span, std::string message) {
  Finding& finding = findings_.emplace_back();
  finding.code = rule_.code;
  finding.rule = rule_.name;
  finding.span = span;
  finding.message = std::move(message);
  return finding;
}

Finding& Reporter::add(std::shared_ptr<const Source> source, Span span, std::string message) {
  Finding& finding = add(span, std::move(message));
  finding.source = std::move(source);
  return finding;
}

}  // namespace owlint
