#include "analyzer/machine/ngcgui_file.h"

#include <algorithm>

#include "analyzer/text/characters.h"

namespace owlint {
namespace {

using Kind = NgcguiProblem::Kind;

/// Without blanks and tabs, in small letters.
std::string packed(std::string_view line) {
  std::string out = small_letters(line);
  std::erase_if(out, [](char c) { return c == ' ' || c == '\t'; });
  return out;
}

/// `o<name>KEYWORD` at the beginning of a packed line.
bool has_keyword(std::string_view line, std::string_view keyword) {
  if (!line.starts_with("o<")) return false;
  for (size_t close = line.find('>', 2); close != std::string_view::npos; close = line.find('>', close + 1)) {
    if (line.substr(close + 1).starts_with(keyword)) return true;
  }
  return false;
}

bool is_numbered_sub(std::string_view line) {
  if (!line.starts_with('o')) return false;
  line.remove_prefix(1);
  while (!line.empty() && is_digit(line[0])) line.remove_prefix(1);
  return line.starts_with("sub");
}

bool is_comment(std::string_view line) {
  return line.starts_with(';') || (line.starts_with('(') && line.rfind(')') == line.size() - 1);
}

/// A word with blanks around it, as ngcgui looks for one in a comment.
bool has_feature(std::string_view line) {
  constexpr std::string_view kWord = " FEATURE ";
  return line.find(kWord) != std::string_view::npos;
}

class NgcguiReader {
 public:
  NgcguiReader(std::string_view name, std::string_view bytes) : name_(name), bytes_(bytes) {}

  std::optional<NgcguiProblem> run() {
    for (size_t at = 0; at < bytes_.size();) {
      const size_t end = std::min(bytes_.find('\n', at), bytes_.size());
      std::string_view line = bytes_.substr(at, end - at);
      if (line.ends_with('\r')) line.remove_suffix(1);
      span_ = {at, at + line.size()};
      at = end + 1;
      if (auto problem = look_at(line)) return problem;
    }
    span_ = {};
    if (!began_) return fail(Kind::kNoSub, "no 'sub' found in file");
    if (!ended_) return fail(Kind::kNoEnd, "no 'endsub' found in file");
    return std::nullopt;
  }

 private:
  std::optional<NgcguiProblem> fail(Kind kind, std::string message) const {
    return NgcguiProblem{kind, span_, std::move(message)};
  }

  std::optional<NgcguiProblem> look_at(std::string_view line) {
    const std::string code = packed(line);
    if (code.empty()) return std::nullopt;
    const bool comment = is_comment(code);
    if (comment && has_feature(line))
      return fail(Kind::kGenerated, "Disallowed use of ngcgui generated file as Subfile");
    if (comment && line == "(not_a_subfile)") return fail(Kind::kNotASubfile, "marked (not_a_subfile)");
    if (is_numbered_sub(code))
      return fail(Kind::kNumberedSub, "can not include subroutines within ngcgui subfile:" + std::string(line));
    if (has_keyword(code, "sub")) {
      if (ended_) return fail(Kind::kSeveralSubs, "Multiple subroutines in file not allowed");
      began_ = true;
      return label(line, "sub label");
    }
    if (comment) return std::nullopt;
    if (ended_ && !code.starts_with("m2")) return fail(Kind::kCodeBehind, "file contains lines after subend");
    if (!began_) return fail(Kind::kCodeBefore, "file contains lines before sub");
    if (ended_) return std::nullopt;
    if (!has_keyword(code, "endsub")) return argument(code);
    ended_ = true;
    return label(line, "endsub label");
  }

  /// `#<name>=#3`: arguments have their names in the order of their numbers.
  std::optional<NgcguiProblem> argument(std::string_view code) {
    constexpr std::string_view kIs = ">=#";
    constexpr size_t kMostDigits = 2;
    constexpr int kMostArguments = 30;
    const size_t is = code.find(kIs);
    if (!code.starts_with("#<") || is == std::string_view::npos) return std::nullopt;
    const std::string_view rest = code.substr(is + kIs.size());
    const std::string_view digits = rest.substr(0, rest.find('('));
    if (digits.empty() || digits.size() > kMostDigits || digits[0] == '0' || !std::ranges::all_of(digits, is_digit))
      return std::nullopt;
    int number = 0;
    for (const char c : digits) number = number * 10 + (c - '0');
    if (number > kMostArguments) return std::nullopt;
    if (number == arguments_ + 1) {
      arguments_ = number;
      return std::nullopt;
    }
    return fail(Kind::kOutOfSequence,
                "out of sequence positional parameter " + std::to_string(number) +
                    " expected: " + std::to_string(arguments_ + 1));
  }

  std::optional<NgcguiProblem> label(std::string_view line, std::string_view what) const {
    const size_t open = line.find('<'), close = line.find('>');
    const std::string_view written = open < close ? line.substr(open + 1, close - open - 1) : std::string_view();
    if (written == name_) return std::nullopt;
    return fail(Kind::kOtherName,
                std::string(what) + ": o<" + std::string(written) + "> does not match subroutine file name");
  }

  std::string_view name_, bytes_;
  Span span_;
  bool began_ = false, ended_ = false;
  int arguments_ = 0;  // that have a name
};

}  // namespace

std::optional<NgcguiProblem> ngcgui_problem(std::string_view name, std::string_view bytes) {
  return NgcguiReader(name, bytes).run();
}

}  // namespace owlint
