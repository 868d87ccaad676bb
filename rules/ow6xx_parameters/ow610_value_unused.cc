// OW610 value-unused: a parameter that is assigned and never read, or assigned again on the next line.
// Depends on: names without `_` are the sub's own; a line's values are read before it assigns.
#include <algorithm>
#include <optional>
#include <set>

#include "analyzer/syntax/look_alike.h"
#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow610 {
namespace {

std::string sorted(std::string text) {
  std::ranges::sort(text);
  return text;
}

/// The name that was probably meant: one that this sub reads, or a global one that any reads, with a letter more or less, or the
/// same letters. Names that differ in one letter are often those of two axes.
std::string meant(const Input& in, const flow::UnusedValue& unused) {
  const Program& p = in.program;
  const std::string& text = p.name(unused.parameter.id);
  const std::string letters = sorted(text);
  std::vector<std::string> names;
  const auto add = [&](RegionId region, bool own) {
    for (const flow::ParameterKey key : in.data.reads_of(region)) {
      const flow::ParameterId other = flow::parameter_of(key);
      if (!other.named || (!own && !flow::is_global(key)) || other.id == unused.parameter.id) continue;
      const std::string& name = p.name(other.id);
      if (name.size() != text.size() || sorted(name) == letters) names.push_back(name);
    }
  };
  const RegionId own = p.region_of[unused.statement];
  for (RegionId region = 0; region < p.regions.size(); ++region) add(region, region == own);
  return nearest(text, names, 2);
}

/// The names that OW603 finds to be read without a value: with the region that reads them.
using Missing = std::set<std::pair<RegionId, std::string>>;

Missing missing_names(const Input& in) {
  const Program& p = in.program;
  Missing missing;
  for (const FlowStop& stop : in.flow.stops) {
    if (stop.kind == StopKind::kNameUndefined && stop.statement != kNoStatement)
      missing.emplace(p.region_of[stop.statement], stop.detail);
  }
  for (RegionId region = 1; region < p.regions.size(); ++region) {
    if (reached(in, region)) continue;
    for (const flow::ParameterKey key : in.data.reads_of(region)) {
      const flow::ParameterId read = flow::parameter_of(key);
      if (read.named && !flow::is_global(key) && in.data.first_assignment(region, key) == kNoStatement)
        missing.emplace(region, p.name(read.id));
    }
  }
  return missing;
}

/// Whether OW603 says of the name that was meant that it has no value: then that is the finding.
bool said_where_it_is_read(const Input& in, const flow::UnusedValue& unused, const std::string& meant,
                           const Missing& missing) {
  const std::string& name = in.program.name(unused.parameter.id);
  const RegionId region = in.program.region_of[unused.statement];
  const auto looks_like = [&](const auto& read) {
    return read.first == region && plain_text(read.second) == plain_text(name);
  };
  return (missing.contains({region, meant}) && near_name(in, meant, region).name == name) ||
      std::ranges::any_of(missing, looks_like);
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  std::optional<Missing> missing;
  constexpr size_t kMaxSuggestions = 20;  // each goes through all names
  size_t suggestions = 0;
  for (const flow::UnusedValue& u : in.data.unused()) {
    const std::string words = parameter_words(p, u.parameter);
    const std::string where = region_words(p, p.region_of[u.statement]);
    if (u.overwritten != kNoStatement) {
      Finding& f =
          out.add(item_span(p, u.statement, u.item), words + " is assigned again before anything reads this value");
      relate(f, p, u.overwritten, "assigned again here");
      f.help = "remove one of the two lines, or assign to another parameter";
      f.reach = in.flow.reach(u.statement);
      continue;
    }
    const RegionId sub = p.region_of[u.statement];
    // What the caller reads under the same name is said as a lost result, or as a name without a value.
    if (u.parameter.named && sub != kMainRegion && call_before_reading(in, sub, u.parameter.id) != nullptr) continue;
    const std::string near = suggestions++ < kMaxSuggestions ? meant(in, u) : std::string();
    if (u.parameter.named && suggestions <= kMaxSuggestions) {
      if (!missing) missing = missing_names(in);
      if (said_where_it_is_read(in, u, near, *missing)) continue;
    }
    Finding& f = out.add(item_span(p, u.statement, u.item), words + " is assigned here and never read in " + where);
    f.reach = in.flow.reach(u.statement);
    if (!near.empty()) {
      f.help = "did you mean `#<" + near + ">`?";
    } else if (u.argument != 0) {
      f.message += ": argument `#" + std::to_string(u.argument) + "` has no effect";
      f.help = "use the value, or remove the argument";
    } else {
      f.help = "remove the line";
      f.weight = Weight::kRemark;
    }
    if (in.profile.may_be_python()) f.weight = Weight::kRemark;  // a remap's Python code may read the names of its sub
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW610",
    .name = "value-unused",
    .summary = "a parameter that is assigned but never read, or overwritten before it is read",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A name that a sub or the main program assigns but never reads, while it reads another name with
almost the same spelling. An argument that only goes into such a name, and so has no effect. A value
that the next line overwrites.

Other unread names are reported as info, and only if you select the rule (`--extend-select OW610`):
without the line the program would do the same. A name that `(debug, …)`, `(print, …)`, `(log, …)` or `(msg, …)` mentions counts
as read. A name that only renames another parameter (`#<feed> = #3`) is not reported. Other programs
may read global names and numbers above `#30`, and the Python code of a machine may read all names
if the INI has a `[PYTHON]` section.)",
            .why = R"(LinuxCNC makes a new parameter for every new name. So a typing error sets a parameter that nothing
reads, and the intended one keeps its old value. There is no message: in the first program below the
machine goes to X10.)",
            .bad = R"(G21 G90
#<width> = 10
G0 Z5 Y#<width>
#<widht> = 60
G0 X#<width>
M2
)",
            .good = R"(G21 G90
#<width> = 10
G0 Z5 Y#<width>
#<width> = 60
G0 X#<width>
M2
)",
            .fix = R"(Correct the name, or remove the line.)",
            .level_reason = "Warning if a value is lost: the name is nearly one that is read, the next line overwrites "
                            "the value, or an argument is never read. Info for a line that has no effect.",
            .interpreter = "",
            .options = "",
            .moves = "X10",
            .moves_good = "X60",
        },
    .check = check,
};

}  // namespace owlint::rules::ow610
