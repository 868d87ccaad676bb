// Interned strings: label and parameter names become small numbers, so that later rooms
// do not compare or hash text.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace owlint {

using NameId = uint32_t;
inline constexpr NameId kNoName = UINT32_MAX;

class Names {
 public:
  NameId intern(std::string_view text) {
    if (const uint32_t number = number_of(text); number != kNoNumber) return intern_number(number);
    NameId& recent = recent_[slot(text)];
    if (recent != kNoName && texts_[recent] == text) return recent;
    auto found = ids_.find(text);
    if (found == ids_.end()) {
      const NameId id = add(std::string(text));
      found = ids_.emplace(texts_[id], id).first;
    }
    return recent = found->second;
  }

  /// The same as interning the number's decimal text.
  NameId intern_number(uint32_t number) {
    if (number >= kNumbers) return intern(std::to_string(number));
    if (number >= numbers_.size())
      numbers_.resize(std::min<size_t>(kNumbers, std::max<size_t>(number + 1, numbers_.size() * 2)), kNoName);
    if (numbers_[number] == kNoName) numbers_[number] = add(std::to_string(number));
    return numbers_[number];
  }

  /// The id of a text that was interned before, or kNoName.
  NameId find(std::string_view text) const {
    if (const uint32_t number = number_of(text); number != kNoNumber)
      return number < numbers_.size() ? numbers_[number] : kNoName;
    const auto found = ids_.find(text);
    return found == ids_.end() ? kNoName : found->second;
  }

  const std::string& text(NameId id) const { return texts_[id]; }
  size_t size() const { return texts_.size(); }

 private:
  // Labels are mostly numbers, and a program may have a million: those below this have a table of their own.
  static constexpr uint32_t kNumbers = 1'000'000;
  static constexpr uint32_t kNoNumber = UINT32_MAX;

  /// The number below kNumbers that `text` is, written as std::to_string writes it.
  static uint32_t number_of(std::string_view text) {
    constexpr size_t kDigits = 6;
    if (text.empty() || text.size() > kDigits || (text[0] == '0' && text.size() > 1)) return kNoNumber;
    uint32_t number = 0;
    for (const char c : text) {
      if (c < '0' || c > '9') return kNoNumber;
      number = number * 10 + static_cast<uint32_t>(c - '0');
    }
    return number;
  }

  static size_t slot(std::string_view text) {
    if (text.empty()) return 0;
    return (text.size() * 5 + size_t{3} * static_cast<unsigned char>(text.front()) +
            static_cast<unsigned char>(text.back())) %
        kRecent;
  }

  NameId add(std::string text) {
    texts_.push_back(std::move(text));
    return static_cast<NameId>(texts_.size() - 1);
  }

  std::deque<std::string> texts_;  // a deque: the map's keys point into it
  std::unordered_map<std::string_view, NameId> ids_;
  std::vector<NameId> numbers_;  // by number
  // Recent names: most come again soon, and this is faster than hashing them.
  static constexpr size_t kRecent = 64;
  std::array<NameId, kRecent> recent_ = nothing();
  static constexpr std::array<NameId, kRecent> nothing() {
    std::array<NameId, kRecent> none{};
    none.fill(kNoName);
    return none;
  }
};

}  // namespace owlint
