// owlint.toml: which one counts, what it may say, and what the command line has over it.
#include <catch2/catch.hpp>

#include "analyzer/checking/settings.h"
#include "analyzer/checking/walk.h"
#include "support/files.h"

#include <filesystem>

using namespace owlint;
using checking::CheckRequest;
using checking::Configuration;
using checking::Settings;

namespace {

/// Settings of `program` in `scratch`; the error in `error`, when one is expected.
Settings settings(const test::Scratch& scratch, const std::string& program, const CheckRequest& line = {},
                  std::string* error = nullptr) {
  Configuration configuration(disk(), line);
  Settings result;
  std::string problem;
  const bool good = configuration.settings_for(scratch.path() + "/" + program, &result, &problem);
  if (error == nullptr) {
    INFO(problem);
    CHECK(good);
  } else {
    CHECK_FALSE(good);
    *error = problem;
  }
  return result;
}

std::string error_of(const std::string& toml) {
  const test::Scratch scratch;
  scratch.write("owlint.toml", toml);
  std::string error;
  settings(scratch, "p.ngc", {}, &error);
  const size_t at = error.find("owlint.toml: ");
  REQUIRE(at != std::string::npos);
  return error.substr(at + 13);
}

}  // namespace

TEST_CASE("a configuration is read", "[settings]") {
  const test::Scratch scratch;
  scratch.write("machine.ini", "[RS274NGC]\nOWORD_WARNONLY = 1\n");
  scratch.write(
      "owlint.toml",
      "ini = \"machine.ini\"\nfeature = \"0x10\"\nlinuxcnc = \"2.8\"\nselect = [\"OW1\"]\nignore = [\"OW104\"]\n"
      "extend-select = [\"OW310\"]\n[severity]\nOW2 = \"warning\"\n");
  const Settings s = settings(scratch, "p.ngc");
  CHECK(s.profile.setup->warnonly);
  CHECK(s.profile.feature == 0x10);
  CHECK(s.profile.version == Version::k2_8);
  CHECK(s.profile.version_given);
  CHECK(s.options.select == std::vector<std::string>{"OW1"});
  CHECK(s.options.ignore == std::vector<std::string>{"OW104"});
  CHECK(s.options.extend_select == std::vector<std::string>{"OW310"});
  CHECK(s.options.severity.at("OW2") == Severity::kWarning);
}

TEST_CASE("the nearest configuration counts", "[settings]") {
  const test::Scratch scratch;
  scratch.write("owlint.toml", "feature = 1\n");
  scratch.write("a/.owlint.toml", "feature = 2\n");
  scratch.write("a/b/c/p.ngc", "");
  scratch.write("d/owlint.toml", "feature = 3\n");
  scratch.write("d/.owlint.toml", "feature = 4\n");
  CHECK(settings(scratch, "p.ngc").profile.feature == 1);
  CHECK(settings(scratch, "a/p.ngc").profile.feature == 2);
  CHECK(settings(scratch, "a/b/c/p.ngc").profile.feature == 2);
  CHECK(settings(scratch, "d/p.ngc").profile.feature == 3);
  CheckRequest isolated;
  isolated.isolated = true;
  CHECK_FALSE(settings(scratch, "a/p.ngc", isolated).profile.feature.has_value());
  CheckRequest chosen;
  chosen.config = scratch.path() + "/d/.owlint.toml";
  CHECK(settings(scratch, "a/p.ngc", chosen).profile.feature == 4);
}

TEST_CASE("the command line is over the configuration", "[settings]") {
  const test::Scratch scratch;
  scratch.write(
      "owlint.toml",
      "feature = 1\nlinuxcnc = \"2.7\"\nselect = [\"OW1\"]\nignore = [\"OW104\"]\n[severity]\nOW1 = \"off\"\n");
  CheckRequest line;
  line.feature = "0x20";
  line.linuxcnc = "2.10";
  line.select = {"OW2"};
  line.ignore = {"OW205"};
  line.severity = {"OW1=error", "OW310=warning"};
  const Settings s = settings(scratch, "p.ngc", line);
  CHECK(s.profile.feature == 0x20);
  CHECK(s.profile.version == Version::k2_10);
  CHECK(s.options.select == std::vector<std::string>{"OW2"});
  CHECK(s.options.ignore == std::vector<std::string>{"OW104", "OW205"});
  CHECK(s.options.severity.at("OW1") == Severity::kError);
  // asking for a severity asks for the rule
  CHECK(std::ranges::count(s.options.extend_select, "OW310") == 1);
}

