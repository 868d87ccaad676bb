#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "analyzer/syntax/further_faults.h"
#include "analyzer/syntax/look_alike.h"
#include "analyzer/text/characters.h"
#include "rules/driver/behind_stops.h"
#include "rules/driver/idioms.h"
#include "rules/driver/words.h"

namespace owlint {
namespace {

uint64_t key_of(RegionId region, NameId label) { return static_cast<uint64_t>(region) << 32 | label; }

using Openers = std::map<std::pair<RegionId, NameId>, StatementId>;

/// Lines that LinuxCNC does not read as the first line of a block that they are meant to be, each by the label of the lines
/// below that belong to it: its own, or that of the first end of its kind for which no block is open.
void find_openers(const Program& program, Openers* openers) {
  std::map<RegionId, std::vector<std::pair<Keyword, StatementId>>> waiting;
  for (StatementId id = 0; id < program.size(); ++id) {
    const Statement& s = program.at(id);
    const RegionId region = program.region_of[id];
    const bool misread = s.name_open || (s.has_error() && !s.refused);
    if (const Meant meant = misread ? meant_by(program, id) : Meant{}; opens_block(meant.keyword)) {
      if (meant.label != kNoName && !program.by_label[meant.label].empty())
        openers->emplace(std::pair(region, meant.label), id);
      else
        waiting[region].emplace_back(meant.keyword, id);
      continue;
    }
    const auto open = waiting.find(region);
    if (open == waiting.end() || s.kind != LineKind::kOWord || s.label == kNoName || s.has_error()) continue;
    const BlockId block = program.block_of[id];
    const bool begins = block != kNoBlock && s.is(Keyword::kWhile) && program.blocks[block].end == kNoStatement &&
        program.blocks[block].mistaken_end == kNoStatement && program.blocks[block].opener == id;
    const Keyword kind = begins ? Keyword::kDo : block == kNoBlock ? opener_of(s.keyword) : Keyword::kUnknown;
    auto& lines = open->second;
    const auto found = std::find_if(lines.rbegin(), lines.rend(), [&](const auto& line) { return line.first == kind; });
    if (kind == Keyword::kUnknown || found == lines.rend()) continue;
    openers->emplace(std::pair(region, s.label), found->second);
    if (begins || ends_block(s.keyword)) lines.erase(std::prev(found.base()), lines.end());
  }
}

/// `100` of a line that begins with `:0100`; empty for other lines.
std::string number_behind_colon(const Program& program, StatementId id) {
  const LineError* const error = program.syntax.error(program.at(id));
  if (error == nullptr || error->kind != StopKind::kBadCharacter || program.source->slice(error->span) != ":")
    return {};
  const std::string_view text = program.source->slice({error->span.end, program.at(id).end()});
  const std::string_view digits = text.substr(0, std::min(text.find_first_not_of("0123456789"), text.size()));
  return digits.empty() ? "" : std::string(digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1)));
}

bool is_until(const Program& program, StatementId id) {
  return program.at(id).is(Keyword::kUnknown) &&
      small_letters(program.source->slice(program.at(id).keyword_span())) == "until";
}

}  // namespace

Index::Index(const Program& program, const FlowResult& flow, const MachineWords& machine, bool codes_known)
    : nature(nature_of(program.source->bytes())), at(program.size()) {
  std::vector<bool> stopped(program.size());
  for (const FlowStop& stop : flow.stops) {
    if (stop.statement == kNoStatement) continue;
    const Statement& s = program.at(stop.statement);
    if (stop.kind != StopKind::kFileEnd || !(opens_block(s.keyword) || s.opens_sub())) stopped[stop.statement] = true;
  }
  for (const Hazard& hazard : flow.hazards) {
    if (hazard.kind == HazardKind::kCrash) stopped[hazard.statement] = true;
  }
  at = stopped;
  for (const Hazard& hazard : flow.hazards) {
    if (hazard.kind != HazardKind::kWarned) continue;
    at[hazard.statement] = true;
    warned_by_code[rules::code_of(hazard.warned, program.at(hazard.statement))].push_back(&hazard);
  }
  std::map<std::tuple<std::string_view, const Program*, uint32_t>, StatementId> set_by;
  for (const FlowStop& stop : flow.stops) {
    if (stop.kind == StopKind::kFileEnd && stop.statement != kNoStatement) {
      // A block whose end has a wrong label: the stop at that end and the end of the file, which a run meets
      // when it skips the block, are one mistake.
      const BlockId block = program.block_of[stop.statement];
      StatementId mistaken = block == kNoBlock ? kNoStatement : program.blocks[block].mistaken_end;
      // Or one that LinuxCNC cannot read.
      if (block != kNoBlock && program.blocks[block].end != kNoStatement &&
          program.at(program.blocks[block].end).refused)
        mistaken = program.blocks[block].end;
      if (mistaken != kNoStatement && stopped[mistaken]) {
        consequences.emplace(mistaken, &stop);
        continue;
      }
    }
    const std::string_view code = rules::code_of(stop, program);
    // Lines that stop on some way because of one line that has set a mode are one mistake: the first one names the others. But a
    // word that the motion does not take is a mistake of its own line.
    const bool of_words = stop.kind == StopKind::kWordUnused || stop.kind == StopKind::kWordMissing;
    if (stop.set_in != nullptr && !of_words) {
      const auto [first, added] = set_by.try_emplace({code, stop.set_in, stop.set_line}, stop.statement);
      if (!added) {
        consequences.emplace(first->second, &stop);
        continue;
      }
    }
    by_code[code].push_back(&stop);
    if (stop.statement != kNoStatement) add_further(program, stop, machine, codes_known);
  }
  subs = misread_subs(program);
  find_spoken_for(program, flow, stopped);
  for (StatementId id = 0; id < program.size(); ++id) add_line(program, id);
  for (NameId id = 0; id < program.syntax.names.size(); ++id) {
    if (std::ranges::any_of(program.syntax.names.text(id), is_foreign)) foreign_names.push_back(id);
  }
  find_shared_labels(program);
  add_behind(program, flow, codes_known);
}

