// Findings that are known and accepted for now: a shop with old programs begins with these, and only new ones are reported.
// The file is JSON, sorted, a finding an entry, so that people can read what changes in it (share/owlint-baseline-1.schema.json).
#pragma once

#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "analyzer/findings/identity.h"

namespace owlint {

class Baseline {
 public:
  /// False and a message where the file is not there or is not a baseline.
  bool read(const std::string& path, std::string* error);
  void write(std::ostream& out) const;

  void add(const Source& source, const std::vector<Finding>& findings);
  /// Takes out the findings of a file that are known; how many that were. What is known once is taken out once.
  size_t take_out(const Source& source, std::vector<Finding>& findings);
  /// Of the files that take_out() has seen, how many entries no finding was for.
  size_t gone() const;

 private:
  std::map<Identity, size_t> known_;  // how often
  std::map<Identity, size_t> met_;
  std::set<std::string> seen_;        // files, by the last part of their path
};

}  // namespace owlint
