// What is at a position, and where else it is: blocks with all their parts, subs with their calls in all files,
// parameters in their scope. Navigation, rename, hover and the call hierarchy use it.
#pragma once

#include <functional>
#include <optional>

#include "analyzer/lsp/parameter_uses.h"
#include "analyzer/lsp/workspace.h"

namespace owlint::lsp {

/// A document and a position in it, from a request's params.
struct Place {
  const Document& document;
  uint64_t offset;
};
Place place_of(Workspace& workspace, const Json& params);

/// One position in one document.
struct Occurrence {
  const Document* document;
  Span span;
  bool definition = false;
};

/// A sub that is called by name, wherever it is defined.
struct Sub {
  std::string name;
  const Document* document = nullptr;  ///< the document that defines it; null: not known
  StatementId opener = kNoStatement;
  bool own_file = false;  ///< the file has its name, so that others call it
};

/// The line that holds an offset, as LinuxCNC ends lines.
Span fed_line(std::string_view text, uint64_t offset);

/// What is at a position.
struct Target {
  enum class Kind : uint8_t { kBlock, kSub, kParameter } kind;
  Span span;  ///< the label or parameter under the cursor
  StatementId statement = kNoStatement;
  BlockId block = kNoBlock;
  std::string name;  ///< of a sub or parameter
};

std::optional<Target> target_at(const Document& document, uint64_t offset);

/// The sub that a label means in a document.
Sub find_sub(Workspace& workspace, const Document& document, const std::string& name);
/// The line that defines a sub in a document; kNoStatement if none does.
StatementId definition_in(const Document& document, const std::string& name);
/// The labels of a document that are a sub's.
std::vector<Occurrence> sub_labels(const Document& document, const std::string& name);
/// Labels of a sub: its definition, ends and returns, and its calls in all files.
std::vector<Occurrence> sub_occurrences(Workspace& workspace, const Document& document, const std::string& name);
std::vector<Occurrence> block_occurrences(const Document& document, BlockId block);
/// Places that name a parameter: in a region, or anywhere in the document.
std::vector<Occurrence> parameter_occurrences(const Document& document, std::optional<RegionId> region,
                                              const std::string& name);
std::vector<Occurrence> occurrences(Workspace& workspace, const Document& document, const Target& target,
                                    uint64_t offset);

/// Calls `each` for the lines of a document, as LinuxCNC ends them, that name parameters: the line's span and the uses.
void for_parameters(const Document& document, const std::function<void(Span, const std::vector<ParameterUse>&)>& each);
/// The region that a byte stands in.
RegionId region_at(const Document& document, uint64_t offset);
/// The comment lines right above a sub, or right below its first line.
std::string leading_comment(const Document& document, StatementId opener);
/// The highest of #1 to #30 that a sub reads.
uint32_t arguments_read(const Document& document, StatementId opener);
/// The condition or arguments of a statement, as written.
std::string condition_text(const Document& document, StatementId id);

}  // namespace owlint::lsp
