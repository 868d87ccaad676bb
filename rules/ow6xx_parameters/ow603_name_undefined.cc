// OW603 name-undefined: a named parameter that is read where some path has not assigned it.
// Depends on (measured): reading an unassigned name stops the run; `#<name>` is local to the sub that runs, `#<_name>` is
// global. A name reads 0 in the value that it is first assigned, and a comment shows one that is not assigned as `######`.
#include <cctype>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "analyzer/machine/predefined.h"
#include "analyzer/machine/remap_names.h"
#include "analyzer/syntax/look_alike.h"
#include "rules/driver/ini_places.h"
#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow603 {
namespace {

/// What is said of `#<_ini[section]entry>`, which the machine's INI does not have.
void tell_entry(const Profile& profile, const std::string& name, Finding& f) {
  f.message = name + " is read here, but " +
      (profile.setup->reads_ini ? "the machine's INI has no number for it"
                                : "`INI_VARS = 0` in the machine's INI hides its entries");
  if (relate_given_name(profile, "", std::string_view(name).substr(3), f)) return;
  f.help =
      "write section and entry in capital letters in the INI, and only a decimal number: no unit, no comment after it; "
      "`EXISTS[#<…>]` tests it first";
  const size_t open = name.find('['), close = name.find(']'), end = name.find('>');
  if (open == std::string::npos || close == std::string::npos || end == std::string::npos || end < close) return;
  if (relate_unread_entry(profile, std::string_view(name).substr(open + 1, close - open - 1),
                          std::string_view(name).substr(close + 1, end - close - 1), f))
    f.help = "write the entry where LinuxCNC looks for it; `EXISTS[#<…>]` tests it first";
}

/// Says which name was probably meant: another one that has a value.
void suggest(const Input& in, const std::string& name, RegionId reader, Finding& f) {
  const NearName near = near_name(in, name, reader);
  if (near.name.empty()) {
    if (reader != kMainRegion && !name.starts_with('_')) {
      f.help = "assign it in the sub, pass it as an argument, or write `#<_" + name +
          ">`, which is global: a name without `_` starts without a value in every call";
    }
    return;
  }
  f.help = "did you mean `#<" + near.name + ">`?";
  relate(f, in.program, near.assigned, "`#<" + near.name + ">` is assigned here");
}

/// Finds the words for a local name that is read without a value: which other name was probably meant.
class LocalNames {
 public:
  explicit LocalNames(const Input& in) : in_(in) {}

  /// Words for another one's name, which becomes a place of the finding.
  std::string belongs(const Elsewhere& other, Finding& f) const {
    const std::string whose = region_words(*other.program, other.program->region_of[other.statement]);
    relate(in_, f, other, "assigned here for " + whose);
    return "the one on " + line_words(in_, other) + " belongs to " + whose;
  }

  /// Finds the words, the position and the help for a name that `reader` reads. `caller`: the call in which it does, if known.
  void explain(const std::string& name, RegionId reader, const Elsewhere& caller, Finding& f) {
    if (in_.data.too_large() || ++asked_ > kMost) return;
    const Program& p = in_.program;
    if (assigns(reader, name)) return;
    const Elsewhere other = owner(name, reader, caller);
    if (other.statement == kNoStatement) return suggest(in_, name, reader, f);
    f.message = "`#<" + name + ">` has no value in " + region_words(p, reader) + ": " + belongs(other, f);
    const RegionId owner_region = other.program->region_of[other.statement];
    if (other.program == &p && p.sub_file && owner_region == kMainRegion && reader != kMainRegion) {
      const std::string line = line_words(in_, other);
      f.message = "`#<" + name + ">` has no value here: a call of this file leaves out " + line + ", which assigns it";
      f.related.back().message = "no call of the file runs this line";
      f.help = "move " + line + " into the sub";
      return;
    }
    // A sub for M98 has no `endsub` that returns a value.
    const StatementId owner_opener = other.program->regions[owner_region].opener;
    const bool of_m98 = owner_opener != kNoStatement && !other.program->at(owner_opener).is(Keyword::kSub);
    if (reader == kMainRegion && of_m98) {
      f.help = "write `#<_" + name + ">` in both places, which is global";
      return;
    }
    f.help = (reader == kMainRegion
                  ? "return the value with `endsub [#<" + name + ">]`, and read `#<_value>`"
                  : "a name without `_` starts without a value in every call: pass the value as an argument") +
        ", or write `#<_" + name + ">` in both places, which is global";
  }

  /// The same for a global name.
  void explain_global(const std::string& name, RegionId reader, Finding& f) {
    f.help = "assign `#<" + name + ">` first";
    if (!in_.data.too_large() && ++asked_ <= kMost) suggest(in_, name, reader, f);
  }

