// Lists of small numbers, one after the other in one array: for example the lines by label, or the lines by sub. A vector
// of vectors would need an allocation for each of a million labels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace owlint {

class Grouped {
 public:
  /// Groups the items 0 to `count` by `group_of(item)`, a number below `groups`, or kNone to leave it out. In a group
  /// the items keep their order.
  static constexpr uint32_t kNone = UINT32_MAX;
  template <typename GroupOf>
  void assign(size_t groups, uint32_t count, const GroupOf& group_of) {
    first_.assign(groups + 1, 0);
    for (uint32_t item = 0; item < count; ++item) {
      if (const uint32_t group = group_of(item); group != kNone) ++first_[group + 1];
    }
    for (size_t i = 1; i <= groups; ++i) first_[i] += first_[i - 1];
    items_.resize(first_[groups]);
    // Filling moves each group's start to its end, which is the start of the next: shifted back afterwards.
    for (uint32_t item = 0; item < count; ++item) {
      if (const uint32_t group = group_of(item); group != kNone) items_[first_[group]++] = item;
    }
    for (size_t i = groups; i > 0; --i) first_[i] = first_[i - 1];
    first_[0] = 0;
  }

  size_t size() const { return first_.empty() ? 0 : first_.size() - 1; }
  /// All items, group after group, and the index of a group's first item.
  std::span<const uint32_t> all() const { return items_; }
  size_t first(size_t group) const { return first_[group]; }
  std::span<const uint32_t> operator[](size_t group) const {
    return {items_.data() + first_[group], first_[group + 1] - first_[group]};
  }

 private:
  std::vector<uint32_t> first_;  // of group i the items [first_[i], first_[i + 1])
  std::vector<uint32_t> items_;
};

}  // namespace owlint