TEST_CASE("overrides change the selection of some files", "[settings]") {
  const test::Scratch scratch;
  scratch.write("owlint.toml",
                "ignore = [\"OW304\"]\n[[overrides]]\nfiles = [\"legacy/*\"]\nignore = [\"OW1\"]\nseverity = {OW2 = "
                "\"warning\"}\n"
                "[[overrides]]\nfiles = [\"*.tap\"]\nselect = [\"OW5\"]\n");
  CHECK(settings(scratch, "p.ngc").options.ignore == std::vector<std::string>{"OW304"});
  const Settings legacy = settings(scratch, "legacy/deep/p.tap");
  CHECK(legacy.options.ignore == std::vector<std::string>{"OW304", "OW1"});  // added to those of all files
  CHECK(legacy.options.select == std::vector<std::string>{"OW5"});
  CHECK(legacy.options.severity.at("OW2") == Severity::kWarning);
  CHECK(settings(scratch, "./deep/../legacy/p.ngc").options.ignore == legacy.options.ignore);
}

TEST_CASE("an unknown key names the nearest one", "[settings]") {
  CHECK(error_of("selct = [\"OW1\"]\n") == "line 1: unknown key `selct`, did you mean `select`?");
  CHECK(error_of("\nextend_select = [\"OW1\"]\n") ==
        "line 2: unknown key `extend_select`, did you mean `extend-select`?");
  CHECK(error_of("[sevrity]\nOW1 = \"off\"\n") == "line 1: unknown key `sevrity`, did you mean `severity`?");
  CHECK(error_of("colour = 1\n") == "line 1: unknown key `colour`");
  CHECK(error_of("[[overrides]]\nfile = [\"*\"]\n") == "line 2: unknown key `file`, did you mean `files`?");
}

TEST_CASE("values that cannot be meant are errors", "[settings]") {
  CHECK(error_of("select = \"OW1\"\n") == "line 1: `select` must be a list of codes");
  CHECK(error_of("select = [1]\n") == "line 1: `select` must be a list of codes");
  CHECK(error_of("ignore = [\"OW1O4\"]\n") == "line 1: there is no rule `OW1O4`, did you mean `OW104`?");
  CHECK(error_of("[severity]\nOW104 = \"fatal\"\n") ==
        "line 2: the severity of `OW104` must be one of off, info, warning, error");
  CHECK(error_of("severity = \"off\"\n") == "line 1: `severity` is a table of codes and levels");
  CHECK(error_of("feature = \"many\"\n") == "line 1: `feature` is a number, as 32 or 0x20");
  CHECK(error_of("feature = -1\n") == "line 1: `feature` is a number, as 32 or 0x20");
  CHECK(error_of("ini = 5\n") == "line 1: `ini` must be text in quotes, such as \"mill.ini\"");
  CHECK(error_of("linuxcnc = 2.9\n") == "line 1: `linuxcnc` must be text in quotes, such as \"2.9\"");
  CHECK(error_of("fail-on = \"off\"\n") == "line 1: `fail-on` is one of info, warning, error");
  CHECK(error_of("exclude = \"old\"\n") == "line 1: `exclude` must be a list of patterns");
  CHECK(error_of("\nsub-path = [5]\n") == "line 2: `sub-path` must be a list of folders");
  // Of several mistakes the first one.
  CHECK(error_of("fail-on = 1\nini = 5\n[severity]\nOW999 = \"off\"\n") ==
        "line 1: `fail-on` is one of info, warning, error");
  CHECK(error_of("linuxcnc = \"2.6\"\n") == "line 1: `linuxcnc` must be one of 2.7, 2.8, 2.9, 2.10, all, not `2.6`");
  CHECK(error_of("[[overrides]]\nselect = [\"OW1\"]\n") == "line 1: an override needs `files`, a list of patterns");
  CHECK(error_of("overrides = 1\n") == "line 1: `overrides` must be a list of tables, written `[[overrides]]`");
  CHECK(error_of("select = [\n").starts_with("line 1: not TOML: "));
}

TEST_CASE("an INI that is named must be there", "[settings]") {
  const test::Scratch scratch;
  scratch.write("owlint.toml", "ini = \"none.ini\"\n");
  std::string error;
  settings(scratch, "p.ngc", {}, &error);
  CHECK(error.find("none.ini: No such file or directory") != std::string::npos);
}

TEST_CASE("folders are searched for programs", "[settings]") {
  const test::Scratch scratch;
  for (const char* name :
       {"b.ngc", "a.NC", "c.tap", "d.cnc", "e.gcode", "f.txt", "sub/g.ngc", ".hidden/h.ngc", "sub/.i.ngc", "j.ngc.bak"})
    scratch.write(name, "M2\n");
  std::filesystem::create_symlink(scratch.path(), scratch.path() + "/sub/loop");
  const checking::Walk found =
      checking::walk(disk(), {scratch.path(), scratch.path() + "/f.txt", scratch.path() + "/b.ngc", "-"}, {});
  std::vector<std::string> names;
  for (const auto& [path, stamp, bytes] : found.files)
    names.push_back(path == "-" ? path : path.substr(scratch.path().size() + 1));
  CHECK(names == std::vector<std::string>{"a.NC", "b.ngc", "c.tap", "d.cnc", "e.gcode", "sub/g.ngc", "f.txt", "-"});
  CHECK(found.problems.empty());
}
