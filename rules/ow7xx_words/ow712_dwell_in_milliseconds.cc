// OW712 dwell-in-milliseconds: a time of minutes in G4 or a drilling cycle that was meant as milliseconds.
// Depends on: P is the time in seconds, for G4 and for G82, G86, G88 and G89; other controllers take a P without a decimal point
// for milliseconds.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analyzer/syntax/last_statement.h"
#include "analyzer/syntax/line_text.h"
#include "rules/driver/modes.h"

namespace owlint::rules::ow712 {
namespace {

constexpr double kLong = 500;  // seconds
constexpr double kThousand = 1000;
/// Times that somebody may wait for: a spindle that warms up, glue that dries.
constexpr std::array kMinutes = {600.0, 900.0, 1200.0, 1800.0, 3600.0, 7200.0};

bool is_meant(double seconds) { return std::ranges::find(kMinutes, seconds) != kMinutes.end(); }

/// Whether digits of a long time follow a P, without a decimal point.
bool may_be_long(std::string_view behind) {
  constexpr size_t kDigits = 3;
  behind.remove_prefix(std::min(behind.find_first_not_of(" \t"), behind.size()));
  const size_t digits = std::min(behind.find_first_not_of("0123456789"), behind.size());
  return digits >= kDigits && (digits == behind.size() || behind[digits] != '.');
}

void report(const Input& in, Reporter& out, Span line) {
  const Program& p = in.program;
  const std::vector<WrittenWord> words = words_of(*p.source, line);
  const WrittenWord* const code = find_word(words, "G4 G82 G86 G88 G89");
  const WrittenWord* const time = find_word(words, "P");
  if (code == nullptr || time == nullptr || !time->value || *time->value < kLong || is_meant(*time->value)) return;
  const StatementId id = last_statement(p.syntax, line.begin);
  const bool of_line = id != kNoStatement && p.at(id).offset == line.begin;
  if (of_line && p.at(id).kind == LineKind::kM98) return;  // it is the number of a sub
  if (!may_be_long(p.source->slice({time->span.begin + 1, time->span.end}))) return;
  const std::string written = shown(*p.source, time->span);
  Finding& f =
      out.add(time->span,
              fmt::format("`{}` with `{}` waits {} seconds", shown(*p.source, code->span), written, written.substr(1)));
  f.help = fmt::format("write `P{}` if these are milliseconds, or `{}.` if so long is meant", *time->value / kThousand,
                       written);
  if (of_line) f.reach = in.flow.reach(id);
}

void check(const Input& in, Reporter& out) {
  const std::string_view bytes = in.program.source->bytes();
  for (const uint64_t begin : in.program.syntax.whole_p_lines)
    report(in, out, {begin, std::min<uint64_t>(bytes.find('\n', begin), bytes.size())});
}

}  // namespace

extern const Rule kRule{
    .code = "OW712",
    .name = "dwell-in-milliseconds",
    .summary = "a wait of minutes that was meant as milliseconds",
    .group = Group::kWords,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(`P` with a whole number of 500 or more, without a decimal point, on a line with `G4`, or with `G82`, `G86`,
`G88` or `G89`. owlint does not report whole times that somebody may mean: 600 (10 minutes), 900, 1200, 1800,
3600 and 7200.)",
            .why =
                R"(In LinuxCNC `P` is the time in **seconds**. On Fanuc, Mach3 and others `G4 P1500` is 1.5 seconds; here the
machine stands for 25 minutes, and nothing says why.)",
            .bad = R"(G21 G90
S1000 M3
G4 P1500
G0 X10
M2
)",
            .good = R"(G21 G90
S1000 M3
G4 P1.5
G0 X10
M2
)",
            .fix =
                R"(Write the time in seconds. Where so long a time is meant, `P1500.` with a decimal point says so.)",
            .level_reason = "Warning: LinuxCNC runs the line, and waits.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow712
