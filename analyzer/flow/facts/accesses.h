// Which parameters lines read, and which they then assign.
#pragma once

#include <span>
#include <vector>

#include "analyzer/flow/domain/parameters.h"
#include "analyzer/program/program.h"

namespace owlint::flow {

/// A parameter as a key: the keys of parameters.h, with kGlobalKey for globals.
using ParameterKey = uint64_t;
inline constexpr ParameterKey kGlobalKey = 1ULL << 32;
inline constexpr ParameterKey kComputedKey = UINT64_MAX;  ///< a number that is known only at run time

inline bool is_global(ParameterKey key) { return (key & kGlobalKey) != 0; }
/// #1 to #30.
inline bool is_own_number(ParameterKey key) { return key < kFirstGlobalNumber; }
ParameterKey key_of_name(const Syntax& syntax, NameId name);
/// Of `#n`, by the expression of its number.
ParameterKey key_of_number(const Syntax& syntax, ExprId number);
/// Of the parameter that an item assigns, if it assigns one.
inline bool assigns(const Item& item) { return item.target_name != kNoName || item.target != kNoExpr; }
ParameterKey key_of_target(const Syntax& syntax, const Item& item);
ParameterId parameter_of(ParameterKey key);

/// An assignment to a parameter.
struct Write {
  ParameterKey key;
  uint32_t item;  ///< of the statement's items
};

/// A parameter that a comment reads, counted as read by a statement (see shown.h).
struct ShownRead {
  StatementId statement;
  ParameterKey key;
};

/// What the lines of a sub read and assign: a part of an AccessTable, which has to outlive it.
class Accesses {
 public:
  std::span<const ParameterKey> reads(size_t line) const {
    return reads_.subspan(first_read(line), first_read(line + 1) - first_read(line));
  }
  std::span<const Write> writes(size_t line) const {
    return writes_.subspan(first_write(line), first_write(line + 1) - first_write(line));
  }
  /// The index of a line's first read; `line` may be one past the last.
  uint32_t first_read(size_t line) const { return first_read_[line] - first_read_[0]; }
  uint32_t first_write(size_t line) const { return first_write_[line] - first_write_[0]; }
  std::span<const ParameterKey> all_reads() const { return reads_; }
  std::span<const Write> all_writes() const { return writes_; }
  /// Whether a line reads a parameter whose number is computed.
  bool reads_any(size_t line) const { return any_[line] != 0; }
  bool reads_any() const { return reads_any_; }
  bool writes_any() const { return writes_any_; }
  size_t size() const { return any_.size(); }

 private:
  friend class AccessTable;
  std::span<const ParameterKey> reads_;
  std::span<const Write> writes_;
  const uint32_t* first_read_ = nullptr;  // by line, and one more
  const uint32_t* first_write_ = nullptr;
  std::span<const uint8_t> any_;  // by line
  bool reads_any_ = false, writes_any_ = false;
};

/// What lines read and assign, one after the other.
class AccessTable {
 public:
  /// Of these lines, in their order. `shown`: what comments read as well, by statement.
  AccessTable(const Program& program, std::span<const uint32_t> statements, std::span<const ShownRead> shown = {});

  /// For `count` lines, from index `first` on.
  Accesses lines(size_t first, size_t count) const;

 private:
  void read(const Syntax& syntax, ExprId id);
  void add(const Program& program, StatementId id);
  void add_shown(std::span<const ShownRead> shown, StatementId id);

  std::vector<ParameterKey> reads_;
  std::vector<Write> writes_;
  std::vector<uint32_t> first_read_, first_write_;  // by line, and one more
  std::vector<uint8_t> any_;
};

}  // namespace owlint::flow
