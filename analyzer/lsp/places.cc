#include "analyzer/lsp/places.h"

#include <algorithm>

#include "analyzer/syntax/last_statement.h"
#include "analyzer/text/paths.h"

namespace owlint::lsp {
namespace {

bool is_sub_word(const Statement& s) { return s.calls() || (s.kind == LineKind::kOWord && global_label(s.keyword)); }

std::string file_stem(const std::string& path) { return small_letters(stem_of(path)); }

}  // namespace

Span fed_line(std::string_view text, uint64_t offset) {
  const size_t before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  const size_t begin = before == std::string_view::npos ? 0 : before + 1;
  return {begin, std::min(text.find('\n', begin), text.size())};
}

StatementId definition_in(const Document& document, const std::string& name) {
  const Program& p = document.program();
  const NameId id = p.syntax.names.find(name);
  if (id == kNoName || id >= p.by_label.size()) return kNoStatement;
  for (const StatementId at : p.by_label[id]) {
    if (p.at(at).opens_sub() && p.regions[p.region_of[at]].opener == at) return at;
  }
  return kNoStatement;
}

std::vector<Occurrence> sub_labels(const Document& document, const std::string& name) {
  const Program& p = document.program();
  const NameId id = p.syntax.names.find(name);
  if (id == kNoName) return {};
  // O-words by their label; M98 is only among the calls.
  std::vector<StatementId> lines;
  for (const StatementId at : p.by_label[id]) {
    if (is_sub_word(p.at(at))) lines.push_back(at);
  }
  for (const Call& call : p.calls) {
    if (call.callee == id && p.at(call.statement).kind != LineKind::kOWord) lines.push_back(call.statement);
  }
  std::ranges::sort(lines);
  std::vector<Occurrence> out;
  for (const StatementId at : lines) out.push_back({&document, p.at(at).label_span(), p.at(at).opens_sub()});
  return out;
}

Place place_of(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  return {document, document.offset(params.at("position"))};
}

std::optional<Target> target_at(const Document& document, uint64_t offset) {
  const std::string_view text = document.text();
  const Span line = fed_line(text, offset);
  for (ParameterUse& use : parameter_uses(text.substr(line.begin, line.end - line.begin))) {
    const Span span{line.begin + use.begin, line.begin + use.end};
    if (use.name.empty() || offset < span.begin || offset > span.end) continue;
    return Target{Target::Kind::kParameter, span, kNoStatement, kNoBlock, std::move(use.name)};
  }
  const StatementId id = document.statement_at(offset);
  if (id == kNoStatement) return std::nullopt;
  const Program& p = document.program();
  const Statement& s = p.at(id);
  const Span head = s.kind != LineKind::kOWord ? s.label_span() : s.head_span();
  if (s.label == kNoName || offset < head.begin || offset > head.end) return std::nullopt;
  if (is_sub_word(s)) return Target{Target::Kind::kSub, s.label_span(), id, kNoBlock, p.name(s.label)};
  if (s.kind != LineKind::kOWord || p.block_of[id] == kNoBlock) return std::nullopt;
  return Target{Target::Kind::kBlock, s.label_span(), id, p.block_of[id], p.name(s.label)};
}

Sub find_sub(Workspace& workspace, const Document& document, const std::string& name) {
  Sub sub{name};
  if (const StatementId own = definition_in(document, name); own != kNoStatement) {
    sub.document = &document;
    sub.opener = own;
  } else if (const std::string path = workspace.called_file(document, name); !path.empty()) {
    if (const Document* other = workspace.document_of_path(path)) {
      const StatementId opener = definition_in(*other, name);
      if (opener != kNoStatement) {
        sub.document = other;
        sub.opener = opener;
      }
    }
  }
  sub.own_file = sub.document != nullptr && file_stem(sub.document->path()) == name;
  return sub;
}

std::vector<Occurrence> sub_occurrences(Workspace& workspace, const Document& document, const std::string& name) {
  const Sub sub = find_sub(workspace, document, name);
  std::vector<Occurrence> out;
  const auto add = [&](const Document& from) {
    for (const Occurrence& o : sub_labels(from, name)) out.push_back(o);
  };
  if (sub.document != nullptr) add(*sub.document);
  if (sub.document != &document) add(document);
  if (!sub.own_file) return out;
  for (const std::string& path : workspace.program_files()) {
    const Document* other = workspace.document_of_path(path);
    if (other == nullptr || other == sub.document || other == &document || definition_in(*other, name) != kNoStatement)
      continue;
    if (other->program().syntax.names.find(name) == kNoName) continue;
    const std::string called = workspace.called_file(*other, name);
    if (!called.empty() && file_key(called) == file_key(sub.document->path())) add(*other);
  }
  return out;
}

std::vector<Occurrence> block_occurrences(const Document& document, BlockId block) {
  const Program& p = document.program();
  std::vector<Occurrence> out;
  const Block& b = p.blocks[block];
  for (const StatementId at : p.by_label[b.label]) {
    if (p.block_of[at] == block) out.push_back({&document, p.at(at).label_span(), at == b.opener});
  }
  return out;
}

void for_parameters(const Document& document, const std::function<void(Span, const std::vector<ParameterUse>&)>& each) {
  const std::string_view text = document.text();
  for (size_t hash = text.find('#'); hash != std::string_view::npos;) {
    const Span line = fed_line(text, hash);
    const std::vector<ParameterUse> uses = parameter_uses(text.substr(line.begin, line.end - line.begin));
    if (!uses.empty()) each(line, uses);
    hash = text.find('#', line.end);
  }
}

std::vector<Occurrence> parameter_occurrences(const Document& document, std::optional<RegionId> region,
                                              const std::string& name) {
  std::vector<Occurrence> out;
  for_parameters(document, [&](Span line, const std::vector<ParameterUse>& uses) {
    if (region && region_at(document, line.begin) != *region) return;
    for (const ParameterUse& use : uses) {
      if (use.name == name) out.push_back({&document, {line.begin + use.begin, line.begin + use.end}, use.assigned});
    }
  });
  return out;
}

std::vector<Occurrence> occurrences(Workspace& workspace, const Document& document, const Target& target,
                                    uint64_t offset) {
  switch (target.kind) {
    case Target::Kind::kBlock: return block_occurrences(document, target.block);
    case Target::Kind::kSub: return sub_occurrences(workspace, document, target.name);
    case Target::Kind::kParameter:
      return parameter_occurrences(
          document, is_shared(target.name) ? std::nullopt : std::optional(region_at(document, offset)), target.name);
  }
  return {};
}

RegionId region_at(const Document& document, uint64_t offset) {
  const Program& p = document.program();
  const StatementId id = last_statement(p.syntax, offset);  // a sub reaches to the end of its `endsub` line
  if (id == kNoStatement) return kMainRegion;
  const RegionId region = p.region_of[id];
  return p.regions[region].end == id && offset > p.at(id).end() ? kMainRegion : region;
}

std::string leading_comment(const Document& document, StatementId opener) {
  const std::string_view text = document.text();
  const size_t line = document.lines().line_of(document.program().at(opener).offset);
  const auto comment_of = [&](size_t number) {
    const Span span = document.lines().line(text, number);
    std::string_view bytes = text.substr(span.begin, span.end - span.begin);
    const size_t first = bytes.find_first_not_of(" \t");
    if (first == std::string_view::npos) return std::string();
    bytes = bytes.substr(first);
    const size_t last = bytes.find_last_not_of(" \t\r");
    bytes = bytes.substr(0, last + 1);
    if (bytes[0] == ';') return std::string(bytes.substr(std::min(bytes.find_first_not_of("; \t"), bytes.size())));
    const bool whole = bytes[0] == '(' && bytes.find(')') == bytes.size() - 1;
    return whole ? std::string(bytes.substr(1, bytes.size() - 2)) : std::string();
  };
  std::string out;
  size_t first = line;
  while (first > 0 && !comment_of(first - 1).empty()) --first;
  for (size_t at = first; at < line; ++at) out += comment_of(at) + "\n";
  for (size_t at = line + 1; out.empty() && at < document.lines().count(); ++at) {
    std::string comment = comment_of(at);
    if (comment.empty()) break;
    for (; !comment.empty(); comment = ++at < document.lines().count() ? comment_of(at) : std::string())
      out += comment + "\n";
  }
  if (!out.empty()) out.pop_back();
  return out;
}

uint32_t arguments_read(const Document& document, StatementId opener) {
  const Program& p = document.program();
  const Region& region = p.regions[p.region_of[opener]];
  uint32_t highest = 0;
  const StatementId last = std::min<StatementId>(region.last, static_cast<StatementId>(p.size()));
  const Span sub{p.at(opener).offset, last > opener ? p.at(last - 1).end() : p.at(opener).end()};
  for_parameters(document, [&](Span line, const std::vector<ParameterUse>& uses) {
    if (line.begin < sub.begin || line.begin >= sub.end) return;
    for (const ParameterUse& use : uses) {
      if (use.printed || use.name.empty() || use.name[0] == '<' || is_shared(use.name)) continue;
      highest = std::max(highest, static_cast<uint32_t>(std::stoi(use.name)));
    }
  });
  return highest;
}

std::string condition_text(const Document& document, StatementId id) {
  const Statement& s = document.program().at(id);
  const std::string_view line = std::string_view(document.text()).substr(s.offset, s.length);
  const size_t open = line.find('[', s.keyword_to);
  const size_t close = line.rfind(']');
  return open == std::string_view::npos || close == std::string_view::npos || close < open
      ? std::string()
      : std::string(line.substr(open, close + 1 - open));
}

}  // namespace owlint::lsp
