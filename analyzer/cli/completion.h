// Completion for bash, zsh and fish: commands, options, the words, codes and files that options take.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace owlint::cli {

/// The scripts, made from the declared options.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

}  // namespace owlint::cli
