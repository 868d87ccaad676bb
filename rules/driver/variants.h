// One program under all settings that count: LinuxCNC's versions, and block delete on and off. Used by lint.cc only.
#pragma once

#include <tuple>

#include "rules/driver/lint.h"

namespace owlint {

/// A finding is the same as another one if both are of one rule and at one place.
using FindingPlace = std::tuple<uint64_t, uint64_t, std::string_view>;
inline FindingPlace place_of(const Finding& f) { return {f.span.begin, f.span.end, f.code}; }

/// Orders findings by place, and drops those that are turned off.
void put_in_order(std::vector<Finding>& findings);

/// Puts together what each of kAllVersions says of one file: a finding is reported once, with the versions in which it is worst.
std::vector<Finding> join_versions(const Source&, std::vector<std::vector<Finding>> by_version);

/// Checks a program under the profile's version and its setting of block delete.
ProgramReport lint_one_way(const std::shared_ptr<const Program>& program, const Profile& profile,
                           const LintOptions& options, Library& library);

/// Checks a program under every version that is asked for. A program with lines that begin with `/` is checked with block
/// delete off, as `rs274` runs it, and on, as LinuxCNC starts (measured).
ProgramReport lint_all_ways(const std::shared_ptr<const Program>& program, const Profile& profile,
                            const LintOptions& options, Library& library);

}  // namespace owlint
