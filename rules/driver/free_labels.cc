// Numbers for labels that no O-word of a program has.
#include <optional>

#include "rules/driver/idioms.h"
#include "rules/driver/stops.h"

namespace owlint::rules {
namespace {

bool is_used(const Program& program, long number) {
  const NameId id = program.syntax.names.find(std::to_string(number));
  return id != kNoName && id < program.by_label.size() && !program.by_label[id].empty();
}

/// The first number from `first` on that nothing has yet; nothing if too many are used.
std::optional<long> first_free(const Input& in, long first) {
  constexpr long kTries = 200;
  for (long number = first; number < first + kTries; ++number) {
    if (!is_used(in.program, number) && !in.given_numbers.contains(number)) return number;
  }
  return std::nullopt;
}

constexpr long kFirst = 100;

}  // namespace

std::string free_label(const Input& in, NameId label) {
  const std::string& text = in.program.name(label);
  if (text.empty() || text.size() > 8 || text.find_first_not_of("0123456789") != std::string::npos) return {};
  const std::optional<long> number = first_free(in, std::stol(text) + 1);
  if (!number) return {};
  in.given_numbers.insert(*number);
  return "o" + std::to_string(*number);
}

std::string free_label_for(const Input& in) {
  const std::optional<long> number = first_free(in, kFirst);
  if (number) in.given_numbers.insert(*number);
  return "o" + std::to_string(number.value_or(kFirst));
}

std::string with_free_label(const Input& in, std::string advice) {
  constexpr std::string_view kExample = "o100 ";
  if (!is_used(in.program, kFirst)) return advice;
  const std::string label = "o" + std::to_string(first_free(in, kFirst + 1).value_or(kFirst)) + " ";
  for (size_t at = advice.find(kExample); at != std::string::npos; at = advice.find(kExample, at + label.size()))
    advice.replace(at, kExample.size(), label);
  return advice;
}

}  // namespace owlint::rules
