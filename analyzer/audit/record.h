// The result of checking a file, as bytes for the store: the findings with everything that belongs to them, and only those
// lines of files that they point at. The bytes are MessagePack, because names and programs need not be UTF-8.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analyzer/checking/run.h"

namespace owlint::audit {

std::string record_of(const checking::Checked& checked);
/// For a list of reports: INIs, or one finding.
std::string record_of(const std::vector<FileReport>& reports);

/// Reads records back. The lines of one file from several records become one excerpt, so that all their findings can be
/// in one report: first add all records, then read them.
class Records {
 public:
  /// Adds a record and returns its number, from 0. This and the other functions throw StoreProblem for bytes that are not a
  /// record.
  size_t add(const std::string& bytes);
  size_t size() const { return records_.size(); }
  checking::Checked checked(size_t number);
  std::vector<FileReport> reports(size_t number);

 private:
  struct Kept {
    uint32_t line_count = 0;
    std::map<uint32_t, KeptLine> lines;
    std::shared_ptr<const Source> source;
  };
  size_t take_in(const std::string& bytes);
  checking::Checked read_checked(const nlohmann::json& record);
  std::vector<std::shared_ptr<const Source>> sources_of(const nlohmann::json& record);
  FileReport report(const nlohmann::json& json, const std::vector<std::shared_ptr<const Source>>& sources) const;
  std::vector<FileReport> list(const nlohmann::json& json,
                               const std::vector<std::shared_ptr<const Source>>& sources) const;

  std::vector<nlohmann::json> records_;
  std::map<std::string, Kept> kept_;
};

}  // namespace owlint::audit
