#include "analyzer/flow/summaries/data_flow.h"

#include <algorithm>
#include <bit>
#include <unordered_set>

namespace owlint::flow {

std::string parameter_text(const Program& program, ParameterId parameter) {
  return parameter.named ? "#<" + program.name(parameter.id) + ">" : "#" + std::to_string(parameter.id);
}

int Summary::last_argument() const { return arguments == 0 ? 0 : 31 - std::countl_zero(arguments); }

DataFlow::DataFlow(const Program& program, std::shared_ptr<const Structure> structure, const Limits& limits)
    : program_(program),
      limits_(limits),
      too_large_(program.size() > limits.data_flow_statements),
      structure_(std::move(structure)) {}

const Structure& DataFlow::structure() const {
  return structure_ != nullptr ? *structure_ : own_structure_.get([this] { return Structure(program_); });
}

const DataFlow::Lines& DataFlow::lines() const {
  return lines_.get([this] { return make_lines(); });
}

DataFlow::Lines DataFlow::make_lines() const {
  Grouped by_region;
  by_region.assign(program_.regions.size(), static_cast<uint32_t>(program_.size()),
                   [&](StatementId id) { return program_.region_of[id]; });
  AccessTable table(program_, by_region.all(), flow::reads_of(program_, shown()));
  std::vector<Sub> subs(program_.regions.size());
  for (RegionId r = 0; r < subs.size(); ++r) subs[r].accesses = table.lines(by_region.first(r), by_region[r].size());
  return {std::move(by_region), std::move(table), std::move(subs)};
}

const ControlFlow& DataFlow::flow_of(RegionId region) const {
  return look(region).flow.get([&] { return ControlFlow(program_, structure(), region, lines_of(region)); });
}

const Liveness& DataFlow::live_in(RegionId region) const {
  const Sub& sub = look(region);
  return sub.live.get([&] { return Liveness(flow_of(region), sub.accesses, region == kMainRegion, limits_); });
}

const Summary& DataFlow::of(RegionId region) const {
  static const Summary kNothing;
  if (too_large_) return kNothing;
  return look(region).summary.get([&] { return summarize(region); });
}

Summary DataFlow::summarize(RegionId region) const {
  const Sub& sub = look(region);
  Summary out;
  if (!live_in(region).known() || sub.accesses.size() == 0) return out;
  out.known = true;
  const NameId count = program_.syntax.names.find("n_args");  // how many were passed, if the INI wants it
  out.any_number = sub.accesses.reads_any() ||
      (count != kNoName && std::ranges::count(sub.accesses.all_reads(), kLocalNames + ParameterKey{count}) > 0);
  std::unordered_set<ParameterKey> met;
  for (const ParameterKey key : sub.accesses.all_reads()) {
    if (is_global(key) && met.insert(key).second) out.reads.push_back(parameter_of(key));
  }
  met.clear();
  for (const auto& write : sub.accesses.all_writes()) {
    if (write.key != kComputedKey && is_global(write.key) && met.insert(write.key).second)
      out.writes.push_back(parameter_of(write.key));
  }
  for (uint32_t n = 1; n < kFirstGlobalNumber; ++n) {
    if (live_in(region).before(0, n)) out.arguments |= 1U << n;
  }
  const auto& nodes = flow_of(region).nodes();
  std::vector<bool> seen(nodes.size());
  std::vector<NodeId> todo{0};
  bool with = false;
  bool without = false;
  while (!todo.empty()) {
    const NodeId id = todo.back();
    todo.pop_back();
    if (seen[id]) continue;
    seen[id] = true;
    const Statement& s = program_.at(nodes[id].statement);
    const bool comes_back = s.is(Keyword::kReturn) || s.is(Keyword::kEndsub);
    if (comes_back) (s.value_count > 0 ? with : without) = true;
    for (const NodeId next : nodes[id].next) {
      if (next < nodes.size()) todo.push_back(next);
    }
  }
  out.returns = with ? (without ? Returns::kSometimes : Returns::kValue) : Returns::kNothing;
  return out;
}

const std::vector<Shown>& DataFlow::shown() const {
  return shown_.get([this] { return shown_in_comments(program_); });
}

const Accesses& DataFlow::accesses_of(RegionId region) const { return look(region).accesses; }

std::span<const StatementId> DataFlow::lines_of(RegionId region) const { return lines().by_region[region]; }

void DataFlow::find_unused(RegionId region, std::vector<UnusedValue>& out) const {
  const Accesses& accesses = look(region).accesses;
  const auto interesting = [&](ParameterKey key) {
    return !is_global(key) && !(is_own_number(key) && accesses.reads_any());
  };
  if (std::ranges::none_of(accesses.all_writes(), [&](const auto& write) { return interesting(write.key); })) return;
  std::vector<ParameterKey> read(accesses.all_reads().begin(), accesses.all_reads().end());
  std::ranges::sort(read);
  const auto statement = [&](size_t line) { return lines_of(region)[line]; };
  // Numbers are anybody's: what the sub leaves in them is lost, which is another rule's, or the operator's. A name for
  // something that has a number or a name already is a remark as well.
  const auto never_read = [&](size_t line, const Write& write) {
    const Item& item = program_.syntax.items_of(program_.at(statement(line)))[write.item];
    const Operator value = program_.syntax.exprs[item.value].op;
    return !is_own_number(write.key) && value != Operator::kParameter && value != Operator::kNamed;
  };
  const auto overwritten = [&](size_t line, const Write& write) {
    if (line + 1 >= accesses.size()) return false;
    const Statement& next = program_.at(statement(line + 1));
    if (next.kind != LineKind::kWords || next.block_delete) return false;
    if (std::ranges::none_of(accesses.writes(line + 1), [&](const auto& other) { return other.key == write.key; }))
      return false;
    return std::ranges::count(accesses.reads(line + 1), write.key) == 0;
  };
  // All that a line does is to assign what nothing reads.
  const auto idle = [&](size_t line) {
    const Statement& s = program_.at(statement(line));
    return s.kind == LineKind::kWords && accesses.writes(line).size() == s.item_count &&
        std::ranges::none_of(accesses.writes(line), [&](const auto& write) {
             return is_global(write.key) || std::ranges::binary_search(read, write.key);
           });
  };
  const auto ends_here = [&](ParameterKey key) {
    if (region == kMainRegion || !is_own_number(key) || key == 0) return false;
    for (size_t line = 0; line < accesses.size(); ++line) {
      if (std::ranges::count(accesses.reads(line), key) > 0 && !idle(line)) return false;
    }
    return true;
  };
  std::unordered_set<ParameterKey> reported;
  for (size_t line = 0; line < accesses.size(); ++line) {
    for (const auto& write : accesses.writes(line)) {
      if (!interesting(write.key)) continue;
      if (!std::ranges::binary_search(read, write.key)) {
        if (!never_read(line, write) || !flow_of(region).known() || !reported.insert(write.key).second) continue;
        const auto argument = std::ranges::find_if(accesses.reads(line), ends_here);
        out.push_back({statement(line), write.item, parameter_of(write.key), kNoStatement,
                       argument == accesses.reads(line).end() ? 0 : static_cast<uint32_t>(*argument)});
      } else if (overwritten(line, write) && flow_of(region).known() &&
                 flow_of(region).nodes()[line].next[0] == line + 1) {
        out.push_back({statement(line), write.item, parameter_of(write.key), statement(line + 1)});
      }
    }
  }
}

std::span<const ParameterKey> DataFlow::reads_of(RegionId region) const { return look(region).accesses.all_reads(); }

const std::vector<UnusedValue>& DataFlow::unused() const {
  return unused_.get([this] {
    std::vector<UnusedValue> out;
    for (RegionId region = 0; region < program_.regions.size() && !too_large_; ++region) find_unused(region, out);
    std::ranges::stable_sort(out, {}, &UnusedValue::statement);
    return out;
  });
}

const std::vector<FixedCondition>& DataFlow::fixed() const {
  return fixed_.get([this] {
    std::vector<FixedCondition> out;
    if (!too_large_) find_fixed(out);
    return out;
  });
}

void DataFlow::find_fixed(std::vector<FixedCondition>& out) const {
  const Presets presets(program_);
  const auto tests = [this](StatementId id) {
    return program_.at(id).is(Keyword::kIf) || program_.at(id).is(Keyword::kWhile);
  };
  for (RegionId region = 0; region < program_.regions.size(); ++region) {
    if (std::ranges::none_of(lines_of(region), tests) || !flow_of(region).known()) continue;
    find_fixed_conditions(program_, flow_of(region), presets, limits_, out);
  }
  std::ranges::stable_sort(out, {}, &FixedCondition::statement);
}

bool DataFlow::surely_reads(RegionId region, uint32_t number) const {
  if (too_large_) return true;
  const Accesses& accesses = look(region).accesses;
  return std::ranges::count(accesses.all_reads(), number) > 0 &&
      std::ranges::none_of(accesses.all_writes(), [&](const auto& write) { return write.key == number; });
}

uint32_t DataFlow::left_behind(RegionId region) const {
  if (too_large_) return 0;
  const Accesses& accesses = look(region).accesses;
  uint32_t assigned = 0;
  for (const auto& write : accesses.all_writes()) {
    if (is_own_number(write.key) && write.key > 0) assigned |= 1U << write.key;
  }
  if (assigned == 0 || accesses.reads_any() || !live_in(region).known()) return 0;
  uint32_t out = 0;
  for (uint32_t n = 1; n < kFirstGlobalNumber; ++n) {
    if ((assigned >> n & 1) == 0) continue;
    const StatementId last = last_assignment(region, n);
    const auto line = static_cast<NodeId>(std::ranges::lower_bound(lines_of(region), last) - lines_of(region).begin());
    if (!live_in(region).after(line, n)) out |= 1U << n;
  }
  return out;
}

StatementId DataFlow::last_assignment(RegionId region, uint32_t number) const {
  const Accesses& accesses = look(region).accesses;
  for (size_t line = accesses.size(); line-- > 0;) {
    if (std::ranges::any_of(accesses.writes(line), [&](const auto& write) { return write.key == number; }))
      return lines_of(region)[line];
  }
  return kNoStatement;
}

bool DataFlow::expects_from_call(StatementId call, uint32_t number) const {
  const RegionId region = program_.region_of[call];
  const Accesses& accesses = look(region).accesses;
  if (accesses.writes_any() || !flow_of(region).known()) return false;
  if (std::ranges::any_of(accesses.all_writes(), [&](const auto& write) { return write.key == number; })) return false;
  // Nothing assigns it here, so what reads it after the call reads the caller's value.
  for (size_t line = accesses.size(); line-- > 0 && lines_of(region)[line] > call;) {
    if (std::ranges::count(accesses.reads(line), number) > 0) return true;
  }
  return false;
}

bool DataFlow::reads_after(StatementId line, ParameterKey key) const {
  const RegionId region = program_.region_of[line];
  const Accesses& accesses = look(region).accesses;
  if (too_large_ || !flow_of(region).known()) return false;
  const auto& nodes = flow_of(region).nodes();
  std::vector<bool> seen(nodes.size());
  std::vector<NodeId> todo;
  const auto go_on = [&](NodeId from) {
    for (const NodeId next : nodes[from].next) {
      if (next < nodes.size() && !seen[next]) todo.push_back(next);
    }
  };
  go_on(static_cast<NodeId>(std::ranges::lower_bound(lines_of(region), line) - lines_of(region).begin()));
  while (!todo.empty()) {
    const NodeId id = todo.back();
    todo.pop_back();
    if (seen[id]) continue;
    seen[id] = true;
    if (std::ranges::count(accesses.reads(id), key) > 0) return true;
    if (std::ranges::count(accesses.writes(id), key, &Write::key) == 0) go_on(id);
  }
  return false;
}

std::span<const DataFlow::Assignment> DataFlow::assignments(RegionId region, ParameterKey key) const {
  const Sub& sub = look(region);
  const std::vector<Assignment>& all = sub.assignments.get([&] {
    std::vector<Assignment> out;
    for (size_t line = 0; line < sub.accesses.size(); ++line) {
      for (const Write& write : sub.accesses.writes(line)) out.emplace_back(write.key, lines_of(region)[line]);
    }
    std::ranges::sort(out);
    return out;
  });
  const auto first = std::ranges::lower_bound(all, key, {}, &Assignment::first);
  return {first, std::ranges::upper_bound(all, key, {}, &Assignment::first)};
}

bool DataFlow::read_above(RegionId region, StatementId place, ParameterKey key) const {
  const Accesses& accesses = look(region).accesses;
  const size_t last = static_cast<size_t>(std::ranges::lower_bound(lines_of(region), place) - lines_of(region).begin());
  return std::ranges::count(accesses.all_reads().first(accesses.first_read(last)), key) > 0;
}

StatementId DataFlow::first_assignment(RegionId region, ParameterKey key) const {
  const auto known = assignments(region, key);
  return known.empty() ? kNoStatement : known.front().second;
}

bool DataFlow::assigned_before(RegionId region, StatementId place, ParameterKey key) const {
  const auto known = assignments(region, key);
  if (known.empty()) return false;
  if (known.front().second < place) return true;
  for (BlockId id = program_.open_above(region, place); id != kNoBlock; id = program_.blocks[id].parent) {
    const Block& block = program_.blocks[id];
    if (block.kind != Keyword::kIf && block.end != kNoStatement && known.front().second <= block.end) return true;
  }
  return false;
}

}  // namespace owlint::flow
