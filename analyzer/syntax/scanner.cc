// The scanner: runs over the bytes once and hands to the line parser only the lines that can matter; the others are not stored.
#include <algorithm>
#include <array>
#include <cstring>

#include "analyzer/syntax/bulk.h"
#include "analyzer/syntax/comment_command.h"
#include "analyzer/syntax/line_look.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/modes_in_effect.h"
#include "analyzer/syntax/statement.h"
#include "analyzer/text/parallel.h"

namespace owlint {
namespace {

// Lines are skipped in stretches, and each stretch is let go when it is over: a file of gigabytes is never in
// memory as a whole.
constexpr size_t kStretch = 4 << 20;  // bytes

/// The bytes up to the last line feed: what comes after it is not plain.
std::string_view whole_lines(std::string_view bytes) { return bytes.substr(0, bytes.rfind('\n') + 1); }

/// A stretch of lines that one core looks through.
struct Stretch {
  uint64_t begin = 0;
  uint64_t end = 0;
};

std::vector<Stretch> cut(const Source& source) {
  const std::string_view bytes = source.bytes();
  std::vector<Stretch> stretches;
  for (size_t at = 0; at < bytes.size();) {
    const size_t feed = at + kStretch < bytes.size() ? bytes.find('\n', at + kStretch) : std::string_view::npos;
    const size_t end = feed == std::string_view::npos ? bytes.size() : feed + 1;
    stretches.push_back({at, end});
    if (bytes.size() > kStretch) source.let_go({at, end});  // looking at one byte can bring in half a megabyte
    at = end;
  }
  return stretches;
}

/// Plain lines, then one that is not; line numbers from 1, from the beginning of the stretch.
struct Found {
  uint32_t plain_first = 0;  ///< the first plain line with code on it; 0 if there is none
  uint32_t plain_last = 0;
  bool plain_text = false;  ///< not all plain lines are blank
  PlainEffect plain_effect;
  LastLines plain_last_lines;
  size_t plain_begin = 0;     ///< their bytes go on to `begin`
  uint32_t plain_before = 0;  ///< the line before them
  Proven proven;              ///< at their beginning
  uint32_t line = 0;          ///< the line after them; at the end of the stretch the number of all lines
  bool over = false;          ///< no line comes after them: the end of the stretch
  LineView view;
  size_t begin = 0;
  size_t end = 0;  ///< without its line feed
};

/// The lines of an effect, which come behind so many others.
PlainEffect behind(PlainEffect effect, uint32_t lines) {
  if (effect.first_move != 0) effect.first_move += lines;
  if (effect.first_arc != 0) effect.first_arc += lines;
  return effect;
}

/// Reads a stretch and passes what it finds to `take`; plain lines, which have none of the `refused` letters, are not stored.
template <typename Take>
void look_through(std::string_view bytes, const Stretch& stretch, uint32_t refused, const Proven& always,
                  const Take& take) {
  const std::string_view until_end = no_line_is_plain ? "" : whole_lines(bytes.substr(0, stretch.end));
  PlainLines plain(until_end, &byte_classifiers().front(), refused);
  uint32_t line = 0;
  Proven proven = always;
  for (size_t at = stretch.begin;;) {
    const Passed passed = plain.pass(at, until_end.size(), proven);
    Found found;
    found.plain_effect = behind(passed.effect, line);
    found.plain_last_lines = passed.last;
    found.plain_text = passed.text;
    found.plain_begin = at;
    found.plain_before = line;
    found.proven = proven;
    if (passed.first_code != 0) {
      found.plain_first = line + passed.first_code;
      found.plain_last = line + passed.last_code;
    }
    line += passed.lines;
    at = passed.next;
    found.line = line;
    found.begin = at;
    found.over = at >= stretch.end;
    if (found.over) return take(found);
    const auto* feed = static_cast<const char*>(std::memchr(bytes.data() + at, '\n', stretch.end - at));
    found.end = feed == nullptr ? stretch.end : static_cast<size_t>(feed - bytes.data());
    found.line = ++line;
    const std::string_view text = bytes.substr(at, found.end - at);
    proven = proven_after(text, passed.proven, always, refused);
    // The limit counts the line feed: a last line without one may be a character longer.
    const size_t limit = kLineLimit + (feed == nullptr ? 1 : 0);
    if (text.size() <= limit) {
      found.view = look(text);
    } else {
      found.view.too_long = true;
    }
    found.view.owlint = text.find(kOwlint) != std::string_view::npos;
    take(found);
    at = std::min(found.end + 1, size_t{stretch.end});
  }
}

/// Puts together what the stretches have, in their order, and parses the lines that matter.
class Reader {
 public:
  Reader(Syntax& out, std::string_view bytes, const MachineWords& machine, Expected expected)
      : out_(out),
        bytes_(bytes),
        plain_(whole_lines(bytes)),
        parser_(out, machine),
        modes_(out, parser_, machine, expected) {}