  /// The same for a name that a sub assigns from itself, which is 0 there (measured).
  void explain_zero(const std::string& name, RegionId sub, Finding& f) {
    const Program& p = in_.program;
    f.message = "`#<" + name + ">` is 0 here: a name without `_` starts without a value in every call of " +
        region_words(p, sub);
    const auto call = std::ranges::find(p.calls, sub, &Call::target);
    const Elsewhere other = owner(name, sub, call == p.calls.end() ? Elsewhere{} : Elsewhere{&p, call->statement});
    if (other.statement != kNoStatement) f.message += "; " + belongs(other, f);
    f.help = "pass the value as an argument, or write `#<_" + name + ">`, which is global";
  }

  /// Whether a line of the region assigns the name.
  bool assigns(RegionId region, const std::string& name) const {
    const NameId id = in_.program.syntax.names.find(name);
    return id != kNoName &&
        in_.data.first_assignment(region, flow::key_of_name(in_.program.syntax, id)) != kNoStatement;
  }

 private:
  /// A line that assigns the name for somebody else: for the caller, or else in the caller's file, or else in this one.
  Elsewhere owner(const std::string& name, RegionId reader, const Elsewhere& caller) const {
    Elsewhere found = caller.program == nullptr ? Elsewhere{} : in_file(name, reader, caller);
    if (found.statement == kNoStatement) found = in_file(name, reader, {&in_.program, kNoStatement});
    return found;
  }

  Elsewhere in_file(const std::string& name, RegionId reader, const Elsewhere& caller) const {
    const Program& p = *caller.program;
    const NameId id = p.syntax.names.find(name);
    Elsewhere first;
    for (StatementId line = 0; id != kNoName && line < p.size(); ++line) {
      for (const Item& item : p.syntax.items_of(p.at(line))) {
        if (item.target_name != id || (&p == &in_.program && p.region_of[line] == reader)) continue;
        if (caller.statement != kNoStatement && p.region_of[line] == p.region_of[caller.statement]) return {&p, line};
        if (first.program == nullptr) first = {&p, line};
      }
    }
    return first;
  }

  static constexpr int kMost = 100;  // each goes through all lines

