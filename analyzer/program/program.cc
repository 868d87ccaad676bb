#include "analyzer/program/program.h"

#include <algorithm>
#include <unordered_map>

namespace owlint {
namespace {

void collect_calls(Program& program) {
  std::unordered_map<NameId, RegionId> first_definition;
  for (RegionId r = 1; r < program.regions.size(); ++r) first_definition.emplace(program.regions[r].name, r);
  for (StatementId id = 0; id < program.size(); ++id) {
    const Statement& s = program.at(id);
    if ((!s.is(Keyword::kCall) && s.kind != LineKind::kM98) || s.refused) continue;
    Call call{id, program.region_of[id], s.label};
    if (const auto found = first_definition.find(call.callee); found != first_definition.end()) call.target = found->second;
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
  std::string text = label_at(id);
  if (!spelling(s.keyword).empty()) text += " " + std::string(spelling(s.keyword));
  return text;
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
    if (program.region_of[id] != kMainRegion) {
      // Plain code behind an `endsub` is counted with the statement before it.
      const Region& region = program.regions[program.region_of[id]];
      if (id == region.end && program.at(id).plain_code_follows) return false;
      continue;
    }
    const Statement& s = program.at(id);
    const bool ends = s.kind == LineKind::kProgramEnd || s.kind == LineKind::kPercent;
    if (!ends || (s.kind == LineKind::kPercent && s.plain_code_follows)) return false;
  }
  return true;
}

void treat_as_sub_file(Program& program) {
  program.entry = own_name(program);
  program.sub_file = program.entry != kNoName;
}

std::unique_ptr<Program> build_program(std::shared_ptr<const Source> source) {
  auto program = std::make_unique<Program>();
  program->syntax = scan(*source);
  program->source = std::move(source);
  index_labels(*program);
  find_regions(*program);
  match_blocks(*program);
  collect_calls(*program);
  if (defines_own_name(*program) && does_nothing(*program)) treat_as_sub_file(*program);
  return program;
}

}  // namespace owlint