/// Stops at words behind the line where every run stops: corrected one by one, they would take as many tries.
void Index::add_behind(const Program& program, const FlowResult& flow, bool codes_known) {
  constexpr size_t kMost = 10'000;  // nobody corrects more before the next check
  std::optional<rules::BehindStops> lines;
  const auto add = [&](StatementId id, const LineError& error) {
    if (behind_.size() == kMost) return;
    if (!lines) lines.emplace(program, flow);
    if (!lines->contains(id) || (error.kind == StopKind::kCodeUnknown && !codes_known)) return;
    FlowStop& stop = behind_.emplace_back();
    stop.statement = id;
    stop.kind = error.kind;
    stop.reach = Reach::kNever;
    stop.interpreter = error.message;
    by_code[rules::code_of(stop, program)].push_back(&stop);
  };
  for (const auto& [code, unmet] : unmet_by_code) {
    const Group group = find_rule(code)->group;
    if (group != Group::kWords && group != Group::kModes && group != Group::kGeometry) continue;
    for (const StatementId id : unmet) add(id, *program.syntax.error(program.at(id)));
  }
  for (const StatementId id : machine_checks_) {
    // Codes that no machine's INI is known to define; that of an axis is the machine's own.
    const LineError& error = program.syntax.errors[program.at(id).first];
    if (error.message.starts_with("Unknown")) add(id, error);
  }
}

/// Stops for the further mistakes of a line of words that stops with its first one.
void Index::add_further(const Program& program, const FlowStop& stop, const MachineWords& machine, bool codes_known) {
  const Statement& s = program.at(stop.statement);
  const auto first = rules::word_error(program, stop);
  const bool of_words = s.has_items() || s.kind == LineKind::kMachineCheck;
  if (!of_words || !first || first->kind != stop.kind || stop.unproven || s.nul || s.inner_cr) return;
  if (!further_.empty() && further_.back().second.statement == stop.statement) return;
  for (LineError& error : further_faults(program.source->slice(s.whole()), s.offset, *first, machine, codes_known)) {
    auto& [mistake, stops] = further_.emplace_back(std::move(error), stop);
    stops.further = &mistake;
    stops.kind = mistake.kind;
    stops.interpreter = mistake.message;
    by_code[rules::code_of(stops, program)].push_back(&stops);
  }
}