  void take(const Found& found) {
    if (out_.unusual) return;
    seen_first_ = seen_first_ || found.plain_text;
    if (found.plain_first != 0) {
      note_plain(before_ + found.plain_first);
      out_.last_code = before_ + found.plain_last;
      pass(found);
    }
    if (found.over) {
      before_ += found.line;
      return;
    }
    take_line(found.begin, found.end, before_ + found.line, found.view);
  }

  void finish() {
    modes_.finish();
    out_.lines = before_;
    out_.blank = !seen_first_;
  }

 private:
  /// Plain lines: what they set, where they go, and of arcs whether they fit. One that has to be looked at is read like any line.
  void pass(const Found& found) {
    size_t from = found.plain_begin;
    uint32_t line = before_ + found.plain_before;
    size_t next = modes_.follow(bytes_, from, found.begin, line + 1, found.plain_effect, found.plain_last_lines);
    if (next == found.begin) return modes_.pass(found.plain_effect, before_, out_.last_code);
    Proven proven = found.proven;
    const auto pass_until = [&](size_t end) {
      const Passed passed = plain_.pass(from, end, proven);
      modes_.pass(behind(passed.effect, line), 0, line + passed.lines);
      line += passed.lines;
      proven = passed.proven;
    };
    while (next < found.begin) {
      pass_until(next);
      const size_t end = bytes_.find('\n', next);
      take_line(next, end, ++line, look(bytes_.substr(next, end - next)));
      // The line's own codes count for those behind it.
      from = next;
      proven = plain_.pass(from, end + 1, proven).proven;
      from = end + 1;
      next = modes_.follow(bytes_, from, found.begin, line + 1, found.plain_effect, found.plain_last_lines);
    }
    pass_until(found.begin);
  }

  void take_line(size_t begin, size_t end, uint32_t number, const LineView& view) {
    std::string_view line = bytes_.substr(begin, end - begin);
    if (!seen_first_) note_first_line(line);
    if (view.whole_p) out_.whole_p_lines.push_back(begin);
    if (view.owlint) out_.owlint_lines.push_back(begin);
    if (line.find('^') != std::string_view::npos) out_.angle_lines.push_back(begin);
    Statement statement;
    statement.line = number;
    const bool too_long = view.too_long && !ends_in_nuls(line);
    if (view.too_long && !too_long) line = line.substr(0, line.find('\0') + 1);
    bool keep = too_long;
    bool asked = false;  // kept only for a question about it
    if (too_long) {
      statement.offset = begin;
      statement.length = static_cast<uint32_t>(std::min<size_t>(line.size(), UINT32_MAX));
      statement.error = static_cast<uint32_t>(out_.errors.size());
      out_.errors.push_back(
          {StopKind::kLineTooLong, {begin + kLineLimit, end}, "Command too long", {}, kNoExpr, 0, 0, 0});
      out_.last_code = number;
      if (has_command(line)) out_.command_lines.push_back(begin);
    } else {
      const bool code =
          view.code && line.find_first_not_of(std::string_view("\0 \t\r\v\f", 6)) != std::string_view::npos;
      if (code) out_.last_code = number;
      if (view.matters || view.too_long) {
        keep = parser_.parse(line, begin, &statement);
        asked = !keep;
        keep = modes_.judge(statement, keep);
        asked = asked && keep && !statement.has_error();
      }
      if (view.speaks || (view.matters && parser_.has_comment())) {
        note_directive(line, begin, number, view.code, keep && statement.kind == LineKind::kOWord, out_);
        if (has_command(line)) out_.command_lines.push_back(begin);
        const bool plain = !keep || (!statement.has_error() && statement.has_items());
        const std::string_view comment = plain ? acting_comment(line) : "";
        out_.runs_python = out_.runs_python || (plain && runs_python(line, comment));
        if (plain && begins(comment, "abort,")) {
          statement.offset = begin;
          statement.length = static_cast<uint32_t>(line.size());
          statement.kind = LineKind::kAbort;
          statement.item_count = 0;
          keep = true;
        }
      }
      if ((!keep || asked) && code) note_plain(number);
    }
    const bool parsed = view.matters && !too_long;
    const WordLine* const words = parsed ? parser_.words() : nullptr;
    const auto questions = parsed ? parser_.questions() : std::span<const uint32_t>();
    const bool asks_machine = !questions.empty() || (words != nullptr && words->is_user_m());
    if (!keep && !asks_machine) return;
    out_.deletes_lines = out_.deletes_lines || statement.block_delete;
    make_room(out_.statements, begin);
    make_room(out_.exprs, begin);
    make_room(out_.values, begin);
    for (const uint32_t error : questions) ask(statement, LineKind::kMachineCheck, error);
    if (keep) modes_.push(statement);
    if (words != nullptr && words->is_user_m()) {
      const Word& code = (*words)[words->word_of(MGroup::kUser)];
      Statement& asks = ask(statement, LineKind::kUserCode, static_cast<uint32_t>(code.value + 0.5));
      asks.keyword_from = code.from;
      asks.keyword_to = code.to;
    }
  }

