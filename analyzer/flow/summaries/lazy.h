// A value that is made when it is first asked for.
#pragma once

#include <optional>

namespace owlint::flow {

/// Its owner stays const: to make the value changes no answer. Not for several threads at once: an object that has one belongs to
/// one thread, or has a lock around it.
template <typename T>
class Lazy {
 public:
  /// The value; `make()` returns it the first time.
  template <typename Make>
  const T& get(const Make& make) const {
    if (!value_) value_.emplace(make());
    return *value_;
  }

 private:
  mutable std::optional<T> value_;
};

}  // namespace owlint::flow
