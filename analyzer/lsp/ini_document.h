// A machine's INI as the language server sees it: its lines, and what of programs and files they name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyzer/lsp/workspace.h"

namespace owlint::lsp {

/// Whether a file is an INI, by its name.
bool is_ini(std::string_view path);

/// A sub or a file that a line names.
struct IniTarget {
  Span span;
  std::string sub;   ///< its name; empty: a file
  std::string path;  ///< of the file; empty if there is none
};

class IniDocument {
 public:
  /// `document` must outlive it.
  IniDocument(Workspace& workspace, const Document& document);

  const Document& document() const { return document_; }
  const IniText& text() const { return text_; }
  /// Null where LinuxCNC reads nothing of the file.
  const MachineSetup* setup() const { return profile_.setup.get(); }

  /// The line with a position in this file; null for an empty one.
  const IniLine* line_at(uint64_t offset) const;
  /// The name of the section that a position is in; empty before the first one.
  std::string_view section_at(uint64_t offset) const;
  /// What a line of this file names, in its order.
  std::vector<IniTarget> targets(const IniLine& line) const;
  std::optional<IniTarget> target_at(uint64_t offset) const;

 private:
  bool is_own(const IniLine& line) const { return line.source == 0; }
  IniTarget sub_target(std::string_view name, uint64_t begin) const;
  std::optional<IniTarget> file_target(std::string_view path, uint64_t begin) const;
  void add_calls(std::string_view code, uint64_t begin, std::vector<IniTarget>* targets) const;

  Workspace& workspace_;
  const Document& document_;
  Profile profile_;
  IniText text_;
};

}  // namespace owlint::lsp
