// OW408 feature-mask-ignored: the INI sets the FEATURE mask.
// Depends on: since 2.8 LinuxCNC reads a key for each bit, and not the mask (measured).
#include "rules/driver/stops.h"

namespace owlint::rules::ow408 {
namespace {

struct Bit {
  uint32_t mask;
  std::string_view key;
  bool on = false;  ///< by default
};
constexpr Bit kBits[] = {{0x01, "RETAIN_G43"},         {0x02, "OWORD_NARGS"},       {0x04, "INI_VARS", true},
                         {0x08, "HAL_PIN_VARS", true}, {0x10, "NO_DOWNCASE_OWORD"}, {0x20, "OWORD_WARNONLY"}};

void check(const Input&, Reporter&) {}

void check_setup(const SetupInput& in, Reporter& out) {
  const Ini::Entry* entry = in.setup.mask_entry;
  if (entry == nullptr || !in.setup.mask || *in.setup.mask == 0) return;
  if (in.profile.version_given && in.profile.version < Version::k2_8) return;
  std::string keys;
  for (const Bit& bit : kBits) {
    if ((*in.setup.mask & bit.mask) != 0 && !bit.on)
      keys += (keys.empty() ? "`" : ", `") + std::string(bit.key) + " = 1`";
  }
  Finding& f = out.add(entry->source, entry->span, "LinuxCNC ignores the mask `" + entry->key + "` since version 2.8");
  constexpr uint32_t kAllBits = 0x3F;
  f.help = !keys.empty()                 ? "write " + keys + " instead, in `[RS274NGC]`"
      : (*in.setup.mask & kAllBits) == 0 ? "remove the line: none of its bits means anything"
                                         : "remove the line: all that it turns on is on by default";
  // Joints have sections of their own since 2.8: with `[AXIS_0]` the machine may still run 2.7, which reads the mask. An INI of
  // those times has no `VERSION` or one of its own, and what LinuxCNC then offers, `update_ini`, replaces the mask.
  const Ini::Entry* version = in.setup.ini.find("EMC", "VERSION");
  const bool of_2_7 = in.setup.ini.has_section("AXIS_0") || version == nullptr || !version->value.starts_with("1.");
  const bool old = of_2_7 && !in.profile.version_given;
  if (keys.empty() || old) f.weight = Weight::kAside;
}

}  // namespace

extern const Rule kRule{
    .code = "OW408",
    .name = "feature-mask-ignored",
    .summary = "the INI sets the FEATURE mask, which LinuxCNC ignores since 2.8",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(`FEATURE` or `FEATURES` in the `[RS274NGC]` section of the INI, with a mask that is not 0.)",
            .why =
                R"(Up to LinuxCNC 2.7 each bit of the mask turned a feature on. Since 2.8 each feature has a key of its
own, and LinuxCNC ignores the mask: with `FEATURES = 0x20` the O-word errors still stop the program.
If you gave no version, owlint applies the mask as documented, and reports this.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[EMC]
VERSION = 1.1
[RS274NGC]
FEATURES = 0x2
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[EMC]
VERSION = 1.1
[RS274NGC]
OWORD_NARGS = 1
)",
            .fix =
                R"(Write the keys that replaced the bits, and remove the mask. `INI_VARS` and `HAL_PIN_VARS` are on by
default; a mask of only these two is an info. So is a mask in an INI of LinuxCNC 2.7, which has
`[AXIS_0]` for the first joint, or no `VERSION = 1.…` in `[EMC]`: 2.8 offers to convert such an INI.)",
            .level_reason = "Warning: LinuxCNC starts and runs, without the features in the mask.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = check,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow408
