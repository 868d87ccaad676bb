// Interned strings: label and parameter names become small numbers, so that nothing after the syntax room
// compares or hashes text.
#pragma once

#include <algorithm>
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
    if (const auto found = ids_.find(text); found != ids_.end()) return found->second;
    const auto id = static_cast<NameId>(texts_.size());
    ids_.emplace(texts_.emplace_back(text), id);
    return id;
  }

  /// The same as interning the number's decimal text, without writing it for numbers that are known already.
  NameId intern_number(uint32_t number) {
    constexpr uint32_t kLargest = 1 << 20;  // beyond that nobody numbers labels
    if (number >= kLargest) return intern(std::to_string(number));
    if (number >= numbers_.size()) numbers_.resize(std::max<size_t>(number + 1, numbers_.size() * 2), kNoName);
    if (numbers_[number] == kNoName) numbers_[number] = intern(std::to_string(number));
    return numbers_[number];
  }

  /// The id of a text that was interned before, or kNoName.
  NameId find(std::string_view text) const {
    const auto found = ids_.find(text);
    return found == ids_.end() ? kNoName : found->second;
  }

  const std::string& text(NameId id) const { return texts_[id]; }
  size_t size() const { return texts_.size(); }

 private:
  std::deque<std::string> texts_;  // a deque: the map's keys point into it
  std::unordered_map<std::string_view, NameId> ids_;
  std::vector<NameId> numbers_;  // by number
};

}  // namespace owlint
