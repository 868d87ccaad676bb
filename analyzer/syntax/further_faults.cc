#include "analyzer/syntax/further_faults.h"

#include <algorithm>

#include "analyzer/syntax/word_line.h"
#include "analyzer/syntax/word_reader.h"

namespace owlint {
namespace {

/// Whether the words behind such a mistake can be read as if it were not there.
bool goes_on_behind(StopKind kind) {
  switch (kind) {
    case StopKind::kWordUnknown:
    case StopKind::kNumberMissing:
    case StopKind::kNumberMalformed:
    case StopKind::kNumberOutOfRange:
    case StopKind::kWordRepeated:
    case StopKind::kCodeUnknown:
    case StopKind::kCodesConflict: return true;
    default: return false;
  }
}

/// Whether a run leaves the line at this code: what is behind it need not be meant to run.
bool leaves_line(const WrittenWord& word) {
  constexpr double kLeaving[] = {2, 30, 98, 99};
  return word.letter == 'm' && word.value && std::ranges::find(kLeaving, *word.value) != std::end(kLeaving);
}

/// One line, read a second time from its beginning.
class Rereading {
 public:
  Rereading(const MachineWords& machine, bool codes_known) : codes_known_(codes_known), words_(machine) {}

  std::vector<LineError> run(WordReader reader, uint64_t first) {
    begin_ = reader.line_begin();
    while (const std::optional<WrittenWord> word = reader.next()) {
      if (leaves_line(*word)) break;
      if (reader.fault() != StopKind::kNone) {
        without_number(*word, reader);
      } else {
        with_value(*word);
      }
    }
    // Two letters without numbers are text, and so is what cannot be read on.
    constexpr int kOfText = 2;
    const auto here = std::ranges::find(faults_, first, [](const LineError& e) { return e.span.begin; });
    if (reader.lost() || lone_letters_ >= kOfText || here == faults_.end()) return {};
    faults_.erase(faults_.begin(), here + 1);
    return std::move(faults_);
  }

 private:
  void without_number(const WrittenWord& word, const WordReader& reader) {
    if (reader.fault() == StopKind::kNumberMissing) ++lone_letters_;
    if (word.letter == 'g' || word.letter == 'm') code_unknown_ = true;
    report({reader.fault(), reader.message(), kNoWord, kNoWord, true}, word);
  }

  void with_value(const WrittenWord& word) {
    const bool code = word.letter == 'g' || word.letter == 'm';
    // Of words that an unknown code may use it is not known what they may be.
    if (code_unknown_ && !code) return;
    const std::optional<Fault> letter = words_.letter(word.letter);
    if (letter && letter->kind == StopKind::kWordUnknown) {
      const uint32_t bit = letter_set({&word.letter, 1});
      if (letter->certain && (unknown_letters_ & bit) == 0) report(*letter, word);
      unknown_letters_ |= bit;
      return;
    }
    if (letter && letter->certain) {
      report(*letter, word);
      return begin_again(word);
    }
    if (const char* refused = word.value ? refused_number(word.letter, *word.value) : nullptr) {
      code_unknown_ = code_unknown_ || code;
      return report({StopKind::kNumberOutOfRange, refused, kNoWord, kNoWord, true}, word);
    }
    const WordLine before = words_;
    const std::optional<Fault> fault = add(word);
    if (!fault) return;
    if (fault->kind == StopKind::kCodeUnknown) {
      words_ = before;
      code_unknown_ = true;
      if (fault->certain || (codes_known_ && fault->message.starts_with("Unknown"))) report(*fault, word);
    } else {
      report(*fault, word);
      begin_again(word);
    }
  }

  std::optional<Fault> add(const WrittenWord& word) {
    return words_.add({word.letter, word.value.has_value(), word.value.value_or(0),
                       static_cast<uint8_t>(word.span.begin - begin_), static_cast<uint8_t>(word.span.end - begin_)});
  }

  /// Two words that exclude each other: perhaps a line feed is missing. What is wrong behind it is wrong on a line that
  /// begins here.
  void begin_again(const WrittenWord& word) {
    words_.clear();
    add(word);
  }

  void report(const Fault& fault, const WrittenWord& word) {
    Span other;
    if (fault.other != kNoWord) other = {begin_ + words_[fault.other].from, begin_ + words_[fault.other].to};
    faults_.push_back({fault.kind, word.span, fault.message, other, kNoExpr, 0, 0});
  }

  bool codes_known_;
  WordLine words_;  // since the last mistake that a line feed would cure
  uint64_t begin_ = 0;
  std::vector<LineError> faults_;
  bool code_unknown_ = false;
  uint32_t unknown_letters_ = 0;  // of axes that the machine lacks
  int lone_letters_ = 0;
};

}  // namespace

std::vector<LineError> further_faults(std::string_view raw, uint64_t offset, const LineError& first,
                                      const MachineWords& machine, bool codes_known) {
  if (!goes_on_behind(first.kind)) return {};
  return Rereading(machine, codes_known).run(WordReader(raw, offset), first.span.begin);
}

}  // namespace owlint
