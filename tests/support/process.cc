#include "support/process.h"

#include "support/bundle.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <sstream>

#include <catch2/catch.hpp>

#include "support/files.h"

namespace owlint::test {

namespace {

Run run_program(std::string program, const std::vector<std::string>& arguments, const std::string& input,
                const std::string& folder) {
  const Scratch scratch;
  const std::string in = scratch.write("in", input);
  const std::string out = scratch.write("out", "");
  const std::string err = scratch.write("err", "");
  std::vector<char*> argv{program.data()};
  std::vector<std::string> copies = arguments;
  for (std::string& argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);

  const auto started = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::dup2(::open(in.c_str(), O_RDONLY), 0);
    ::dup2(::open(out.c_str(), O_WRONLY), 1);
    ::dup2(::open(err.c_str(), O_WRONLY), 2);
    if (!folder.empty() && ::chdir(folder.c_str()) != 0) ::_exit(126);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  Run run;
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = read_file(out);
  run.err = read_file(err);
  return run;
}

}  // namespace

Run owlint(const std::vector<std::string>& arguments, const std::string& input, const std::string& folder) {
  return run_program(OWLINT_PROGRAM, arguments, input, folder);
}

Run shell(const std::string& script, const std::string& folder) {
  return run_program(
      "/bin/bash",
      {"-c",
       std::string("owlint() { ") + OWLINT_PROGRAM + " \"$@\"; }; export OWLINT=" + OWLINT_PROGRAM + "; " + script},
      "", folder);
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

namespace {

nlohmann::json report_of(std::vector<std::string> arguments, const std::string& options, const std::string& input) {
  arguments.insert(arguments.begin(), {"check", "--isolated", "--format", "json"});
  const std::vector<std::string> more = words(options);
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Run run = owlint(arguments, input);
  INFO("options: " << options << "\nstandard error: " << run.err);
  REQUIRE(run.status <= 1);
  return nlohmann::json::parse(run.out);
}

}  // namespace

nlohmann::json findings_of(const std::string& program, const std::string& options) {
  if (is_bundle(program)) return findings_of_bundle(program, options);
  return report_of({"-"}, options, program)["files"][0]["findings"];
}

nlohmann::json check_files(const std::vector<std::string>& paths, const std::string& options) {
  nlohmann::json files = report_of(paths, options, "")["files"];
  REQUIRE(files.size() == paths.size());
  for (size_t i = 0; i < paths.size(); ++i) REQUIRE(files[i]["path"].get<std::string>() == paths[i]);
  return files;
}

}  // namespace owlint::test
