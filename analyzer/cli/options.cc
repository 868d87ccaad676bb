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

CLI::Option* add_words(CLI::App& app, const std::string& name, std::string& value, const std::string& what,
                       std::vector<std::string> words, const std::string& kind) {
  return app.add_option(name, value, what)->transform(one_of(std::move(words)))->type_name(kind)->capture_default_str();
}

CLI::Option* add_file(CLI::App& app, const std::string& name, auto& value, const std::string& what) {
  return app.add_option(name, value, what)->type_name("FILE");
}

/// An option that may be given several times.
CLI::Option* add_list(CLI::App& app, const std::string& name, std::vector<std::string>& list, const std::string& what,
                      const std::string& kind) {
  return app.add_option(name, list, what)->allow_extra_args(false)->type_name(kind);
}

void add_format(CLI::App& app, std::string& value, std::vector<std::string> words, const std::string& what) {
  add_words(app, "--format", value, what, std::move(words), "FORMAT");
}

void add_color(CLI::App& app, CommandLine& line) {
  add_words(app, "--color", line.color, "use colours in the text", {"auto", "always", "never"}, "WHEN");
}

void add_fail_on(CLI::App& app, CommandLine& line, const std::string& what) {
  app.add_option("--fail-on", line.fail_on, what)
      ->transform(one_of({"error", "warning", "info"}))
      ->type_name("LEVEL")
      ->default_str("error");
}

void add_jobs(CLI::App& app, CommandLine& line) {
  app.add_option("--jobs", line.jobs, "how many programs to check at the same time (default: one per core)")
      ->check(count())
      ->type_name("N");
}

/// Which files are programs.
void add_walk_options(CLI::App& app, WalkOptions& walk) {
  add_list(app, "--exclude", walk.exclude,
           "leave out files and folders that match the pattern, written as in .gitignore", "PATTERN")
      ->group("Files");
  app.add_flag("--force-exclude", walk.force_exclude,
               "apply --exclude also to files that are named on the command line, as hooks do")
      ->group("Files");
  add_list(app, "--include", walk.include, "also check files in folders that match the pattern, for example *.txt",
           "PATTERN")
      ->group("Files");
  app.add_flag("--ignore-files,!--no-ignore-files", walk.ignore_files,
               "leave out files that .gitignore and .owlintignore in the folders name (default)")
      ->group("Files");
  app.add_flag("--allow-empty", walk.allow_empty, "accept a folder without programs")->group("Files");
}

/// Which configuration file.
void add_configuration_options(CLI::App& app, CommandLine& line, const std::string& group) {
  add_file(app, "--config", line.config, "use this owlint.toml instead of the nearest one")->group(group);
  app.add_flag("--isolated", line.isolated, "use no owlint.toml")->group(group);
}

/// Where the files of called subs are.
void add_machine_options(CLI::App& app, CommandLine& line, const std::string& group) {
  add_file(app, "--ini", line.ini, "the INI file of the machine that runs the programs")->group(group);
  app.add_flag("--find-ini,!--no-find-ini", line.find_ini,
               "without --ini, use the INI in the program's folder, or in the nearest folder above that has one, if it "
               "has only one (default)")
      ->group(group);
  add_list(app, "--sub-path", line.sub_path,
           "also look for called files in this folder, after the folders of the INI; may be given several times", "DIR")
      ->group(group);
}

/// Which machine, and which rules: the same wherever programs are checked.
void add_settings_options(CLI::App& app, CommandLine& line) {
  add_machine_options(app, line, "Machine");
  app.add_option("--feature", line.feature,
                 "the FEATURE mask, for example 32 or 0x20; 0x20 makes OW101 to OW108 warnings")
      ->check(mask())
      ->type_name("MASK")
      ->group("Machine");
  app.add_option("--linuxcnc", line.linuxcnc, "the LinuxCNC version, or all to report what stops in any version")
      ->transform(one_of({"2.7", "2.8", "2.9", "2.10", "all"}))
      ->type_name("VERSION")
      ->default_str("2.9")
      ->group("Machine");
  const auto codes = [&](const char* name, std::vector<std::string>& list, const char* what) {
    add_list(app, name, list, what, "CODES")->delimiter(',')->transform(rule_code())->group("Rules");
  };
  codes("--select", line.select, "use only these rules: codes, names, or prefixes such as OW3");
  codes("--extend-select", line.extend_select, "also use these rules, even if they are off by default");
  codes("--ignore", line.ignore, "do not use these rules");
  add_list(app, "--severity", line.severity, "set the severity of a rule: off, info, warning or error", "CODE=LEVEL")
      ->delimiter(',')
      ->transform(code_level())
      ->group("Rules");
  add_fail_on(app, line, "exit with 1 if there is a finding of this severity or worse");
  app.get_option("--fail-on")->group("Rules");
  add_configuration_options(app, line, "Rules");
}

