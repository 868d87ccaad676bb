#include "analyzer/cli/options.h"

#include "analyzer/cli/help.h"
#include "analyzer/cli/values.h"
#include "analyzer/report/formats.h"

namespace owlint::cli {
namespace {

/// The names of the formats; those for people may be left out.
std::vector<std::string> format_names(bool all) {
  std::vector<std::string> names;
  for (const Format& format : formats()) {
    if (all || !format.for_people) names.emplace_back(format.name);
  }
  return names;
}

CLI::Option* add_words(CLI::App& app, const std::string& name, std::string& value, const std::string& what, std::vector<std::string> words, const std::string& kind) {
  return app.add_option(name, value, what)->check(one_of(std::move(words)))->type_name(kind)->capture_default_str();
}

CLI::Option* add_file(CLI::App& app, const std::string& name, auto& value, const std::string& what) { return app.add_option(name, value, what)->type_name("FILE"); }

/// An option that may be given several times.
CLI::Option* add_list(CLI::App& app, const std::string& name, std::vector<std::string>& list, const std::string& what, const std::string& kind) {
  return app.add_option(name, list, what)->allow_extra_args(false)->type_name(kind);
}

void add_format(CLI::App& app, std::string& value, std::vector<std::string> words, const std::string& what) { add_words(app, "--format", value, what, std::move(words), "FORMAT"); }

void add_color(CLI::App& app, CommandLine& line) { add_words(app, "--color", line.color, "colours in the text", {"auto", "always", "never"}, "WHEN"); }

void add_fail_on(CLI::App& app, CommandLine& line, const std::string& what) {
  app.add_option("--fail-on", line.fail_on, what)->check(one_of({"error", "warning", "info"}))->type_name("LEVEL")->default_str("error");
}

void add_jobs(CLI::App& app, CommandLine& line) {
  app.add_option("--jobs", line.jobs, "programs checked at the same time (default: one per core)")->check(count())->type_name("N");
}

/// Which files are programs.
void add_walk_options(CLI::App& app, WalkOptions& walk) {
  add_list(app, "--exclude", walk.exclude, "leave these files and folders out: a pattern as in .gitignore", "PATTERN")->group("Files");
  app.add_flag("--force-exclude", walk.force_exclude, "leave out what is excluded also where it is named, as hooks do")->group("Files");
  add_list(app, "--include", walk.include, "files in folders that fit are programs as well: a pattern, as *.txt", "PATTERN")->group("Files");
  app.add_flag("--ignore-files,!--no-ignore-files", walk.ignore_files, "leave out what .gitignore and .owlintignore in the folders say (default)")->group("Files");
  app.add_flag("--allow-empty", walk.allow_empty, "a folder without programs is no mistake")->group("Files");
}

/// Which configuration file.
void add_configuration_options(CLI::App& app, CommandLine& line, const std::string& group) {
  add_file(app, "--config", line.config, "use this owlint.toml instead of the nearest one above each file")->group(group);
  app.add_flag("--isolated", line.isolated, "use no owlint.toml")->group(group);
}

/// Where the files of called subs are.
void add_machine_options(CLI::App& app, CommandLine& line, const std::string& group) {
  add_file(app, "--ini", line.ini, "INI file of the machine that runs the programs")->group(group);
  app.add_flag("--find-ini,!--no-find-ini", line.find_ini, "without --ini, use the machine INI in the nearest folder above the programs, if there is just one (default)")->group(group);
  add_list(app, "--sub-path", line.sub_path, "look for called files in this folder as well, behind the folders of the INI; may be given several times", "DIR")->group(group);
}

/// Which machine, and which rules: the same wherever programs are checked.
void add_settings_options(CLI::App& app, CommandLine& line) {
  add_machine_options(app, line, "Machine");
  app.add_option("--feature", line.feature, "FEATURE mask, as 32 or 0x20; 0x20 makes OW101 to OW108 warnings")->check(mask())->type_name("MASK")->group("Machine");
  app.add_option("--linuxcnc", line.linuxcnc, "LinuxCNC version, or all: what stops in any of them")->check(one_of({"2.7", "2.8", "2.9", "2.10", "all"}))->type_name("VERSION")->default_str("2.9")->group("Machine");
  const auto codes = [&](const char* name, std::vector<std::string>& list, const char* what) {
    add_list(app, name, list, what, "CODES")->delimiter(',')->check(rule_code())->group("Rules");
  };
  codes("--select", line.select, "only these rules: codes, their beginnings as OW3, or names of rules");
  codes("--extend-select", line.extend_select, "these rules as well, also those that are off unless selected");
  codes("--ignore", line.ignore, "not these rules");
  add_list(app, "--severity", line.severity, "severity of a rule: off, info, warning, error", "CODE=LEVEL")->delimiter(',')->check(code_level())->group("Rules");
  add_fail_on(app, line, "exit with 1 from this severity on");
  app.get_option("--fail-on")->group("Rules");
  add_configuration_options(app, line, "Rules");
}

void add_check(CLI::App& app, CommandLine& line) {
  CLI::App& check = *app.add_subcommand("check", "find mistakes in programs");
  check.add_option("PATH", line.paths, "programs, folders (searched for *.ngc *.nc *.tap *.cnc *.gcode), or - for standard input")->required();
  add_settings_options(check, line);
  add_walk_options(check, line.walk);
  check.add_flag("--fix", line.fix, "fix what can be fixed safely: a program that ran does the same afterwards")->group("Fix");
  check.add_flag("--unsafe", line.unsafe, "fix the rest as well, where it is known how; look at what comes out")->group("Fix");
  check.add_flag("--fix-only", line.fix_only, "fix, and report nothing")->group("Fix");
  check.add_flag("--diff", line.diff, "change nothing; print what --fix would change")->group("Fix");
  check.add_flag("--add-suppressions", line.add_suppressions, "write a comment before each line with a finding that suppresses it")->group("Old findings");
  check.add_option("--reason", line.reason, "why, for --add-suppressions")->type_name("TEXT")->group("Old findings");
  add_file(check, "--baseline", line.baseline, "findings that are in this file are known and not reported")->group("Old findings");
  check.add_flag("--update-baseline", line.update_baseline, "write all findings of this run into the baseline")->group("Old findings");
  check.add_option("--since", line.since, "only files that have changed since this git revision, or are new")->type_name("REV")->group("Old findings");
  add_format(check, line.format, format_names(true), "how findings are written");
  add_file(check, "--output", line.output, "write the report to a file");
  add_color(check, line);
  check.add_option("--stdin-filename", line.stdin_filename, "what standard input is called in the report")->type_name("NAME");
  check.add_flag("--statistics", line.statistics, "count the findings by rule, on standard error");
  check.add_flag("--coarse", line.coarse, "analyse every program like a very large one")->group("");  // for tests, not shown
  check.add_flag("-q,--quiet", line.quiet, "no summary line");
  add_jobs(check, line);
  for (const char* name : {"--format", "--output", "--color", "--stdin-filename", "--statistics", "--quiet", "--jobs"}) check.get_option(name)->group("Output");
  check.footer("Suppress a finding with a comment on the line before it: (owlint: ignore OW304 because ...)");
}

void add_audit(CLI::App& app, AuditLine& line) {
  CLI::App& audit = *app.add_subcommand("audit", "check a whole store of programs again and again: only what has changed is analysed");
  CommandLine& check = line.check;
  const auto store = [&](CLI::App& command) { add_file(command, "--store", line.store, "the SQLite file that keeps what was found")->capture_default_str(); };
  const auto quiet = [&](CLI::App& command) { command.add_flag("-q,--quiet", check.quiet, "no summary"); };
  const auto run = [&](CLI::App& command) { command.add_option("RUN", line.run, "a number of `owlint audit list`, last, last-1, or STORE:RUN")->capture_default_str(); };

  audit.add_option("PATH", check.paths, "folders and programs");
  store(audit);
  add_file(audit, "--report", line.report, "write the page: one HTML file that needs nothing else");
  audit.add_flag("--fail-on-new", line.fail_on_new, "exit with 1 only for findings that the run before had not");
  audit.add_flag("--watch", line.watch, "go on, and audit again whenever a program is saved");
  audit.add_option("--shard", line.shard, "only one part of the programs, as 1/4: for several machines, see `merge`")->type_name("I/N");
  audit.add_flag("--wait", line.wait, "wait where another audit is using the store");
  add_jobs(audit, check);
  quiet(audit);
  add_color(audit, check);
  add_settings_options(audit, check);
  add_walk_options(audit, check.walk);

  store(*audit.add_subcommand("list", "list the runs of a store"));
  CLI::App& show = *audit.add_subcommand("show", "show the findings of a run");
  run(show);
  store(show);
  add_color(show, check);
  quiet(show);
  CLI::App& exported = *audit.add_subcommand("export", "write the findings of a run for other programs");
  run(exported);
  store(exported);
  add_format(exported, check.format, format_names(false), "how findings are written");
  exported.get_option("--format")->required()->default_str("");
  add_file(exported, "--output", check.output, "write to a file");
  CLI::App& diff = *audit.add_subcommand("diff", "what is new and what is gone from one run to another");
  diff.add_option("A", line.from, "the older run: a number, last-1, STORE or STORE:RUN")->required();
  diff.add_option("B", line.to, "the newer run")->required();
  store(diff);
  add_fail_on(diff, check, "exit with 1 for new findings from this severity on");
  add_color(diff, check);
  quiet(diff);
  CLI::App& merge = *audit.add_subcommand("merge", "put the stores of all shards of a job together");
  merge.add_option("STORE", line.stores, "a store for each shard")->required();
  store(merge);
  merge.add_flag("--wait", line.wait, "wait where another audit is using the store");
  quiet(merge);
  audit.require_subcommand(0, 1);
  audit.footer("A folder that is named like one of the commands is written with a slash: `owlint audit ./show`.");
}

void add_graph(CLI::App& app, Said& said) {
  CLI::App& graph = *app.add_subcommand("graph", "draw the blocks of a program, and the calls of it and of the files that it calls");
  said.graph.paths.resize(1);
  graph.add_option("FILE", said.graph.paths[0], "the program")->required();
  add_format(graph, said.graph_format, {"dot", "mermaid", "json", "svg"}, "how the graph is written");
  add_machine_options(graph, said.graph, "Options");
  add_configuration_options(graph, said.graph, "Options");
}

void add_fmt(CLI::App& app, Said& said) {
  CLI::App& format = *app.add_subcommand("fmt", "indent programs by their subs and blocks; nothing else changes");
  format.add_option("PATH", said.format.paths, "programs, folders, or - for standard input, which is written to standard output")->required();
  format.add_flag("--check", said.format_check, "change nothing; exit with 1 where something would change");
  format.add_flag("--diff", said.format_diff, "change nothing; print what would change");
  add_configuration_options(format, said.format, "Options");
  add_walk_options(format, said.format.walk);
}

void add_config(CLI::App& app, Said& said) {
  CLI::App& config = *app.add_subcommand("config", "show the settings that programs are checked with, and where they come from");
  config.add_option("PATH", said.config.paths, "programs or folders (default: this one); with --check, files named owlint.toml or folders that have one");
  config.add_flag("--show", said.config_show, "list the settings (default)");
  config.add_flag("--check", said.config_check, "only say whether the configuration is right");
  add_settings_options(config, said.config);
}

}  // namespace

void add_commands(CLI::App& app, Said& said) {
  app.formatter(std::make_shared<Help>());
  app.set_help_flag("-h,--help", "show this help");
  app.require_subcommand(1);
  app.footer("`owlint PATH...` is short for `owlint check PATH...`.\n"
             "Exit status: 0 nothing at or above --fail-on, 1 findings, 2 usage, configuration or unreadable input, 3 internal error.");
  add_check(app, said.check);
  add_audit(app, said.audit);
  add_graph(app, said);
  add_fmt(app, said);
  CLI::App& lsp = *app.add_subcommand("lsp", "language server on standard input and output, for editors");
  lsp.add_flag_function("--stdio", [](std::int64_t) {}, "as always; some editors say it");
  add_config(app, said);
  CLI::App& explain = *app.add_subcommand("explain", "what a rule finds, why, an example, and how to fix it");
  explain.add_option("CODE", said.code, "code or name of a rule, as OW104 or if-label-reused")->required()->type_name("CODE");
  add_color(explain, said.check);
  CLI::App& rules = *app.add_subcommand("rules", "list all rules");
  add_format(rules, said.rules_format, {"text", "json", "markdown"}, "how the list is written");
  rules.add_option("--pages", said.pages, "write a Markdown page for each rule into this folder")->type_name("DIR");
  // For the installation: not shown.
  CLI::App& generate = *app.add_subcommand("generate", "manual pages and shell completions")->group("");
  generate.add_option("DIR", said.generated, "where they are written to")->required();

  const auto flags_take_no_value = [](CLI::App& command) {
    for (CLI::Option* option : command.get_options()) {
      if (!takes_value(*option)) option->disable_flag_override();
    }
  };
  for (CLI::App* command : app.get_subcommands(nullptr)) {
    flags_take_no_value(*command);
    for (CLI::App* one : command->get_subcommands(nullptr)) flags_take_no_value(*one);
  }
}

}  // namespace owlint::cli
