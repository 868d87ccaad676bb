// OW421 var-file-malformed: a file of parameters with which LinuxCNC does not start, or a line in it that is read otherwise.
// Depends on: numbers must rise and end at 5601, lines of text are ignored (measured with `rs274 -v`).
#include "analyzer/machine/var_file.h"
#include "rules/driver/machine_rules.h"

namespace owlint::rules::ow421 {
namespace {

void check_setup(const SetupInput& in, Reporter& out) {
  const IniLine* key = find_line(in.setup.text, "RS274NGC", "PARAMETER_FILE");
  const std::string folder(folder_of(in.setup.path));
  const std::string path =
      normal_path(joined_path(folder, key == nullptr ? "rs274ngc.var" : std::string(in.setup.text.value(*key))));
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
  for (const VarRow& row : file.rows) {
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
    .summary = "a file of parameters with which LinuxCNC does not start",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A line of the file that `PARAMETER_FILE` names, whose number is not above the one before it, or not from 1
to 5601; or whose number has a point.)",
            .why =
                R"(LinuxCNC reads the file when it starts, line by line: a whole number, then a value. Lines with text are
ignored. The numbers must rise; the first that does not refuses the start with `Parameter file out of
order`.)",
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
            .fix = R"(Put the lines in order; each number once.)",
            .level_reason = "Error where LinuxCNC does not start, else warning.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow421