void Index::add_line(const Program& program, StatementId id) {
  const Statement& s = program.at(id);
  if (s.has_error()) {
    FlowStop unmet;
    unmet.statement = id;
    unmet.kind = program.syntax.errors[s.error].kind;
    if (!at[id] && !spoken_for.contains(id)) unmet_by_code[rules::code_of(unmet, program)].push_back(id);
    if ((s.is(Keyword::kUnknown) || s.is(Keyword::kBare)) && s.label != kNoName)
      unreadable.insert(key_of(program.region_of[id], s.label));
    if (const NameId meant = rules::mistyped_label(program, id); meant != kNoName)
      unreadable.insert(key_of(program.region_of[id], meant));
    if (unmet.kind == StopKind::kBadCharacter) odd_lines.push_back(id);
  }
  if (s.kind == LineKind::kMachineCheck && !at[id]) machine_checks_.push_back(id);
  if (s.name_open) {
    const Meant meant = meant_by(program, id);
    if (meant.label != kNoName) unreadable.insert(key_of(program.region_of[id], meant.label));
  }
  if (s.name_open || s.nul || s.inner_cr) {
    if (odd_lines.empty() || odd_lines.back() != id) odd_lines.push_back(id);
  }
  if (s.is(Keyword::kBare)) program_numbers.push_back(id);
  if (s.kind == LineKind::kProgramEnd || s.has_m99() || s.kind == LineKind::kPercent) ends.push_back(id);
  if (s.has_items() && s.item_count > 1) several_items.push_back(id);
  if (s.kind != LineKind::kOWord) return;
  if ((s.keyword == Keyword::kIf || s.keyword == Keyword::kElseif || s.keyword == Keyword::kWhile) && s.value_count > 0)
    tests.push_back(id);
  if (s.keyword == Keyword::kSub || s.keyword == Keyword::kEndsub || s.keyword == Keyword::kReturn) {
    sub_lines.push_back(id);
  } else if (!global_label(s.keyword) && s.label != kNoName) {
    const BlockId block = program.block_of[id];
    // Of a line that is refused, its label may be none: the finding about the line comes first.
    if (!s.refused && (block == kNoBlock || program.blocks[block].mistaken_end == id)) stray_parts.push_back(id);
  }
}

void Index::find_spoken_for(const Program& program, const FlowResult& flow, const std::vector<bool>& stopped) {
  // What was meant to end a sub or a block: the sub or block says so.
  for (const Region& region : program.regions) {
    if (region.likely_end == kNoStatement || region.end != kNoStatement || stopped[region.likely_end]) continue;
    // Two lines that lack the same are one mistake.
    const LineError* begin = program.syntax.error(program.at(region.opener));
    const LineError* end = program.syntax.error(program.at(region.likely_end));
    const bool same = begin != nullptr && end != nullptr && begin->kind == end->kind;
    if (!program.at(region.opener).refused || same) spoken_for.insert(region.likely_end);
  }
  // What was meant to begin one: the first stop that comes of it.
  find_openers(program, &openers);
  std::unordered_map<std::string, StatementId> colons;  // `:100`, by number
  for (StatementId id = 0; id < program.size(); ++id) {
    if (const std::string number = number_behind_colon(program, id); !number.empty()) colons.emplace(number, id);
  }
  const auto speak_for = [&](const auto& lines, auto key, StatementId before) {
    const auto found = lines.find(key);
    if (found != lines.end() && found->second < before && !stopped[found->second]) spoken_for.insert(found->second);
  };
  for (const FlowStop& stop : flow.stops) {
    if (stop.statement == kNoStatement) continue;
    const Statement& s = program.at(stop.statement);
    if (stop.kind == StopKind::kFileEnd) {
      const BlockId block = program.block_of[stop.statement];
      const StatementId end = block == kNoBlock ? kNoStatement : program.blocks[block].mistaken_end;
      if (end != kNoStatement && !stopped[end]) spoken_for.insert(end);
    } else if (stop.kind == StopKind::kSubNotFound) {
      speak_for(subs, program.syntax.names.find(stop.detail), kNoStatement);
      if (s.kind == LineKind::kM98) speak_for(colons, stop.detail, kNoStatement);
    } else if (stop.kind == StopKind::kBracketMissing && s.is(Keyword::kRepeat) && s.label != kNoName) {
      // `repeat` … `until`: the first line says it all.
      for (const StatementId id : program.by_label[s.label]) {
        if (id > stop.statement && !stopped[id] && is_until(program, id)) spoken_for.insert(id);
      }
    } else if (stop.kind == StopKind::kReturnOutside || stop.kind == StopKind::kNotInDefinition) {
      speak_for(subs, s.label, stop.statement);
    } else if (stop.kind == StopKind::kLabelUndefined && s.label != kNoName) {
      speak_for(openers, std::pair(program.region_of[stop.statement], s.label), stop.statement);
    }
  }
}

void Index::find_shared_labels(const Program& program) {
  // Blocks are region by region: what was noted for an earlier region is out of date.
  std::vector<BlockId> first(program.syntax.names.size(), kNoBlock);
  for (BlockId id = 0; id < program.blocks.size(); ++id) {
    const Block& block = program.blocks[id];
    BlockId& known = first[block.label];
    if (known == kNoBlock || program.blocks[known].region != block.region) {
      known = id;
    } else {
      shared_labels.emplace_back(program.blocks[known].opener, block.opener);
    }
  }
}

}  // namespace owlint
