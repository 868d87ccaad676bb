#include "rules/driver/block_helpers.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "analyzer/machine/predefined.h"
#include "rules/driver/wrong_ends.h"

namespace owlint::rules {
namespace {

/// The ancestors of a statement's place, outermost first, each with the index of the branch that holds it.
std::vector<std::pair<BlockId, size_t>> branches_of(const Program& program, StatementId id) {
  std::vector<std::pair<BlockId, size_t>> out;
  BlockId at = program.block_of[id];
  if (at != kNoBlock && program.blocks[at].opener == id) at = program.blocks[at].parent;
  constexpr size_t kMaxDepth = 64;  // deeper nests are not compared
  for (; at != kNoBlock && out.size() < kMaxDepth; at = program.blocks[at].parent) {
    const auto parts = program.parts[at];
    const auto branch = std::ranges::upper_bound(parts, id) - parts.begin();
    out.emplace_back(at, static_cast<size_t>(branch));
  }
  std::ranges::reverse(out);
  return out;
}

}  // namespace

bool is_forgotten_end(const Program& p, StatementId id) {
  const Statement& s = p.at(id);
  const BlockId block = p.block_of[id];
  return s.is(Keyword::kBare) && !s.has_error() && !s.name_open && block != kNoBlock &&
      p.blocks[block].mistaken_end == id;
}

void tell_forgotten_end(const Program& p, StatementId id, Finding& f) {
  const Block& block = p.blocks[p.block_of[id]];
  const std::string right = p.label_at(id) + " " + std::string(spelling(end_of(block.kind)));
  f.message = "`" + p.head(id) + "` has no keyword, so it does not close `" + p.head_of(block) + "` on line " +
      std::to_string(p.at(block.opener).line) + ": LinuxCNC reads it as the beginning of a Fanuc-style sub";
  f.help = "write `" + right + "`";
  f.fixes.push_back({f.help, false, {{p.at(id).head_span(), right}}, true});
  relate(f, p, block.opener, "`" + p.head_of(block) + "` begins here");
}

std::string with_article(Keyword keyword) {
  const std::string word(spelling(keyword));
  const bool vowel = !word.empty() && std::string_view("aeiou").find(word[0]) != std::string_view::npos;
  return (vowel ? "an `" : "a `") + word + "`";
}

namespace {

/// The block in whose branches two lines are, each in another one; none if one run can get to both.
BlockId dividing_block(const Program& program, StatementId a, StatementId b) {
  const auto left = branches_of(program, a);
  const auto right = branches_of(program, b);
  for (size_t i = 0; i < std::min(left.size(), right.size()); ++i) {
    if (left[i].first != right[i].first) return kNoBlock;
    if (left[i].second != right[i].second) return left[i].first;
  }
  return kNoBlock;
}

/// Whether a value is made of numbers and of what the machine decides on once. Depth is bounded by the length of a line.
bool decided_by_machine(const Syntax& syntax, ExprId value) {
  const Expr& expr = syntax.exprs[value];
  if (expr.op == Operator::kNumber) return true;
  if (expr.op == Operator::kNamed) return fixed_by_machine(syntax.names.text(expr.name()));
  if (expr.op == Operator::kParameter || expr.op == Operator::kExistsNamed || expr.op == Operator::kExistsNumbered)
    return false;
  return decided_by_machine(syntax, expr.left()) &&
      (expr.right() == kNoExpr || decided_by_machine(syntax, expr.right()));
}

}  // namespace

bool in_exclusive_branches(const Program& program, StatementId a, StatementId b) {
  return dividing_block(program, a, b) != kNoBlock;
}

bool divided_by_machine(const Program& program, StatementId a, StatementId b) {
  const BlockId block = dividing_block(program, a, b);
  if (block == kNoBlock) return false;
  const auto decided = [&](StatementId id) {
    const Statement& s = program.at(id);
    return s.is(Keyword::kElse) ||
        (s.value_count > 0 && decided_by_machine(program.syntax, program.syntax.values_of(s).front()));
  };
  return decided(program.blocks[block].opener) && std::ranges::all_of(program.parts[block], decided);
}

bool has_unreadable_line(const Input& in, NameId label, RegionId region) {
  return in.index.unreadable.contains(static_cast<uint64_t>(region) << 32 | label);
}

bool has_misread_opener(const Input& in, StatementId id) {
  const auto opener = in.index.openers.find({in.program.region_of[id], in.program.at(id).label});
  return opener != in.index.openers.end() && opener->second < id && in.program.at(opener->second).has_error();
}

bool loops_again(const Input& in, StatementId id) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  if ((!s.is(Keyword::kEndwhile) && !s.is(Keyword::kEndrepeat)) || p.block_of[id] != kNoBlock || !in.flow.executed[id])
    return false;
  return std::ranges::any_of(in.flow.hazards, [&](const Hazard& h) {
    if (h.kind != HazardKind::kEndlessLoop || p.region_of[h.statement] != p.region_of[id]) return false;
    const BlockId block = p.block_of[h.statement];
    return ended_again(p, block, id) != nullptr;
  });
}

