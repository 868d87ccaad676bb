// Search paths and called files that nobody means well with: owlint comes back, says what is there, reads nothing else.
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace linked_hostile_test {
namespace {

namespace fs = std::filesystem;

/// Checks `p.ngc` in the folder, with its machine.ini.
nlohmann::json check(const Scratch& folder, const std::string& program, const std::vector<std::string>& more = {}) {
  folder.write("p.ngc", program);
  std::vector<std::string> arguments{"check", "--isolated", "--ini", "machine.ini", "--format", "json", "p.ngc"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Run run = owlint::test::owlint(arguments, "", folder.path());
  INFO(run.err);
  REQUIRE(run.status < 2);
  return nlohmann::json::parse(run.out);
}

std::vector<std::string> codes(const nlohmann::json& report) {
  std::vector<std::string> out;
  for (const auto& file : report["files"]) {
    for (const auto& f : file["findings"]) out.push_back(f["code"]);
  }
  return out;
}

std::string sub(const std::string& name, const std::string& body) {
  return "o<" + name + "> sub\n" + body + "o<" + name + "> endsub\n";
}

}  // namespace

TEST_CASE("what is no file is found and not read", "[hostile]") {
  const Scratch folder;
  folder.write("machine.ini", "[RS274NGC]\nSUBROUTINE_PATH = subs\n");
  fs::create_directories(folder.path() + "/subs/folder.ngc");
  REQUIRE(::mkfifo((folder.path() + "/subs/pipe.ngc").c_str(), 0600) == 0);
  fs::create_symlink("/dev/zero", folder.path() + "/subs/zero.ngc");
  fs::create_symlink("loop.ngc", folder.path() + "/subs/loop.ngc");
  fs::create_symlink("nowhere.ngc", folder.path() + "/subs/broken.ngc");
  using Codes = std::vector<std::string>;
  for (const char* name : {"folder", "pipe", "zero"}) {
    INFO(name);
    CHECK(codes(check(folder, fmt::format("o<{}> call\nM2\n", name))) == Codes{"OW401"});
  }
  for (const char* name : {"loop", "broken"}) {
    INFO(name);
    CHECK(codes(check(folder, fmt::format("o<{}> call\nM2\n", name))) == Codes{"OW208"});
  }
}

TEST_CASE("folders that contain themselves are walked once", "[hostile]") {
  const Scratch folder;
  folder.write("machine.ini",
               "[RS274NGC]\nSUBROUTINE_PATH = subs:subs/again:subs/again/again\n[WIZARD]\nWIZARD_ROOT = tree\n");
  folder.write("subs/a.ngc", sub("a", "G0 X1\n"));
  folder.write("tree/b/b.ngc", sub("b", "G0 X1\n"));
  fs::create_directory_symlink(".", folder.path() + "/subs/again");
  fs::create_directory_symlink("..", folder.path() + "/tree/b/up");
  CHECK(codes(check(folder, "o<a> call\no<b> call\nM2\n")).empty());
  CHECK(codes(check(folder, "o<c> call\nM2\n")) == std::vector<std::string>{"OW208"});
}

TEST_CASE("a name never leads out of the search path", "[hostile]") {
  const Scratch folder;
  folder.write("machine.ini", "[RS274NGC]\nSUBROUTINE_PATH = subs\n");
  folder.write("secret.txt", "");
  folder.write("outside/s.ngc", sub("s", "o1 iff\n"));
  fs::create_directories(folder.path() + "/subs");
  for (const char* name : {"../outside/s", "./../outside/s", "~/s", "a/../../outside/s"}) {
    INFO(name);
    const auto report = check(folder, fmt::format("o<{}> call\nM2\n", name));
    CHECK(report["files"].size() == 1);
    CHECK(std::ranges::count(codes(report), "OW506") == 1);
  }
  const std::string absolute = folder.path() + "/outside/s";
  CHECK(std::ranges::count(codes(check(folder, "o<" + absolute + "> call\nM2\n")), "OW506") == 1);
}

TEST_CASE("a search path with 100,000 files is no burden", "[hostile]") {
  const Scratch folder;
  folder.write("machine.ini", "[RS274NGC]\nSUBROUTINE_PATH = subs\n");
  fs::create_directories(folder.path() + "/subs");
  for (int i = 0; i < 100'000; ++i) std::ofstream(fmt::format("{}/subs/part_{}.ngc", folder.path(), i));
  std::ofstream(folder.path() + "/subs/probe_z.ngc") << sub("probe_z", "G0 X1\n");
  std::string program;
  for (int i = 0; i < 300; ++i) program += fmt::format("o<prob_z{}> call\n", i % 10);
  const auto started = std::chrono::steady_clock::now();
  const auto report = check(folder, "o<probe_z> call\no<prob_z> call\n" + program + "M2\n");
  CHECK(std::chrono::steady_clock::now() - started < std::chrono::seconds(20 * OWLINT_PATIENCE));
  REQUIRE_FALSE(report["files"][0]["findings"].empty());
  CHECK(report["files"][0]["findings"][0]["help"] == "did you mean `o<probe_z>`, in subs/probe_z.ngc?");
}

TEST_CASE("files that call each other in every way end", "[hostile]") {
  const Scratch folder;
  folder.write("machine.ini", "[RS274NGC]\nSUBROUTINE_PATH = subs\n");
  // Ten files, each calling all: a call graph with exponentially many paths, all of them too deep.
  std::string calls;
  for (int i = 0; i < 10; ++i) calls += fmt::format("o{} if [#500 GT {}]\no<f{}> call [#1]\no{} endif\n", i, i, i, i);
  for (int i = 0; i < 10; ++i) folder.write(fmt::format("subs/f{}.ngc", i), sub(fmt::format("f{}", i), calls));
  const auto report = check(folder, "o<f0> call [1]\nM2\n");
  CHECK(std::ranges::count(codes(report), "OW210") > 0);
  // A chain that is far longer than calls can be nested.
  for (int i = 0; i < 3000; ++i)
    folder.write(fmt::format("subs/c{}.ngc", i), sub(fmt::format("c{}", i), fmt::format("o<c{}> call\n", i + 1)));
  CHECK(codes(check(folder, "o<c0> call\nM2\n")) == std::vector<std::string>{"OW210"});
}

TEST_CASE("ten thousand programs parse their shared files once", "[hostile]") {
  const Scratch folder;
  folder.write("machine.ini", "[RS274NGC]\nSUBROUTINE_PATH = subs\n");
  for (int i = 0; i < 500; ++i) folder.write(fmt::format("subs/s{}.ngc", i), sub(fmt::format("s{}", i), "G0 X#1\n"));
  for (int i = 0; i < 10'000; ++i) {
    folder.write(fmt::format("programs/p{:05}.ngc", i),
                 fmt::format("o<s{}> call [1]\no<s{}> call [2]\nM2\n", i % 500, (i * 7 + 3) % 500));
  }
  for (const char* jobs : {"1", "2"}) {
    const Run run = owlint::test::owlint(
        {"check", "--isolated", "--ini", "machine.ini", "--statistics", "--jobs", jobs, "programs"}, "", folder.path());
    INFO(run.err);
    CHECK(run.status == 0);
    CHECK(run.err.find("  10500  files parsed, 500 of them for 20000 calls from other files\n") != std::string::npos);
  }
}

}  // namespace linked_hostile_test
