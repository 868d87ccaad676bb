// What a machine says of tools and spindles, as the words of its programs need it.
#include "analyzer/program/machine_words.h"

#include <catch2/catch.hpp>

#include "analyzer/text/memory_files.h"

using namespace owlint;

namespace {

/// The machine of an INI in `/m`, with its tool tables.
class Machine {
 public:
  explicit Machine(const std::string& ini, const std::string& table = "T1 P1 D6 Z40\nT2 P2 D-1 Q3\n",
                   const std::string& path = "/m/tool.tbl") {
    files_.add_file("/m/machine.ini", ini);
    files_.add_file(path, table);
    std::string error;
    profile.setup = read_setup(files_, "/m/machine.ini", &error);
    REQUIRE(profile.setup != nullptr);
  }

  Profile profile;

 private:
  MemoryFiles files_;
};

std::string key_of(const Machine& machine) { return WordsOfMachine(machine.profile).key(); }

}  // namespace

TEST_CASE("the tools of a machine are those of its table", "[machine]") {
  const Machine machine("[EMCIO]\nTOOL_TABLE = tools/mill.tbl\n", "; mill\nT1 P1 D6 Z40\nT2 P2 D-1 Q3\n",
                        "/m/tools/mill.tbl");
  const WordsOfMachine words(machine.profile);
  REQUIRE(words.words.tools.has_value());
  const std::span<const Tool> tools = *words.words.tools;
  REQUIRE(tools.size() == 2);
  CHECK(tools[0].number == 1);
  CHECK(tools[0].diameter == 6);
  CHECK(tools[0].orientation == 0);
  CHECK(tools[0].has_offset);
  CHECK(tools[1].diameter == -1);
  CHECK(tools[1].orientation == 3);
  CHECK_FALSE(tools[1].has_offset);
  CHECK(machine.profile.setup->tools_source->path() == "/m/tools/mill.tbl");
  CHECK(machine.profile.setup->tools->find(2)->line == 3);
}

TEST_CASE("without a tool table nothing is known of tools", "[machine]") {
  CHECK(WordsOfMachine(Machine("").profile).words.tools.has_value());  // tool.tbl
  CHECK(WordsOfMachine(Machine("[EMCIO]\nTOOL_TABLE = /m/tool.tbl\n").profile).words.tools.has_value());
  for (const char* line :
       {"TOOL_TABLE = other.tbl", "TOOL_TABLE = tool.tbl # mill", "TOOL_TABLE = .", "DB_PROGRAM = ./tools",
        "TOOL_TABLE = tool.tbl\nDB_PROGRAM = ./tools", "TOOL_TABLE = ~/tool.tbl"}) {
    INFO(line);
    CHECK_FALSE(WordsOfMachine(Machine(std::string("[EMCIO]\n") + line + "\n").profile).words.tools.has_value());
  }
  CHECK_FALSE(WordsOfMachine(Profile{}).words.tools.has_value());
}

TEST_CASE("a random changer is 1, and any other integer but 0", "[machine]") {
  const auto tools = [](const std::string& value) {
    return Machine("[EMCIO]\nRANDOM_TOOLCHANGER = " + value + "\n", "T1 P1\nT2 P1\n").profile.setup->tools->rows.size();
  };
  for (const char* on : {"1", "+1", "2", "-1", "01"}) CHECK(tools(on) == 1);
  for (const char* off : {"0", "YES", "1.0", "1 # c", "+-1"}) CHECK(tools(off) == 2);
}

TEST_CASE("a machine says how many spindles it has, and whether M6 stops them", "[machine]") {
  const auto spindles = [](const std::string& value) {
    return WordsOfMachine(Machine("[TRAJ]\nSPINDLES = " + value + "\n").profile).words.spindles;
  };
  CHECK(spindles("3") == 3);
  CHECK(spindles("+2") == 2);
  CHECK(spindles("0") == 0);
  for (const char* wrong : {"", "two", "2.0", "2 # c", "0x2", "99999999999"}) CHECK(spindles(wrong) == 1);

  const auto keeps = [](const std::string& value) {
    return WordsOfMachine(Machine("[EMCIO]\nTOOL_CHANGE_WITH_SPINDLE_ON = " + value + "\n").profile)
        .words.change_keeps_spindle;
  };
  CHECK(keeps("1"));
  CHECK(keeps("2"));
  CHECK_FALSE(keeps("0"));
  CHECK_FALSE(keeps("YES"));
  const WordsOfMachine none{Profile{}};
  CHECK(none.words.spindles == 1);
  CHECK_FALSE(none.words.change_keeps_spindle);
}

