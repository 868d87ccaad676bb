// Manual pages and shell completions, made from the same table of options as `--help`.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace owlint::cli {

/// Writes `man1/owlint*.1`, `bash/owlint`, `zsh/_owlint` and `fish/owlint.fish` into a folder. Returns false and a message on
/// failure.
bool generate(const CLI::App& app, const std::string& folder, std::string* error);

}  // namespace owlint::cli
