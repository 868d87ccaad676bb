#include "analyzer/flow/engine/debug.h"

#include <bit>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "analyzer/flow/domain/modes.h"
#include "analyzer/flow/engine/iteration.h"

namespace owlint::flow {
namespace {

/// X, Y and Z of the current point; `?` where a coordinate depends on where the machine stood.
std::string text_of(const Place& place) {
  std::string out;
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    const Coordinate at = place.at[axis];
    const char letter = kAxisOrder[static_cast<size_t>(axis)];
    out += fmt::format("{}{}{}", out.empty() ? "" : " ", letter, at.is_known() ? fmt::format("{:g}", at.value) : "?");
  }
  return out;
}

std::string text_of(Mode mode, const KnownSet& set) {
  std::string out;
  for (ValueSet rest = set.members; rest != 0; rest &= rest - 1)
    out += (out.empty() ? "" : "|") + value_name(mode, static_cast<uint8_t>(std::countr_zero(rest)));
  return set.open ? out + " open" : out;
}

std::string text_of(ValueId value, const KnownValues& values) {
  switch (value) {
    case kUnassigned: return "not assigned";
    case kUnknown: return "assigned";
    case kMaybeUnassigned: return "assigned on some paths";
    case kNotPassed: return "not passed";
    case kNotReturned: return "not returned";
    case kCleared: return "cleared";
    case kMaybeNotReturned: return "not returned on some paths";
    default: break;
  }
  if (KnownValues::is_constant(value)) return fmt::format("{:g}", values.value(value));
  if (KnownValues::is_set(value))
    return fmt::format("{:#x}{}", values.set(value).members, values.set(value).open ? " open" : "");
  if (KnownValues::is_place(value)) return text_of(values.place(value));
  const Range range = values.range(value);
  return fmt::format("{}{:g}..{:g}{}", range.above_low ? ">" : "", range.low, range.high, range.below_high ? "<" : "");
}

std::string text_of(uint8_t flag) {
  std::string out;
  for (const auto& [bit, word] : {std::pair(kNo, "no"), std::pair(kYes, "yes"), std::pair(kStale, "stale")}) {
    if ((flag & bit) != 0) out += (out.empty() ? "" : "|") + std::string(word);
  }
  return out;
}

/// Collects, line by line, what the iteration executes and joins.
class Watcher final : public Events {
 public:
  Watcher(Iteration& analysis, const Linked& linked) : analysis_(analysis), at_(linked.program().size() + 1) {}

  void stop(const State& at, StopReport report) override { note(at, "stops: " + report.message); }
  void hazard(const State&, HazardReport) override {}
  void end(const State& at) override { note(at, "ends"); }
  void end_of_file(const State& at) override { note(at, "the file ends"); }
  void executed(const State& state) override {
    const auto& trace = *analysis_.trace();
    const RecordId from = trace.at(state.record).parent;
    std::string line = fmt::format("step {}", state.record);
    if (from != kNoRecord) line += fmt::format(" from {}", from);
    if (state.branch != Branch::kNone) line += state.branch == Branch::kTrue ? " (true)" : " (false)";
    note(state, line + ": " + text_of(state));
  }
  void joined(const State& state, const Partition& partition) override {
    const Precision& precision = analysis_.precision();
    note(state,
         fmt::format("joined: {} states are kept apart here, and the limit after {} steps is {}", partition.seen.size(),
                     precision.steps(), precision.now().states));
  }

  void write(std::ostream& out, const Linked& linked) const {
    for (StatementId id = 0; id < at_.size(); ++id) {
      if (at_[id].empty()) continue;
      if (linked.at_end(id)) {
        out << "end of file\n";
      } else {
        const Source& source = linked.source_of(id);
        const Statement& s = linked.program().at(id);
        out << fmt::format("{}:{}: {}\n", source.path(), s.line, source.slice(s.whole()));
      }
      for (const std::string& note : at_[id]) out << "  " << note << '\n';
    }
    const Calls& calls = analysis_.calls();
    for (ContextId context = 1; context < calls.size(); ++context) {
      const Frame& frame = calls[context];
      out << fmt::format("call {}: o<{}>, {} callers, {} exits{}{}\n", context,
                         analysis_.machine().name(frame.info.sub), frame.callers.size(), frame.exits.size(),
                         frame.joined_entry != nullptr ? ", entries joined" : "",
                         frame.joined_exit != Frame::kNoExit ? ", exits joined" : "");
    }
    const FlowStatistics statistics = analysis_.statistics();
    out << fmt::format("{} steps, {} states joined\n", statistics.steps, statistics.merges);
  }

 private:
  void note(const State& at, std::string text) { at_[at.position].push_back(std::move(text)); }

  std::string text_of(const State& state) const {
    std::string out = fmt::format("call {}", state.context);
    const auto add = [&](const std::string& part) { out += ", " + part; };
    if (state.skip != kNoLabel) add("skips to o<" + analysis_.machine().full_text(state.skip) + ">");
    if (state.seek) add("seeks its sub");
    if (state.joined) add("joined");
    if (state.mixed) add("mixed");
    const auto add_flag = [&](const char* name, uint8_t flag) {
      if (flag != kNo) add(fmt::format("{} {}", name, flow::text_of(flag)));
    };
    add_flag("branch taken", state.flags.executed);
    add_flag("breaking", state.flags.breaking);
    add_flag("continuing", state.flags.continuing);
    add_flag("returned", state.flags.returned);
    state.table.for_each([&](FullLabel label, uint32_t packed) {
      std::string lines;
      const Definers::Set set = analysis_.machine().definers().get(packed);
      for (const StatementId line : set.lines) lines += fmt::format(" {}", analysis_.program().at(line).line);
      add(fmt::format("o<{}> at{}{}", analysis_.machine().full_text(label), lines,
                      set.undefined ? " or undefined" : ""));
    });
    for (const auto& [label, count] : state.counts.all())
      add(fmt::format("o<{}> {} passes left", analysis_.machine().full_text(label),
                      count < kManyLeft ? std::to_string(count) : "some"));
    add_values(state.parameters.locals, kLocalNames, add);
    add_values(state.parameters.globals, kGlobalNames, add);
    return out;
  }

  template <typename Add>
  void add_values(const PersistentMap& map, uint32_t names, const Add& add) const {
    const KnownValues& values = analysis_.machine().evaluator().values();
    map.for_each([&](uint32_t key, uint32_t value) {
      if (key >= kModeKeys && key < kModeKeys + kModes && KnownValues::is_set(value)) {
        const auto mode = static_cast<Mode>(key - kModeKeys);
        return add(fmt::format("{} {}", mode_name(mode), flow::text_of(mode, values.set(value))));
      }
      if (key == kPlaceKey) return add("at " + flow::text_of(value, values));
      const bool named = key >= names && key - names < analysis_.program().syntax.names.size();
      const std::string name = named ? "<" + analysis_.program().name(key - names) + ">" : std::to_string(key);
      add(fmt::format("#{} {}", name, flow::text_of(value, values)));
    });
  }

  Iteration& analysis_;
  std::vector<std::vector<std::string>> at_;  // by statement
};

}  // namespace

void write_states(std::ostream& out, const Linked& linked, const Profile& profile, const Limits& limits) {
  Iteration analysis(linked, profile, Detail::kBySize, nullptr, limits);
  Watcher watcher(analysis, linked);
  analysis.run(watcher);
  watcher.write(out, linked);
}

}  // namespace owlint::flow