void add_relabel_fix(const Input& in, StatementId opener, Finding& finding) {
  const BlockId id = in.program.block_of[opener];
  if (id == kNoBlock || in.program.blocks[id].end == kNoStatement) return;
  const Block& block = in.program.blocks[id];
  constexpr StatementId kLargest = 2000;  // nobody relabels by hand what is larger than this
  if (block.end - block.opener > kLargest) return;
  const std::string label = free_label(in, block.label);
  if (label.empty()) return;
  Fix fix;
  fix.title = "use the free number " + label + " for this block";
  for (StatementId at = block.opener; at <= block.end; ++at) {
    if (in.program.block_of[at] == id) fix.edits.push_back({in.program.at(at).label_span(), label});
  }
  // Relabelling is only safe where the interpreter stopped anyway, and where the lines are this block's beyond doubt.
  fix.safe = finding.stops;
  fix.if_all_stop = true;
  for (BlockId outer = block.parent; outer != kNoBlock; outer = in.program.blocks[outer].parent) {
    if (in.program.blocks[outer].label == block.label) fix.safe = false;
  }
  finding.fixes.push_back(std::move(fix));
}

void check_label_reused(const Input& in, Reporter& out, Keyword keyword) {
  const Program& p = in.program;
  const auto report = [&](StatementId at, StatementId other) -> Finding* {
    const Statement& first = p.at(other);
    Finding& f = out.add(p.at(at).label_span(),
                         "label `" + p.label_text(p.at(at).label) + "` is already used for " +
                             with_article(first.keyword) + " on line " + std::to_string(first.line));
    relate(f, p, other, "first used here");
    f.help = "give this block another label, on all of its lines";
    return &f;
  };
  const auto stop = [&](const FlowStop& s) -> Finding* {
    if (p.at(s.statement).label == kNoName || s.other == kNoStatement) {
      Finding& f = out.add(p.at(s.statement).label_span(), "this label is already used");
      f.help = "give this block another label, on all of its lines";
      return &f;
    }
    Finding* f = report(s.statement, s.other);
    f->stops = true;
    if (tell_wrong_end(p, s.statement, *f)) return f;
    add_relabel_fix(in, s.statement, *f);
    return f;
  };
  for_stops(in, out, stop);
  for_warned(in, out, [&](const FlowStop& s) -> Finding* {
    FlowStop with_other = s;
    for (const StatementId at :
         p.at(s.statement).label == kNoName ? std::span<const StatementId>{} : p.by_label[p.at(s.statement).label]) {
      if (at != s.statement && opens_block(p.at(at).keyword) && p.region_of[at] == p.region_of[s.statement]) {
        with_other.other = at;
        break;
      }
    }
    Finding* f = stop(with_other);
    f->stops = false;
    return f;
  });
  for (const auto& [first, later] : in.index.shared_labels) {
    if (!p.at(later).is(keyword) || has_stop(in, later) || in.flow.executed[later]) continue;
    if (in_exclusive_branches(p, first, later)) continue;  // OW214 reports those
    Finding* f = report(later, first);
    f->reach = Reach::kNever;
    add_relabel_fix(in, later, *f);
  }
}