void add_check(CLI::App& app, CommandLine& line) {
  CLI::App& check = *app.add_subcommand("check", "find mistakes in programs");
  check
      .add_option("PATH", line.paths,
                  "programs, folders (searched for *.ngc *.nc *.tap *.cnc *.gcode), or - for standard input")
      ->required();
  add_settings_options(check, line);
  add_walk_options(check, line.walk);
  line.walk.takes_inis = true;
  check.add_flag("--fix", line.fix, "make the safe fixes: a program that ran does exactly the same afterwards")
      ->group("Fix");
  check.add_flag("--unsafe", line.unsafe, "also make fixes that may change what the program does; check the result")
      ->group("Fix");
  check.add_flag("--fix-only", line.fix_only, "make the fixes and report nothing")->group("Fix");
  check.add_flag("--diff", line.diff, "print what --fix would change, and change nothing")->group("Fix");
  check
      .add_flag("--add-suppressions", line.add_suppressions,
                "write a comment before each line with a finding, to suppress the finding")
      ->group("Old findings");
  check.add_option("--reason", line.reason, "the reason in the comments of --add-suppressions")
      ->type_name("TEXT")
      ->group("Old findings");
  add_file(check, "--baseline", line.baseline, "do not report the findings in this file: they are known")
      ->group("Old findings");
  check.add_flag("--update-baseline", line.update_baseline, "write all findings of this run to the baseline file")
      ->group("Old findings");
  check.add_option("--since", line.since, "check only files that are new or have changed since this git revision")
      ->type_name("REV")
      ->group("Old findings");
  add_format(check, line.format, format_names(true), "the form of the report");
  add_file(check, "--output", line.output, "write the report to a file");
  add_color(check, line);
  check.add_option("--stdin-filename", line.stdin_filename, "the name of standard input in the report")
      ->type_name("NAME");
  check.add_flag("--statistics", line.statistics, "print the number of findings by rule to standard error");
  check.add_flag("--coarse", line.coarse, "analyse every program like a very large one")
      ->group("");  // for tests, not shown
  check.add_flag("-q,--quiet", line.quiet, "print no summary");
  add_jobs(check, line);
  for (const char* name : {"--format", "--output", "--color", "--stdin-filename", "--statistics", "--quiet", "--jobs"})
    check.get_option(name)->group("Output");
  check.footer("Suppress a finding with a comment on the line before it: (owlint: ignore OW304 because ...)");
}

void add_audit(CLI::App& app, AuditLine& line) {
  CLI::App& audit =
      *app.add_subcommand("audit", "check all programs on a file server; later runs analyse only what has changed");
  CommandLine& check = line.check;
  const auto store = [&](CLI::App& command) {
    add_file(command, "--store", line.store, "the SQLite file with the results")->capture_default_str();
  };
  const auto quiet = [&](CLI::App& command) { command.add_flag("-q,--quiet", check.quiet, "print no summary"); };
  const auto run = [&](CLI::App& command) {
    command.add_option("RUN", line.run, "a number from `owlint audit list`, last, last-1, or STORE:RUN")
        ->capture_default_str();
  };

  audit.add_option("PATH", check.paths, "folders and programs");
  store(audit);
  add_file(audit, "--report", line.report, "write the page: one HTML file that needs nothing else");
  audit.add_flag("--fail-on-new", line.fail_on_new, "exit with 1 only for findings that the run before did not have");
  audit.add_flag("--watch", line.watch, "keep running, and audit again whenever a program is saved");
  audit
      .add_option("--shard", line.shard,
                  "audit only one part of the programs, for example 1/4, to use several computers; see `merge`")
      ->type_name("I/N");
  audit.add_flag("--wait", line.wait, "wait if another audit is using the store");
  add_jobs(audit, check);
  quiet(audit);
  add_color(audit, check);
  add_settings_options(audit, check);
  add_walk_options(audit, check.walk);
  check.walk.takes_inis = true;

  store(*audit.add_subcommand("list", "list the runs of a store"));
  CLI::App& show = *audit.add_subcommand("show", "show the findings of a run");
  run(show);
  store(show);
  add_color(show, check);
  quiet(show);
  CLI::App& exported = *audit.add_subcommand("export", "write the findings of a run for other programs");
  run(exported);
  store(exported);
  add_format(exported, check.format, format_names(false), "the form of the report");
  exported.get_option("--format")->required()->default_str("");
  add_file(exported, "--output", check.output, "write to a file");
  CLI::App& diff = *audit.add_subcommand("diff", "show what is new and what is gone from one run to another");
  diff.add_option("A", line.from, "the older run: a number, last-1, STORE or STORE:RUN")->required();
  diff.add_option("B", line.to, "the newer run")->required();
  store(diff);
  add_fail_on(diff, check, "exit with 1 if there is a new finding of this severity or worse");
  add_color(diff, check);
  quiet(diff);
  CLI::App& merge = *audit.add_subcommand("merge", "join the stores of all shards of a job");
  merge.add_option("STORE", line.stores, "a store for each shard")->required();
  store(merge);
  merge.add_flag("--wait", line.wait, "wait if another audit is using the store");
  quiet(merge);
  audit.require_subcommand(0, 1);
  audit.footer("If a folder has the name of a command, write it with a slash: `owlint audit ./show`.");
}

