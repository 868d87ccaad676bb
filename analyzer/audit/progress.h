// The progress of an audit: on a terminal the bar of `pv`, with rate and time left; otherwise a line now and then.
#pragma once

#include <chrono>
#include <cstddef>

namespace owlint::audit {

class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void tell(size_t done, size_t total);
  /// Removes the bar.
  void finish();

 private:
  void start_bar(size_t total);

  bool quiet_;
  bool started_ = false;
  int bar_ = -1;      // where pv counts lines
  int process_ = -1;  // pv
  size_t reported_ = 0;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace owlint::audit
