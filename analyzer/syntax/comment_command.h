// Comments that LinuxCNC carries out, as far as they begin like one: `(MSG, …)`, `(PRINT, …)`, `(py, …)`.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "analyzer/text/characters.h"

namespace owlint {

/// Comments for owlint begin with it, in small letters or capitals.
inline constexpr std::string_view kOwlint = "owlint";

/// A word that a comment begins with. Source: measured, see OW710.
struct CommentCommand {
  enum Form : uint8_t {
    kText,      ///< a text, as it is
    kShows,     ///< a text with parameters
    kFile,      ///< a name of a file
    kBare,      ///< nothing need follow
    kCapitals,  ///< the same, and only capitals are known
  };

  std::string_view word;  ///< in small letters
  Form form;
};

inline constexpr std::array kCommentCommands = std::to_array<CommentCommand>({
    {"msg", CommentCommand::kText},
    {"debug", CommentCommand::kShows},
    {"print", CommentCommand::kShows},
    {"log", CommentCommand::kShows},
    {"abort", CommentCommand::kShows},
    {"logopen", CommentCommand::kFile},
    {"logappend", CommentCommand::kFile},
    {"logclose", CommentCommand::kBare},
    {"py", CommentCommand::kBare},
    {"pyrun", CommentCommand::kFile},
    {"pyreload", CommentCommand::kBare},
    {"probeopen", CommentCommand::kCapitals},
    {"probeclose", CommentCommand::kCapitals},
});

/// That of a comment's text, in small letters or capitals; null for other comments.
constexpr const CommentCommand* comment_command(std::string_view text) {
  size_t from = 0;
  while (from < text.size() && is_space_or_tab(text[from])) ++from;
  size_t to = from;
  while (to < text.size() && is_letter(text[to])) ++to;
  const std::string_view word = text.substr(from, to - from);
  constexpr std::string_view kFirstLetters = "mdlap";  // most comments have another
  if (word.empty() || kFirstLetters.find(static_cast<char>(word[0] | 0x20)) == std::string_view::npos) return nullptr;
  const auto* command = std::ranges::find_if(kCommentCommands, [word](const CommentCommand& one) {
    return std::ranges::equal(word, one.word, [](char a, char b) { return (a | 0x20) == b; });
  });
  return command == kCommentCommands.end() ? nullptr : command;
}

/// Whether a line has a comment that begins like one.
inline bool has_command(std::string_view line) {
  for (size_t at = 0; (at = line.find('(', at)) != std::string_view::npos; ++at) {
    if (comment_command(line.substr(at + 1)) != nullptr) return true;
  }
  return false;
}

}  // namespace owlint
