// The command line of owlint: which command runs.
#include <sys/auxv.h>

#include <algorithm>
#include <exception>
#include <iostream>

#include <fmt/format.h>

#include "analyzer/cli/commands.h"
#include "analyzer/cli/generate.h"
#include "analyzer/cli/options.h"
#include "analyzer/cli/usage.h"
#include "analyzer/report/report.h"

namespace owlint::cli {
namespace {

/// What somebody who reports a fault is asked for.
std::string version_text() {
#ifdef __clang__
  constexpr std::string_view kCompiler = "clang " __clang_version__;
#else
  constexpr std::string_view kCompiler = "g++ " __VERSION__;
#endif
  const bool is_static = ::getauxval(AT_BASE) == 0;  // no dynamic linker was loaded
  return fmt::format("owlint {}\nbuilt with {}, {}, linked {}", kToolVersion, kCompiler, OWLINT_BUILD_TYPE,
                     is_static ? "statically" : "dynamically");
}

bool is_command(CLI::App& app, const std::string& name) {
  return std::ranges::any_of(app.get_subcommands(nullptr),
                             [&](const CLI::App* command) { return command->get_name() == name; });
}

int wrong_usage(const std::string& message) {
  complain(message);
  return kUsage;
}

int run_audit(const CLI::App& app, const AuditLine& line) {
  if (app.got_subcommand("list")) return audit_list_command(line);
  if (app.got_subcommand("show") || app.got_subcommand("export")) return audit_show_command(line);
  if (app.got_subcommand("diff")) return audit_diff_command(line);
  if (app.got_subcommand("merge")) return audit_merge_command(line);
  if (line.check.paths.empty()) return wrong_usage("`owlint audit` needs PATH: folders and programs");
  return audit_command(line);
}

int run_command(const CLI::App& app, const Said& said) {
  if (app.got_subcommand("check")) return check_command(said.check);
  if (app.got_subcommand("audit")) return run_audit(*app.get_subcommand("audit"), said.audit);
  if (app.got_subcommand("graph")) return graph_command(said.graph, said.graph_format);
  if (app.got_subcommand("modes")) return modes_command(said.modes, said.modes_line, said.modes_format);
  if (app.got_subcommand("extents")) return extents_command(said.extents, said.extents_format);
  if (app.got_subcommand("debug-flow")) return debug_flow_command(said.debugged, said.debugged_states);
  if (app.got_subcommand("fmt")) return format_command(said.format, said.format_check, said.format_diff);
  if (app.got_subcommand("lsp")) return lsp_command();
  if (app.got_subcommand("explain")) return explain_command(said.code, said.check.color);
  if (app.got_subcommand("config")) {
    if (said.config_show && said.config_check) return wrong_usage("--show and --check do not go together");
    return config_command(said.config, said.config_check);
  }
  if (app.got_subcommand("generate")) {
    std::string error;
    return generate(app, said.generated, &error) ? kClean : wrong_usage(error);
  }
  return said.pages.empty() ? rules_command(said.rules_format) : rule_pages_command(said.pages);
}

int run(std::vector<std::string> arguments) {
  CLI::App app{
      "owlint finds mistakes in LinuxCNC programs that stop the machine, before it moves. It checks O-words, "
      "parameters, the words of every line, the modes and the position of the tool.",
      "owlint"};
  app.set_version_flag("--version", version_text(), "show the version, and how this owlint was built");
  Said said;
  add_commands(app, said);
  if (arguments.empty()) {
    std::cerr << app.help();
    return kUsage;
  }
  const std::string first = arguments.front();
  if (first == "help") {
    arguments.erase(arguments.begin());
    arguments.emplace_back("--help");
  } else if (!is_command(app, first) && first != "--help" && first != "-h" && first != "--version") {
    if (const std::string misspelt = misspelt_command(app, first); !misspelt.empty()) return wrong_usage(misspelt);
    arguments.insert(arguments.begin(), "check");  // it may be left out
  }
  try {
    std::ranges::reverse(arguments);  // CLI11 takes them from the back
    app.parse(arguments);
  } catch (const CLI::Success& asked) {  // --help, --version
    return app.exit(asked);
  } catch (const CLI::ParseError& problem) {
    return wrong_usage(usage_problem(app, problem));
  }
  return run_command(app, said);
}

}  // namespace
}  // namespace owlint::cli

int main(int argc, char** argv) {
  using namespace owlint::cli;
  std::ios::sync_with_stdio(false);
  try {
    const int status = run({argv + 1, argv + argc});
    std::cout.flush();
    if (std::cout) return status;
    complain("cannot write to standard output");
    return status == kInternal ? kInternal : kUsage;
  } catch (const std::exception& problem) {
    complain(std::string("internal error: ") + problem.what());
    return kInternal;
  }
}
