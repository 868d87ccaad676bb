// The catalogue: every rule, in the order of the codes. A new rule is added here and nowhere else.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "rules/driver/stops.h"

namespace owlint {
namespace rules {

extern const Rule kOw001;
extern const Rule kOw002;
extern const Rule kOw101;
extern const Rule kOw102;
extern const Rule kOw103;
extern const Rule kOw104;
extern const Rule kOw105;
extern const Rule kOw106;
extern const Rule kOw107;
extern const Rule kOw108;
extern const Rule kOw201;
extern const Rule kOw202;
extern const Rule kOw203;
extern const Rule kOw204;
extern const Rule kOw205;
extern const Rule kOw206;
extern const Rule kOw207;
extern const Rule kOw208;
extern const Rule kOw209;
extern const Rule kOw210;
extern const Rule kOw211;
extern const Rule kOw212;
extern const Rule kOw213;
extern const Rule kOw214;
extern const Rule kOw215;
extern const Rule kOw216;
extern const Rule kOw217;
extern const Rule kOw218;
extern const Rule kOw301;
extern const Rule kOw302;
extern const Rule kOw303;
extern const Rule kOw304;
extern const Rule kOw305;
extern const Rule kOw306;
extern const Rule kOw307;
extern const Rule kOw308;
extern const Rule kOw309;
extern const Rule kOw310;
extern const Rule kOw311;
extern const Rule kOw312;
extern const Rule kOw313;
extern const Rule kOw314;
extern const Rule kOw315;
extern const Rule kOw316;
extern const Rule kOw317;
extern const Rule kOw318;
extern const Rule kOw319;
extern const Rule kOw401;
extern const Rule kOw402;
extern const Rule kOw403;
extern const Rule kOw404;
extern const Rule kOw405;
extern const Rule kOw406;
extern const Rule kOw407;
extern const Rule kOw408;
extern const Rule kOw409;
extern const Rule kOw410;
extern const Rule kOw411;
extern const Rule kOw501;
extern const Rule kOw502;
extern const Rule kOw503;
extern const Rule kOw504;
extern const Rule kOw505;
extern const Rule kOw506;
extern const Rule kOw507;
extern const Rule kOw508;
extern const Rule kOw509;
extern const Rule kOw510;
extern const Rule kOw511;
extern const Rule kOw512;
extern const Rule kOw513;
extern const Rule kOw601;
extern const Rule kOw602;
extern const Rule kOw603;
extern const Rule kOw604;
extern const Rule kOw605;
extern const Rule kOw606;
extern const Rule kOw607;
extern const Rule kOw608;
extern const Rule kOw609;
extern const Rule kOw610;
extern const Rule kOw611;
extern const Rule kOw612;

}  // namespace rules

namespace {

constexpr std::array<std::string_view, 7> kGroupTitles = {
    "comments for owlint", "LinuxCNC's documented O-word errors", "blocks and calls", "the line", "files and machine configuration",
    "hazards", "parameters"};

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
      &kOw001,
      &kOw002,
      &kOw101,
      &kOw102,
      &kOw103,
      &kOw104,
      &kOw105,
      &kOw106,
      &kOw107,
      &kOw108,
      &kOw201,
      &kOw202,
      &kOw203,
      &kOw204,
      &kOw205,
      &kOw206,
      &kOw207,
      &kOw208,
      &kOw209,
      &kOw210,
      &kOw211,
      &kOw212,
      &kOw213,
      &kOw214,
      &kOw215,
      &kOw216,
      &kOw217,
      &kOw218,
      &kOw301,
      &kOw302,
      &kOw303,
      &kOw304,
      &kOw305,
      &kOw306,
      &kOw307,
      &kOw308,
      &kOw309,
      &kOw310,
      &kOw311,
      &kOw312,
      &kOw313,
      &kOw314,
      &kOw315,
      &kOw316,
      &kOw317,
      &kOw318,
      &kOw319,
      &kOw401,
      &kOw402,
      &kOw403,
      &kOw404,
      &kOw405,
      &kOw406,
      &kOw407,
      &kOw408,
      &kOw409,
      &kOw410,
      &kOw411,
      &kOw501,
      &kOw502,
      &kOw503,
      &kOw504,
      &kOw505,
      &kOw506,
      &kOw507,
      &kOw508,
      &kOw509,
      &kOw510,
      &kOw511,
      &kOw512,
      &kOw513,
      &kOw601,
      &kOw602,
      &kOw603,
      &kOw604,
      &kOw605,
      &kOw606,
      &kOw607,
      &kOw608,
      &kOw609,
      &kOw610,
      &kOw611,
      &kOw612,
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
  return fmt::format("there is no rule `{}`{}", text, near.empty() ? "; `owlint rules` lists them" : fmt::format(", did you mean `{}`?", near));
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
  for (const Rule* rule : catalogue()) candidates.emplace_back(code ? small_letters(rule->code) : std::string(rule->name));
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
