// Hover: what an O-word or another word does, what is known of its label, what the sub says of itself.
#include <fmt/format.h>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/keywords.h"
#include "analyzer/lsp/mode_help.h"
#include "analyzer/lsp/places.h"
#include "analyzer/lsp/word_help.h"
#include "analyzer/report/arc_drawing.h"
#include "analyzer/report/summary.h"
#include "analyzer/text/base64.h"

namespace owlint::lsp {
namespace {

std::string line_of(const Document& document, StatementId id) { return std::to_string(document.program().at(id).line); }

std::string about_sub(Workspace& workspace, const Document& document, const std::string& name) {
  const Sub sub = find_sub(workspace, document, name);
  if (sub.document == nullptr)
    return fmt::format("`{}` is not defined here, and owlint finds no file for it.", label_text(name));
  std::string out = sub.document == &document
      ? fmt::format("`{} sub` begins on line {}.", label_text(name), line_of(document, sub.opener))
      : fmt::format("`{} sub` is in `{}`, line {}.", label_text(name), sub.document->path(),
                    line_of(*sub.document, sub.opener));
  const std::string comment = leading_comment(*sub.document, sub.opener);
  if (!comment.empty()) out += "\n\n```\n" + comment + "\n```";
  const Program& p = sub.document->program();
  if (const std::string summary = summary_text(p, sub.document->data().of(p.region_of[sub.opener])); !summary.empty())
    return out + "\n\nIt " + summary + ".";
  const uint32_t arguments = arguments_read(*sub.document, sub.opener);
  out += arguments == 0 ? "\n\nIt reads no arguments." : fmt::format("\n\nIt reads arguments up to `#{}`.", arguments);
  return out;
}

std::string about_block(const Document& document, BlockId id) {
  const Program& p = document.program();
  const Block& b = p.blocks[id];
  std::string out = fmt::format("`{}` begins on line {}", p.head_of(b), line_of(document, b.opener));
  if (const std::string condition = condition_text(document, b.opener); !condition.empty())
    out += fmt::format(" with `{}`", condition);
  out += b.end == kNoStatement ? " and is not closed." : fmt::format(" and ends on line {}.", line_of(document, b.end));
  return out;
}

std::string about_parameter(const Document& document, uint64_t offset, const std::string& name) {
  const std::vector<Occurrence> all = parameter_occurrences(document, offset, name);
  size_t writes = 0;
  for (const Occurrence& o : all) writes += o.definition ? 1 : 0;
  const bool named = name[0] == '<';
  const bool global = named ? name.starts_with("<_") : name.size() > 2 || std::stoi(name) > 30;
  const std::string kind = named ? (global ? "a global name" : "a name of this sub only")
      : global                   ? "a global number"
                                 : "an argument, or a number of this sub only";
  return fmt::format("`#{}` is {}: assigned {} times, read {} times {}.", name, kind, writes, all.size() - writes,
                     global ? "in this file" : "in this sub");
}

/// The numbers of the arcs on a line that do not fit, with a drawing where the client shows images.
std::string about_arcs(const Workspace& workspace, const Document& document, uint32_t line) {
  const Checked* checked = workspace.checked(document.uri());
  if (checked == nullptr) return {};
  std::string out;
  for (const Finding& f : checked->findings) {
    if (f.arc == nullptr || document.lines().line_of(f.span.begin) + 1 != line) continue;
    out += "\n\nThe arc:\n";
    for (const ArcFact& fact : arc_facts(*f.arc)) out += fmt::format("\n- {}: {}", fact.name, fact.words);
    if (workspace.client_shows_images)
      out += fmt::format("\n\n![the arc](data:image/svg+xml;base64,{})", base64(arc_svg(*f.arc)));
  }
  return out;
}

Json hover_of(const Document& document, const std::string& text, Span span) {
  return {{"contents", {{"kind", "markdown"}, {"value", text}}}, {"range", document.range(span)}};
}

}  // namespace

Json hover(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = target_at(document, offset);
  std::string text;
  Span span;
  if (target && target->kind == Target::Kind::kParameter) {
    text = about_parameter(document, offset, target->name);
    span = target->span;
  } else {
    const StatementId id = document.statement_at(offset);
    const bool runs_sub =
        id != kNoStatement && (document.program().at(id).kind == LineKind::kOWord || document.program().at(id).calls());
    if (runs_sub) span = document.program().at(id).head_span();
    if (!runs_sub || offset < span.begin || offset > span.end) {
      const auto word = word_help(document, workspace.profile_of(document), offset);
      if (!word) return nullptr;
      const auto line = static_cast<uint32_t>(document.lines().line_of(offset)) + 1;
      std::string help = word->text + about_arcs(workspace, document, line);
      if (const std::string modes = modes_before(workspace, document, line); !modes.empty()) help += "\n\n" + modes;
      return hover_of(document, help, word->span);
    }
    const Statement& s = document.program().at(id);
    text = s.kind == LineKind::kM98    ? "**M98** calls a Fanuc-style sub by its number."
        : s.kind == LineKind::kContour ? "**Q** is the number of the sub whose moves are the contour."
                                       : fmt::format("**{}** {}.", document.program().head(id), meaning(s.keyword));
    if (target && target->kind == Target::Kind::kSub) text += "\n\n" + about_sub(workspace, document, target->name);
    if (target && target->kind == Target::Kind::kBlock) text += "\n\n" + about_block(document, target->block);
  }
  return hover_of(document, text, span);
}

}  // namespace owlint::lsp
