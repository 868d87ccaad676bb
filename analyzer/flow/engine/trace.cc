#include "analyzer/flow/engine/trace.h"

#include <algorithm>

namespace owlint::flow {
namespace {

void pack(const std::vector<std::pair<RecordId, RecordId>>& edges, size_t nodes, bool forward,
          std::vector<uint32_t>& first, std::vector<uint32_t>& list) {
  first.assign(nodes + 1, 0);
  for (const auto& [from, to] : edges) ++first[(forward ? from : to) + 1];
  for (size_t i = 1; i <= nodes; ++i) first[i] += first[i - 1];
  list.resize(edges.size());
  std::vector<uint32_t> fill(first.begin(), first.end() - 1);
  for (const auto& [from, to] : edges) list[fill[forward ? from : to]++] = forward ? to : from;
}

}  // namespace

/// Tarjan's strongly connected components, with the recursion as a stack of (record, next edge): by record the number of
/// its component, from 1, or 0 if there is no way from it back to it. The edges of record i are `next[first[i]]` up to
/// `next[first[i + 1]]`.
std::vector<uint32_t> Trace::ways_round(const std::vector<uint32_t>& first, const std::vector<uint32_t>& next) {
  const auto size = static_cast<RecordId>(first.size() - 1);
  constexpr uint32_t kNew = 0;
  std::vector<uint32_t> order(size, kNew);
  std::vector<uint32_t> low(size);
  std::vector<uint32_t> group(size);
  std::vector<bool> open(size);
  std::vector<RecordId> stack;
  std::vector<std::pair<RecordId, uint32_t>> walk;
  uint32_t count = 0;
  uint32_t groups = 0;
  const auto enter = [&](RecordId id) {
    order[id] = low[id] = ++count;
    stack.push_back(id);
    open[id] = true;
    walk.emplace_back(id, first[id]);
  };
  for (RecordId start = 0; start < size; ++start) {
    if (order[start] != kNew) continue;
    enter(start);
    while (!walk.empty()) {
      auto& [id, edge] = walk.back();
      if (edge < first[id + 1]) {
        const RecordId to = next[edge++];
        if (order[to] == kNew) {
          enter(to);
        } else if (open[to]) {
          low[id] = std::min(low[id], order[to]);
        }
        continue;
      }
      const RecordId done = id;
      walk.pop_back();
      if (!walk.empty()) low[walk.back().first] = std::min(low[walk.back().first], low[done]);
      if (low[done] != order[done]) continue;
      const bool self =
          std::find(next.begin() + first[done], next.begin() + first[done + 1], done) != next.begin() + first[done + 1];
      const bool cycle = stack.back() != done || self;
      if (cycle) ++groups;
      RecordId member = kNoRecord;
      while (member != done) {
        member = stack.back();
        stack.pop_back();
        open[member] = false;
        if (cycle) group[member] = groups;
      }
    }
  }
  return group;
}

void Trace::finish() {
  std::vector<std::pair<RecordId, RecordId>> edges;
  for (const Link& link : links_) edges.emplace_back(link.from, link.to);
  for (RecordId id = 0; id < records_.size(); ++id) {
    if (records_[id].parent != kNoRecord) edges.emplace_back(records_[id].parent, id);
  }
  pack(edges, records_.size(), true, next_first_, next_);
  pack(edges, records_.size(), false, previous_first_, previous_);
  std::vector<RecordId> ends;
  for (const auto& [at, key] : terminals_) ends.push_back(at);
  ends_at_.assign(records_.size(), false);
  for (const RecordId end : ends) ends_at_[end] = true;
  hanging_ = backward_from(ends);
  hanging_.flip();
}

std::vector<bool> Trace::backward_from(const std::vector<RecordId>& goals) const {
  std::vector<bool> seen(records_.size());
  std::vector<RecordId> todo;
  for (const RecordId goal : goals) {
    if (!seen[goal]) todo.push_back(goal);
    seen[goal] = true;
  }
  while (!todo.empty()) {
    const RecordId id = todo.back();
    todo.pop_back();
    for (uint32_t i = previous_first_[id]; i < previous_first_[id + 1]; ++i) {
      if (seen[previous_[i]]) continue;
      seen[previous_[i]] = true;
      todo.push_back(previous_[i]);
    }
  }
  return seen;
}

bool Trace::only_end(uint32_t key) const {
  return std::ranges::all_of(terminals_, [key](const auto& t) { return t.second == key; }) &&
      std::ranges::find(hanging_, true) == hanging_.end();
}

/// Whether a run can go round for ever within the given records, none of which leads to an end.
bool Trace::has_cycle(const std::vector<bool>& within) const {
  const auto inside = [&](RecordId id) { return within[id] && hanging_[id]; };
  std::vector<uint32_t> ways_on(records_.size());
  std::vector<RecordId> dead_ends;
  size_t left = 0;
  for (RecordId id = 0; id < records_.size(); ++id) {
    if (!inside(id)) continue;
    ++left;
    for (uint32_t i = next_first_[id]; i < next_first_[id + 1]; ++i) ways_on[id] += inside(next_[i]) ? 1 : 0;
    if (ways_on[id] == 0) dead_ends.push_back(id);
  }
  while (!dead_ends.empty()) {
    const RecordId id = dead_ends.back();
    dead_ends.pop_back();
    --left;
    for (uint32_t i = previous_first_[id]; i < previous_first_[id + 1]; ++i) {
      const RecordId before = previous_[i];
      if (inside(before) && --ways_on[before] == 0) dead_ends.push_back(before);
    }
  }
  return left > 0;
}

std::vector<uint32_t> Trace::idle_cycles() const {
  // What a call does is one edge over it: its own lines, and the ways back to other callers, are no way round.
  std::vector<std::pair<RecordId, RecordId>> edges = calls_;
  for (const Link& link : links_) {
    if (link.branch != Branch::kTrue && !records_[link.to].after_call) edges.emplace_back(link.from, link.to);
  }
  for (RecordId id = 0; id < records_.size(); ++id) {
    const Record& record = records_[id];
    if (record.parent != kNoRecord && record.branch != Branch::kTrue && !record.after_call)
      edges.emplace_back(record.parent, id);
  }
  std::vector<uint32_t> first;
  std::vector<uint32_t> next;
  pack(edges, records_.size(), true, first, next);
  return ways_round(first, next);
}

std::vector<uint32_t> Trace::closed_cycles(const std::function<bool(RecordId, RecordId)>& removed) const {
  std::vector<std::pair<RecordId, RecordId>> edges;
  for_edges([&](RecordId from, RecordId to) {
    if (!removed(from, to)) edges.emplace_back(from, to);
  });
  std::vector<uint32_t> first;
  std::vector<uint32_t> next;
  pack(edges, records_.size(), true, first, next);
  std::vector<uint32_t> group = ways_round(first, next);
  std::vector<bool> left(records_.size() + 1);  // by group
  for (const auto& [from, to] : edges) {
    if (group[from] != group[to]) left[group[from]] = true;
  }
  for (uint32_t& number : group) {
    if (left[number]) number = 0;
  }
  return group;
}

bool Trace::is_left_out(StatementId statement) const {
  return std::ranges::any_of(left_out_,
                             [&](const auto& lines) { return statement >= lines.first && statement < lines.second; });
}

bool Trace::avoidable(StatementId statement) const {
  const auto hits = [&](RecordId id) { return records_[id].statement == statement && records_[id].executed; };
  std::vector<bool> seen(records_.size());
  std::vector<RecordId> todo{0};
  seen[0] = !hits(0);
  if (hits(0)) todo.clear();
  while (!todo.empty()) {
    const RecordId id = todo.back();
    todo.pop_back();
    if (ends_at_[id]) return true;
    for (uint32_t i = next_first_[id]; i < next_first_[id + 1]; ++i) {
      if (seen[next_[i]] || hits(next_[i])) continue;
      seen[next_[i]] = true;
      todo.push_back(next_[i]);
    }
  }
  return has_cycle(seen);
}

std::vector<Decision> Trace::path(RecordId stop, uint32_t key) const {
  std::vector<bool> can_stop;
  if (records_.size() < path_records_) {
    std::vector<RecordId> goals;
    for (const auto& [at, k] : terminals_) {
      if (k == key && (unsure_.contains(stop) || !unsure_.contains(at))) goals.push_back(at);
    }
    can_stop = backward_from(goals);
  }
  std::vector<Decision> path;
  for (RecordId id = stop; records_[id].parent != kNoRecord; id = records_[id].parent) {
    const Record& record = records_[id];
    if (record.branch == Branch::kNone) continue;
    const RecordId parent = record.parent;
    bool decides = can_stop.empty();
    for (uint32_t i = next_first_[parent]; !decides && i < next_first_[parent + 1]; ++i) decides = !can_stop[next_[i]];
    if (!decides) continue;
    // In a loop or a recursion the last pass is the one that counts.
    const StatementId decided = records_[parent].statement;
    if (std::ranges::find(path, decided, &Decision::statement) != path.end()) continue;
    path.push_back({decided, record.branch == Branch::kTrue});
    if (path.size() == path_decisions_) break;
  }
  std::ranges::reverse(path);
  return path;
}

}  // namespace owlint::flow