namespace {

/// Whether an end at `line` would be this block's: its sub is closed, but further down; no branch of the block around it
/// comes in between, nor its end, nor has an outer one its label.
bool may_end_at(const Program& p, const Block& block, StatementId line) {
  const Region& region = p.regions[block.region];
  if (block.region != kMainRegion && (region.end == kNoStatement || region.early_end < line)) return false;
  if (block.parent == kNoBlock) return true;
  for (BlockId outer = block.parent; outer != kNoBlock; outer = p.blocks[outer].parent) {
    if (p.blocks[outer].label == block.label) return false;
  }
  if (p.blocks[block.parent].end < line) return false;
  return std::ranges::none_of(p.parts[block.parent],
                              [&](StatementId part) { return part > block.opener && part < line; });
}

/// By label: the first block outside all subs that nothing closes; blocks are in the order of regions. To skip it can
/// lead into a sub.
std::unordered_map<NameId, StatementId> unclosed_in_main(const Program& p) {
  std::unordered_map<NameId, StatementId> out;
  for (const Block& block : p.blocks) {
    if (block.region != kMainRegion) break;
    if (block.end == kNoStatement && block.label != kNoName) out.try_emplace(block.label, block.opener);
  }
  return out;
}

/// Whether lines with the block's label follow, which would then be without it; also where that takes long to find out.
bool comes_again(const Program& p, const Block& block, StatementId line) {
  constexpr size_t kHorizon = 4096;
  const StatementId last = p.regions[block.region].last;
  const auto lines = p.by_label[block.label];
  const auto from = std::ranges::upper_bound(lines, line);
  for (auto at = from; at != lines.end() && *at < last; ++at) {
    if (p.region_of[*at] == block.region || static_cast<size_t>(at - from) == kHorizon) return true;
  }
  return false;
}

/// A branch or a jump whose label no open block has: the innermost block around it that has such lines is probably meant.
void add_label_fix(const Program& p, StatementId id, Finding& finding) {
  const Statement& line = p.at(id);
  const bool branch = line.is(Keyword::kElse) || line.is(Keyword::kElseif);
  if ((!branch && !line.is(Keyword::kBreak) && !line.is(Keyword::kContinue)) || line.label == kNoName) return;
  const auto place = [](const Block& b) { return std::pair(b.region, b.opener); };
  const auto after = std::ranges::upper_bound(p.blocks, std::pair(p.region_of[id], id), {}, place);
  if (after == p.blocks.begin() || std::prev(after)->region != p.region_of[id]) return;
  for (auto number = static_cast<BlockId>(after - p.blocks.begin() - 1); number != kNoBlock;
       number = p.blocks[number].parent) {
    const Block& block = p.blocks[number];
    const StatementId end = block.end == kNoStatement ? block.mistaken_end : block.end;
    if (end == kNoStatement || end < id) continue;
    if (branch ? block.kind != Keyword::kIf : block.kind != Keyword::kWhile && block.kind != Keyword::kDo) {
      if (branch) return;  // a branch within another block is none of the `if` around that
      continue;
    }
    if (block.label == line.label) return;  // the right one already: something else is wrong
    if (p.at(block.opener).block_delete && !line.block_delete) return;  // where that is left out, this one still stops
    const std::string label = p.label_text(block.label);
    finding.help = "write `" + label + " " + std::string(spelling(line.keyword)) + "`, if `" + p.head_of(block) +
        "` on line " + std::to_string(p.at(block.opener).line) + " is the one you mean";
    const bool shared = std::ranges::any_of(p.by_label[block.label], [&](StatementId other) {
      return other < id && other != block.opener && p.region_of[other] == block.region &&
          opens_block(p.at(other).keyword);
    });
    if (shared) return;  // the label would name the block that had it first
    finding.fixes.push_back({"write `" + label + "`", false, {{line.label_span(), label}}});
    return;
  }
}

}  // namespace

