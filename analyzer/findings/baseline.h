// Findings that are known and accepted for now: a shop with old programs begins with these, and only new ones are reported.
// The file is sorted JSON with an entry for each finding, so that people can read changes in it
// (share/owlint-baseline-1.schema.json).
#pragma once

#include <map>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/findings/identity.h"

namespace owlint {

class Baseline {
 public:
  /// Reads a baseline's text. Returns false and a message if it is none; `path` is how the message names it.
  bool parse(std::string_view text, const std::string& path, std::string* error);
  void write(std::ostream& out) const;

  void add(const Source& source, const std::vector<Finding>& findings);
  /// Removes the known findings of a file, and returns how many. A finding that is known once is removed once.
  size_t take_out(const Source& source, std::vector<Finding>& findings);
  /// How many entries for files that take_out() has seen had no finding.
  size_t gone() const;

 private:
  std::map<Identity, size_t> known_;  // how often
  std::map<Identity, size_t> met_;
  std::set<std::string> seen_;  // files, by the last part of their path
};

}  // namespace owlint
