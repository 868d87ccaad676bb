// Numbers for labels that no O-word of a program has.
#include "rules/driver/idioms.h"
#include "rules/driver/stops.h"

namespace owlint::rules {
namespace {

bool is_used(const Program& program, long number) {
  const NameId id = program.syntax.names.find(std::to_string(number));
  return id != kNoName && id < program.by_label.size() && !program.by_label[id].empty();
}

}  // namespace

std::string free_label(const Input& in, NameId label) {
  const Program& program = in.program;
  const std::string& text = program.name(label);
  if (text.empty() || text.size() > 8 || text.find_first_not_of("0123456789") != std::string::npos) return {};
  constexpr long kTries = 200;
  for (long number = std::stol(text) + 1, last = number + kTries; number < last; ++number) {
    if (!is_used(program, number) && in.given_numbers.insert(number).second) return "o" + std::to_string(number);
  }
  return {};
}

std::string free_label_for(const Input& in) {
  constexpr long kFirst = 100, kTries = 200;
  for (long number = kFirst; number < kFirst + kTries; ++number) {
    if (!is_used(in.program, number) && in.given_numbers.insert(number).second) return "o" + std::to_string(number);
  }
  return "o" + std::to_string(kFirst);
}

std::string with_free_label(const Input& in, std::string advice) {
  constexpr std::string_view kExample = "o100 ";
  constexpr long kFirst = 100, kTries = 200;
  if (!is_used(in.program, kFirst)) return advice;
  long number = kFirst + 1;
  while (number < kFirst + kTries && (is_used(in.program, number) || in.given_numbers.contains(number))) ++number;
  const std::string label = "o" + std::to_string(number) + " ";
  for (size_t at = advice.find(kExample); at != std::string::npos; at = advice.find(kExample, at + label.size()))
    advice.replace(at, kExample.size(), label);
  return advice;
}

}  // namespace owlint::rules
