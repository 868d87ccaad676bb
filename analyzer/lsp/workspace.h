// What the server knows: the open documents, the folders, the files that it has read from disk, and the findings in them.
// An open document replaces its file: programs that call it are checked with the text in the editor.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "analyzer/checking/settings.h"
#include "analyzer/flow/engine/known_calls.h"
#include "analyzer/lsp/document.h"
#include "analyzer/text/memory_files.h"
#include "rules/driver/lint.h"

namespace owlint::lsp {

/// The findings of one document, as last sent.
struct Checked {
  std::vector<Finding> findings;
  std::vector<std::string> calls;  ///< paths of the files that the program calls
  std::string result_id;           ///< of the pull model: changes when the findings do
};

/// The last full answer to a question for semantic tokens.
struct SentTokens {
  uint64_t id = 0;
  std::vector<uint32_t> data;
};

class Workspace {
 public:
  /// `saved`: the files behind the open documents; they must outlive this.
  explicit Workspace(const Files& saved);

  std::map<std::string, SentTokens> sent_tokens;  ///< by uri

  Encoding encoding = Encoding::kUtf16;
  /// The client's settings, used as command line options: `ini`, `sub-path`, `linuxcnc`, `feature`, `select`,
  /// `extend-select`, `ignore`.
  void configure(const Json& settings);

  void add_folder(const std::string& uri);
  void remove_folder(const std::string& uri);
  const std::vector<std::string>& folders() const { return folders_; }  ///< paths

  Document& open(const std::string& uri, std::string text, std::optional<int64_t> version);
  void close(const std::string& uri);
  Document* find_open(const std::string& uri);
  /// An open document, or the file on disk. Throws ResponseError if there is neither.
  const Document& document(const std::string& uri);
  const Document* document_of_path(const std::string& path);
  std::vector<Document*> open_documents();

  /// Files have changed on disk: everything that was read is out of date.
  void forget_files();
  /// Called with the progress of long work: reading the programs of a workspace, and checking them.
  std::function<void(const char* work, size_t done, size_t of)> progress = [](const char*, size_t, size_t) {};
  /// Reads all programs of the workspace now, instead of when first needed.
  void read_all();
  /// The programs below the workspace folders, and those that are open; by path.
  std::vector<std::string> program_files();
  /// All programs that may share something with `from`: those of the workspace, and those on its search path; itself first.
  std::vector<const Document*> documents_around(const Document& from);
  /// Of these, the ones that a run with `from` in it may read: what calls it, and what it and those call; itself first.
  std::vector<const Document*> documents_run_with(const Document& from);
  /// The machines that programs of the workspace may run on: the one that `from` is checked for, and those whose INIs are
  /// in the workspace or on the search path.
  std::vector<std::shared_ptr<const MachineSetup>> machines(const Document& from);
  /// The machine and version that a document is checked for; the defaults where its settings are wrong.
  Profile profile_of(const Document& document);
  bool client_shows_images = false;  ///< in Markdown, from data URIs: the setting `images`
  bool renames_files = true;         ///< the client does, when an edit wants it

  /// Checks a document and, with it, the open ones that call it or that it calls. Returns the uris of all that were
  /// checked; findings() then has them.
  std::vector<std::string> check(const std::string& uri);
  const Checked* checked(const std::string& uri) const;
  /// Checks all programs of the workspace, open or not; by path. Clients ask every few seconds, so the findings are kept until
  /// something changes.
  const std::map<std::string, Checked>& check_everything();
  /// Checks a file that may be open or not.
  Checked check_alone(const std::string& path);

  /// The file that a call of `name` in a document leads to; empty if there is none.
  std::string called_file(const Document& from, const std::string& name);
  /// The names of all files that a document could call.
  std::vector<std::string> callable_files(const Document& from);
  /// All files, with the text of open documents.
  const Files& files() const { return files_; }
  std::vector<std::string> notes() const { return configuration_->notes(); }

 private:
  std::shared_ptr<const SearchPath> search_path(const Document& from);
  std::shared_ptr<const Source> text_of_open(const std::string& path) const;
  std::set<std::string> related(const Document& document) const;
  std::set<std::string> open_on_machine(const std::string& ini);
  void forget_file(const std::string& path);
  void forget_machines();
  std::vector<std::string> ini_files();
  std::map<std::string, Checked> run(const std::vector<std::string>& files);
  bool settings_for(const std::string& path, checking::Settings* settings);

  UnsavedFiles files_;
  checking::CheckRequest line_;
  std::unique_ptr<checking::Configuration> configuration_;
  std::vector<std::string> folders_;
  std::map<std::string, std::unique_ptr<Document>> open_;     // by uri
  std::map<std::string, std::string> uri_of_;                 // of open documents, by file key
  std::map<std::string, std::unique_ptr<Document>> on_disk_;  // by path
  std::map<std::string, Checked> checked_;                    // by uri
  std::optional<std::set<std::string>> called_files_;         // keys of files that some program of the workspace calls
  std::optional<std::map<std::string, Checked>> everything_;
  std::map<std::string, flow::KnownCalls> known_calls_;  // of open documents, by file key
  std::unique_ptr<Library> library_;                     // the files that are called, parsed once for many checks
};

}  // namespace owlint::lsp
