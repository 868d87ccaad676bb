// What a command line says, besides what is to be checked: how the result is shown, and what is done with it.
#pragma once

#include <string>

#include "analyzer/checking/settings.h"

namespace owlint::cli {

using namespace checking;

struct CommandLine : CheckRequest {
  std::string format = "text";
  std::string output;
  std::string color = "auto";
  std::string stdin_filename = "<stdin>";
  bool statistics = false;
  bool quiet = false;
  bool fix = false, unsafe = false, diff = false, fix_only = false;
  std::string baseline, since, reason;  ///< empty if not given
  bool update_baseline = false, add_suppressions = false;
};

}  // namespace owlint::cli
