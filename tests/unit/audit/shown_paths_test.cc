// How the page of an audit names files.
#include <catch2/catch.hpp>

#include "analyzer/audit/shown_paths.h"

using owlint::audit::ShownPaths;
using Strings = std::vector<std::string>;

TEST_CASE("the page of an audit names files from the audited folders", "[audit]") {
  const ShownPaths one({"/srv/nc/"});
  CHECK(one.roots() == Strings{"nc"});
  CHECK(one.path("/srv/nc/mill/plate.ngc") == "mill/plate.ngc");
  CHECK(one.path("/srv/nc/./mill/../plate.ngc") == "plate.ngc");
  CHECK(one.path("/srv/ncfiles/plate.ngc") == "…/ncfiles/plate.ngc");
  CHECK(one.path("/srv/machine.ini") == "…/srv/machine.ini");
  CHECK(one.path("/machine.ini") == "…/machine.ini");

  const ShownPaths several({"/srv/a/nc", "/srv/b/nc", "/srv/lib", "/srv/a/nc/inside", "/home/x/part.ngc", "/srv/lib"});
  CHECK(several.roots() == Strings{"a/nc", "b/nc", "lib", "inside", "part.ngc"});
  CHECK(several.path("/srv/a/nc/p.ngc") == "a/nc/p.ngc");
  CHECK(several.path("/srv/a/nc/inside/p.ngc") == "a/nc/inside/p.ngc");
  CHECK(several.path("/srv/lib/sub/s.ngc") == "lib/sub/s.ngc");
  CHECK(several.path("/home/x/part.ngc") == "part.ngc");
  CHECK(several.path("/home/x/other.ngc") == "…/x/other.ngc");

  const ShownPaths all({"/"});
  CHECK(all.path("/srv/nc/plate.ngc") == "srv/nc/plate.ngc");
}

TEST_CASE("the page of an audit has no absolute paths in its messages", "[audit]") {
  ShownPaths paths({"/srv/my nc", "/opt/lib"});
  paths.know("/srv/old subs/s.ngc");
  paths.know("/srv/machine.ini");  // above a root, which is named by itself
  const auto check = [&](const std::string& words, const std::string& shown) {
    INFO(words);
    CHECK(paths.text(words) == shown);
  };
  check("EOF in file:/srv/my nc/mill/a b.ngc seeking o-word: o<x>",
        "EOF in file:my nc/mill/a b.ngc seeking o-word: o<x>");
  check("the folder `../x` of `PROGRAM_PREFIX` does not exist (/opt/lib/x)",
        "the folder `../x` of `PROGRAM_PREFIX` does not exist (lib/x)");
  check("no file in /srv/my nc, or /opt/lib:/home/joe/linuxcnc/subs", "no file in my nc, or lib:…/linuxcnc/subs");
  check("`/home/joe smith/nc files/subs/` is missing", "`…/nc files/subs` is missing");
  check("called in /srv/old subs/s.ngc and /srv/machine.ini", "called in …/old subs/s.ngc and …/srv/machine.ini");
  // What is no path, or a path that says nothing of the machine, stays.
  for (const char* words : {"`/ M30` and `/M30` are left out", "G0 X[#1/#2/3] Y[1 /2/3]", "write `a/b/c.ngc` or ~/x/y",
                            "see http://linuxcnc.org/docs/html", "a / b", "/", ""})
    check(words, words);
}