  const Input& in_;
  int asked_ = 0;
};

/// Whether a remap may give a name to the sub whose lines read it.
bool given(const Input& in, const std::string& name, RegionId reader) {
  return enters_from_outside(in.program, reader) && remap_gives(name, in.program.name(in.program.entry), in.profile);
}

/// Calls `each` for the names that a value reads, and for those that it asks for.
// Depth is bounded by the length of a line.
template <typename Each>
void for_names(const Program& p, ExprId id, const Each& each) {
  const Expr& expr = p.syntax.exprs[id];
  if (expr.op == Operator::kNamed || expr.op == Operator::kExistsNamed)
    return each(expr.name(), expr.op == Operator::kExistsNamed);
  for_each_operand(expr, [&](ExprId operand) { for_names(p, operand, each); });
}

/// The same for all values of a line.
template <typename Each>
void for_names_of(const Program& p, const Statement& s, const Each& each) {
  if (s.label_expr != kNoExpr) for_names(p, s.label_expr, each);
  for (const ExprId value : p.syntax.values_of(s)) for_names(p, value, each);
  for (const Item& item : p.syntax.items_of(s)) for_names(p, item.value, each);
}

/// Names that a sub assigns from themselves: they do not keep what an earlier call has left in them.
void check_own_values(const Input& in, LocalNames& names, Reporter& out) {
  const Program& p = in.program;
  for (RegionId r = 1; r < p.regions.size(); ++r) {
    for (const StatementId id : in.data.lines_of(r)) {
      const std::span<const Item> items = p.syntax.items_of(p.at(id));
      for (uint32_t i = 0; i < items.size(); ++i) {
        const Item& item = items[i];
        if (item.target_name == kNoName) continue;
        bool reads_itself = false;
        for_names(p, item.value,
                  [&](NameId name, bool exists) { reads_itself |= name == item.target_name && !exists; });
        if (!reads_itself) continue;
        const std::string& name = p.name(item.target_name);
        const flow::ParameterKey key = flow::key_of_name(p.syntax, item.target_name);
        if (name.starts_with('_') || in.data.assigned_before(r, id, key) || in.data.read_above(r, id, key) ||
            given(in, name, r))
          continue;
        Finding& f = out.add(item_span(p, id, i), "");
        names.explain_zero(name, r, f);
        f.reach = in.flow.reach(id);
      }
    }
  }
}

/// Names without a value in comments that show them.
void check_comments(const Input& in, LocalNames& names, Reporter& out) {
  const Program& p = in.program;
  for (const flow::Shown& shown : in.data.shown()) {
    if (!shown.acts || shown.local.empty() || given(in, shown.local, shown.region)) continue;
    const StatementId above = shown.above;
    if (above != kNoStatement && p.at(above).kind == LineKind::kProgramEnd) continue;
    if (shown.key != flow::kComputedKey &&
        in.data.assigned_before(shown.region, above == kNoStatement ? 0 : above + 1, shown.key))
      continue;
    // Without an INI, a name that the sub assigns below may be one that Python gives it.
    const bool below =
        shown.key != flow::kComputedKey && in.data.first_assignment(shown.region, shown.key) != kNoStatement;
    if (below && in.profile.setup == nullptr && enters_from_outside(p, shown.region)) continue;
    const bool runs = reached(in, shown.region);
    if (runs && above != kNoStatement && in.flow.reach(above) == Reach::kNever) continue;
    Finding& f = out.add(shown.span, "`#<" + shown.local + ">` has no value here");
    names.explain(shown.local, shown.region, {}, f);
    f.message += "; LinuxCNC shows `######`";
    if (f.help.empty()) f.help = "assign it first";
    f.reach = !runs ? Reach::kNever : above == kNoStatement ? Reach::kAlways : in.flow.reach(above);
  }
}

/// Names that the lines of a sub read and never assign, in subs that no run gets to.
void check_unreached(const Input& in, LocalNames& names, Reporter& out) {
  const Program& p = in.program;
  for (RegionId r = 1; r < p.regions.size(); ++r) {
    if (reached(in, r)) continue;
    const auto missing = [&](NameId name) {
      const std::string& text = p.name(name);
      return !text.starts_with('_') && !remap_gives(text, "", {}) &&
          in.data.first_assignment(r, flow::key_of_name(p.syntax, name)) == kNoStatement;
    };
    std::set<NameId> told;
    for (const StatementId id : in.data.lines_of(r)) {
      for_names_of(p, p.at(id), [&](NameId name, bool exists) {
        if (!missing(name) || !told.insert(name).second || exists) return;
        Finding& f = out.add(read_span(p, id, "#<" + p.name(name) + ">"),
                             "`#<" + p.name(name) + ">` is read here, but " + region_words(p, r) + " never assigns it");
        f.help = "assign it first, or pass it as an argument";
        names.explain(p.name(name), r, {}, f);
        f.reach = Reach::kNever;
      });
    }
  }
}

/// `X#<rot Y#<rot>`: the next name is read as a part of the one whose `>` is missing. That one, as it is written; empty for
/// other names.
std::string open_name(const Program& p, const Statement& s, const std::string& name) {
  if (name.find("#<") == std::string::npos) return {};
  const std::string_view line = p.source->slice(s.whole());
  for (size_t open = line.find('<'); open != std::string_view::npos; open = line.find('<', open + 1)) {
    const size_t close = line.find('>', open);
    if (close == std::string_view::npos) break;
    std::string read = small_letters(line.substr(open + 1, close - open - 1));
    std::erase_if(read, [](char c) { return c == ' ' || c == '\t'; });
    if (read != name) continue;
    const std::string_view text = line.substr(open + 1, close - open - 1);
    size_t end = text.find_first_not_of(" \t");
    while (end < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_' || is_foreign(text[end])))
      ++end;
    return std::string(text.substr(0, std::min(end, text.size())));
  }
  return {};
}

/// Names the line that assigns the name which looks like this one.
void relate_look_alike(const Input& in, const std::string& name, RegionId reader, Finding& f) {
  const Program& p = in.program;
  if (in.data.too_large()) return;
  for (NameId other = 0; other < p.syntax.names.size(); ++other) {
    if (p.name(other) == name || plain_text(p.name(other)) != plain_text(name)) continue;
    const StatementId line = in.data.first_assignment(reader, flow::key_of_name(p.syntax, other));
    if (line != kNoStatement) return relate(f, p, line, "the other name is assigned here");
  }
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  std::optional<std::string> documented;
  LocalNames names(in);
  for_stops(in, out, [&](const FlowStop& s) -> Finding* {
    const std::string name = "`#<" + s.detail + ">`";
    const bool some = s.reach != Reach::kAlways;
    const bool local = !s.detail.starts_with("_");
    const bool cases = some && local && (in.data.too_large() || names.assigns(p.region_of[s.statement], s.detail));
    const std::string_view why = !some ? "was not assigned before"
        : local && !cases              ? "no line assigns it"
                                       : "not assigned on every path";
    Finding& f =
        out.add(read_span(p, s.statement, "#<" + s.detail + ">"), fmt::format("{} is read here, but {}", name, why));
    f.help = "assign " + name + " first; a name without `_` belongs to the sub in which it is assigned";
    f.uncertain = cases || (some && local && p.syntax.runs_python);  // a list of cases may name all that there are
    // Then all names that the sub assigns in these cases are one question to its author.
    if (cases) f.group = fmt::format("cases of region {} in {}", p.region_of[s.statement], p.source->path());
    if (const std::string open = open_name(p, p.at(s.statement), s.detail); !open.empty()) {
      f.message = "the name `" + open + "` has no `>`: LinuxCNC reads " + name;
      f.help = "write `#<" + open + ">`: a `>` is missing after `" + open + "`";
      return &f;
    }
    // A global that the program says it needs comes from outside.
    if (!documented) documented = leading_comment(*p.source);
    if (s.detail.starts_with("_") && documented->find("#<" + s.detail + ">") != std::string::npos) {
      f.uncertain = true;
      f.help = "assign " + name + " before this program runs, as its first comment says";
      return &f;
    }
    if (s.detail.starts_with("_") && p.syntax.runs_python) {
      f.uncertain = true;
      f.help = "assign " + name + " first, unless the Python code in this program's comments does so";
      return &f;
    }
    if (const auto since = predefined_since(s.detail)) {
      const std::string version(version_text(in.profile.version));
      f.message = name + " is read here, but " +
          (*since > in.profile.version
               ? "LinuxCNC " + version + " does not have it; it came with " + std::string(version_text(*since))
               : "not every release of LinuxCNC " + version + " has it");
      f.help = "do not use it, test it first with `EXISTS[" + name.substr(1, name.size() - 2) +
          "]`, or give the machine's version with `--linuxcnc`";
    } else if (s.detail.starts_with("_ini[") && in.profile.setup != nullptr) {
      tell_entry(in.profile, name, f);
    } else if (const std::string other = look_alike_name(in, s.detail); !other.empty()) {
      f.help = other;
      relate_look_alike(in, s.detail, p.region_of[s.statement], f);
    } else if (s.detail.starts_with("_")) {
      names.explain_global(s.detail, p.region_of[s.statement], f);
    } else {
      const bool called = s.call != kNoStatement || s.call_elsewhere.program != nullptr;
      names.explain(s.detail, p.region_of[s.statement], called ? place_of(in, s.call, s.call_elsewhere) : Elsewhere{},
                    f);
      const NameId sub = p.regions[p.region_of[s.statement]].name;
      if (sub != kNoName) relate_given_name(in.profile, p.name(sub), s.detail, f);
    }
    // `[EXISTS[#<name>] AND [#<name> GT 3]]`.
    if (const Span asked = asked_span(p, s.statement, "#<" + s.detail + ">"); asked.end > asked.begin) {
      f.help =
          "LinuxCNC computes both sides of `AND` and `OR`: ask with `EXISTS` in an `if` of its own, and read the "
          "name in a second one inside it";
    }
    return &f;
  });
  if (in.data.too_large()) return;
  check_own_values(in, names, out);
  check_comments(in, names, out);
  check_unreached(in, names, out);
}

}  // namespace

extern const Rule kRule{
    .code = "OW603",
    .name = "name-undefined",
    .summary = "`#<name>` is read but not assigned on every path",
    .group = Group::kDataFlow,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A `#<name>` that is read, but no line before it has given it a value: a typing error in the name, an
assignment in only one branch, or a name that belongs to the caller or to the called sub.)",
            .why = R"(The interpreter stops at the line that reads the name, on the first run that gets there without an
assignment. Numbers are 0 before they are assigned, but names have no value. `#<name>` belongs to
the sub that is running: the main program's `#<depth>` does not exist inside a sub, and the sub's
does not exist outside. `#<_name>` with an underscore is global. On the line that sets a name for the
first time it counts as 0: `#<n> = [#<n> + 1]` gives 1 and does not stop. In a sub this happens in
every call, so such a counter never gets past 1. A comment `(debug, #<name>)` shows `######` for a name without a value. Skipped lines are
not checked, and `EXISTS[#<name>]` tests a name without stopping.

If the comment at the top of the program mentions a global name, owlint assumes that it exists. A
file that is called from outside gets its arguments as numbers. A remap passes letters (`#<p>`):
owlint assumes that all of them exist, or, with an INI, only those in its `REMAP` line.
`#<_ini[section]entry>` is an entry of the machine's INI; owlint looks it up if it knows the INI. It
assumes that `#<_hal[pin]>` exists. A name that only some releases of the version have is a warning.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  #<top> = #5063
o100 endif
G0 Z[#<top> + 5]
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
#<top> = 0
o100 if [#5070 EQ 1]
  #<top> = #5063
o100 endif
G0 Z[#<top> + 5]
M2
)",
            .fix = R"(Assign the name before the branch, pass it to the sub as an argument, or use a global name with an
underscore.)",
            .level_reason = "Error if a run gets here without the name: the program stops. Warning if another program "
                            "may have set the global name. Info if a list of cases may name every value that there is.",
            .interpreter = "Named parameter #<top> not defined",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow603
