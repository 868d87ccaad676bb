#include "analyzer/lsp/naming.h"

#include <algorithm>

#include "analyzer/flow/domain/parameters.h"
#include "analyzer/flow/facts/structured.h"
#include "analyzer/lsp/ini_uses.h"
#include "analyzer/machine/predefined.h"
#include "analyzer/text/paths.h"

namespace owlint::lsp {
namespace {

constexpr long kLastFreeNumber = 5000;  // what follows is LinuxCNC's: positions, offsets, tool data

bool is_block_label(const Statement& s) { return s.kind == LineKind::kOWord && !global_label(s.keyword); }
std::string file_name(const std::string& path) { return std::string(name_of(path)); }

/// Whether runs are always in the sub that their line stands in, so that each sub's names are its own.
bool keeps_subs_apart(const Document& document, RegionId region) {
  const flow::Structure& structure = document.data().structure();
  const Program& p = document.program();
  const bool in_block = std::ranges::any_of(p.regions, [](const Region& r) { return r.enclosing != kNoBlock; });
  return !in_block && (structure.regular || (region != kMainRegion && structure.apart[region]));
}

/// `G70` to `G72` with a Q run a sub without a call; the line's Q, or nothing.
std::optional<std::string> sub_of_cycle(std::string_view line) {
  std::string code;
  bool comment = false;
  for (const char c : small_letters(line)) {
    if (c == ';' && !comment) break;
    if (c == '(') comment = true;
    if (!comment && c != ' ' && c != '\t' && c != '\r') code += c;
    if (c == ')') comment = false;
  }
  const auto cycle = [&](const char* word) {
    const size_t at = code.find(word);
    return at != std::string::npos && (at + 3 == code.size() || code[at + 3] < '0' || code[at + 3] > '9');
  };
  const size_t q = code.find('q');
  if (q == std::string::npos || !(cycle("g70") || cycle("g71") || cycle("g72"))) return std::nullopt;
  const size_t end = std::min(code.find_first_not_of("0123456789", q + 1), code.size());
  return code.substr(q + 1, end - q - 1);
}

}  // namespace

bool is_number(std::string_view name) {
  return !name.empty() && name.find_first_not_of("0123456789") == std::string_view::npos;
}

void refuse(const std::string& why) { throw ResponseError{ErrorCode::kRequestFailed, why}; }

std::string Naming::text(const std::string& name) const {
  return target_.kind != Target::Kind::kParameter ? label_text(name) : "#" + name;
}

std::string Naming::place(const Document& in, uint64_t offset) const {
  const std::string line = "line " + std::to_string(in.lines().line_of(offset) + 1);
  return &in == &document_ ? line : line + " of " + file_name(in.path());
}

Naming::Naming(Workspace& workspace, const Document& document, Target target, uint64_t offset)
    : workspace_(workspace), document_(document), target_(std::move(target)) {
  if (target_.kind != Target::Kind::kBlock) machines_ = workspace.machines(document);
  switch (target_.kind) {
    case Target::Kind::kBlock: find_block(); break;
    case Target::Kind::kSub: find_sub_of_run(); break;
    case Target::Kind::kParameter: find_parameter(offset); break;
  }
}

/// Every place where `name` has the meaning that it has at the place of the rename, or would get it.
std::vector<Occurrence> Naming::uses(const std::string& name) const {
  std::vector<Occurrence> out;
  for (const Document* in : documents_) {
    std::vector<Occurrence> found;
    switch (target_.kind) {
      case Target::Kind::kBlock: found = block_labels(*in, name); break;
      case Target::Kind::kSub: found = sub_labels(*in, name); break;
      case Target::Kind::kParameter: found = parameter_occurrences(*in, region_, name); break;
    }
    out.insert(out.end(), found.begin(), found.end());
  }
  return out;
}

void Naming::require_free(const std::string& name) const {
  require_ours(name);
  const std::vector<Occurrence> taken = uses(name);
  if (!taken.empty())
    refuse("`" + text(name) + "` is used on " + place(*taken.front().document, taken.front().span.begin) + " already");
  if (target_.kind != Target::Kind::kSub) return;
  const std::string file = workspace_.called_file(*sub_.document, name);
  if (!file.empty()) refuse("the file " + file + " exists already");
  if (!sub_.own_file) return;
  // Calls that find nothing now would find the file, and so would calls above a sub of this name.
  for (const Document* in : workspace_.documents_around(*sub_.document)) {
    const std::vector<Occurrence> labels = sub_labels(*in, name);
    if (!labels.empty())
      refuse("`" + text(name) + "` is used on " + place(*in, labels.front().span.begin) + " already");
  }
}

void Naming::require_ours(const std::string& name) const {
  switch (target_.kind) {
    case Target::Kind::kBlock: require_no_computed_label(name); break;
    case Target::Kind::kSub:
      require_no_computed_label(name);
      require_no_other_call(name);
      break;
    case Target::Kind::kParameter:
      require_parameter_of_programs(name);
      require_no_computed_number(name);
      require_not_read_in_passing(name);
      break;
  }
}

// Blocks

std::vector<Occurrence> Naming::block_labels(const Document& in, const std::string& name) const {
  const Program& p = in.program();
  const NameId id = p.syntax.names.find(name);
  std::vector<Occurrence> out;
  if (id == kNoName || id >= p.by_label.size()) return out;
  for (const StatementId at : p.by_label[id]) {
    const bool here = !region_ || p.region_of[at] == *region_;
    if (here && is_block_label(p.at(at))) out.push_back({&in, p.at(at).label_span(), opens_block(p.at(at).keyword)});
  }
  return out;
}

void Naming::find_block() {
  const Program& p = document_.program();
  const Block& block = p.blocks[target_.block];
  target_.name = p.name(block.label);
  documents_ = {&document_};
  if (keeps_subs_apart(document_, block.region)) region_ = block.region;
  require_ours(target_.name);
  for (const Occurrence& o : uses(target_.name)) {
    const StatementId at = document_.statement_at(o.span.begin);
    if (p.block_of[at] == kNoBlock)
      refuse("`" + p.head(at) + "` on " + place(document_, o.span.begin) + " belongs to no block: correct it first");
    if (p.block_of[at] == target_.block) places_.push_back(o);
  }
}

void Naming::require_no_computed_label(const std::string& name) const {
  if (!is_number(name)) return;  // only numbers are computed
  for (const Document* in : documents_) {
    const Program& p = in->program();
    for (StatementId id = 0; id < p.size(); ++id) {
      const Statement& s = p.at(id);
      if (s.label_expr == kNoExpr || is_block_label(s) != (target_.kind == Target::Kind::kBlock)) continue;
      if (region_ && p.region_of[id] != *region_) continue;
      refuse("the label on " + place(*in, s.offset) + " is computed: it may be `" + text(name) + "`");
    }
  }
}

// Subs

void Naming::find_sub_of_run() {
  const std::string& name = target_.name;
  const std::string label = "`" + label_text(name) + "`";
  sub_ = find_sub(workspace_, document_, name);
  documents_ = workspace_.documents_run_with(sub_.document == nullptr ? document_ : *sub_.document);
  std::vector<const Document*> definers;
  std::ranges::copy_if(documents_, std::back_inserter(definers),
                       [&](const Document* in) { return definition_in(*in, name) != kNoStatement; });
  if (sub_.document == nullptr) {
    // A helper of another file, which is known once that file has been called.
    if (definers.size() != 1) refuse("the definition of " + label + " is not known");
    sub_ = {name, definers.front(), definition_in(*definers.front(), name), false};
    documents_ = workspace_.documents_run_with(*sub_.document);
  }
  if (sub_.own_file && !workspace_.renames_files)
    refuse("the editor cannot rename files, and " + file_name(sub_.document->path()) + " is named after its sub");
  require_ours(name);
  for (const Document* in : documents_) {
    const std::vector<Occurrence> labels = sub_labels(*in, name);
    if (labels.empty()) continue;
    if (in != sub_.document) {
      if (definition_in(*in, name) != kNoStatement) continue;  // its own
      // Of a name that the run has met, LinuxCNC does not ask where else it is defined.
      const std::string file = workspace_.called_file(*in, name);
      std::string other = file.empty() || file_key(file) == file_key(sub_.document->path()) ? "" : file;
      if (other.empty() && definers.size() > 1) other = definers[definers[0] == sub_.document ? 1 : 0]->path();
      if (!other.empty())
        refuse(label + " on " + place(*in, labels.front().span.begin) + " may be the one of " +
               file_name(sub_.document->path()) + " or of " + file_name(other));
    }
    places_.insert(places_.end(), labels.begin(), labels.end());
  }
}

/// Calls that are no O-word of the sub's name: by a path, by a cycle, by the machine.
void Naming::require_no_other_call(const std::string& name) const {
  for (const Document* in : documents_) {
    const Program& p = in->program();
    for (const Call& call : p.calls) {
      if (call.callee == kNoName) continue;
      const std::string& path = p.name(call.callee);
      if (path == name && p.at(call.statement).runs_remap())
        refuse("`" + p.head(call.statement) + "` on " + place(*in, p.at(call.statement).offset) +
               " runs it: the INI names it");
      if (path != name && path.ends_with("/" + name))
        refuse("`" + p.label_text(call.callee) + "` on " + place(*in, p.at(call.statement).offset) +
               " calls it by a path");
    }
    if (!is_number(name) || in->text().find_first_of("Qq") == std::string::npos) continue;
    for (size_t line = 0; line < in->lines().count(); ++line) {
      const Span span = in->lines().line(in->text(), line);
      const auto q = sub_of_cycle(std::string_view(in->text()).substr(span.begin, span.end - span.begin));
      if (q && (q->empty() || *q == name))
        refuse("the Q on " + place(*in, span.begin) + (q->empty() ? " may run `" : " runs `") + label_text(name) + "`");
    }
  }
  if (!sub_.own_file) return;
  for (const auto& machine : machines_) {
    const Ini::Entry* entry = ini_use_of_sub(machine->ini, name);
    if (entry == nullptr) continue;
    const auto file = machine->search_path->find(name);
    if (file && file_key(file->path) != file_key(sub_.document->path())) continue;  // another machine's
    refuse(text_of(*entry) + " names `" + label_text(name) + "`");
  }
}

// Parameters

void Naming::find_parameter(uint64_t offset) {
  const std::string& name = target_.name;
  const RegionId region = region_at(document_, offset);
  documents_ = is_shared(name) ? workspace_.documents_around(document_) : std::vector<const Document*>{&document_};
  if (!is_shared(name) && keeps_subs_apart(document_, region)) region_ = region;
  require_ours(name);
  places_ = uses(name);
  if (!is_shared(name)) require_not_given();
  if (std::ranges::none_of(places_, &Occurrence::definition))
    refuse("`" + text(name) + "` is assigned nowhere" + (region_ ? " in its sub" : "") +
           ": its value comes from elsewhere");
}

void Naming::require_parameter_of_programs(const std::string& name) const {
  const std::string shown = "`" + text(name) + "`";
  if (name[0] == '<') {
    const std::string bare = name.substr(1, name.size() - 2);
    if (may_be_predefined(bare) || bare == "n_args") refuse(shown + " is LinuxCNC's own");
  } else {
    const long number = std::stol(name);
    if (number == 0 || number > kLastFreeNumber)
      refuse(shown + " is LinuxCNC's own: programs have `#1` to `#" + std::to_string(kLastFreeNumber) + "`");
  }
  if (!is_shared(name)) return;
  for (const auto& machine : machines_) {
    if (const Ini::Entry* entry = ini_use_of_parameter(machine->ini, name)) refuse(text_of(*entry) + " names " + shown);
    std::string path;
    if (const uint32_t line = line_of_kept_number(*machine, name, &path))
      refuse("LinuxCNC keeps " + shown + " on line " + std::to_string(line) + " of " + path);
  }
}

void Naming::require_no_computed_number(const std::string& name) const {
  if (!is_number(name)) return;
  for (const Document* in : documents_) {
    for_parameters(*in, [&](Span line, const std::vector<ParameterUse>& uses) {
      if (region_ && region_at(*in, line.begin) != *region_) return;
      for (const ParameterUse& use : uses) {
        if (use.name.empty())
          refuse("the number of a parameter on " + place(*in, line.begin) + " is computed: it may be `#" + name + "`");
      }
    });
    if (is_shared(name)) continue;
    // M98 leaves #1 to #30 as they are: the sub of another file has the same ones.
    for (const Call& call : in->program().calls) {
      const Statement& s = in->program().at(call.statement);
      if (s.kind == LineKind::kM98 && call.target == kNoRegion)
        refuse("`M98` on " + place(*in, s.offset) + " leaves `#" + name + "` to its sub");
    }
    const NameId own = in->program().syntax.names.find(small_letters(stem_of(in->path())));
    for (const Region& region : in->program().regions) {
      if (region.name == own && region.opener != kNoStatement && in->program().at(region.opener).is(Keyword::kBare))
        refuse("`M98` in other files leaves `#" + name + "` to this sub");
    }
  }
}

/// The value on `endsub` and `return` is also computed while a definition is passed over, with the parameters of the
/// main program.
void Naming::require_not_read_in_passing(const std::string& name) const {
  if (!region_) return;
  const Program& p = document_.program();
  const auto concerned = [&](const ParameterUse& use) { return use.name == name || use.name == target_.name; };
  std::optional<Span> main;  // the first line of the main program that has one of the two
  for_parameters(document_, [&](Span line, const std::vector<ParameterUse>& uses) {
    if (std::ranges::none_of(uses, concerned)) return;
    const RegionId region = region_at(document_, line.begin);
    if (region == kMainRegion && !main) main = line;
    const StatementId id = document_.statement_at(line.begin);
    if (region == kMainRegion || (region != *region_ && *region_ != kMainRegion) || !main || id == kNoStatement) return;
    if (!p.at(id).is(Keyword::kEndsub) && !p.at(id).is(Keyword::kReturn)) return;
    refuse("the value on " + place(document_, line.begin) + " is also computed for the main program's `" + text(name) +
           "`, on " + place(document_, main->begin));
  });
}

/// A sub's argument, and what a remap puts into names of its sub, come from the caller.
void Naming::require_not_given() const {
  const Program& p = document_.program();
  const std::string shown = "`" + text(target_.name) + "`";
  std::vector<RegionId> regions;
  for (const Occurrence& o : places_) regions.push_back(region_at(document_, o.span.begin));
  std::ranges::sort(regions);
  regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
  for (const RegionId region : regions) {
    if (region == kMainRegion || p.regions[region].name == kNoName || set_first(region)) continue;
    const std::string sub = "`" + p.label_text(p.regions[region].name) + "`";
    if (is_number(target_.name)) {
      const flow::Summary& summary = document_.data().of(region);
      if (!summary.known || prints(region) || (summary.arguments >> std::stoul(target_.name) & 1) != 0)
        refuse(shown + " may be an argument of " + sub + ": its calls decide about it");
    } else {
      for (const auto& machine : machines_) {
        if (is_remap(machine->ini, p.name(p.regions[region].name)))
          refuse("a remap calls " + sub + ", and may set " + shown);
      }
    }
  }
}

bool Naming::prints(RegionId region) const {
  bool found = false;
  for_parameters(document_, [&](Span line, const std::vector<ParameterUse>& uses) {
    const auto wanted = [&](const ParameterUse& use) { return use.printed && use.name == target_.name; };
    found = found || (std::ranges::any_of(uses, wanted) && region_at(document_, line.begin) == region);
  });
  return found;
}

/// Whether the first thing that a sub does with the parameter, on every way, is to set it.
bool Naming::set_first(RegionId region) const {
  const Program& p = document_.program();
  const auto here = [&](const Occurrence& o) { return region_at(document_, o.span.begin) == region; };
  const auto first = std::ranges::find_if(places_, here);
  if (first == places_.end() || !first->definition) return false;
  const StatementId at = document_.statement_at(first->span.begin);
  const auto next = std::find_if(first + 1, places_.end(), here);
  if (at == kNoStatement || (next != places_.end() && document_.statement_at(next->span.begin) == at)) return false;
  return std::ranges::none_of(p.blocks, [&](const Block& b) {
    return b.region == region && b.opener < at && (b.end == kNoStatement || b.end > at);
  });
}

}  // namespace owlint::lsp
