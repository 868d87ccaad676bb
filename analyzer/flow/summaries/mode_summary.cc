#include "analyzer/flow/summaries/mode_summary.h"

#include <bit>

#include "analyzer/flow/facts/mode_uses.h"

namespace owlint::flow {
namespace {

/// What one mode is set to in a sub.
struct Settings {
  ValueSet values = 0;
  bool always = false;  ///< by a line that is in no block
};

class Builder {
 public:
  Builder(const Program& program, RegionId region) : program_(program), region_(region) {}

  ModeSummary build() {
    const Region& region = program_.regions[region_];
    const StatementId first = region.opener == kNoStatement ? 0 : region.opener;
    if (region.opener == kNoStatement) {
      for (const ModeNeed& need : program_.syntax.first_needs) this->need(need);
      for (const ModeChange& change : program_.syntax.first_changes) set(change.mode, change.value, true);
    }
    for (StatementId id = first; id < program_.size() && (id < region.last || region.opener == kNoStatement); ++id) {
      if (program_.region_of[id] == region_) add(id);
    }
    ModeSummary out;
    out.needs = std::move(needs_);
    for (const auto& [mode, settings] : set_) {
      out.changes.push_back(mode);
      if (settings.always && is_single(settings.values))
        out.leaves.emplace(mode, static_cast<uint8_t>(std::countr_zero(settings.values)));
    }
    return out;
  }

 private:
  void need(const ModeNeed& need) {
    // Every move depends on these, and hardly any sub means one of them.
    if (need.mode == Mode::kDiameter || need.mode == Mode::kRetract || need.mode == Mode::kCompensation) return;
    if (!set_.contains(need.mode)) needs_.try_emplace(need.mode, need.line);
  }
  void set(Mode mode, uint8_t value, bool always) {
    Settings& settings = set_[mode];
    settings.values |= value == ModeChange::kAny ? all_values(mode) : value_bit(value);
    settings.always = settings.always || always;
  }

  void add(StatementId id) {
    const Statement& s = program_.at(id);
    const bool always = program_.block_of[id] == kNoBlock;
    if (s.kind == LineKind::kModeLine) add_words(s, always);
    for (const ModeNeed& need : program_.syntax.needs_after(id)) this->need(need);
    for (const ModeChange& change : program_.syntax.changes_after(id)) set(change.mode, change.value, always);
  }

  void add_words(const Statement& s, bool always) {
    const MachineWords machine;
    WordLine words(machine);
    if (!read_words(program_.syntax, s, words)) return;
    const ModeState before = ModeState::unknown();
    ModeState after = before;
    std::vector<ModeFault> faults;
    ModeRun(machine, words).run(&after, &faults);
    for (size_t i = 0; i < kModes; ++i) {
      const auto mode = static_cast<Mode>(i);
      if ((after.now.assigned & mask_of(mode)) == 0) continue;
      const bool known = !after.now.is_open(mode) && is_single(after.now[mode]);
      set(mode, known ? static_cast<uint8_t>(std::countr_zero(after.now[mode])) : ModeChange::kAny, always);
    }
  }

  const Program& program_;
  RegionId region_;
  std::map<Mode, uint32_t> needs_;
  std::map<Mode, Settings> set_;
};

}  // namespace

ModeSummary summary_of_modes(const Program& program, RegionId region) { return Builder(program, region).build(); }

}  // namespace owlint::flow
