// Joins a program with the files that it calls, and those that they call, as the interpreter would find them. The
// result is one Program for the flow room, with the statements of all files one after the other and a kFileEnd after each
// file, and a way back from its statements to the files.
#pragma once

#include <algorithm>
#include <unordered_map>

#include "analyzer/machine/answers.h"
#include "analyzer/machine/profile.h"
#include "analyzer/program/library.h"

namespace owlint {

/// One file of a joined program: statements [first, last); `last` is its kFileEnd.
struct LinkedFile {
  std::shared_ptr<const Program> program;
  StatementId first = 0;
  StatementId last = 0;
  bool regular = true;  ///< false: a folder or device instead of a file
};

/// Where a call leads if the label table does not have the name.
struct CallTarget {
  static constexpr uint32_t kNotFound = UINT32_MAX;
  uint32_t file = kNotFound;
  bool opaque = false;  ///< the name leaves the search path, or a shell would expand it: owlint does not look
};

class Linked {
 public:
  /// `program` with all files that its calls lead to. `notes`: note the questions to the search path.
  Linked(std::shared_ptr<const Program> program, const Profile& profile, Library& library, bool notes = false);

  /// All files as one program; the statements of the first file have the same numbers there.
  const Program& program() const { return joined_ == nullptr ? *files_[0].program : *joined_; }
  const std::vector<LinkedFile>& files() const { return files_; }
  /// Index of the file that a statement (or a file's end) belongs to.
  uint32_t file_of(StatementId id) const;
  bool at_end(StatementId id) const { return id >= program().size() || program().at(id).kind == LineKind::kFileEnd; }
  const Source& source_of(StatementId id) const { return *files_[file_of(id)].program->source; }

  /// Where LinuxCNC would find a called name that is not in the label table.
  CallTarget target(const std::string& name) const;
  /// Adds a file for a name that only the flow analysis knows. False if there is none, or if it is already here.
  bool add(const std::string& name);
  /// Whether a line of these files begins with `/`, so that they run in one way with block delete and in another without.
  bool deletes_lines() const {
    return std::ranges::any_of(files_, [](const LinkedFile& file) { return file.program->syntax.deletes_lines; });
  }
  const Answers& search_path() const { return answers_; }

 private:
  uint32_t add_file(const FoundFile& found);
  std::shared_ptr<const Program> as_run(std::shared_ptr<const Program> program) const;
  void follow(size_t from);
  void join();

  std::vector<LinkedFile> files_;
  std::unordered_map<std::string, uint32_t> by_path_;
  std::unordered_map<std::string, CallTarget> targets_;  // those that have a file
  Answers answers_;
  std::shared_ptr<const Program> joined_;
  Library& library_;
  const Profile profile_;
};

/// The name of a call's label in the label table: from LinuxCNC 2.9 on, the part after the last `/`.
std::string_view called_label(std::string_view name, Version version);

}  // namespace owlint
