// Any bytes are lines of words: what the parser finds is on its line, and a line that the fast path of the scanner passes runs
// with every motion that may be in effect. The first byte chooses the release, and whether the machine is known.
#include <bit>
#include <cstdlib>

#include "analyzer/syntax/bulk.h"
#include "analyzer/syntax/further_faults.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/word_reader.h"

using namespace owlint;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

/// A line, and the motions that may be in effect before it, as the parser sees it.
class Line {
 public:
  Line(std::string_view text, uint64_t offset, const MachineWords& machine)
      : text_(text), offset_(offset), machine_(machine), parser_(syntax_, machine) {
    kept_ = parser_.parse(text, offset, &statement_);
    if (parser_.words() != nullptr) look_at(*parser_.words());
    if (parser_.words_of_call() != nullptr) look_at(*parser_.words_of_call());
    if (parser_.words() != nullptr && !statement_.has_error()) read_again(*parser_.words());
    require(parser_.unsure() == kNoError || parser_.unsure() < syntax_.errors.size());
    for (const LineError& error : syntax_.errors) look_at(error);
    if (!statement_.has_error()) return;
    require(kept_ && statement_.error < syntax_.errors.size());
    const LineError& first = *syntax_.error(statement_);
    uint64_t last = first.span.begin;
    for (const LineError& error : further_faults(text_, offset_, first, machine_, true)) {
      look_at(error);
      require(error.span.begin > last);
      last = error.span.begin;
    }
  }

  /// Whether no run can be said to go on behind it. `*modes`: of the runs that get here, and behind it of those that go on.
  bool stops(MotionSet* modes) const {
    const WordLine* words = parser_.words();
    if (words == nullptr || statement_.has_error() || statement_.block_delete || words->has_unknown_code()) {
      *modes = all_modes();
      return statement_.has_error() && !statement_.block_delete;
    }
    *modes = passing(*words, *modes);
    *modes = words->after(*modes) & all_modes();
    return *modes == 0;
  }

  /// The fast path has passed the line.
  void must_run(MotionSet modes, Motion motion) const {
    require(!statement_.has_error() && parser_.unsure() == kNoError && parser_.words() != nullptr);
    require(passing(*parser_.words(), modes) == modes);
    const GCode* const code = parser_.words()->code(GGroup::kMotion);
    require(motion == (code == nullptr ? Motion::kNone : code->motion));
  }

 private:
  void inside(Span span) const {
    require(span.begin <= span.end && (span.end == 0 || (span.begin >= offset_ && span.end <= offset_ + text_.size())));
  }

  void look_at(const LineError& error) const {
    inside(error.span);
    inside(error.other);
    require(!error.message.empty());
    require(error.read_from <= error.read_to && error.read_to <= syntax_.exprs.size());
  }

  void look_at(const WordLine& words) const {
    uint8_t last = 0;
    for (size_t i = 0; i < words.size(); ++i) {
      const Word& word = words[i];
      require(word_row(word.letter) != nullptr);
      require(last <= word.from && word.from < word.to && word.to <= text_.size());
      last = word.to;
    }
    for (MotionSet rest = all_modes(); rest != 0; rest &= rest - 1) {
      const auto fault = fault_with(words, static_cast<Motion>(std::countr_zero(rest)));
      if (!fault) continue;
      require(!fault->message.empty());
      require(fault->word == kNoWord || fault->word < words.size());
      require(fault->other == kNoWord || fault->other < words.size());
    }
  }

  /// Who reads the line a second time finds the same words.
  void read_again(const WordLine& words) const {
    WordReader reader(text_, offset_);
    for (size_t i = 0; i < words.size(); ++i) {
      const std::optional<WrittenWord> word = reader.next();
      require(word && reader.fault() == StopKind::kNone && word->letter == words[i].letter);
      require(word->span == Span{offset_ + words[i].from, offset_ + words[i].to});
      require(word->value.has_value() == words[i].known && (!words[i].known || *word->value == words[i].value));
    }
    require(!reader.next() && !reader.lost());
  }

  static std::optional<Fault> fault_with(const WordLine& words, Motion motion) {
    return words.check({.motion = motion, .distance = Modes::kDistanceUnknown, .plane = Modes::kPlaneUnknown});
  }

  static MotionSet passing(const WordLine& words, MotionSet modes) {
    MotionSet passing = 0;
    for (MotionSet rest = modes; rest != 0; rest &= rest - 1) {
      const auto motion = static_cast<Motion>(std::countr_zero(rest));
      const auto fault = fault_with(words, motion);
      if (!fault || !fault->certain) passing |= set_of(motion);
    }
    return passing;
  }

  std::string_view text_;
  uint64_t offset_;
  const MachineWords& machine_;
  Syntax syntax_;
  LineParser parser_;
  Statement statement_;
  bool kept_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  MachineWords machine;
  machine.release = static_cast<Release>(data[0] & 3);
  machine.unsure = (data[0] & 4) != 0;
  std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  bytes += '\n';
  MotionSet modes = all_modes();
  Proven proven;
  PlainLines plain(bytes), one_by_one(bytes, nullptr);
  for (size_t at = 0; at < bytes.size();) {
    const size_t feed = bytes.find('\n', at);
    const std::string_view text = std::string_view(bytes).substr(at, feed - at);
    const Passed passed = plain.pass(at, feed + 1, proven);
    require(passed == one_by_one.pass(at, feed + 1, proven));
    require(passed.lines <= 1 && passed.next == (passed.lines == 1 ? feed + 1 : at));
    if (text.size() > kLineLimit) return 0;
    const Line line(text, at, machine);
    if (passed.lines == 1) line.must_run(modes, passed.effect.motion);
    proven = passed.lines == 1 ? passed.proven : proven_after(text, proven);
    if (line.stops(&modes)) return 0;
    at = feed + 1;
  }
  return 0;
}