  Statement& ask(const Statement& line, LineKind kind, uint32_t first) {
    return out_.statements.emplace_back(question_about(line, kind, first));
  }
  void note_first_line(std::string_view line) {
    line = line.substr(0, line.find('\0'));  // where LinuxCNC's line ends
    const size_t first = line.find_first_not_of(" \t\r\v\f");
    if (first == std::string_view::npos) return;
    seen_first_ = true;
    out_.percent = line[first] == '%' && line.find_first_not_of(" \t\r\v\f", first + 1) == std::string_view::npos;
  }

  void note_plain(uint32_t line) {
    if (out_.statements.empty()) {
      if (out_.first_plain_line == 0) out_.first_plain_line = line;
    } else if (!out_.statements.back().plain_code_follows) {
      out_.statements.back().plain_code_follows = true;
      out_.statements.back().first_plain_line = line;
    }
  }

  /// Room for one more, and if there is none, for as many as the whole file will have if it goes on like this.
  template <typename T>
  void make_room(std::vector<T>& list, size_t at) const {
    constexpr size_t kFew = 1024;
    if (list.size() < list.capacity() || list.size() < kFew) return;
    const auto expected = static_cast<size_t>(static_cast<double>(list.size()) * static_cast<double>(bytes_.size()) /
                                              static_cast<double>(at + 1) * 1.05);
    list.reserve(std::max(expected, list.size() * 2));
  }

  Syntax& out_;
  std::string_view bytes_;
  PlainLines plain_;  // for plain lines that are passed again
  LineParser parser_;
  ModesInEffect modes_;
  uint32_t before_ = 0;      // lines in the stretches before
  bool seen_first_ = false;  // a line that is not blank
};

}  // namespace

Syntax scan(const Source& source, const MachineWords& machine, Expected expected) {
  Syntax out;
  const std::string_view bytes = source.bytes();
  Reader reader(out, bytes, machine, expected);
  const Proven always = expected == Expected::kUsual ? Proven::usual() : Proven();
  const std::vector<Stretch> stretches = cut(source);
  uint32_t refused = machine.wrapped | machine.indexing;
  for (const RemappedCode& code : machine.remapped) {
    if (code.letter == 'f' || code.letter == 's') refused |= letter_set({&code.letter, 1});
  }
  const auto look_at = [&](size_t i, const auto& take) {
    const Span span{stretches[i].begin, stretches[i].end};
    if (stretches.size() > 1) source.will_read(span);
    look_through(bytes, stretches[i], refused, always, take);
  };
  if (stretches.size() == 1 || one_core()) {
    for (size_t i = 0; i < stretches.size() && !out.unusual; ++i) {
      look_at(i, [&](const Found& found) { reader.take(found); });
      if (stretches.size() > 1) source.let_go({stretches[i].begin, stretches[i].end});
    }
  } else {
    const auto make = [&](size_t i) {
      std::vector<Found> found;
      look_at(i, [&](const Found& one) { found.push_back(one); });
      return found;
    };
    for_each_in_order(stretches.size(), make, [&](size_t i, const std::vector<Found>& found) {
      for (const Found& one : found) reader.take(one);
      source.let_go({stretches[i].begin, stretches[i].end});
    });
  }
  reader.finish();
  return out;
}

}  // namespace owlint
