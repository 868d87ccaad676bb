// A map from small integers to small integers that is cheap to copy: states share equal parts.
// Value 0 means "absent". Copies share nodes; nodes live as long as their pool.
#pragma once

#include <array>
#include <cstdint>
#include <memory_resource>
#include <new>
#include <type_traits>

namespace owlint::flow {

/// Spreads a key-value pair over 64 bits, so that the sum over a map's pairs identifies its content.
inline uint64_t mix(uint64_t key, uint64_t value) {
  uint64_t x = key * 0x9E3779B97F4A7C15ULL ^ (value + 0x632BE59BD9B4E019ULL);
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

class PersistentMap {
 public:
  struct Node {
    union {
      std::array<Node*, 16> children{};  // of inner nodes
      std::array<uint32_t, 16> values;   // of leaves; all zero means empty for both
    };
    uint32_t batch = 0;  // the batch in which it was made; 0: none
  };

  class Pool {
   public:
    Node* copy(const Node* node) {
      static_assert(std::is_trivially_destructible_v<Node>);
      Node* made = new (memory_.allocate(sizeof(Node), alignof(Node))) Node(node == nullptr ? Node{} : *node);
      made->batch = batch_;
      return made;
    }
    /// A node to write to: the same one if it was made in this batch and nothing else shares it.
    Node* own(Node* node) { return node != nullptr && batch_ != 0 && node->batch == batch_ ? node : copy(node); }

    /// While it lives, several values are set in one map, which must not be copied meanwhile: each node is copied only once.
    class Batch {
     public:
      explicit Batch(Pool& pool) : pool_(pool) { pool_.batch_ = ++pool_.batches_; }
      ~Batch() { pool_.batch_ = 0; }
      Batch(const Batch&) = delete;
      Batch& operator=(const Batch&) = delete;

     private:
      Pool& pool_;
    };

   private:
    std::pmr::monotonic_buffer_resource memory_{32 * sizeof(Node)};  // the first block; each one after it is larger
    uint32_t batch_ = 0;
    uint32_t batches_ = 0;
  };

  uint32_t get(uint32_t key) const {
    if (!fits(key)) return 0;
    const Node* node = root_;
    for (int level = height_; node != nullptr && level > 0; --level) node = node->children[digit(key, level)];
    return node == nullptr ? 0 : node->values[digit(key, 0)];
  }

  void set(Pool& pool, uint32_t key, uint32_t value) {
    const uint32_t old = get(key);
    if (old == value) return;
    while (!fits(key)) grow(pool);
    Node* node = pool.own(root_);
    root_ = node;
    for (int level = height_; level > 0; --level) {
      Node* child = pool.own(node->children[digit(key, level)]);
      node->children[digit(key, level)] = child;
      node = child;
    }
    node->values[digit(key, 0)] = value;
    rehash(key, old, value);
  }

  /// Calls `visit(key, value)` for all pairs, in the order of their keys.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    visit_node(root_, height_, 0, visit);
  }

  /// Equal content has equal hashes, in whatever order it was written. merge() takes maps with equal hashes for equal; different
  /// ones are by accident with odds of 2^-64 for each pair (see State::hash()).
  uint64_t hash() const { return hash_; }

  /// The pointwise join of two maps; `join(key, a, b)` is called where they differ. Shared parts cost nothing.
  template <typename Join>
  static PersistentMap merge(Pool& pool, PersistentMap a, PersistentMap b, const Join& join) {
    if (a.hash_ == b.hash_) return a;
    while (a.height_ < b.height_) a.grow(pool);
    while (b.height_ < a.height_) b.grow(pool);
    a.root_ = a.merge_nodes(pool, a.root_, b.root_, a.height_, 0, join);
    return a;
  }

 private:
  static uint32_t digit(uint32_t key, int level) { return (key >> (4 * level)) & 15; }
  bool fits(uint32_t key) const { return (static_cast<uint64_t>(key) >> (4 * (height_ + 1))) == 0; }

  template <typename Visit>
  static void visit_node(const Node* node, int level, uint32_t prefix, const Visit& visit) {
    if (node == nullptr) return;
    for (uint32_t i = 0; i < 16; ++i) {
      const uint32_t key = prefix * 16 + i;
      if (level > 0) {
        visit_node(node->children[i], level - 1, key, visit);
      } else if (node->values[i] != 0) {
        visit(key, node->values[i]);
      }
    }
  }

  void grow(Pool& pool) {
    if (root_ != nullptr) {
      Node* top = pool.copy(nullptr);
      top->children[0] = root_;
      root_ = top;
    }
    ++height_;
  }

  void rehash(uint32_t key, uint32_t old, uint32_t value) {
    if (old != 0) hash_ -= mix(key, old);
    if (value != 0) hash_ += mix(key, value);
  }

  // Recursion depth is the height of the tree, at most 7.
  template <typename Join>
  Node* merge_nodes(Pool& pool, Node* a, Node* b, int level, uint32_t prefix, const Join& join) {
    if (a == b) return a;
    static const Node kEmpty{};
    const Node& left = a == nullptr ? kEmpty : *a;
    const Node& right = b == nullptr ? kEmpty : *b;
    Node* out = nullptr;
    for (uint32_t i = 0; i < 16; ++i) {
      const uint32_t key = prefix * 16 + i;
      if (level > 0) {
        Node* child = merge_nodes(pool, left.children[i], right.children[i], level - 1, key, join);
        if (child == left.children[i]) continue;
        if (out == nullptr) out = pool.copy(&left);
        out->children[i] = child;
      } else {
        const uint32_t value =
            left.values[i] == right.values[i] ? left.values[i] : join(key, left.values[i], right.values[i]);
        if (value == left.values[i]) continue;
        if (out == nullptr) out = pool.copy(&left);
        out->values[i] = value;
        rehash(key, left.values[i], value);
      }
    }
    return out == nullptr ? a : out;
  }

  Node* root_ = nullptr;
  uint64_t hash_ = 0;
  int height_ = 0;
};

}  // namespace owlint::flow