void add_graph(CLI::App& app, Said& said) {
  CLI::App& graph = *app.add_subcommand(
      "graph", "draw the blocks of a program, and the calls between it and the files that it calls");
  said.graph.paths.resize(1);
  graph.add_option("FILE", said.graph.paths[0], "the program")->required();
  add_format(graph, said.graph_format, {"dot", "mermaid", "json", "svg"}, "the form of the graph");
  add_machine_options(graph, said.graph, "Options");
  add_configuration_options(graph, said.graph, "Options");
}

void add_modes(CLI::App& app, Said& said) {
  CLI::App& modes = *app.add_subcommand(
      "modes", "show which modes (G90, G21, feed, spindle ...) are in effect before a line, and where they were set");
  said.modes.paths.resize(1);
  modes.add_option("FILE", said.modes.paths[0], "the program")->required();
  modes.add_option("LINE", said.modes_line, "the line, from 1 (default: what every line changes)")
      ->check(count())
      ->type_name("");
  add_format(modes, said.modes_format, {"text", "json"}, "the form of the list");
  add_machine_options(modes, said.modes, "Options");
  add_configuration_options(modes, said.modes, "Options");
}

void add_extents(CLI::App& app, Said& said) {
  CLI::App& extents = *app.add_subcommand(
      "extents",
      "show how far a program goes: the least and the greatest coordinate of each axis, and what is unknown");
  said.extents.paths.resize(1);
  extents.add_option("FILE", said.extents.paths[0], "the program")->required();
  add_format(extents, said.extents_format, {"text", "json"}, "the form of the tables");
  add_machine_options(extents, said.extents, "Options");
  add_configuration_options(extents, said.extents, "Options");
}

/// For those who work on the analysis: not shown.
void add_debug_flow(CLI::App& app, Said& said) {
  CLI::App& debug = *app.add_subcommand(
      "debug-flow", "print the states that the flow analysis has at each line, and why they are joined");
  debug.group("");
  said.debugged.paths.resize(1);
  debug.add_option("FILE", said.debugged.paths[0], "the program")->required();
  debug.add_option("--states", said.debugged_states, "keep at most N states apart at a line, and N calls of a sub")
      ->type_name("N");
  add_machine_options(debug, said.debugged, "Options");
}

void add_fmt(CLI::App& app, Said& said) {
  CLI::App& format = *app.add_subcommand("fmt", "indent programs by their subs and blocks, and change nothing else");
  format
      .add_option("PATH", said.format.paths, "programs, folders, or - to read standard input and write standard output")
      ->required();
  format.add_flag("--check", said.format_check, "change nothing; exit with 1 if something would change");
  format.add_flag("--diff", said.format_diff, "change nothing; print what would change");
  add_configuration_options(format, said.format, "Options");
  add_walk_options(format, said.format.walk);
}

void add_config(CLI::App& app, Said& said) {
  CLI::App& config = *app.add_subcommand("config", "show the settings for programs, and where they come from");
  config.add_option("PATH", said.config.paths,
                    "programs or folders (default: the current folder); with --check, files named owlint.toml or "
                    "folders that have one");
  config.add_flag("--show", said.config_show, "list the settings (default)");
  config.add_flag("--check", said.config_check, "only check the configuration");
  add_settings_options(config, said.config);
}

}  // namespace

void add_commands(CLI::App& app, Said& said) {
  app.formatter(std::make_shared<Help>());
  app.set_help_flag("-h,--help", "show this help");
  app.require_subcommand(1);
  app.footer(
      "`owlint PATH...` is short for `owlint check PATH...`.\n"
      "Exit status: 0 no finding at or above --fail-on, 1 findings, 2 usage, configuration or unreadable input, 3 "
      "internal error.");
  add_check(app, said.check);
  add_audit(app, said.audit);
  add_graph(app, said);
  add_modes(app, said);
  add_extents(app, said);
  add_fmt(app, said);
  CLI::App& lsp = *app.add_subcommand("lsp", "run a language server for editors, on standard input and output");
  lsp.add_flag_function(
      "--stdio", [](std::int64_t) {},
      "does nothing: owlint always uses standard input and output, but some editors need this option");
  add_config(app, said);
  CLI::App& explain =
      *app.add_subcommand("explain", "explain a rule: what it finds, why, an example, and how to fix it");
  explain
      .add_option("CODE", said.code,
                  "the code or name of a rule, for example OW104 or if-label-reused; OW1 or `label` lists several")
      ->required()
      ->type_name("CODE");
  add_color(explain, said.check);
  CLI::App& rules = *app.add_subcommand("rules", "list all rules");
  add_format(rules, said.rules_format, {"text", "json", "markdown"}, "the form of the list");
  rules.add_option("--pages", said.pages, "write a Markdown page for each rule into this folder")->type_name("DIR");
  // For the installation: not shown.
  CLI::App& generate = *app.add_subcommand("generate", "manual pages and shell completions")->group("");
  generate.add_option("DIR", said.generated, "the folder for the files")->required();
  add_debug_flow(app, said);

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
