// Depends on (measured): the word comes first in the comment and the comma right after it; of several comments on a line only
// the last one acts, on the line of an O-word none does; `(msg, …)` shows `#5` as it is; a name without a value is
// shown as `######`.
#include "analyzer/flow/facts/shown.h"
#include "analyzer/syntax/last_statement.h"
#include "analyzer/text/characters.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace owlint::flow {
namespace {

char small(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// The short word before the first comma, in small letters.
std::string word_of(std::string_view comment) {
  constexpr size_t kMost = 32;  // bytes, with blanks before it
  std::string word;
  const size_t comma = comment.substr(0, kMost).find(',');
  if (comma == std::string_view::npos) return word;
  for (const char c : comment.substr(0, comma)) {
    if (!word.empty() || (c != ' ' && c != '\t')) word += small(c);
  }
  return word;
}

class Finder {
 public:
  explicit Finder(const Program& program) : program_(program), text_(program.source->bytes()) {}

  std::vector<Shown> run() {
    for (const uint64_t begin : program_.syntax.command_lines)
      line(begin, std::min(text_.find('\n', begin), text_.size()));
    return std::move(shown_);
  }

 private:
  void line(size_t begin, size_t end) {
    size_t last = 0;  // of the parameters, the first one of the last comment
    bool any = false;
    for (size_t at = begin; at < end && text_[at] != ';'; ++at) {
      if (text_[at] != '(') continue;
      const size_t close = std::min(text_.find(')', at), end);
      last = shown_.size();
      any = comment(at + 1, close) || any;
      at = close;
    }
    if (!any) return;
    const auto& statements = program_.syntax.statements;
    const StatementId above = last_statement(program_.syntax, end);
    const bool on_line = above != kNoStatement && statements[above].offset >= begin;
    const bool on_oword = on_line && statements[above].kind == LineKind::kOWord;
    RegionId region = above == kNoStatement ? kMainRegion : program_.region_of[above];
    if (!on_line && program_.regions[region].end == above) region = kMainRegion;
    for (size_t i = added_; i < shown_.size(); ++i) {
      shown_[i].above = above;
      shown_[i].region = region;
      shown_[i].acts = shown_[i].acts && i >= last && !on_oword;
    }
    added_ = shown_.size();
  }

  /// Whether the comment from `at` to `close` shows parameters.
  bool comment(size_t at, size_t close) {
    static constexpr std::array kWords{"debug", "print", "log", "abort", "msg"};
    const std::string word = word_of(text_.substr(at, close - at));
    if (std::ranges::find(kWords, word) == kWords.end()) return false;
    const size_t before = shown_.size();
    for (at = std::min(text_.find('#', at), close); at < close; at = std::min(text_.find('#', at + 1), close))
      parameter(at, close, word != "msg");
    return shown_.size() > before;
  }

  void parameter(size_t at, size_t close, bool acts) {
    size_t end = at + 1;
    ParameterKey key = kComputedKey;
    std::string name;
    if (end < close && text_[end] == '<') {
      const size_t angle = text_.find('>', end);
      if (angle >= close) return;
      for (++end; end < angle; ++end) {
        if (text_[end] != ' ' && text_[end] != '\t') name += small(text_[end]);
      }
      ++end;
      if (const NameId id = program_.syntax.names.find(name); id != kNoName) key = key_of_name(program_.syntax, id);
      if (name.starts_with('_')) name.clear();
    } else {
      constexpr size_t kMostDigits = 4;
      uint64_t number = 0;
      for (; end < close && end <= at + kMostDigits && is_digit(text_[end]); ++end)
        number = number * 10 + static_cast<uint64_t>(text_[end] - '0');
      if (end == at + 1) return;
      key = number | (number >= kFirstGlobalNumber ? kGlobalKey : 0);
    }
    shown_.push_back({{at, end}, std::move(name), key, kNoStatement, kMainRegion, acts});
  }

  const Program& program_;
  std::string_view text_;
  std::vector<Shown> shown_;
  size_t added_ = 0;  // of `shown_`: those whose place is known
};

}  // namespace

std::vector<Shown> shown_in_comments(const Program& program) { return Finder(program).run(); }

std::vector<ShownRead> reads_of(const Program& program, const std::vector<Shown>& shown) {
  std::vector<ShownRead> reads;
  std::vector<StatementId> next(program.regions.size(), kNoStatement);  // by region, below the comment
  auto id = static_cast<StatementId>(program.size());
  for (auto s = shown.rbegin(); s != shown.rend(); ++s) {
    for (; id > 0 && (s->above == kNoStatement || id - 1 > s->above); --id) next[program.region_of[id - 1]] = id - 1;
    StatementId reader = next[s->region];
    // No way leads from the end of a branch to the line that begins the next one.
    const bool branch_ends =
        reader != kNoStatement && (program.at(reader).is(Keyword::kElse) || program.at(reader).is(Keyword::kElseif));
    if ((reader == kNoStatement || branch_ends) && s->above != kNoStatement && program.region_of[s->above] == s->region)
      reader = s->above;
    if (reader != kNoStatement && s->key != kComputedKey) reads.push_back({reader, s->key});
  }
  std::ranges::sort(reads, {}, &ShownRead::statement);
  return reads;
}

}  // namespace owlint::flow
