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

bool runs_by_itself(const Program& program) {
  const NameId own = own_name(program);
  if (own == kNoName) return true;
  // A call of anything, or `o<own>` alone, which may be a call that lacks its `call`.
  if (std::ranges::any_of(program.calls, [](const Call& call) { return call.caller == kMainRegion; })) return true;
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

/// Whether G91 may be in effect where the lines between two statements do not say it.
bool may_be_in_g91(const Program& program, const MachineWords& machine) {
  const Syntax& syntax = program.syntax;
  const bool starts = machine.start != nullptr && machine.start->now[Mode::kDistance] != value_bit(modes::kG90);
  const bool calls_files =
      std::ranges::any_of(program.calls, [](const Call& call) { return call.target == kNoRegion; });
  return syntax.may_set_g91 || syntax.runs_python || starts || !machine.remapped.empty() || program.sub_file ||
      calls_files;
}

std::unique_ptr<Program> read_program(std::shared_ptr<const Source> source, const MachineWords& machine, Sums sums) {
  auto program = std::make_unique<Program>();
  program->syntax = scan(*source, machine, sums);
  program->source = std::move(source);
  build_structure(*program);
  return program;
}

}  // namespace

std::unique_ptr<Program> build_program(std::shared_ptr<const Source> source, const MachineWords& machine) {
  constexpr size_t kLarge = 1 << 20;  // bytes: that many numbers are worth leaving out
  const Sums sums = source->bytes().size() < kLarge ? Sums::kAll : Sums::kLinesSayIt;
  auto program = read_program(source, machine, sums);
  if (!program->syntax.lacks_sums || !may_be_in_g91(*program, machine)) return program;
  program.reset();
  return read_program(std::move(source), machine, Sums::kAll);
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