TEST_CASE("machines whose lines may run otherwise have other keys", "[machine]") {
  const Machine machine("");
  CHECK(key_of(machine) == key_of(Machine("")));
  CHECK(key_of(machine) == key_of(Machine("", "T1 P7 Z40 D6 ;mill\n\nT2 P2 D-1 Q3\n")));
  CHECK(key_of(machine) != key_of(Machine("", "T1 P7 Z41 D6\nT2 P2 D-1 Q3\n")));
  CHECK(key_of(machine) != key_of(Machine("[EMCIO]\nDB_PROGRAM = x\n")));
  CHECK(key_of(machine) != key_of(Machine("[TRAJ]\nSPINDLES = 2\n")));
  CHECK(key_of(machine) != key_of(Machine("[EMCIO]\nTOOL_CHANGE_WITH_SPINDLE_ON = 1\n")));
  for (const char* table : {"", "T1 P1 D6 Z40\n", "T1 P1 D6 Z40\nT3 P2 D-1 Q3\n", "T1 P1 D6\nT2 P2 D-1 Q3\n",
                            "T1 P1 D6 Z40\nT2 P2 D-1 Q4\n", "T1 P1 D6 Z40\nT2 P2 D-2 Q3\n"}) {
    INFO(table);
    CHECK(key_of(machine) != key_of(Machine("", table)));
  }
  CHECK(key_of(Machine("", "")) != key_of(Machine("[EMCIO]\nDB_PROGRAM = x\n")));
}

TEST_CASE("an axis has the limits of its section", "[machine]") {
  const Machine machine("[AXIS_X]\nMIN_LIMIT = -10\nMAX_LIMIT = +400.5\n[AXIS_Z]\nMAX_LIMIT = 0\n");
  const MachineWords& words = WordsOfMachine(machine.profile).words;
  CHECK(words.has_limits);
  CHECK(words.limits[0] == AxisLimits{-10, 400.5});
  CHECK(words.limits[1] == AxisLimits{});
  CHECK(words.limits[2] == AxisLimits{AxisLimits{}.least, 0});
  CHECK(limit_entry(machine.profile.setup->ini, 2, true)->section == "AXIS_Z");
  CHECK(limit_entry(machine.profile.setup->ini, 2, false) == nullptr);
}

TEST_CASE("a value that is no number, or limits that are exchanged, limit nothing", "[machine]") {
  for (const char* limit : {"MAX_LIMIT = 100 # mm", "MAX_LIMIT = 7mm", "MAX_LIMIT = -5\nMIN_LIMIT = 5"}) {
    INFO(limit);
    CHECK_FALSE(WordsOfMachine(Machine(std::string("[AXIS_X]\n") + limit + "\n").profile).words.has_limits);
  }
}

TEST_CASE("where joints are axes, the limit of a joint is that of its axis", "[machine]") {
  const char* const joint = "[JOINT_1]\nMAX_LIMIT = 80\n";
  const auto limit_of = [&](const std::string& kinematics, size_t axis) {
    const Machine machine("[TRAJ]\nCOORDINATES = X Y Z\n[KINS]\nKINEMATICS = " + kinematics + "\n" + joint);
    return WordsOfMachine(machine.profile).words.limits[axis].greatest;
  };
  CHECK(limit_of("trivkins coordinates=XYZ", 1) == 80);
  CHECK(limit_of("trivkins", 1) == 80);
  CHECK(limit_of("trivkins coordinates=XZ", 2) == 80);
  CHECK(limit_of("5axiskins", 1) == AxisLimits{}.greatest);
}

TEST_CASE("limits of rotary axes are degrees, or unknown", "[machine]") {
  const auto limited = [](const std::string& units) {
    const Machine machine("[TRAJ]\nCOORDINATES = X Y Z A\n" + units + "[AXIS_A]\nMAX_LIMIT = 90\n");
    return WordsOfMachine(machine.profile).words.has_limits;
  };
  CHECK(limited("ANGULAR_UNITS = degree\n"));
  CHECK_FALSE(limited("ANGULAR_UNITS = rad\n"));
  CHECK_FALSE(limited(""));
}

TEST_CASE("a REMAP of a code that LinuxCNC cannot remap takes its meaning away", "[machine][remap]") {
  const auto lost = [](const char* line, Release release = Release::k2_8) { return lost_code(line, release); };
  REQUIRE(lost("M5 modalgroup=6 ngc=fa"));
  CHECK(lost("M5 modalgroup=6 ngc=fa")->group == MGroup::kToolChange);
  CHECK(lost("M1200 ngc=fa")->number == 1200);
  CHECK(lost("M1200 ngc=fa")->group == MGroup::kUser);
  CHECK(lost("G17 modalgroup=1 ngc=fa")->number == 170);
  CHECK(lost("M7 modalgroup=6 ngc=fa"));
  CHECK_FALSE(lost("M7 modalgroup=6 ngc=fa", Release::k2_10));
  for (const char* kept :
       {"M5 modalgroup=7 ngc=fa", "M400 modalgroup=6 ngc=fa", "M6 modalgroup=6 ngc=fa", "M98 modalgroup=6 ngc=fa",
        "M99 ngc=fa", "G1 ngc=fa", "G88.1 ngc=fa", "T ngc=fa", "M5 modalgroup=3 ngc=fa", "M5"}) {
    INFO(kept);
    CHECK_FALSE(lost(kept));
  }
}
