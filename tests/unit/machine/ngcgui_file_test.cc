// What ngcgui refuses in a file of a sub.
#include <catch2/catch.hpp>

#include "analyzer/machine/ngcgui_file.h"

using namespace owlint;

namespace {

std::string refused(std::string_view bytes) {
  const auto problem = ngcgui_problem("hole", bytes);
  return problem ? problem->message : "";
}

TEST_CASE("ngcgui takes one sub with its file's name, and comments around it") {
  CHECK(
      refused(
          "(info: a hole)\n\no<hole> sub\n #<x> = #1 (=5 where)\n #<y> = #2\n G0 X#<x>\no<hole> endsub\n; end\nM2\n") ==
      "");
  CHECK(refused("O < hole > SUB\nO<hole>ENDSUB") == "sub label: o< hole > does not match subroutine file name");
  CHECK(refused("o<hole>sub\r\no<hole>endsub\r\n") == "");
}

TEST_CASE("ngcgui refuses other subs, and lines outside of the sub") {
  CHECK(refused("") == "no 'sub' found in file");
  CHECK(refused("o<hole> sub\nG0 X1\n") == "no 'endsub' found in file");
  CHECK(refused("G21\no<hole> sub\n") == "file contains lines before sub");
  CHECK(refused("o<hole> sub\no<hole> endsub\nG0 X1") == "file contains lines after subend");
  CHECK(refused("o<hole> sub\no<hole> endsub\no<b> sub\n") == "Multiple subroutines in file not allowed");
  CHECK(refused("o<Hole> sub\n") == "sub label: o<Hole> does not match subroutine file name");
  CHECK(refused("o<hole> sub\no<b> endsub") == "endsub label: o<b> does not match subroutine file name");
  CHECK(refused("o100 sub") == "can not include subroutines within ngcgui subfile:o100 sub");
  CHECK(refused("(not_a_subfile)\no<hole> sub") == "marked (not_a_subfile)");
  CHECK(refused("(ngcgui: FEATURE x)\n") == "Disallowed use of ngcgui generated file as Subfile");
}

TEST_CASE("ngcgui wants the names of arguments in order") {
  CHECK(refused("o<hole> sub\n#<y> = #2\n") == "out of sequence positional parameter 2 expected: 1");
  CHECK(refused("o<hole> sub\n#<y> = #31\n#<z> = #100\n#<w> = [#2]\no<hole> endsub") == "");
}

}  // namespace
