#include "analyzer/flow/engine/extent_map.h"

#include "analyzer/flow/engine/iteration.h"

namespace owlint::flow {
namespace {

class Collector final : public Events, public PlaceWatch {
 public:
  Collector(Iteration& analysis, Extents& extents) : analysis_(analysis), extents_(extents) {
    analysis.machine().set_watch(this);
  }

  void stop(const State& at, StopReport) override {
    if (at.position == kNoStatement || analysis_.linked().at_end(at.position)) return;
    extents_.stop({analysis_.linked().file_of(at.position), analysis_.program().at(at.position).line});
  }
  void hazard(const State&, HazardReport) override {}
  void end(const State&) override {}
  void end_of_file(const State&) override {}

  void begin(const State&, StatementId line) override { extents_.go_on_in(analysis_.linked().file_of(line)); }
  bool visit(const Moves& moves) override { return extents_.visit(moves); }
  void lose(uint32_t line, AxisSet axes) override { extents_.lose(line, axes); }
  bool sees_all() const override { return true; }

 private:
  Iteration& analysis_;
  Extents& extents_;
};

}  // namespace

Extents extents_of(const Linked& linked, const Profile& profile, const Limits& limits) {
  const Program& main = *linked.files()[0].program;
  // Lines of the program's own file that run before any other: a file that is only called has none.
  Extents extents = main.syntax.extents != nullptr && !main.sub_file ? *main.syntax.extents : Extents();
  Iteration analysis(linked, profile, Detail::kBySize, nullptr, limits, kAllModes);
  Collector collector(analysis, extents);
  analysis.run(collector);
  return extents;
}

}  // namespace owlint::flow
