#include "rules/driver/parameter_helpers.h"

#include <algorithm>
#include <cmath>

#include "analyzer/machine/predefined.h"
#include "analyzer/text/characters.h"
#include "rules/driver/positions.h"

namespace owlint::rules {

std::string parameter_words(const Program& program, flow::ParameterId parameter) {
  return "`" + flow::parameter_text(program, parameter) + "`";
}

std::string returning_sub(const Elsewhere& line, std::string_view otherwise) {
  const bool known = line.program != nullptr && line.program->at(line.statement).label != kNoName;
  return known ? "`" + line.program->label_at(line.statement) + "`" : std::string(otherwise);
}

Span item_span(const Program& program, StatementId statement, uint32_t item) {
  const Statement& s = program.at(statement);
  const Item& place = program.syntax.items_of(s)[item];
  return place.from < place.to ? s.span(place.from, place.to) : s.whole();
}

namespace {

/// The first place on a line that mentions a parameter: in an `EXISTS` or to read its value, but not to assign it.
Span mention(const Program& program, StatementId statement, std::string_view parameter, bool asked) {
  const Statement& s = program.at(statement);
  if (s.length > kLineLimit) return {};
  LineText line;
  if (line.assign(program.source->slice(s.whole()), s.offset) != StopKind::kNone) return {};
  const std::string_view text = line.text();
  for (size_t at = 0; at < text.size() && text[at] != ';'; ++at) {
    if (text[at] == '(') at = std::min(text.find(')', at), text.size() - 1);
    if (!text.substr(at).starts_with(parameter)) continue;
    const size_t end = at + parameter.size();
    const char next = line[end];
    const bool longer = parameter.back() != '>' && (is_digit(next) || next == '.');
    if (longer || next == '=' || text.substr(0, at).ends_with("exists[") != asked) continue;
    return line.span(at, end);
  }
  return {};
}

}  // namespace

Span read_span(const Program& program, StatementId statement, std::string_view parameter) {
  const Span found = mention(program, statement, parameter, false);
  return found.end > found.begin ? found : program.at(statement).whole();
}

Span asked_span(const Program& program, StatementId statement, std::string_view name) {
  return mention(program, statement, name, true);
}

void tell_new_machine(const Input& in, const FlowStop& stop, Finding& finding) {
  if (!stop.on_new_machine) return;
  const auto on_line = [&](uint32_t number) {
    if (stop.statement == kNoStatement) return false;
    const Span found = mention(in.program, stop.statement, "#" + std::to_string(number), false);
    return found.begin < found.end;
  };
  std::vector<uint32_t> read;
  std::ranges::copy_if(stop.unset, std::back_inserter(read), on_line);
  const std::vector<uint32_t>& named = read.empty() ? stop.unset : read;
  if (named.empty() || (read.empty() && in.program.syntax.reads_place)) return add_start(finding);
  constexpr size_t kNamed = 3;
  std::string list;
  for (size_t i = 0; i < std::min(named.size(), kNamed); ++i)
    list += (i == 0 ? "`#" : ", `#") + std::to_string(named[i]) + "`";
  if (named.size() > kNamed) list += ", …";
  const bool one = named.size() == 1;
  finding.message += "; " + list + (one ? " is" : " are") + " not set before, and 0 when LinuxCNC has just started";
  finding.help = "set " + list + " before " + (one ? "it is" : "they are") + " used";
  finding.fixes.clear();
}

std::string region_words(const Program& program, RegionId region) {
  return region == kMainRegion ? "the main program" : "`" + program.label_text(program.regions[region].name) + "`";
}

std::string argument_words(uint32_t bits) {
  std::vector<std::string> names;
  for (int n = 1; n < 32; ++n) {
    if ((bits >> n & 1) != 0) names.push_back("`#" + std::to_string(n) + "`");
  }
  std::string out;
  for (size_t i = 0; i < names.size(); ++i) out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

NearName near_name(const Input& in, const std::string& name, RegionId reader) {
  const Program& p = in.program;
  if (in.data.too_large() || name.size() < 2) return {};  // one letter is near to every other
  const bool global = flow::is_global_name(name);
  std::vector<std::string> names;
  const auto add_written = [&](RegionId region, bool globals) {
    for (const flow::Write& write : in.data.accesses_of(region).all_writes()) {
      if (write.key == flow::kComputedKey) continue;
      const flow::ParameterId target = flow::parameter_of(write.key);
      if (target.named && flow::is_global(write.key) == globals && p.name(target.id) != name)
        names.push_back(p.name(target.id));
    }
  };
  const auto assigned = [&](RegionId region, const std::string& text) {
    const NameId id = p.syntax.names.find(text);
    return id == kNoName ? kNoStatement : in.data.first_assignment(region, flow::key_of_name(p.syntax, id));
  };
  const auto found = [&](std::string text) {
    NearName near;
    near.assigned = assigned(reader, text);
    for (RegionId region = 0; flow::is_global_name(text) && region < p.regions.size() && near.assigned == kNoStatement;
         ++region)
      near.assigned = assigned(region, text);
    near.name = std::move(text);
    return near;
  };
  if (global) {
    for (RegionId region = 0; region < p.regions.size(); ++region) add_written(region, true);
  } else {
    add_written(reader, false);
  }
  if (std::string near = nearest(name, names); !near.empty()) return found(std::move(near));
  // A predefined name of one letter is near to everything.
  constexpr size_t kShort = 4;
  constexpr size_t kLong = 9;
  const std::string as_global = global ? name : "_" + name;
  if (as_global.size() <= kShort) return {};
  const std::string known = nearest(as_global, predefined_names(in.profile.version), as_global.size() < kLong ? 1 : 2);
  if (!known.empty()) return {known, kNoStatement};
  if (global) {
    // Without the `_` it is a name of the reader's own.
    const std::string local = name.substr(1);
    return assigned(reader, local) == kNoStatement ? NearName{} : found(local);
  }
  for (RegionId region = 0; region < p.regions.size(); ++region) {
    if (assigned(region, as_global) != kNoStatement) return found(as_global);
  }
  return {};
}

bool enters_from_outside(const Program& program, RegionId region) {
  return program.sub_file && program.regions[region].name == program.entry;
}

bool reached(const Input& in, RegionId region) {
  const Region& r = in.program.regions[region];
  if (region == kMainRegion || enters_from_outside(in.program, region)) return true;
  const auto executed = [&](StatementId id) { return in.flow.executed[id] && id != r.opener && id != r.end; };
  const auto called = [&](const Call& call) { return call.target == region && in.flow.executed[call.statement]; };
  return std::ranges::any_of(in.data.lines_of(region), executed) || std::ranges::any_of(in.program.calls, called);
}

// Depth is bounded by the length of a line.
const Call* call_before_reading(const Input& in, RegionId region, NameId name) {
  constexpr int kMostTries = 20;  // each may go through all lines
  int tries = 0;
  const auto reads = [&](const Call& call) {
    return call.target == region && in.program.at(call.statement).kind != LineKind::kM98 && ++tries <= kMostTries &&
        in.data.reads_after(call.statement, flow::key_of_name(in.program.syntax, name));
  };
  const auto found = std::ranges::find_if(in.program.calls, reads);
  return found == in.program.calls.end() ? nullptr : &*found;
}

bool computes_fraction(const Program& program, ExprId value) {
  const Expr& expr = program.syntax.exprs[value];
  const auto fraction = [&](ExprId operand) {
    const Expr& number = program.syntax.exprs[operand];
    return number.op == Operator::kNumber && number.value() != std::floor(number.value());
  };
  switch (expr.op) {
    case Operator::kNumber:
    case Operator::kExistsNamed:
    case Operator::kExistsNumbered:
    case Operator::kNamed:
    case Operator::kParameter:
    case Operator::kFix:
    case Operator::kFup:
    case Operator::kRound: return false;
    case Operator::kDivide:
    case Operator::kSqrt:
    case Operator::kSin:
    case Operator::kCos:
    case Operator::kTan:
    case Operator::kAsin:
    case Operator::kAcos:
    case Operator::kAtan:
    case Operator::kExp:
    case Operator::kLn: return true;
    case Operator::kPlus:
    case Operator::kMinus:
    case Operator::kTimes:
      if (any_operand(expr, fraction)) return true;
      break;
    default: break;
  }
  return any_operand(expr, [&](ExprId operand) { return computes_fraction(program, operand); });
}

std::optional<flow::ParameterKey> passed_parameter(const Program& p, ExprId argument) {
  const Expr& expr = p.syntax.exprs[argument];
  if (expr.op == Operator::kNamed) return flow::key_of_name(p.syntax, expr.name());
  if (expr.op != Operator::kParameter) return std::nullopt;
  const flow::ParameterKey key = flow::key_of_number(p.syntax, expr.left());
  return key == flow::kComputedKey ? std::nullopt : std::optional(key);
}

std::string leading_comment(const Source& source) {
  constexpr uint64_t kMost = 16'384;  // bytes
  const std::string_view text = source.bytes().substr(0, kMost);
  std::string out;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    std::string line;
    for (const char c : text.substr(at, end - at)) {
      if (c != ' ' && c != '\t' && c != '\r') line += c;
    }
    if (!line.empty() && line[0] != '(' && line[0] != ';' && line[0] != '%') break;
    out += small_letters(line);
    at = end + 1;
  }
  return out;
}

}  // namespace owlint::rules
