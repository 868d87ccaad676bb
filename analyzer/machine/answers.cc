#include "analyzer/machine/answers.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include "analyzer/text/paths.h"
#include "analyzer/text/source.h"

namespace owlint {
namespace {

/// A folder in the place of the file is another answer than a file.
std::string file_text(const FoundFile& file) { return file_key(file.path) + (file.regular ? "" : "/"); }

std::string text_of(const std::optional<FoundFile>& file) { return file ? file_text(*file) : std::string(); }

std::string text_of(const std::vector<FoundFile>& files) {
  std::string text;
  for (const FoundFile& file : files) text += file_text(file) + '\n';
  return text;
}

std::string text_of(const std::optional<std::string>& path) { return path ? file_key(*path) : std::string(); }

std::string text_of(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += name + '\n';
  return fmt::format("{:016x}", XXH3_64bits(all.data(), all.size()));
}

}  // namespace

void Answers::note(Answer::Question question, std::string_view name, std::string text) const {
  if (notes_) noted_.push_back({question, std::string(name), std::move(text)});
}

std::optional<FoundFile> Answers::find(std::string_view name) const {
  auto found = path_->find(name);
  if (notes_) note(Answer::Question::kFind, name, text_of(found));
  return found;
}

std::vector<FoundFile> Answers::find_all(std::string_view name) const {
  auto found = path_->find_all(name);
  if (notes_) note(Answer::Question::kFindAll, name, text_of(found));
  if (notes_ && found.size() > 1) {
    for (const FoundFile& file : found) compared_.insert(file_key(file.path));
  }
  return found;
}

std::optional<std::string> Answers::find_other_case(std::string_view name) const {
  auto found = path_->find_other_case(name);
  if (notes_) note(Answer::Question::kOtherCase, name, text_of(found));
  return found;
}

std::optional<std::string> Answers::find_other_ending(std::string_view name) const {
  auto found = path_->find_other_ending(name);
  if (notes_) note(Answer::Question::kOtherEnding, name, text_of(found));
  return found;
}

std::vector<std::string> Answers::names() const {
  auto names = path_->names();
  if (notes_) note(Answer::Question::kNames, "", text_of(names));
  return names;
}

std::string ask(const SearchPath& path, Answer::Question question, std::string_view name) {
  switch (question) {
    case Answer::Question::kFind: return text_of(path.find(name));
    case Answer::Question::kFindAll: return text_of(path.find_all(name));
    case Answer::Question::kOtherCase: return text_of(path.find_other_case(name));
    case Answer::Question::kOtherEnding: return text_of(path.find_other_ending(name));
    case Answer::Question::kNames: return text_of(path.names());
  }
  return {};
}

}  // namespace owlint
