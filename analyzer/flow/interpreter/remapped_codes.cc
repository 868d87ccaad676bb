#include "analyzer/flow/interpreter/remapped_codes.h"

#include <algorithm>
#include <string>

namespace owlint::flow {
namespace {

/// M codes that are built in within their own subs, each with the group that it must be in; a bit for each but those of kStop,
/// which share one.
constexpr std::pair<int, MGroup> kOwnCodes[] = {
    {6, MGroup::kToolChange},     {61, MGroup::kToolChange},    {62, MGroup::kInputsOutputs},
    {63, MGroup::kInputsOutputs}, {64, MGroup::kInputsOutputs}, {65, MGroup::kInputsOutputs},
    {66, MGroup::kInputsOutputs}, {67, MGroup::kInputsOutputs}, {68, MGroup::kInputsOutputs},
    {0, MGroup::kStop},           {1, MGroup::kStop},           {60, MGroup::kStop}};
constexpr int kFirstOfStop = 9;
constexpr int kFirstOfCoolant = 13;  // M7, M8, M9, from 2.10 on

}  // namespace

RemappedCodes::RemappedCodes(const MachineWords& machine) : machine_(machine) {}

uint16_t RemappedCodes::own_bit(const RemappedCode& code) const {
  switch (code.letter) {
    case 't': return 1;
    case 's': return 2;
    case 'f': return 4;
    case 'm': break;
    default: return 0;
  }
  // By another name, such as M06, it is another code (measured).
  if (code.name.substr(1) != std::to_string(code.number)) return 0;
  if (code.number >= 7 && code.number <= 9) {
    const bool own = machine_.release >= Release::k2_10 && code.group == MGroup::kCoolant;
    return static_cast<uint16_t>(own ? 1U << (kFirstOfCoolant + code.number - 7) : 0);
  }
  constexpr int kFirstBit = 3;
  const auto* const own = std::ranges::find(kOwnCodes, std::pair<int, MGroup>(code.number, code.group));
  if (own == std::end(kOwnCodes)) return 0;
  return static_cast<uint16_t>(1U << (kFirstBit + std::min<ptrdiff_t>(own - kOwnCodes, kFirstOfStop)));
}

const MachineWords& RemappedCodes::words_within(uint16_t built_in) const {
  if (built_in == 0) return machine_;
  const auto [entry, added] = within_.try_emplace(built_in);
  Within& within = entry->second;
  if (!added) return within.words;
  std::ranges::copy_if(machine_.remapped, std::back_inserter(within.remapped),
                       [&](const RemappedCode& code) { return (own_bit(code) & built_in) == 0; });
  within.words = machine_;
  within.words.remapped = within.remapped;
  return within.words;
}

const RemappedCode* RemappedCodes::code_at(const Syntax& syntax, const Statement& remap, uint16_t built_in) const {
  const RemappedCode* const code = code_of_remap(syntax, remap, machine_);
  return code == nullptr || (own_bit(*code) & built_in) != 0 ? nullptr : code;
}

uint16_t RemappedCodes::built_in_within(std::string_view sub) const {
  uint16_t built_in = 0;
  for (const RemappedCode& code : machine_.remapped) {
    if (small_letters(code.sub.substr(code.sub.rfind('/') + 1)) == sub) built_in |= own_bit(code);
  }
  return built_in;
}

bool RemappedCodes::run_python() const {
  return std::ranges::any_of(machine_.remapped,
                             [](const RemappedCode& code) { return code.python_before || code.python_behind; });
}

}  // namespace owlint::flow
