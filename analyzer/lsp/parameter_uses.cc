#include "analyzer/lsp/parameter_uses.h"

#include <algorithm>
#include <charconv>

#include "analyzer/flow/domain/parameters.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/text/characters.h"
#include "analyzer/text/source.h"

namespace owlint::lsp {
namespace {

std::string without_blanks(std::string_view text) {
  std::string out;
  std::ranges::copy_if(text, std::back_inserter(out), [](char c) { return !is_blank(c); });
  return out;
}

/// `(debug, …)` and the like print the parameters that they name; `comment` begins behind the bracket.
bool prints(std::string_view comment) {
  comment = comment.substr(std::min(comment.find_first_not_of(" \t"), comment.size()));
  const std::string word = small_letters(comment.substr(0, comment.find(',')));
  return comment.size() > word.size() && (word == "debug" || word == "print" || word == "log" || word == "abort");
}

class Finder {
 public:
  explicit Finder(std::string_view line) : line_(line) {}

  std::vector<ParameterUse> run() {
    for (size_t at = 0; at < line_.size() && line_[at] != ';';) {
      switch (line_[at]) {
        case '(': at = comment(at); break;
        case '<': at = behind('>', at); break;  // of a label
        case '#': at = parameter(at); break;
        case '[':
          ++depth_;
          ++at;
          break;
        case ']':
          --depth_;
          ++at;
          break;
        default: ++at;
      }
    }
    return std::move(uses_);
  }

 private:
  size_t behind(char c, size_t from) const {
    const size_t at = line_.find(c, from);
    return at == std::string_view::npos ? line_.size() : at + 1;
  }

  size_t skip_blanks(size_t at) const {
    while (at < line_.size() && is_blank(line_[at])) ++at;
    return at;
  }

  /// `<depth>` with its bracket at `open`; nothing where it is not closed.
  std::string name(size_t open, size_t end) const {
    return line_[end - 1] == '>' ? small_letters(without_blanks(line_.substr(open, end - open))) : std::string();
  }

  size_t parameter(size_t hash) {
    const size_t at = skip_blanks(hash + 1);
    if (at < line_.size() && line_[at] == '<') {
      const size_t end = behind('>', at);
      std::string found = name(at, end);
      if (!found.empty()) uses_.push_back({hash, end, std::move(found), assigns(end), false});
      return end;
    }
    size_t end = at;
    while (end < line_.size() && (is_digit(line_[end]) || line_[end] == '.' || is_blank(line_[end]))) ++end;
    while (end > hash + 1 && is_blank(line_[end - 1])) --end;
    std::string number;
    double value = 0;
    const std::string digits = without_blanks(line_.substr(hash + 1, end - hash - 1));
    const auto [rest, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem == std::errc{} && rest == digits.data() + digits.size()) label_of_number(value, &number);
    uses_.push_back({hash, end, std::move(number), assigns(end), false});
    return end;
  }

  bool assigns(size_t end) const {
    const size_t next = skip_blanks(end);
    return depth_ == 0 && next < line_.size() && line_[next] == '=';
  }

  /// In comments blanks count, and nothing is computed (measured).
  size_t comment(size_t open) {
    const size_t close = behind(')', open);
    if (!prints(line_.substr(open + 1, close - open - 1))) return close;
    for (size_t at = line_.find('#', open); at < close; at = std::min(line_.find('#', at), close)) {
      size_t end = at + 1;
      if (end < close && line_[end] == '<') {
        end = std::min(behind('>', end), close);
        std::string found = name(at + 1, end);
        if (!found.empty()) uses_.push_back({at, end, std::move(found), false, true});
      } else {
        while (end < close && is_digit(line_[end])) ++end;
        constexpr size_t kDigits = 4;  // as many as the largest parameter has
        if (end > at + 1 && end - at - 1 <= kDigits)
          uses_.push_back(
              {at, end, std::to_string(std::stoi(std::string(line_.substr(at + 1, end - at - 1)))), false, true});
      }
      at = end;
    }
    return close;
  }

  std::string_view line_;
  int depth_ = 0;
  std::vector<ParameterUse> uses_;
};

}  // namespace

std::vector<ParameterUse> parameter_uses(std::string_view line) { return Finder(line).run(); }

bool is_shared(std::string_view name) {
  if (name.starts_with('<')) return flow::is_global_name(name.substr(1));
  int number = 0;
  const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), number);
  return problem != std::errc{} || number >= flow::kFirstGlobalNumber;
}

}  // namespace owlint::lsp
