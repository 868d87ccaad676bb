// The command line of owlint.
#include <sys/auxv.h>

#include <algorithm>
#include <array>
#include <exception>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include "analyzer/cli/audit.h"
#include "analyzer/cli/commands.h"
#include "analyzer/cli/generate.h"
#include "analyzer/report/formats.h"
#include "analyzer/syntax/bulk.h"
#include "rules/stops.h"

namespace {

using owlint::cli::AuditLine;
using owlint::cli::CommandLine;
using owlint::cli::WalkOptions;

constexpr std::array<std::string_view, 9> kCommands = {"check", "audit", "graph", "explain", "rules", "fmt", "lsp", "config", "generate"};

/// Which files are programs.
void add_walk_options(CLI::App& app, WalkOptions& walk) {
  app.add_option("--exclude", walk.exclude, "leave these files and folders out: a pattern as in .gitignore")->allow_extra_args(false)->type_name("PATTERN")->group("Files");
  app.add_option("--include", walk.include, "files in folders whose names fit are programs as well, as *.txt")->allow_extra_args(false)->type_name("PATTERN")->group("Files");
  app.add_flag("--ignore-files,!--no-ignore-files", walk.ignore_files, "leave out what .gitignore and .owlintignore in the folders say (default)")->group("Files");
}

/// Which machine, and which rules: the same wherever programs are checked.
void add_settings_options(CLI::App& app, CommandLine& line) {
  app.add_option("--ini", line.ini, "INI file of the machine that runs the programs")->type_name("FILE")->group("Machine");
  app.add_flag("--find-ini,!--no-find-ini", line.find_ini, "without --ini, use the machine INI in the nearest folder above the programs, if there is just one (default)")->group("Machine");
  app.add_option("--sub-path", line.sub_path, "look for called files in this folder as well, behind the folders of the INI; may be given several times")->allow_extra_args(false)->type_name("DIR")->group("Machine");
  app.add_option("--feature", line.feature, "FEATURE mask, as 32 or 0x20; 0x20 makes OW101 to OW108 warnings")->type_name("MASK")->group("Machine");
  app.add_option("--linuxcnc", line.linuxcnc, "LinuxCNC version: 2.7, 2.8, 2.9 (default), 2.10, or all: what stops in any of them")->type_name("VERSION")->group("Machine");
  app.add_option("--select", line.select, "only these rules: codes or beginnings, as OW3")->delimiter(',')->allow_extra_args(false)->type_name("CODES")->group("Rules");
  app.add_option("--extend-select", line.extend_select, "these rules as well")->delimiter(',')->allow_extra_args(false)->type_name("CODES")->group("Rules");
  app.add_option("--ignore", line.ignore, "not these rules")->delimiter(',')->allow_extra_args(false)->type_name("CODES")->group("Rules");
  app.add_option("--severity", line.severity, "severity of a rule: off, info, warning, error")->delimiter(',')->allow_extra_args(false)->type_name("CODE=LEVEL")->group("Rules");
  app.add_option("--fail-on", line.fail_on, "exit with 1 from this severity on")->check(CLI::IsMember({"error", "warning", "info"}))->type_name("error|warning|info")->capture_default_str()->group("Rules");
  app.add_option("--config", line.config, "use this owlint.toml instead of the nearest one above each file")->type_name("FILE")->group("Rules");
  app.add_flag("--isolated", line.isolated, "use no owlint.toml")->group("Rules");
}

std::string format_names(bool for_people) {
  std::vector<std::string> names;
  for (const owlint::Format& format : owlint::formats()) {
    if (for_people || !format.for_people) names.emplace_back(format.name);
  }
  return fmt::format("{}", fmt::join(names, "|"));
}

void add_check_options(CLI::App& app, CommandLine& line) {
  app.add_option("PATH", line.paths, "programs, folders (searched for *.ngc *.nc *.tap *.cnc *.gcode), or - for standard input")->required();
  add_settings_options(app, line);
  add_walk_options(app, line.walk);
  app.add_flag("--fix", line.fix, "fix what can be fixed safely: a program that ran does the same afterwards")->group("Fix");
  app.add_flag("--unsafe", line.unsafe, "fix the rest as well, where it is known how; look at what comes out")->group("Fix");
  app.add_flag("--fix-only", line.fix_only, "fix, and report nothing")->group("Fix");
  app.add_flag("--diff", line.diff, "change nothing; print what --fix would change")->group("Fix");
  app.add_flag("--add-suppressions", line.add_suppressions, "write a comment before each line with a finding, which suppresses it")->group("Old findings");
  app.add_option("--reason", line.reason, "why, for --add-suppressions")->type_name("TEXT")->group("Old findings");
  app.add_option("--baseline", line.baseline, "findings that are in this file are known and not reported")->type_name("FILE")->group("Old findings");
  app.add_flag("--update-baseline", line.update_baseline, "write all findings of this run into the baseline")->group("Old findings");
  app.add_option("--since", line.since, "only files that have changed since this git revision, or are new")->type_name("REV")->group("Old findings");
  std::vector<std::string> names;
  for (const owlint::Format& format : owlint::formats()) names.emplace_back(format.name);
  app.add_option("--format", line.format, "how findings are written")->check(CLI::IsMember(names))->type_name(format_names(true))->capture_default_str()->group("Output");
  app.add_option("--output", line.output, "write the report to a file")->type_name("FILE")->group("Output");
  app.add_option("--color", line.color, "colours in the text")->check(CLI::IsMember({"auto", "always", "never"}))->type_name("auto|always|never")->capture_default_str()->group("Output");
  app.add_option("--stdin-filename", line.stdin_filename, "what standard input is called in the report")->type_name("NAME")->group("Output");
  app.add_flag("--statistics", line.statistics, "count the findings by rule, on standard error")->group("Output");
  app.add_flag("--coarse", line.coarse, "analyse every program like a very large one")->group("");  // for tests, not shown
  app.add_flag("-q,--quiet", line.quiet, "no summary line")->group("Output");
  app.add_option("--jobs", line.jobs, "files checked at the same time (default: one per core)")->type_name("N")->group("Output");
}

/// `owlint audit` with its own commands, which come back as what they run.
std::function<int()> add_audit(CLI::App& app, AuditLine& line, CLI::App*& audit) {
  audit = app.add_subcommand("audit", "check a whole store of programs again and again: only what has changed is analysed");
  CommandLine& check = line.check;
  const auto store = [&](CLI::App& command) { command.add_option("--store", line.store, "the SQLite file that keeps what was found")->type_name("FILE")->capture_default_str(); };
  const auto quiet = [&](CLI::App& command) { command.add_flag("-q,--quiet", check.quiet, "no summary"); };
  const auto color = [&](CLI::App& command) { command.add_option("--color", check.color, "colours in the text")->check(CLI::IsMember({"auto", "always", "never"}))->type_name("auto|always|never")->capture_default_str(); };
  const auto run = [&](CLI::App& command) { command.add_option("RUN", line.run, "a number of `owlint audit list`, last, last-1, or STORE:RUN")->capture_default_str(); };

  audit->add_option("PATH", check.paths, "folders and programs");
  store(*audit);
  audit->add_option("--report", line.report, "write the page: one HTML file that needs nothing else")->type_name("FILE");
  audit->add_flag("--fail-on-new", line.fail_on_new, "exit with 1 only for findings that the run before had not");
  audit->add_flag("--watch", line.watch, "go on, and audit again whenever a program is saved");
  audit->add_option("--shard", line.shard, "only one part of the programs, as 1/4: for several machines, see `merge`")->type_name("I/N");
  audit->add_flag("--wait", line.wait, "wait where another audit is using the store");
  audit->add_option("--jobs", check.jobs, "programs checked at the same time (default: one per core)")->type_name("N");
  quiet(*audit);
  color(*audit);
  add_settings_options(*audit, check);
  add_walk_options(*audit, check.walk);

  CLI::App* list = audit->add_subcommand("list", "list the runs of a store");
  store(*list);
  CLI::App* show = audit->add_subcommand("show", "show the findings of a run");
  run(*show);
  store(*show);
  color(*show);
  quiet(*show);
  CLI::App* exported = audit->add_subcommand("export", "write the findings of a run for other programs");
  run(*exported);
  store(*exported);
  std::vector<std::string> names;
  for (const owlint::Format& format : owlint::formats()) {
    if (!format.for_people) names.emplace_back(format.name);
  }
  exported->add_option("--format", check.format, "how findings are written")->check(CLI::IsMember(names))->type_name(format_names(false))->required();
  exported->add_option("--output", check.output, "write to a file")->type_name("FILE");
  CLI::App* diff = audit->add_subcommand("diff", "what is new and what is gone from one run to another");
  diff->add_option("A", line.from, "the older run: a number, last-1, STORE or STORE:RUN")->required();
  diff->add_option("B", line.to, "the newer run")->required();
  store(*diff);
  diff->add_option("--fail-on", check.fail_on, "exit with 1 for new findings from this severity on")->check(CLI::IsMember({"error", "warning", "info"}))->type_name("error|warning|info")->capture_default_str();
  color(*diff);
  quiet(*diff);
  CLI::App* merge = audit->add_subcommand("merge", "put the stores of all shards of a job together");
  merge->add_option("STORE", line.stores, "a store for each shard")->required();
  store(*merge);
  merge->add_flag("--wait", line.wait, "wait where another audit is using the store");
  quiet(*merge);
  audit->require_subcommand(0, 1);
  audit->footer("A folder that is named like one of the commands is written with a slash: `owlint audit ./show`.");
  return [=, &line]() -> int {
    if (list->parsed()) return owlint::cli::audit_list_command(line);
    if (show->parsed() || exported->parsed()) return owlint::cli::audit_show_command(line);
    if (diff->parsed()) return owlint::cli::audit_diff_command(line);
    if (merge->parsed()) return owlint::cli::audit_merge_command(line);
    if (line.check.paths.empty()) {
      owlint::cli::complain("`owlint audit` needs a PATH: a folder of programs");
      return owlint::cli::kUsage;
    }
    return owlint::cli::audit_command(line);
  };
}

/// What somebody who reports a fault is asked for.
std::string version_text() {
#ifdef __clang__
  constexpr std::string_view kCompiler = "clang " __clang_version__;
#else
  constexpr std::string_view kCompiler = "g++ " __VERSION__;
#endif
  const bool is_static = ::getauxval(AT_BASE) == 0;  // no dynamic linker was loaded
  return fmt::format("owlint {}\nbuilt with {}, {}, linked {}; fast path: {}", owlint::kToolVersion, kCompiler, OWLINT_BUILD_TYPE, is_static ? "statically" : "dynamically", owlint::bulk_variants().front().name);
}

/// What is wrong with an option that there is not, or "". It is said first: PATH is missing only because such an option took its place.
std::string unknown_option(const CLI::App& app) {
  for (const std::string& left : app.remaining(true)) {
    if (!left.starts_with('-')) continue;
    std::vector<std::string> known;
    for (const CLI::App* command : app.get_subcommands()) {
      for (const CLI::Option* option : command->get_options()) {
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
      }
    }
    const std::string near = owlint::rules::nearest(left, known);
    return fmt::format("unknown option `{}`{}", left, near.empty() ? "; `--help` lists all, and what comes after `--` is a path" : ", did you mean `" + near + "`?");
  }
  return "";
}

int run(std::vector<std::string> arguments) {
  CLI::App app{"owlint finds the O-word mistakes in LinuxCNC G-code that stop the machine, before it moves.", "owlint"};
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  app.footer("`owlint PATH...` is short for `owlint check PATH...`.\n"
             "Exit status: 0 nothing at or above --fail-on, 1 findings, 2 usage, configuration or unreadable input, 3 internal error.");

  CommandLine line;
  CLI::App* check = app.add_subcommand("check", "lint programs");
  add_check_options(*check, line);
  check->footer("Suppress a finding with a comment on the line before it: (owlint: ignore OW304 -- reason)");

  AuditLine audit_line;
  CLI::App* audit = nullptr;
  const std::function<int()> run_audit = add_audit(app, audit_line, audit);

  CommandLine graph_line;
  graph_line.paths.resize(1);
  std::string graph_format = "dot";
  CLI::App* graph = app.add_subcommand("graph", "print the block graph of a program, and the call graph of it and the files that it calls");
  graph->add_option("FILE", graph_line.paths[0], "the program")->required();
  graph->add_option("--format", graph_format, "dot, mermaid, json or svg")->check(CLI::IsMember({"dot", "mermaid", "json", "svg"}))->type_name("dot|mermaid|json|svg")->capture_default_str();
  graph->add_option("--ini", graph_line.ini, "INI file of the machine, which says where called files are")->type_name("FILE");
  graph->add_option("--sub-path", graph_line.sub_path, "look for called files in this folder as well")->allow_extra_args(false)->type_name("DIR");
  graph->add_flag("--find-ini,!--no-find-ini", graph_line.find_ini, "without --ini, use the one machine INI in the nearest folder above (default)");
  graph->add_flag("--isolated", graph_line.isolated, "use no owlint.toml");

  CommandLine format_line;
  bool format_check = false;
  bool format_diff = false;
  CLI::App* format = app.add_subcommand("fmt", "indent programs by their subs and blocks; nothing else changes");
  format->add_option("PATH", format_line.paths, "programs, folders, or - for standard input, which is written to standard output")->required();
  format->add_flag("--check", format_check, "change nothing; exit with 1 where something would change");
  format->add_flag("--diff", format_diff, "change nothing; print what would change");

  CLI::App* lsp = app.add_subcommand("lsp", "language server on standard input and output, for editors");
  lsp->add_flag_function("--stdio", [](std::int64_t) {}, "as always; some editors say it");

  CommandLine config_line;
  bool config_check = false;
  bool config_show = false;
  CLI::App* config = app.add_subcommand("config", "the settings that programs are checked with, and where they come from");
  config->add_option("PATH", config_line.paths, "programs or folders (default: this one); with --check, files named owlint.toml or folders that have one");
  CLI::Option* show = config->add_flag("--show", config_show, "list the settings (default)");
  config->add_flag("--check", config_check, "only say whether the configuration is right")->excludes(show);
  config->add_option("--ini", config_line.ini, "as for `owlint check`")->type_name("FILE");
  config->add_option("--sub-path", config_line.sub_path, "as for `owlint check`")->allow_extra_args(false)->type_name("DIR");
  config->add_option("--config", config_line.config, "as for `owlint check`")->type_name("FILE");
  config->add_flag("--isolated", config_line.isolated, "as for `owlint check`");

  // For the installation: not shown.
  std::string generated;
  CLI::App* generate = app.add_subcommand("generate", "manual pages and shell completions")->group("");
  generate->add_option("FOLDER", generated)->required();

  std::string code;
  CLI::App* explain = app.add_subcommand("explain", "what a rule finds, why, an example, and how to fix it");
  explain->add_option("CODE", code, "code or name of a rule, as OW104 or if-label-reused")->required();

  std::string rules_format = "text";
  CLI::App* rules = app.add_subcommand("rules", "list all rules");
  rules->add_option("--format", rules_format, "text, json or markdown")->check(CLI::IsMember({"text", "json", "markdown"}))->type_name("text|json|markdown")->capture_default_str();

  std::string pages;
  rules->add_option("--pages", pages, "write a Markdown page for each rule into this folder")->type_name("FOLDER");

  if (arguments.empty()) {
    std::cerr << app.help();
    return owlint::cli::kUsage;
  }
  // `check` may be left out.
  if (!arguments.empty() && std::ranges::find(kCommands, arguments.front()) == kCommands.end() &&
      arguments.front() != "--help" && arguments.front() != "-h" && arguments.front() != "--version") {
    arguments.insert(arguments.begin(), "check");
  }
  try {
    std::ranges::reverse(arguments);  // CLI11 takes them from the back
    app.parse(arguments);
  } catch (const CLI::ParseError& problem) {
    if (const std::string unknown = unknown_option(app); !unknown.empty()) {
      owlint::cli::complain(unknown);
      return owlint::cli::kUsage;
    }
    const int status = app.exit(problem);
    return status == 0 ? owlint::cli::kClean : owlint::cli::kUsage;
  }
  if (check->parsed()) return owlint::cli::check_command(line);
  if (audit->parsed()) return run_audit();
  if (graph->parsed()) return owlint::cli::graph_command(graph_line, graph_format);
  if (format->parsed()) return owlint::cli::format_command(format_line, format_check, format_diff);
  if (config->parsed()) return owlint::cli::config_command(config_line, config_check);
  if (generate->parsed()) {
    std::string error;
    if (owlint::cli::generate(app, generated, &error)) return owlint::cli::kClean;
    owlint::cli::complain(error);
    return owlint::cli::kUsage;
  }
  if (lsp->parsed()) return owlint::cli::lsp_command();
  if (explain->parsed()) return owlint::cli::explain_command(code);
  if (!pages.empty()) return owlint::cli::rule_pages_command(pages);
  return owlint::cli::rules_command(rules_format);
}

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& problem) {
    owlint::cli::complain(std::string("internal error: ") + problem.what());
    return owlint::cli::kInternal;
  }
}
