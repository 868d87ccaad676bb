// OW317 blank-in-number: two numbers in brackets with only a space between them.
// Depends on: LinuxCNC removes spaces before it reads a line, also inside numbers: `[1 2]` is 12.
#include <algorithm>

#include "analyzer/syntax/last_statement.h"
#include "rules/driver/idioms.h"

namespace owlint::rules::ow317 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Span span : p.syntax.split_numbers) {
    const StatementId id = last_statement(p.syntax, span.begin);
    if (id == kNoStatement) continue;
    const std::string written(p.source->slice(span));
    std::string read = written;
    std::erase_if(read, [](char c) { return c == ' ' || c == '\t'; });
    Finding& f =
        out.add(span, "`" + written + "` is read as `" + read + "`: LinuxCNC removes spaces, also inside numbers");
    f.reach = in.flow.reach(id);
    f.help = "write the number without a space";
    if (!p.at(id).is(Keyword::kCall)) continue;
    std::string apart = written;
    for (size_t at = apart.find_first_of(" \t"); at != std::string::npos; at = apart.find_first_of(" \t", at + 3)) {
      const size_t end = apart.find_first_not_of(" \t", at);
      apart.replace(at, end - at, "] [");
    }
    const Statement& s = p.at(id);
    std::string_view behind = p.source->slice({s.keyword_span().end, s.end()});
    behind = behind.substr(0, behind.find_first_of("(;\r"));
    const std::string all = arguments_in_brackets(behind);
    f.help = "write each argument in its own brackets: `" + (all.empty() ? "[" + apart + "]" : all) + "`";
    f.fixes.push_back({"write each argument in its own brackets", false, {{span, apart}}});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW317",
    .name = "blank-in-number",
    .summary = "a space inside a number in brackets: LinuxCNC reads one number",
    .group = Group::kLine,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(`o100 call [1 2]`, `o100 repeat [1 0]`: two numbers in one pair of brackets, with a space between
them.)",
            .why = R"(LinuxCNC removes all spaces before it reads a line. `[1 2]` is the number 12: the sub gets **one
argument, 12**, and its `#2` is 0. There is no message.)",
            .bad = R"(G21 G90
o100 sub
  G0 X#1 Y#2
o100 endsub
o100 call [1 2]
M2
)",
            .good = R"(G21 G90
o100 sub
  G0 X#1 Y#2
o100 endsub
o100 call [1] [2]
M2
)",
            .fix = R"(Write each argument in its own brackets; write a number without spaces.)",
            .level_reason = "Warning: LinuxCNC runs the line, with one number instead of two.",
            .interpreter = "",
            .options = "",
            .moves = "X12",
            .moves_good = "X1",
        },
    .check = check,
};

}  // namespace owlint::rules::ow317
