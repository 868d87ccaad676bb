// What one program asks of the search path, and the answers: a later run asks the same questions. If all
// answers are the same, the program's findings are the same too.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "analyzer/machine/search_path.h"

namespace owlint {

/// One question and its answer, as text. Files are named by file_key().
struct Answer {
  /// Stored by an audit, where 4 is something else.
  enum class Question : uint8_t { kFind = 0, kFindAll = 1, kOtherCase = 2, kNames = 3, kOtherEnding = 5 };
  Question question = Question::kFind;
  std::string name;  ///< of the sub; empty for kNames
  std::string text;  ///< the file, the files, or a hash of the names; empty for none

  bool operator==(const Answer&) const = default;
};

/// Asks a search path, and notes the answers if wanted. For one program, and so for one thread.
class Answers {
 public:
  Answers(std::shared_ptr<const SearchPath> path, bool notes) : path_(std::move(path)), notes_(notes) {}

  std::optional<FoundFile> find(std::string_view name) const;
  std::vector<FoundFile> find_all(std::string_view name) const;
  std::optional<std::string> find_other_case(std::string_view name) const;
  std::optional<std::string> find_other_ending(std::string_view name) const;
  std::vector<std::string> names() const;

  const std::shared_ptr<const SearchPath>& path() const { return path_; }
  const std::vector<Answer>& noted() const { return noted_; }
  /// Files whose bytes were compared.
  const std::set<std::string>& compared() const { return compared_; }

 private:
  void note(Answer::Question question, std::string_view name, std::string text) const;

  std::shared_ptr<const SearchPath> path_;
  bool notes_;
  mutable std::vector<Answer> noted_;
  mutable std::set<std::string> compared_;
};

/// What the search path answers now.
std::string ask(const SearchPath& path, Answer::Question question, std::string_view name);

}  // namespace owlint