void check_parts(const Input& in, Reporter& out, bool (*wanted)(Keyword), std::string_view openers) {
  const Program& p = in.program;
  std::optional<std::unordered_map<NameId, StatementId>> around;
  const auto report = [&](const FlowStop& s) -> Finding* {
    const Statement& line = p.at(s.statement);
    const std::string head = p.head(s.statement);
    const BlockId id = p.block_of[s.statement];
    const Block* block = id == kNoBlock ? nullptr : &p.blocks[id];
    if (block != nullptr && block->mistaken_end == s.statement) {
      Finding& f = out.add(line.label_span(),
                           "`" + head + "` does not close `" + p.head_of(*block) + "` on line " +
                               std::to_string(p.at(block->opener).line));
      relate(f, p, block->opener, "`" + p.head_of(*block) + "` begins here");
      const std::string right = p.label_text(block->label) + " " + std::string(spelling(end_of(block->kind)));
      f.help = "write `" + right + "`";
      if (block->kind == Keyword::kDo)
        f.help = "write `" + right + " [...]`; the loop goes on while the condition is true";
      if (!around) around = unclosed_in_main(p);
      const auto unclosed = around->find(line.label);
      if (block->region != kMainRegion && unclosed != around->end() && unclosed->second < s.statement) {
        relate(f, p, unclosed->second, "if this is skipped, `" + head + "` ends it");
        f.help = "close `" + p.head(unclosed->second) + "` before the sub";
        return &f;
      }
      // Where its label was another block's before, the end would be that one's; that of another kind of block below may come
      // first in the next pass of a loop.
      const bool shared = std::ranges::any_of(in.index.shared_labels, [&](const auto& pair) {
        return pair.second == block->opener ||
            (pair.first == block->opener && !p.at(pair.second).is(p.at(block->opener).keyword));
      });
      if (shared || block->crossed != kNoBlock || !may_end_at(p, *block, s.statement)) return &f;
      if (block->label != line.label) {
        f.fixes.push_back(
            {"write `" + right + "`", !comes_again(p, *block, s.statement), {{line.head_span(), right}}, true});
      } else if (block->kind != Keyword::kDo) {
        f.fixes.push_back(
            {"write `" + right + "`", true, {{line.keyword_span(), std::string(spelling(end_of(block->kind)))}}, true});
      }
      return &f;
    }
    if (s.other != kNoStatement) {
      const Statement& opener = p.at(s.other);
      Finding& f = out.add(line.label_span(),
                           "`" + head + "` has the label of `" + p.head(s.other) + "` on line " +
                               std::to_string(opener.line) + ", which is no " + std::string(openers));
      relate(f, p, s.other, "the label is used here");
      const BlockId ended = p.block_of[s.other];
      const auto reopens = [&](const Block& other) {
        return other.label == line.label && p.blocks[ended].end < other.opener && other.opener < s.statement;
      };
      const bool over = opener.is(Keyword::kDo) && line.is(Keyword::kEndwhile) && ended != kNoBlock &&
          p.blocks[ended].end != kNoStatement && p.blocks[ended].end < s.statement &&
          std::ranges::none_of(p.blocks, reopens);
      if (over) {
        const Statement& end = p.at(p.blocks[ended].end);
        f.message = "`" + head + "`, but `" + p.head(p.blocks[ended].end) + "` on line " + std::to_string(end.line) +
            " has already ended the loop";
        f.help = "remove the line: a `do` ends with its `while`";
        f.fixes.push_back({"remove `" + head + "`", false, {{line.head_span(), ""}}});
        return &f;
      }
      f.help = "write the label of the " + std::string(openers) + " that it belongs to";
      if (opener.is(Keyword::kRepeat) && (line.is(Keyword::kBreak) || line.is(Keyword::kContinue)))
        f.help = "a `repeat` cannot be left early: write the loop as a `while` with a counter";
      return &f;
    }
    if (block != nullptr && block->crossed != kNoBlock) {
      const Block& outer = p.blocks[block->crossed];
      Finding& f = out.add(line.label_span(),
                           "`" + head + "` is outside `" + p.head_of(outer) + "`, but its block begins inside: if `" +
                               p.head_of(outer) + "` is skipped, the label is unknown here");
      relate(f, p, block->opener, "`" + p.head_of(*block) + "` begins here");
      relate(f, p, outer.end, "`" + p.head_of(outer) + "` ends here");
      f.help = "close the inner block before the end of the outer one";
      return &f;
    }
    const Region& region = p.regions[p.region_of[s.statement]];
    const bool cut = region.early_end != kNoStatement && region.early_end < s.statement;
    Finding& f = out.add(line.label_span(), "`" + head + "` has no " + std::string(openers) + " with this label");
    if (cut) {
      // The interpreter skipped the definition only up to its first `endsub`.
      f.message = "`" + head + "` is outside the sub: `" + p.head(region.early_end) + "` on line " +
          std::to_string(p.at(region.early_end).line) + " has already ended it";
      relate(f, p, region.early_end, "the sub ends here");
      f.help = "write `return` instead of the early `endsub`";
    }
    if (f.help.empty()) {
      f.help = "correct the label, or remove the line";
      if (const uint32_t deleted = deleted_opener(p, line.label, opens_block); deleted != 0) {
        f.message += ": the line that begins its block has a `/`";
        f.related.push_back(
            {p.source->line(deleted), "where block delete is on, LinuxCNC leaves this line out", nullptr});
        f.help = "write the `/` on all lines of the block, or on none";
        return &f;
      }
      add_label_fix(p, s.statement, f);
      const auto misread = in.index.openers.find({p.region_of[s.statement], line.label});
      if (misread != in.index.openers.end() && misread->second < s.statement) {
        f.message += ": " + misread_words(p, misread->second);
        f.fixes.clear();
        name_misread(p, misread->second,
                     p.label_at(s.statement) + " " + std::string(spelling(meant_by(p, misread->second).keyword)), f);
      }
    }
    return &f;
  };
  for_stops(in, out, report);
  for_warned(in, out, [&](const FlowStop& s) -> Finding* {
    // The end of a block whose opener had a used label: said there already.
    const BlockId block = p.block_of[s.statement];
    if (block != kNoBlock && p.blocks[block].end == s.statement && has_stop(in, p.blocks[block].opener)) return nullptr;
    return report(s);
  });
  for (const StatementId id : in.index.stray_parts) {
    const Statement& s = p.at(id);
    if (!wanted(s.keyword) || has_stop(in, id)) continue;
    if (has_unreadable_line(in, s.label, p.region_of[id]) || loops_again(in, id) || has_misread_opener(in, id) ||
        p.regions[p.region_of[id]].likely_end == id)
      continue;
    FlowStop unmet;
    unmet.statement = id;
    if (Finding* f = report(unmet)) f->reach = in.flow.reach(id);
  }
}

}  // namespace owlint::rules
