#include "analyzer/program/program.h"

#include <algorithm>
#include <unordered_map>

#include "analyzer/text/paths.h"

namespace owlint {
namespace {

void collect_calls(Program& program) {
  std::unordered_map<NameId, RegionId> first_definition;
  for (RegionId r = 1; r < program.regions.size(); ++r) first_definition.emplace(program.regions[r].name, r);
  for (StatementId id = 0; id < program.size(); ++id) {
    const Statement& s = program.at(id);
    if ((!s.calls() && !s.runs_remap()) || s.refused) continue;
    Call call{id, program.region_of[id], s.label};
    if (const auto found = first_definition.find(call.callee); found != first_definition.end())
      call.target = found->second;
    program.calls.push_back(call);
  }
}

NameId own_name(const Program& program) {
  const NameId name = program.syntax.names.find(small_letters(stem_of(program.source->path())));
  if (name == kNoName) return kNoName;
  for (const Region& region : program.regions) {
    if (region.opener == kNoStatement) continue;
    if (region.name == name && program.at(region.opener).is(Keyword::kSub)) return name;
  }
  return kNoName;
}

/// Whether a statement, or the plain lines behind it, is code outside of subs.
bool works_outside(const Program& program, StatementId id) {
  const Statement& s = program.at(id);
  // Plain code behind an `endsub` is counted with the statement before it.
  if (program.region_of[id] != kMainRegion)
    return id == program.regions[program.region_of[id]].end && s.plain_code_follows;
  return s.kind == LineKind::kPercent ? s.plain_code_follows : s.kind != LineKind::kProgramEnd;
}

}  // namespace

std::string label_text(const std::string& name) {
  // `o<0100>` is another label than `o100`.
  const bool zero = name.size() > 1 && name[0] == '0';
  const bool number = !name.empty() && !zero && name.find_first_not_of("-0123456789") == std::string::npos;
  return number ? "o" + name : "o<" + name + ">";
}

std::string Program::label_at(StatementId id) const {
  const Statement& s = at(id);
  return s.label != kNoName ? label_text(s.label) : std::string(source->slice(s.label_span()));
}

std::string Program::head(StatementId id) const {
  const Statement& s = at(id);
  if (s.kind == LineKind::kRemap) return std::string(source->slice(s.label_span()));
  std::string text = label_at(id);
  if (!spelling(s.keyword).empty()) text += " " + std::string(spelling(s.keyword));
  return text;
}

RegionId Program::find_sub(std::string_view label) const {
  for (RegionId r = kMainRegion + 1; r < regions.size(); ++r) {
    if (regions[r].opener != kNoStatement && regions[r].name != kNoName && name(regions[r].name) == label) return r;
  }
  return kNoRegion;
}

BlockId Program::open_above(RegionId region, StatementId place) const {
  const auto begins = [](const Block& block) { return std::pair(block.region, block.opener); };
  const auto below = std::ranges::lower_bound(blocks, std::pair(region, place), {}, begins);
  if (below == blocks.begin()) return kNoBlock;
  // Of the blocks that begin above, the last one's parents are those around the place.
  auto block = static_cast<BlockId>(below - blocks.begin() - 1);
  if (blocks[block].region != region) return kNoBlock;
  while (block != kNoBlock && blocks[block].end != kNoStatement && blocks[block].end < place)
    block = blocks[block].parent;
  return block;
}

void index_labels(Program& program) {
  program.by_label.assign(program.syntax.names.size(), static_cast<uint32_t>(program.size()), [&](StatementId id) {
    const Statement& s = program.at(id);
    return s.kind == LineKind::kOWord ? s.label : kNoName;
  });
}

std::vector<std::string> called_names(const std::string& code) {
  const Syntax syntax = scan(*Source::own("", code + "\n"));
  std::vector<std::string> names;
  for (const Statement& s : syntax.statements) {
    if (s.is(Keyword::kCall) && s.label != kNoName) names.push_back(syntax.names.text(s.label));
  }
  return names;
}

bool defines_own_name(const Program& program) { return own_name(program) != kNoName; }

bool does_nothing(const Program& program) {
  if (program.syntax.first_plain_line != 0) return false;
  for (StatementId id = 0; id < program.size(); ++id) {
    if (works_outside(program, id)) return false;
  }
  return true;
}

namespace {

bool ends_as_program(const Program& program) {
  for (StatementId id = 0; id < program.size(); ++id) {
    const LineKind kind = program.at(id).kind;
    const bool ends = kind == LineKind::kProgramEnd || kind == LineKind::kPercent || program.at(id).has_m99();
    if (ends && program.region_of[id] == kMainRegion) return true;
  }
  return false;
}

}  // namespace

bool runs_by_itself(const Program& program) {
  const NameId own = own_name(program);
  if (own == kNoName) return true;
  // A call of anything in what ends as a program does: without an end it only tries the sub. Or `o<own>` alone, which may be a
  // call that lacks its `call`.
  const bool calls = std::ranges::any_of(program.calls, [](const Call& call) { return call.caller == kMainRegion; });
  if (calls && ends_as_program(program)) return true;
  if (std::ranges::any_of(program.by_label[own], [&](StatementId id) { return program.at(id).is(Keyword::kBare); }))
    return true;
  bool code = program.syntax.first_plain_line != 0;
  for (StatementId id = 0; id < program.size() && !(program.at(id).is(Keyword::kSub) && program.at(id).label == own);
       ++id) {
    const bool ends = program.at(id).kind == LineKind::kProgramEnd && program.region_of[id] == kMainRegion;
    if (code && ends) return true;
    code = code || works_outside(program, id);
  }
  return false;
}

void treat_as_sub_file(Program& program) {
  program.entry = own_name(program);
  program.sub_file = program.entry != kNoName;
}

namespace {

void build_structure(Program& program) {
  index_labels(program);
  find_regions(program);
  match_blocks(program);
  collect_calls(program);
  if (!runs_by_itself(program)) treat_as_sub_file(program);
}

/// Whether runs begin, or come back from what is not in the file, with other modes than an interpreter starts with.
bool comes_from_elsewhere(const Program& program) {
  const bool calls_files =
      std::ranges::any_of(program.calls, [](const Call& call) { return call.target == kNoRegion; });
  return program.syntax.runs_python || program.sub_file || calls_files;
}

/// Whether what was taken for granted is so.
bool is_as_read(const Program& program, Expected expected) {
  const Syntax& syntax = program.syntax;
  switch (expected) {
    case Expected::kAnything: return true;
    case Expected::kNoG91: return !syntax.lacks_sums || (!syntax.may_set_g91 && !comes_from_elsewhere(program));
    case Expected::kUsual: return !syntax.unusual && !syntax.asks_place && !comes_from_elsewhere(program);
  }
  return false;
}

/// Whether it may be so on this machine.
bool may_be_read(const MachineWords& machine, Expected expected) {
  if (expected == Expected::kAnything) return true;
  const ModeSets start = machine.start == nullptr ? ModeSets::started() : machine.start->now;
  const auto starts_as_usual = [&](Mode mode) {
    return start[mode] == ModeSets::started()[mode] && !start.is_open(mode);
  };
  if (!machine.remapped.empty() || !machine.lost.empty() || !starts_as_usual(Mode::kDistance)) return false;
  if (expected == Expected::kNoG91) return true;
  bool usual = !machine.has_limits && !machine.measures_extents && machine.wrapped == 0 && machine.indexing == 0;
  for (size_t i = 0; i < kModes; ++i) {
    const auto mode = static_cast<Mode>(i);
    usual = usual && ((kUsualModes & mask_of(mode)) == 0 || starts_as_usual(mode));
  }
  return usual;
}

std::unique_ptr<Program> read_program(std::shared_ptr<const Source> source, const MachineWords& machine,
                                      Expected expected) {
  auto program = std::make_unique<Program>();
  program->syntax = scan(*source, machine, expected);
  program->source = std::move(source);
  build_structure(*program);
  return program;
}

}  // namespace

std::unique_ptr<Program> build_program(std::shared_ptr<const Source> source, const MachineWords& machine) {
  if (source->bytes().size() >= large_program) {
    for (const Expected expected : {Expected::kUsual, Expected::kNoG91}) {
      if (!may_be_read(machine, expected)) continue;
      auto program = read_program(source, machine, expected);
      if (is_as_read(*program, expected)) return program;
    }
  }
  return read_program(std::move(source), machine, Expected::kAnything);
}

std::shared_ptr<const Program> without_deleted_lines(std::shared_ptr<const Program> program) {
  if (!program->syntax.deletes_lines) return program;
  auto out = std::make_shared<Program>();
  out->source = program->source;
  out->syntax = program->syntax;
  auto& statements = out->syntax.statements;
  auto& changes = out->syntax.mode_changes;
  auto& needs = out->syntax.mode_needs;
  auto& places = out->syntax.place_changes;
  statements.clear();
  changes.clear();
  needs.clear();
  places.clear();
  for (StatementId id = 0; id < program->size(); ++id) {
    if (id == program->syntax.left_at) out->syntax.left_at = static_cast<StatementId>(statements.size());
    const Statement& s = program->at(id);
    const LineError* error = program->syntax.error(s);
    const bool read = error != nullptr && error->kind <= StopKind::kCommentUnclosed;
    if (!s.block_delete || read) {
      statements.push_back(s);
      for (ModeChange change : program->syntax.changes_after(id)) {
        change.after = static_cast<StatementId>(statements.size() - 1);
        changes.push_back(change);
      }
      for (PlaceChange place : program->syntax.places_after(id)) {
        place.after = static_cast<StatementId>(statements.size() - 1);
        places.push_back(place);
      }
      for (ModeNeed need : program->syntax.needs_after(id)) {
        need.after = static_cast<StatementId>(statements.size() - 1);
        needs.push_back(need);
      }
      continue;
    }
    if (s.kind == LineKind::kOWord && s.label != kNoName) out->left_out.try_emplace({s.label, s.keyword}, s.line);
    if (s.asks_inputs && !statements.empty()) statements.back().asks_inputs = true;
    if (s.plain_code_follows && !statements.empty() && !statements.back().plain_code_follows) {
      statements.back().plain_code_follows = true;
      statements.back().first_plain_line = s.first_plain_line;
    }
  }
  build_structure(*out);
  if (program->sub_file) treat_as_sub_file(*out);
  return out;
}

}  // namespace owlint
