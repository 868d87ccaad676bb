// What is wrong with a command line, in owlint's own words.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace owlint::cli {

/// The message for what CLI11 found.
std::string usage_problem(const CLI::App& app, const CLI::ParseError& problem);

/// The message for a first argument that is neither a command nor a path, and looks like a command; else empty.
std::string misspelt_command(const CLI::App& app, const std::string& argument);

}  // namespace owlint::cli
