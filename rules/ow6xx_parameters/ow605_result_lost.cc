// OW605 result-lost: a sub leaves a result in #1 to #30 for its caller.
// Depends on: a call passes values; it saves #1 to #30 and restores all of them on return (measured).
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow605 {
namespace {

/// A sub in the file of a program, with what its lines do.
struct Sub {
  const Program* program = nullptr;
  const flow::DataFlow* data = nullptr;
  RegionId region = kMainRegion;
};

/// Finds subs in this file and in others.
class Subs {
 public:
  explicit Subs(const Input& in) : in_(in) {}

  Sub called_by(const Call& call) {
    if (call.target != kNoRegion) return {&in_.program, &in_.data, call.target};
    if (call.callee == kNoName) return {};
    const uint32_t file = in_.linked.target(in_.program.name(call.callee)).file;
    if (file == CallTarget::kNotFound || in_.linked.files()[file].program.get() == &in_.program) return {};
    const Program& p = *in_.linked.files()[file].program;
    const NameId name = p.syntax.names.find(in_.program.name(call.callee));
    for (RegionId r = 1; r < p.regions.size(); ++r) {
      if (p.regions[r].name == name) return {&p, &files_.try_emplace(file, p).first->second, r};
    }
    return {};
  }

 private:
  const Input& in_;
  std::map<uint32_t, flow::DataFlow> files_;
};

/// Whether the last line of a sub that assigns #n gives it a number.
bool sets_number(const Sub& sub, uint32_t n) {
  const Program& p = *sub.program;
  return std::ranges::any_of(p.syntax.items_of(p.at(sub.data->last_assignment(sub.region, n))), [&](const Item& item) {
    return flow::assigns(item) && flow::key_of_target(p.syntax, item) == n &&
        p.syntax.exprs[item.value].op == Operator::kNumber;
  });
}

/// Whether a sub changes an argument for its caller: it assigns #n last without using that. One that only sets an argument to a
/// number, which it has used before, may tidy up.
bool changes(const Sub& sub, uint32_t n) {
  if ((sub.data->left_behind(sub.region) >> n & 1) == 0) return false;
  const bool used = (sub.data->of(sub.region).arguments >> n & 1) != 0;
  return !used || !sets_number(sub, n);
}

/// Which numbers of a sub a finding is about: one mistake, one finding.
using Told = std::set<std::tuple<const Program*, RegionId, uint32_t>>;

/// Numbers that a sub assigns without using them, and that the main program reads after the call.
void check_numbers(const Input& in, const Call& call, const Sub& sub, const Told& told, Reporter& out) {
  const Program& p = in.program;
  const bool here = sub.program == &p;
  const uint32_t left = sub.data->left_behind(sub.region);
  for (uint32_t n = 1; left != 0 && n < flow::kFirstGlobalNumber; ++n) {
    // Where the caller sets the number itself, only what the sub computes for nobody else is meant for it.
    const bool expected = (left >> n & 1) != 0 &&
        (in.data.expects_from_call(call.statement, n) ||
         (!sets_number(sub, n) && in.data.reads_after(call.statement, n)));
    if (!expected || told.contains({sub.program, sub.region, n})) continue;
    const StatementId assigned = sub.data->last_assignment(sub.region, n);
    const std::string number = "`#" + std::to_string(n) + "`";
    Finding& f = here ? out.add(p.at(assigned).whole(),
                                number + " is assigned here, but the caller does not see it: the end of " +
                                    region_words(p, sub.region) + " restores the caller's " + number)
                      : out.add(p.at(call.statement).head_span(),
                                number + " is read after this call, but its end restores the caller's " + number +
                                    ": what the sub assigns is lost");
    if (here) {
      relate(f, p, call.statement, "called here; " + number + " is read after the call");
    } else {
      f.related.push_back({sub.program->at(assigned).whole(), number + " is assigned here", sub.program->source});
    }
    f.help = "return it with `endsub [#" + std::to_string(n) +
        "]` and read `#<_value>`, or use a number above #30 or a name that begins with `_`";
    f.reach = in.flow.reach(call.statement);
  }
}

/// Names that a sub assigns and never reads, and that its caller sets and reads after the call: they are two parameters.
void check_names(const Input& in, const Call& call, const Sub& sub, Reporter& out) {
  const Program& p = in.program;
  const Program& other = *sub.program;
  for (const flow::UnusedValue& u : sub.data->unused()) {
    if (!u.parameter.named || u.overwritten != kNoStatement || other.region_of[u.statement] != sub.region) continue;
    const std::string& text = other.name(u.parameter.id);
    const NameId name = p.syntax.names.find(text);
    if (name == kNoName || text.starts_with('_')) continue;
    const flow::ParameterKey key = flow::key_of_name(p.syntax, name);
    // Where nothing sets it, it is said there.
    if (in.data.first_assignment(call.caller, key) == kNoStatement || !in.data.reads_after(call.statement, key))
      continue;
    const std::string words = "`#<" + text + ">`";
    const Span assigned = item_span(other, u.statement, u.item);
    const std::string reason = ": a name without `_` belongs to the sub in which it is assigned";
    Finding& f = &other == &p
        ? out.add(assigned, words + " is assigned here, but the caller does not see it" + reason)
        : out.add(p.at(call.statement).head_span(),
                  words + " is read after this call, but the sub assigns a `#<" + text + ">` of its own" + reason);
    if (&other == &p) {
      relate(f, p, call.statement, "called here; the caller reads its own " + words + " after the call");
    } else {
      f.related.push_back({assigned, words + " is assigned here", other.source});
    }
    f.help = "return it with `" + p.label_text(call.callee) + " endsub [#<" + text + ">]`, and write `#<" + text +
        "> = #<_value>` after the call";
    f.reach = in.flow.reach(call.statement);
  }
}

/// Parameters that are passed to a sub which changes its argument, and read after the call as if they were changed.
class ByReference {
 public:
  ByReference(const Input& in, Reporter& out) : in_(in), out_(out), subs_(in) {}

  void check(const Call& call) {
    const Program& p = in_.program;
    const Statement& s = p.at(call.statement);
    if (s.has_error()) return;
    const std::span<const ExprId> values = p.syntax.values_of(s);
    for (uint32_t i = 0; i < values.size() && i + 1 < flow::kFirstGlobalNumber; ++i) {
      const auto key = passed_parameter(p, values[i]);
      const Sub sub = key ? subs_.called_by(call) : Sub{};
      if (sub.program == nullptr) continue;
      constexpr int kMostTries = 100;  // each may go through all lines
      const auto [tries, first] = left_.try_emplace({sub.program, sub.region, i + 1}, kMostTries);
      if (first && !changes(sub, i + 1)) tries->second = 0;
      if (tries->second == 0) continue;
      --tries->second;
      if (assigns(sub, *key) || !in_.data.reads_after(call.statement, *key)) continue;
      tries->second = 0;
      told_.insert({sub.program, sub.region, i + 1});
      report(call, sub, i + 1, *key);
    }
  }

  const Told& told() const { return told_; }

 private:
  /// Whether the sub itself assigns what the caller has passed, as it may with a global.
  bool assigns(const Sub& sub, flow::ParameterKey key) const {
    if (!flow::is_global(key)) return false;
    const std::vector<flow::ParameterId>& writes = sub.data->of(sub.region).writes;
    const std::string text = flow::parameter_text(in_.program, flow::parameter_of(key));
    return std::ranges::any_of(writes,
                               [&](flow::ParameterId w) { return flow::parameter_text(*sub.program, w) == text; });
  }

  void report(const Call& call, const Sub& sub, uint32_t n, flow::ParameterKey key) {
    const Program& p = in_.program;
    const std::string text = flow::parameter_text(p, flow::parameter_of(key));
    const std::string words = "`" + text + "`";
    const std::string own = "`#" + std::to_string(n) + "`";
    const std::string name = "`" + p.label_text(call.callee) + "`";
    const StatementId assigned = sub.data->last_assignment(sub.region, n);
    const bool here = sub.program == &p;
    const std::string stays = "a call passes only values, so the caller's " + words + " does not change";
    Finding& f = here ? out_.add(p.at(assigned).whole(), name + " changes its own " + own + " here: " + stays)
                      : out_.add(p.at(call.statement).head_span(), name + " changes its own " + own + ": " + stays);
    if (here) {
      relate(f, p, call.statement, words + " is passed here and read after the call");
    } else {
      f.related.push_back({sub.program->at(assigned).whole(), own + " is changed here", sub.program->source});
    }
    f.help = "return the new value with `" + p.label_text(call.callee) + " endsub [#" + std::to_string(n) +
        "]`, and write `" + text + " = #<_value>` after the call";
    f.reach = in_.flow.reach(call.statement);
  }

  const Input& in_;
  Reporter& out_;
  Subs subs_;
  Told told_;
  std::map<std::tuple<const Program*, RegionId, uint32_t>, int>
      left_;  ///< by sub and argument: calls that may still be looked at
};

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  std::set<std::pair<const Program*, RegionId>> seen;
  ByReference by_reference(in, out);
  Subs subs(in);
  for (const Call& call : p.calls) {
    if (p.at(call.statement).kind == LineKind::kM98) continue;  // shares the numbers
    by_reference.check(call);
  }
  for (const Call& call : p.calls) {
    if (p.at(call.statement).kind == LineKind::kM98) continue;
    // In a sub, what it reads may be its own argument. The first call has the most lines after it.
    if (call.caller != kMainRegion) continue;
    const Sub sub = subs.called_by(call);
    if (sub.program == nullptr || !seen.emplace(sub.program, sub.region).second) continue;
    check_numbers(in, call, sub, by_reference.told(), out);
    check_names(in, call, sub, out);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW605",
    .name = "result-lost",
    .summary = "a sub assigns #1 to #30 for its caller, but the call restores them",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A sub puts its result into one of `#1` to `#30` and does not use it itself. The main program reads
this number after the call and never sets it.

The same holds for a name without `_`: the `#<result>` of the sub is not that of its caller.

Or a sub changes an argument: the caller passes a parameter and reads it after the call as if the
sub had changed it: `#1 = [#1 + 1]` in the sub, `o<next> call [#5]`, then `X#5`. A parameter that
`(debug, #5)` or another such comment shows counts as read.)",
            .why = R"(A call saves `#1` to `#30` and restores them when the sub returns. The sub's result is lost: the
caller gets its own old value, usually 0. There is no message. Nothing is passed by reference: the sub
gets the values of its arguments.)",
            .bad = R"(G21 G90
o100 sub
  #5 = [#1 + #2]
o100 endsub
G0 X50 Z5
o100 call [10] [20]
G0 X#5
M2
)",
            .good = R"(G21 G90
o100 sub
  #5 = [#1 + #2]
o100 endsub [#5]
G0 X50 Z5
o100 call [10] [20]
G0 X#<_value>
M2
)",
            .fix = R"(Return one value with `endsub [...]`. For several values, use numbers above `#30` or names that
begin with `_`.)",
            .level_reason = "Warning: the program runs, but its caller keeps the old value.",
            .interpreter = "",
            .options = "",
            .moves = "X0",
            .moves_good = "X30",
        },
    .check = check,
};

}  // namespace owlint::rules::ow605
