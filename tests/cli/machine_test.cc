// Programs on their machine, as users check them: which INI is taken, what is reported of called files, and how often.
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace machine_test {
namespace {

const std::string kIni = "[EMC]\nVERSION = 1.1\n[RS274NGC]\nSUBROUTINE_PATH = subs\n";

Run check(const Scratch& folder, const std::string& arguments) {
  return owlint::test::owlint(words("check " + arguments), "", folder.path());
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A machine with a program that calls a faulty file.
void write_machine(const Scratch& folder) {
  folder.write("machine.ini", kIni);
  folder.write("subs/bad.ngc", "o<bad> sub\no10 iff [1]\no<bad> endsub\n");
  folder.write("programs/mill/a.ngc", "o<bad> call\nM2\n");
}

}  // namespace

TEST_CASE("the INI in the nearest folder above a program is used and named", "[machine]") {
  const Scratch folder;
  write_machine(folder);
  const Run run = check(folder, "--isolated programs");
  CHECK(run.status == 1);
  CHECK(contains(run.out, "subs/bad.ngc:2:"));
  CHECK(contains(run.err, "owlint: using the machine INI machine.ini (--no-find-ini turns this off)\n"));
  const Run quiet = check(folder, "--isolated --quiet programs");
  CHECK_FALSE(contains(quiet.err, "using"));
  CHECK(quiet.out == run.out);
}

TEST_CASE("looking for an INI can be turned off", "[machine]") {
  const Scratch folder;
  write_machine(folder);
  const Run off = check(folder, "--isolated --no-find-ini programs");
  CHECK(off.status == 0);
  CHECK_FALSE(contains(off.err, "using"));
  CHECK(contains(off.out, "OW208"));
  folder.write("owlint.toml", "find-ini = false\n");
  CHECK(check(folder, "programs").out == off.out);
  folder.write("owlint.toml", "find-ini = 1\n");
  const Run wrong = check(folder, "programs");
  CHECK(wrong.status == 2);
  CHECK(contains(wrong.err, "line 1: `find-ini` must be true or false"));
}

TEST_CASE("of several INIs none is used", "[machine]") {
  const Scratch folder;
  write_machine(folder);
  folder.write("other.ini", kIni);
  folder.write("programs/desktop.ini", "[ViewState]\nMode=\n");  // no machine
  const Run run = check(folder, "--isolated programs");
  CHECK(run.status == 0);
  CHECK(contains(run.err, "2 machine INIs in "));
  CHECK(contains(run.err, "none is used: choose one with --ini"));
  CHECK(check(folder, "--isolated --ini other.ini programs").status == 1);
}

TEST_CASE("a code that one of several INIs remaps is no error", "[machine]") {
  const Scratch folder;
  folder.write("inch.ini", kIni + "REMAP = M13 modalgroup=10 ngc=both\n");
  folder.write("metric.ini", kIni);
  folder.write("subs/both.ngc", "o<both> sub\nM3\no<both> endsub\n");
  folder.write("programs/a.ngc", "M13\nM2\n");
  const Run run = check(folder, "--isolated programs");
  CHECK(run.status == 0);
  CHECK(contains(run.out, "info `M13` is not a code of LinuxCNC; one of the machine INIs near this program remaps it"));
  folder.write("programs/a.ngc", "M14\nM2\n");
  CHECK(check(folder, "--isolated programs").status == 1);
}

TEST_CASE("copies of an INI with one mistake are one finding, and several parts of configurations an info",
          "[machine]") {
  const Scratch folder;
  for (const std::string name : {"a", "b", "c"}) {
    folder.write(name + "/machine.ini",
                 kIni + "RETAIN_G34 = 1\n[HAL]\nHALFILE = mill.hal\n[EMCIO]\nTOOL_TABLE = mill.tbl\n");
    folder.write(name + "/p.ngc", "M2\n");
  }
  const Run copies = check(folder, "--isolated .");
  CHECK(contains(copies.out, "a/machine.ini:5:1: warning LinuxCNC reads no `RETAIN_G34`"));
  CHECK(contains(copies.out, "(3 places in 3 files)"));
  CHECK_FALSE(contains(copies.out, "b/machine.ini:5:1: warning"));
  CHECK(contains(copies.out,
                 "info 3 files and folders that this INI names are not here: `subs`, `mill.hal`, `mill.tbl`"));
  for (const std::string name : {"a", "b", "c"}) folder.write(name + "/mill.hal", "loadrt trivkins\n");
  CHECK(contains(check(folder, "--isolated a").out, "warning the folder `subs` of `SUBROUTINE_PATH` does not exist"));
}

TEST_CASE("however many INIs there are, a check and an audit say it in two lines", "[machine]") {
  const Scratch folder;
  for (const std::string name : {"a", "b", "c", "d", "e"}) {
    folder.write(name + "/machine.ini", kIni);
    folder.write(name + "/p.ngc", "M2\n");
    folder.write(name + "2/one.ini", kIni);
    folder.write(name + "2/two.ini", kIni);
    folder.write(name + "2/p.ngc", "M2\n");
  }
  for (const char* command : {"check --isolated .", "audit --isolated ."}) {
    INFO(command);
    const Run run = owlint::test::owlint(words(command), "", folder.path());
    CHECK(contains(run.err,
                   "using 5 machine INIs, each for the programs in and below its folder: a/machine.ini, b/machine.ini, "
                   "c/machine.ini and 2 more (--no-find-ini turns this off)\n"));
    CHECK(contains(run.err, "5 folders have several machine INIs each, so none of them is used: "));
    CHECK(contains(run.err,
                   "is used: a2, b2, c2 and 2 more; choose one with --ini, or with `ini` in an owlint.toml there\n"));
    CHECK_FALSE(contains(run.err, "d/machine.ini"));
  }
}

TEST_CASE("an INI that cannot be read is a usage error, an include that cannot is a note", "[machine]") {
  const Scratch folder;
  write_machine(folder);
  const Run missing = check(folder, "--isolated --ini none.ini programs");
  CHECK(missing.status == 2);
  CHECK(contains(missing.err, "cannot read the INI none.ini: No such file or directory"));
  folder.write("machine.ini", kIni + "#INCLUDE more.inc\n");
  const Run note = check(folder, "--isolated programs");
  CHECK(note.status == 1);
  CHECK(contains(note.err, "line 5: cannot read the file of `#INCLUDE more.inc`"));
}

TEST_CASE("a finding in a called file is reported once, with the calls that lead to it", "[machine]") {
  const Scratch folder;
  write_machine(folder);
  for (const char* name : {"b", "c"}) folder.write(std::string("programs/") + name + ".ngc", "o<bad> call\nM2\n");
  for (const char* paths : {"programs", "programs subs", "subs programs"}) {
    for (const char* jobs : {"1", "2"}) {
      INFO(paths);
      const auto report = nlohmann::json::parse(
          check(folder, std::string("--isolated --format json --jobs ") + jobs + " " + paths).out);
      CHECK(report["summary"]["errors"] == 1);
      std::vector<nlohmann::json> found;
      for (const auto& file : report["files"]) {
        for (const auto& f : file["findings"]) found.push_back({{"path", file["path"]}, {"finding", f}});
      }
      REQUIRE(found.size() == 1);
      CHECK(found[0]["path"] == "subs/bad.ngc");
      CHECK(found[0]["finding"]["start"]["line"] == 2);
      std::vector<std::string> calls;
      for (const auto& related : found[0]["finding"]["related"]) calls.push_back(related["path"]);
      std::ranges::sort(calls);
      CHECK(calls == std::vector<std::string>{"programs/b.ngc", "programs/c.ngc", "programs/mill/a.ngc"});
    }
  }
}

TEST_CASE("a file is named as it was given, whichever way a call found it first", "[machine]") {
  const Scratch folder;
  write_machine(folder);
  const std::string absolute = folder.path() + "/";
  for (const std::string& programs : {std::string(), absolute}) {
    for (const std::string& subs : {std::string(), absolute}) {
      // With one job the program comes first, and with it the call.
      const std::string both = " --jobs 1 " + programs + "programs " + subs + "subs";
      CHECK(contains(check(folder, "--isolated --format jsonl" + both).out, "\"path\":\"" + subs + "subs/bad.ngc\""));
      CHECK(
          contains(check(folder, "--isolated --add-suppressions --reason known" + both).err, "suppressed 1 finding\n"));
      write_machine(folder);
    }
  }
}

TEST_CASE("called files and the INI of a program with an absolute path have absolute paths", "[machine]") {
  const Scratch folder;
  const Scratch elsewhere;
  write_machine(folder);
  const Run run = check(elsewhere, "--isolated --format gcc " + folder.path() + "/programs");
  CHECK(run.status == 1);
  CHECK(contains(run.out, folder.path() + "/subs/bad.ngc:2:"));
  CHECK(contains(run.err, "using the machine INI " + folder.path() + "/machine.ini"));
  CHECK_FALSE(contains(run.out + run.err, ".."));
}

TEST_CASE("files that others call are no programs", "[machine]") {
  const Scratch folder;
  folder.write("machine.ini",
               kIni + "REMAP = M410 modalgroup=10 ngc=remapped\n[HALUI]\nMDI_COMMAND = o<button> call [1]\n");
  // Code after the sub, no M2: as a program each of these would stop at its end.
  for (const char* name : {"called", "remapped", "button"}) {
    folder.write(std::string("subs/") + name + ".ngc",
                 std::string("o<") + name + "> sub\nG0 X#1\no<" + name + "> endsub\nG0 X0\n");
  }
  folder.write("p.ngc", "o<called> call [1]\nM2\n");
  const Run run = check(folder, "--isolated .");
  INFO(run.out);
  CHECK(run.status == 0);
  folder.write("machine.ini", kIni);
  CHECK(contains(check(folder, "--isolated .").out, "subs/button.ngc"));
}

TEST_CASE("what stops in some versions only says in which", "[machine]") {
  const Scratch folder;
  folder.write("machine.ini", kIni);
  folder.write("subs/two.ngc", "o<two> sub\no100 call\no<two> endsub\no100 sub\no100 endsub\n");
  folder.write("p.ngc", "o<two> call\nM2\n");
  CHECK(check(folder, "--isolated p.ngc").status == 0);
  const Run all = check(folder, "--isolated --linuxcnc all --format json p.ngc");
  CHECK(all.status == 1);
  const auto report = nlohmann::json::parse(all.out);
  CHECK(report["files"][1]["findings"][0]["versions"] == nlohmann::json{"2.10"});
  folder.write("owlint.toml", "linuxcnc = \"all\"\n");
  CHECK(check(folder, "p.ngc").status == 1);
}

TEST_CASE("Python functions are named and not reported", "[machine]") {
  const Scratch folder;
  folder.write("machine.ini", kIni + "[PYTHON]\nTOPLEVEL = top.py\n");
  folder.write("top.py", "import remap\n");
  folder.write("subs/other.ngc", "o<other> sub\no<other> endsub\n");
  folder.write("p.ngc", "o<measure> call\nM2\n");
  const Run run = check(folder, "--isolated p.ngc");
  CHECK(run.status == 0);
  CHECK(run.out.empty());
  CHECK(contains(run.err, "assumed to be functions of the INI's [PYTHON] module: o<measure>\n"));
}

TEST_CASE("graphs show the called files", "[machine]") {
  const Scratch folder;
  folder.write("machine.ini", kIni);
  folder.write("subs/two.ngc", "o<two> sub\no100 call\no<two> endsub\no100 sub\no100 endsub\n");
  folder.write("p.ngc", "o<two> call\no<none> call\nM2\n");
  const auto graph = [&](const std::string& format) {
    return owlint::test::owlint({"graph", "--format", format, "p.ngc"}, "", folder.path());
  };
  CHECK(contains(graph("dot").out, "label=\"subs/two.ngc\""));
  CHECK(contains(graph("mermaid").out, "subgraph file1[\"subs/two.ngc\"]"));
  const auto json = nlohmann::json::parse(graph("json").out);
  CHECK(json["calls"][0]["file"] == "subs/two.ngc");
  CHECK(json["calls"][1]["file"].is_null());
  CHECK(json["files"][0]["path"] == "subs/two.ngc");
  CHECK(json["files"][0]["calls"][0]["to"] == 2);
  const Run svg = graph("svg");
  INFO(svg.err);
  CHECK(svg.status == 0);
  CHECK(contains(svg.out, "<svg"));
  CHECK(contains(svg.out, "subs/two.ngc"));
}

TEST_CASE("folders of --sub-path are searched for called files, behind those of the INI", "[machine]") {
  const Scratch folder;
  folder.write("programs/p.ngc", "o<bad> call\nM2\n");
  folder.write("macros/bad.ngc", "o<bad> sub\no10 iff [1]\no<bad> endsub\n");
  folder.write("good/bad.ngc", "o<bad> sub\no<bad> endsub\n");
  CHECK(contains(check(folder, "--isolated programs").out, "OW208"));
  const Run found = check(folder, "--isolated --sub-path macros programs");
  CHECK(found.status == 1);
  CHECK(contains(found.out, "macros/bad.ngc:2:"));
  CHECK(check(folder, "--isolated --sub-path good --sub-path macros programs").status == 0);  // the first one is read
  CHECK(contains(check(folder, "--isolated --sub-path good --sub-path macros programs").out, "OW405"));
  folder.write("programs/bad.ngc", "o<bad> sub\no<bad> endsub\n");
  CHECK(check(folder, "--isolated --sub-path macros programs").status == 0);  // the program's own folder comes first
  std::filesystem::remove(folder.path() + "/programs/bad.ngc");
  folder.write("machine.ini", kIni + "[WIZARD]\nWIZARD_ROOT = wizards\n");
  CHECK(contains(check(folder, "--isolated --ini machine.ini --sub-path macros programs").out, "macros/bad.ngc:2:"));
  folder.write("wizards/deep/bad.ngc", "o<bad> sub\no<bad> endsub\n");
  CHECK(check(folder, "--isolated --ini machine.ini --sub-path macros programs").status == 0);
  const Run missing = check(folder, "--isolated --sub-path none programs");
  CHECK(missing.status == 2);
  CHECK(missing.err == "owlint: --sub-path: there is no folder none\n");
}

TEST_CASE("sub-path in owlint.toml is seen from its folder, and adds to --sub-path", "[machine]") {
  const Scratch folder;
  folder.write("owlint.toml", "sub-path = [\"macros\", \"more\"]\n");
  folder.write("programs/p.ngc", "o<bad> call\no<fine> call\nM2\n");
  folder.write("macros/bad.ngc", "o<bad> sub\no10 iff [1]\no<bad> endsub\n");
  folder.write("more/fine.ngc", "o<fine> sub\no<fine> endsub\n");
  folder.write("good/bad.ngc", "o<bad> sub\no<bad> endsub\n");
  const Run found = check(folder, "programs");
  CHECK(contains(found.out, "macros/bad.ngc:2:"));
  CHECK_FALSE(contains(found.out, "OW208"));
  const Scratch elsewhere;
  CHECK(contains(check(elsewhere, folder.path() + "/programs").out, folder.path() + "/macros/bad.ngc:2:"));
  const Run both = check(folder, "--sub-path good programs");  // in front of the file's
  CHECK(both.status == 0);
  CHECK_FALSE(contains(both.out, "OW208"));
  const std::string listed = owlint::test::owlint({"config", "--sub-path", "good", "programs"}, "", folder.path()).out;
  CHECK(contains(listed, "sub-path         good                     # --sub-path\n"));
  CHECK(contains(listed, "sub-path         macros                   # owlint.toml:1\n"));
  const Run graph = owlint::test::owlint({"graph", "--format", "json", "programs/p.ngc"}, "", folder.path());
  CHECK(contains(graph.out, "macros/bad.ngc"));
  folder.write("owlint.toml", "\nsub-path = [\"none\"]\n");
  const Run missing = check(folder, "programs");
  CHECK(missing.status == 2);
  CHECK(missing.err == "owlint: owlint.toml:2: there is no folder none\n");
}

TEST_CASE("subs that the INI calls are looked for in the folders of --sub-path as well", "[machine]") {
  const Scratch folder;
  folder.write("machine.ini", "[EMC]\nVERSION = 1.1\n[HALUI]\nMDI_COMMAND = o<button> call\n");
  folder.write("macros/button.ngc", "o<button> sub\no<button> endsub\n");
  folder.write("p.ngc", "M2\n");
  CHECK(contains(check(folder, "--isolated --ini machine.ini p.ngc").out, "OW208"));
  CHECK(check(folder, "--isolated --ini machine.ini --sub-path macros p.ngc").out.empty());
}

}  // namespace machine_test
