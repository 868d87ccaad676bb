// `--help`: what a command does, its options in groups, as wide as the terminal.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace owlint::cli {

class Help : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace owlint::cli
