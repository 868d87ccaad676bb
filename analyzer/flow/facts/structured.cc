#include "analyzer/flow/facts/structured.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace owlint::flow {
namespace {

bool part_of_block(const Statement& s) { return s.kind == LineKind::kOWord && !global_label(s.keyword); }

bool is_regular(const Program& program) {
  for (RegionId r = 1; r < program.regions.size(); ++r) {
    const Region& region = program.regions[r];
    if (region.opener == kNoStatement) continue;  // the main part of a called file
    if (region.end == kNoStatement || region.early_end != kNoStatement) return false;
    if (!program.at(region.opener).is(Keyword::kSub)) return false;
  }
  for (const Block& block : program.blocks) {
    if (block.end == kNoStatement || block.crossed != kNoBlock) return false;
  }
  for (StatementId id = 0; id < program.size(); ++id) {
    const Statement& s = program.at(id);
    if (s.kind == LineKind::kM98 || s.kind == LineKind::kContour) return false;
    if (s.kind != LineKind::kOWord) continue;
    if (s.label == kNoName || program.syntax.error(s) != nullptr) return false;
    if (part_of_block(s) && program.block_of[id] == kNoBlock) return false;
    const Region& region = program.regions[program.region_of[id]];
    const bool ends = s.is(Keyword::kEndsub) || s.is(Keyword::kReturn);
    if (ends && region.opener == kNoStatement) return false;
    if (s.opens_sub() && region.opener != id) return false;
  }
  return true;
}

bool has_shallow_calls(const Program& program) {
  // Longest chain from the main program, by rounds: after nine of them nothing may be left to deepen.
  std::unordered_map<NameId, std::vector<NameId>> callees;
  for (const Call& call : program.calls) {
    if (call.callee == kNoName) return false;
    callees[program.regions[call.caller].name].push_back(call.callee);
  }
  std::unordered_set<NameId> level{program.sub_file ? program.entry : kNoName};
  for (int depth = program.sub_file ? 1 : 0; depth <= kMaxCallDepth; ++depth) {
    std::unordered_set<NameId> next;
    for (const NameId name : level) {
      const auto found = callees.find(name);
      if (found != callees.end()) next.insert(found->second.begin(), found->second.end());
    }
    if (next.empty()) return true;
    level = std::move(next);
  }
  return false;
}

/// A part or end of a block that is inside another one, opened later, or that belongs to none at all: a skip can
/// land there. So is what a sub begins or ends in.
void mark_entered_sideways(const Program& program, std::vector<bool>& good) {
  struct Open {
    BlockId block;
    uint32_t subs;  ///< how many lines that begin or end a sub came before it
  };
  std::vector<Open> open;
  uint32_t subs = 0;
  for (StatementId id = 0; id < program.size(); ++id) {
    const Statement& s = program.at(id);
    if (!part_of_block(s)) {
      if (s.opens_sub() || s.is(Keyword::kEndsub) || s.has_m99()) ++subs;
      continue;
    }
    if (s.is(Keyword::kBreak) || s.is(Keyword::kContinue)) continue;  // these never end a skip
    const BlockId block = program.block_of[id];
    if (block != kNoBlock && program.blocks[block].opener == id) {
      open.push_back({block, subs});
      continue;
    }
    while (!open.empty() && open.back().block != block) {
      good[open.back().block] = false;
      open.pop_back();
    }
    if (open.empty() || program.blocks[block].end != id) continue;
    if (open.back().subs != subs) good[block] = false;
    open.pop_back();
  }
}

/// Subs in which a call stays until it comes back, whatever the rest of the program is like.
std::vector<bool> find_apart(const Program& program) {
  std::vector<bool> apart(program.regions.size());
  std::vector<uint8_t> definitions(program.syntax.names.size());  // by name, up to two
  for (const Statement& s : program.syntax.statements) {
    if (s.opens_sub() && s.label != kNoName && definitions[s.label] < 2) ++definitions[s.label];
  }
  const auto stays = [&](StatementId id) {
    const Statement& s = program.at(id);
    if (s.kind == LineKind::kWords || s.kind == LineKind::kProgramEnd) return true;
    if (s.kind != LineKind::kOWord || s.label == kNoName || program.syntax.error(s) != nullptr) return false;
    if (part_of_block(s)) return program.block_of[id] != kNoBlock;
    return s.is(Keyword::kCall) || s.is(Keyword::kReturn);
  };
  for (RegionId r = 1; r < program.regions.size(); ++r) {
    const Region& region = program.regions[r];
    if (region.opener == kNoStatement || region.end == kNoStatement || region.early_end != kNoStatement) continue;
    const Statement& end = program.at(region.end);
    if (!program.at(region.opener).is(Keyword::kSub) || !end.is(Keyword::kEndsub) || definitions[region.name] != 1)
      continue;
    bool all = program.syntax.error(program.at(region.opener)) == nullptr && program.syntax.error(end) == nullptr;
    for (StatementId id = region.opener + 1; all && id < region.end; ++id) all = stays(id);
    apart[r] = all;
  }
  for (const Block& block : program.blocks) {
    if (block.end == kNoStatement || block.crossed != kNoBlock) apart[block.region] = false;
  }
  return apart;
}

/// Labels that are on several blocks, or on lines of none, among the lines of one scope: `scope_of` a line, by name of
/// the sub or, for all else, their number. `bad` takes the blocks.
template <typename ScopeOf, typename Bad>
void find_shared_labels(const Program& program, const ScopeOf& scope_of, const Bad& bad) {
  const size_t names = program.syntax.names.size();
  Grouped scopes;
  scopes.assign(names + 1, static_cast<uint32_t>(program.size()), [&](StatementId id) {
    const Statement& s = program.at(id);
    return part_of_block(s) && s.label != kNoName ? scope_of(id) : Grouped::kNone;
  });
  std::vector<BlockId> owner(names);  // by label: the only block that has it in this scope, else kNoBlock
  std::vector<uint32_t> seen_in(names, UINT32_MAX);  // by label: the scope that `owner` is for
  for (uint32_t scope = 0; scope <= names; ++scope) {
    bool shared = false;
    for (const StatementId id : scopes[scope]) {
      const NameId label = program.at(id).label;
      const BlockId block = program.block_of[id];
      if (seen_in[label] != scope) {
        seen_in[label] = scope;
        owner[label] = block;
      } else if (owner[label] != block) {
        if (owner[label] != kNoBlock) bad(owner[label]);
        owner[label] = kNoBlock;
        shared = true;
      }
    }
    if (!shared) continue;
    for (const StatementId id : scopes[scope]) {
      const BlockId block = program.block_of[id];
      if (block != kNoBlock && owner[program.at(id).label] != block) bad(block);
    }
  }
}

bool has_computed_labels(const Program& program) {
  return std::ranges::any_of(program.syntax.statements, [](const Statement& s) {
    return part_of_block(s) && s.label == kNoName && s.label_expr != kNoExpr;
  });
}

std::vector<bool> structured_blocks(const Program& program, bool regular, const std::vector<bool>& apart) {
  if (has_computed_labels(program)) return std::vector<bool>(program.blocks.size());
  std::vector<bool> good(program.blocks.size(), true);
  mark_entered_sideways(program, good);
  // A scope is a sub where runs stay in their subs, else the whole file.
  const auto others = static_cast<uint32_t>(program.syntax.names.size());
  const auto sub_of = [&](StatementId id) {
    const NameId sub = program.regions[program.region_of[id]].name;
    return sub == kNoName ? others : sub;
  };
  const auto bad = [&](BlockId block) { good[block] = false; };
  if (regular) {
    find_shared_labels(program, sub_of, bad);
  } else {
    const auto is_apart = [&](BlockId block) { return apart[program.blocks[block].region]; };
    find_shared_labels(
        program, [&](StatementId) { return others; },
        [&](BlockId block) {
          if (!is_apart(block)) bad(block);
        });
    find_shared_labels(
        program, [&](StatementId id) { return apart[program.region_of[id]] ? sub_of(id) : Grouped::kNone; }, bad);
  }
  for (BlockId id = static_cast<BlockId>(program.blocks.size()); id-- > 0;) {
    const Block& block = program.blocks[id];
    if (block.end == kNoStatement || block.crossed != kNoBlock) good[id] = false;
    // Inner blocks come after their parents: by now all of them have been looked at.
    if (!good[id] && block.parent != kNoBlock) good[block.parent] = false;
  }
  return good;
}

}  // namespace

Structure::Structure(const Program& program)
    : regular(is_regular(program)),
      shallow_calls(regular && has_shallow_calls(program)),
      apart(find_apart(program)),
      structured(structured_blocks(program, regular, apart)) {}

}  // namespace owlint::flow
