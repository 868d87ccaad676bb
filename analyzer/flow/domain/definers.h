// The domain of the label table: for each label, the first lines that it may belong to.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "analyzer/flow/domain/persistent_map.h"
#include "analyzer/flow/limits.h"
#include "analyzer/syntax/statement.h"

namespace owlint::flow {

/// A label with its scope, by its number in AbstractMachine::labels_; 0 is none.
using FullLabel = uint32_t;
inline constexpr FullLabel kNoLabel = 0;

/// Sets of first lines, packed into the values of a map from FullLabel: 0 is the set of "undefined" alone. A join is the union:
/// commutative, associative and idempotent. It keeps only the foremost Limits::kDefiners lines, and the lines of a program
/// are finitely many, so chains come to rest without widening.
class Definers {
 public:
  /// The foremost Limits::kDefiners lines, sorted.
  class Lines {
   public:
    using value_type = StatementId;
    void push_back(StatementId line) { lines_[size_++] = line; }
    StatementId front() const { return lines_[0]; }
    const StatementId* begin() const { return lines_.data(); }
    const StatementId* end() const { return lines_.data() + size_; }
    size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    void shorten() { size_ = std::min(size_, Limits::kDefiners); }

   private:
    std::array<StatementId, 2 * Limits::kDefiners> lines_{};  // room for two sets that are joined
    size_t size_ = 0;
  };
  struct Set {
    Lines lines;
    bool undefined = false;
  };
  static uint32_t one(StatementId line) { return (line + 1) << 1; }
  static constexpr uint32_t kElsewhere = 1;  ///< a sub that owlint does not know, of the calling program or of a file
  Set get(uint32_t packed) const;
  uint32_t join(uint32_t a, uint32_t b);
  /// Label by label.
  PersistentMap join(PersistentMap::Pool& pool, const PersistentMap& a, const PersistentMap& b);
  uint32_t without_undefined(uint32_t packed);

 private:
  uint32_t pack(Set set);
  std::vector<Set> sets_;
  std::unordered_map<uint64_t, uint32_t> ids_;
};

}  // namespace owlint::flow
