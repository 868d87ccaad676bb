// What options take: checked in owlint's own words, shown in help, offered by completion.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace owlint::cli {

// --- to be given to an option's transform(): they change what is written otherwise ---

/// One of these words, in any case.
CLI::Validator one_of(std::vector<std::string> words);
/// A rule's code, its name, or the beginning of codes.
CLI::Validator rule_code();
/// CODE=LEVEL.
CLI::Validator code_level();

// --- to be given to an option's check() ---

/// A number that counts something, from 1.
CLI::Validator count();
/// A FEATURE mask.
CLI::Validator mask();

// --- what an option is ---

bool takes_value(const CLI::Option& option);
/// What its value is called: FILE, CODES.
std::string value_name(const CLI::Option& option);
/// The words that it takes; none where any text will do.
std::vector<std::string> words_of(const CLI::Option& option);
/// `-q`, `--quiet`.
std::vector<std::string> spellings(const CLI::Option& option);
/// Its description, with the words that it takes and the default.
std::string description_of(const CLI::Option& option);

// --- what a command is ---

/// Its options that people see, positional ones left out.
std::vector<const CLI::Option*> options_of(const CLI::App& command);
std::vector<const CLI::Option*> positionals_of(const CLI::App& command);

/// A command, or one of a command's own: `audit`, `audit list`.
struct Command {
  std::string path;
  const CLI::App* app;
};
using Commands = std::vector<Command>;

/// The commands of a command that people see.
Commands commands_of(const CLI::App& app, const std::string& path = {});
/// All of them, a command's own behind it.
Commands all_commands(const CLI::App& app);

}  // namespace owlint::cli
