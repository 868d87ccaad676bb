// OW421 var-file-malformed: a file of parameters with which LinuxCNC does not start, or a line in it that is read otherwise.
// Depends on: numbers must rise and end at 5601, lines of text are ignored (measured with `rs274 -v`).
#include <algorithm>
#include <cmath>
#include <map>

#include "analyzer/machine/var_file.h"
#include "rules/driver/ini_places.h"
#include "rules/driver/machine_rules.h"

namespace owlint::rules::ow421 {
namespace {

std::string path_of_file(const MachineSetup& setup) {
  const IniLine* key = find_line(setup.text, "RS274NGC", "PARAMETER_FILE");
  const std::string folder(folder_of(setup.path));
  return normal_path(joined_path(folder, key == nullptr ? "rs274ngc.var" : std::string(setup.text.value(*key))));
}

constexpr long kFirstOfUser = 31, kLastOfUser = 5000;

/// Whether a value reads #number.
// Depth is bounded by the length of a line.
bool counts_on(const Syntax& syntax, ExprId id, double number) {
  const Expr& expr = syntax.exprs[id];
  if (expr.op == Operator::kParameter && syntax.exprs[expr.left()].op == Operator::kNumber &&
      syntax.exprs[expr.left()].value() == number)
    return true;
  bool found = false;
  for_each_operand(expr, [&](ExprId operand) { found = found || counts_on(syntax, operand, number); });
  return found;
}

/// A number that the program only counts on, from what an earlier run has left.
struct Count {
  StatementId line = kNoStatement;
  Span span;
  bool only = true;  ///< nothing else assigns it
};

/// `#500 = [#500 + 1]`, by the number.
std::map<long, Count> counts_in(const Program& p) {
  std::map<long, Count> counts;
  for (StatementId id = 0; id < p.size(); ++id) {
    for (const Item& item : p.syntax.items_of(p.at(id))) {
      if (item.target == kNoExpr || p.syntax.exprs[item.target].op != Operator::kNumber) continue;
      const double number = p.syntax.exprs[item.target].value();
      if (number < kFirstOfUser || number > kLastOfUser || number != std::floor(number)) continue;
      const bool again = counts_on(p.syntax, item.value, number) && p.open_above(p.region_of[id], id) == kNoBlock;
      const auto [entry, added] = counts.try_emplace(static_cast<long>(number));
      if (added) {
        entry->second = {id, p.at(id).span(item.from, item.to), again};
      } else {
        entry->second.only = false;
      }
    }
  }
  std::erase_if(counts, [](const auto& count) { return !count.second.only; });
  return counts;
}

/// A program that counts parts goes on where the last run has ended, but LinuxCNC keeps only numbers that the file lists.
void check(const Input& in, Reporter& out) {
  const MachineSetup* const setup = in.profile.setup.get();
  if (setup == nullptr || in.program.sub_file || in.program.syntax.items.empty()) return;
  std::map<long, Count> counts = counts_in(in.program);
  if (counts.empty()) return;
  for (const LinkedFile& file : in.linked.files()) {
    if (file.program.get() == &in.program) continue;
    for (const Item& item : file.program->syntax.items) {
      const bool assigns = item.target != kNoExpr && file.program->syntax.exprs[item.target].op == Operator::kNumber;
      if (assigns) counts.erase(std::lround(file.program->syntax.exprs[item.target].value()));
    }
  }
  const std::string path = path_of_file(*setup);
  const Files& files = setup->search_path->files();
  std::string error;
  const auto source = files.is_file(path) ? files.read(path, &error) : nullptr;
  if (source == nullptr) return;
  const VarFile kept = read_var_file(source->bytes());
  if (kept.problem) return;
  for (const auto& [number, count] : counts) {
    if (std::ranges::find(kept.rows, number, &VarRow::number) != kept.rows.end()) continue;
    const std::string name = "`#" + std::to_string(number) + "`";
    Finding& f =
        out.add(count.span,
                name + " goes on from its last value, but begins at 0 whenever LinuxCNC starts: " + file_name(*source) +
                    " does not list it");
    f.help = "add the line `" + std::to_string(number) + " 0` to the file, in the order of its numbers";
    f.weight = Weight::kAside;
    const Ini::Entry* const key = setup->ini.find("RS274NGC", "PARAMETER_FILE");
    if (key != nullptr) relate_ini(f, *key, "the file is named here");
    f.reach = in.flow.reach(count.line);
  }
}

/// The word behind a parameter's number.
Span value_of(const Source& source, const VarRow& row) {
  const std::string_view bytes = source.bytes();
  const size_t begin = std::min(bytes.find_first_not_of(" \t", row.span.end), bytes.size());
  return {begin, std::min(bytes.find_first_of(" \t\r\n", begin), bytes.size())};
}

/// Where digits, a comma and digits are the value; else 0.
size_t comma_in_value(const Source& source, const VarRow& row) {
  const Span value = value_of(source, row);
  const std::string_view text = source.slice(value);
  const size_t comma = text.find(',');
  const auto is_digit = [&](size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
  const bool number = text.find_first_not_of("+-0123456789.,") == std::string_view::npos;
  return comma != std::string_view::npos && comma > 0 && number && is_digit(comma - 1) && is_digit(comma + 1)
      ? value.begin + comma
      : 0;
}

size_t behind_blanks(std::string_view text, size_t at) {
  return std::min(text.find_first_not_of(" \t\r", at), text.size());
}

size_t behind_digits(std::string_view text, size_t at) {
  return std::min(text.find_first_not_of("0123456789", at), text.size());
}

/// `#500 3`, and `500 a`: a number with one word behind it.
void check_word(const std::shared_ptr<const Source>& source, Span whole, size_t begin, size_t behind, Reporter& out) {
  const std::string_view text = source->slice(whole);
  const size_t end = std::min(text.find_first_of(" \t\r", behind), text.size());
  if (behind >= text.size() || behind_blanks(text, end) < text.size()) return;
  const std::string word(text.substr(behind, end - behind));
  const bool number = word.find_first_not_of("+-.0123456789") == std::string::npos;
  const bool sign = text[begin] == '#';
  if (sign != number) return;  // with both it is a comment
  Finding& f = out.add(source, {whole.begin + begin, whole.begin + end},
                       sign ? "LinuxCNC ignores this line: `#` may not stand before the number"
                            : "LinuxCNC ignores this line: `" + word + "` is not a number");
  f.help = sign
      ? "write `" + std::string(text.substr(begin + 1, end - begin - 1)) + "`; if the line is a comment, add words"
      : "write a number behind it";
}

/// A line that LinuxCNC ignores, though it has a parameter's number (measured with `rs274 -v`): `500=3`, `#500 = 3`, `500`. With
/// the same number in another line it is a comment.
void check_ignored(const std::shared_ptr<const Source>& source, Span whole, const VarFile& file, Reporter& out) {
  const std::string_view text = source->slice(whole);
  size_t at = behind_blanks(text, 0);
  const bool sign = at < text.size() && text[at] == '#';
  const size_t begin = at;
  at = sign ? at + 1 : at;
  const size_t end = behind_digits(text, at);
  constexpr size_t kMostDigits = 4;
  if (end == at || end - at > kMostDigits) return;
  const std::string number(text.substr(at, end - at));
  const size_t behind = behind_blanks(text, end);
  const bool equals = behind < text.size() && text[behind] == '=';
  if (std::ranges::find(file.rows, std::stol(number), &VarRow::number) != file.rows.end()) return;
  if (!equals && (sign || behind < text.size())) return check_word(source, whole, begin, behind, out);
  const std::string_view value = text.substr(behind_blanks(text, equals ? behind + 1 : behind));
  if (equals && (value.empty() || std::string_view("+-.0123456789").find(value[0]) == std::string_view::npos)) return;
  const size_t last = std::min(text.find_last_not_of(" \t\r") + 1, text.size());
  Finding& f = out.add(source, {whole.begin + begin, whole.begin + last},
                       equals ? "LinuxCNC ignores this line: only blanks may be between the number and its value"
                              : "LinuxCNC ignores this line: the number has no value");
  f.help = equals ? "write `" + number + " " + std::string(value.substr(0, value.find_first_of(" \t\r"))) + "`"
                  : "write a value behind it, such as `" + number + " 0`";
}

/// What hides numbers from LinuxCNC: a byte order mark that of the first line, Mac line ends all but the first.
void check_form(const std::shared_ptr<const Source>& source, const VarFile& file, Reporter& out) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  constexpr size_t kMostLines = 10'000, kMostFindings = 100;
  const std::string_view bytes = source->bytes();
  if (bytes.starts_with(kMark) && bytes.size() > kMark.size() && bytes[kMark.size()] >= '0' &&
      bytes[kMark.size()] <= '9') {
    Finding& f = out.add(source, {0, kMark.size()},
                         "the file begins with a byte order mark: LinuxCNC ignores the number in its first line");
    f.help = "remove the mark: save the file as UTF-8 without BOM";
    f.fixes.push_back({"remove the byte order mark", false, {{{0, kMark.size()}, ""}}});
  }
  const size_t end_of_first = bytes.find('\r');
  const bool alone =
      end_of_first + 1 < bytes.size() && bytes[end_of_first + 1] != '\r' && end_of_first != std::string_view::npos;
  if (const size_t end = end_of_first; alone && bytes.find('\n') > end + 1) {
    Finding& f = out.add(source, {end, end + 1},
                         "the lines end with a carriage return alone: LinuxCNC reads only the first number");
    f.help = "save the file with Unix line endings (LF)";
    return;
  }
  size_t found = 0, lines = 0;
  for (size_t at = 0; at < bytes.size() && found < kMostFindings && lines < kMostLines; ++lines) {
    const size_t end = std::min(bytes.find('\n', at), bytes.size());
    const bool row =
        std::ranges::any_of(file.rows, [&](const VarRow& one) { return one.span.begin >= at && one.span.begin < end; });
    if (!row) check_ignored(source, {at, end}, file, out);
    at = end + 1;
  }
}

void check_setup(const SetupInput& in, Reporter& out) {
  const std::string path = path_of_file(in.setup);
  std::string error;
  const auto source = in.library.files().is_file(path) ? in.library.files().read(path, &error) : nullptr;
  if (source == nullptr) return;
  const VarFile file = read_var_file(source->bytes());
  if (file.problem) {
    const VarProblem& problem = *file.problem;
    const bool order = problem.kind == VarProblem::Kind::kOutOfOrder;
    const std::string number = "#" + std::string(source->slice(problem.row.span));
    const bool twice = order && problem.row.number == problem.before.number;
    Finding& f = out.add(source, problem.row.span,
                         twice       ? number + " is there twice: LinuxCNC does not start with this file"
                             : order ? number + " is below #" + std::to_string(problem.before.number) +
                                 ": numbers must rise, or LinuxCNC does not start with this file"
                                     : "there is no parameter " + number + ": LinuxCNC does not start with this file");
    f.help = twice ? "remove one of the two lines"
        : order    ? "put the lines in the order of their numbers"
                   : "remove the line: numbers go from 1 to 5601";
    if (order) f.related.push_back({problem.before.span, "the number before it", nullptr});
    refuses(f, order ? "Parameter file out of order" : "Parameter number out of range");
  }
  if (!file.problem) check_form(source, file, out);  // else the rest is not read
  for (const VarRow& row : file.rows) {
    if (const size_t comma = comma_in_value(*source, row); comma != 0) {
      const Span value = value_of(*source, row);
      Finding& f = out.add(
          source, value,
          "the comma ends the number: LinuxCNC reads `" + std::string(source->slice({value.begin, comma})) + "`");
      f.help = "write a point: `" + std::string(source->slice({value.begin, comma})) + "." +
          std::string(source->slice({comma + 1, value.end})) + "`";
      f.fixes.push_back({"write a point", false, {{{comma, comma + 1}, "."}}});
    }
    if (!row.fraction) continue;
    Finding& f = out.add(source, row.span,
                         "a number of a parameter with a point: LinuxCNC takes what follows the integer for the value");
    f.help = "write the number without a point";
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW421",
    .name = "var-file-malformed",
    .summary = "a file of parameters that LinuxCNC refuses, or that does not keep a parameter",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(In the file that `PARAMETER_FILE` names: a line whose number is not greater than the one before it,
is not from 1 to 5601, or has a decimal point, or whose value has a comma; a line such as `500=3` or `500`, which
LinuxCNC ignores. In a program: a parameter
from `#31` on that is meant to keep its value between runs (`#500 = [#500 + 1]`, and nothing else sets
it), but is not in the file.)",
            .why =
                R"(LinuxCNC reads the file when it starts, line by line: a whole number, then a value. Lines with text
are ignored. The numbers must rise: at the first one that does not, LinuxCNC refuses to start, with
`Parameter file out of order`. When LinuxCNC ends, it writes the parameters that the file lists
already, and its own; all others are lost.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
PARAMETER_FILE = machine.var
; file: machine.var
31.5 7
5161 0.000000
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
PARAMETER_FILE = machine.var
; file: machine.var
31 7
5161 0.000000
)",
            .fix =
                R"(Put the lines in order; each number once. Add a line with the number and 0 for a parameter that is to be kept.)",
            .level_reason = "Error where LinuxCNC does not start, else warning; info for a parameter that is not kept.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = check,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow421
