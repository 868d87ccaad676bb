// Runs work on several cores, with OpenMP. use_cores() sets how many, once. Work inside parallel work runs on one core. An
// exception in the work is thrown again to the caller, and no further work begins after it.
#pragma once

#include <omp.h>

#include <atomic>
#include <cstddef>
#include <exception>

namespace owlint {

/// 0: all of them.
inline void use_cores(unsigned count) {
  omp_set_num_threads(count == 0 ? omp_get_num_procs() : static_cast<int>(count));
}

/// Whether work would run on one core: there is only one, or this is inside parallel work.
inline bool one_core() { return omp_get_max_threads() == 1 || omp_in_parallel() != 0; }

/// The first exception of several threads. After it no further work begins.
class FirstProblem {
 public:
  template <typename Work>
  void guard(const Work& work) {
    if (met_.load(std::memory_order_relaxed)) return;
    try {
      work();
    } catch (...) {
      met_.store(true, std::memory_order_relaxed);
#pragma omp critical(owlint_first_problem)
      if (!problem_) problem_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (problem_) std::rethrow_exception(problem_);
  }

 private:
  std::atomic<bool> met_ = false;
  std::exception_ptr problem_;
};

/// Calls `each(i)` for 0 to `count`, in any order.
template <typename Each>
void for_each(size_t count, const Each& each) {
  FirstProblem problem;
#pragma omp parallel for schedule(dynamic) if (count > 1)
  for (size_t i = 0; i < count; ++i) problem.guard([&] { each(i); });
  problem.rethrow();
}

/// Calls `make(i)` for 0 to `count`, in any order, and `take(i, made)` with the results, one by one from the first to the
/// last. Only a few results wait at a time.
template <typename Make, typename Take>
void for_each_in_order(size_t count, const Make& make, const Take& take) {
  FirstProblem problem;
#pragma omp parallel for ordered schedule(dynamic) if (count > 1)
  for (size_t i = 0; i < count; ++i) {
    decltype(make(i)) made{};
    problem.guard([&] { made = make(i); });
#pragma omp ordered
    problem.guard([&] { take(i, made); });
  }
  problem.rethrow();
}

}  // namespace owlint
