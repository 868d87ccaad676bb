// OW418 remap-arguments: what a REMAP line passes to its sub is not what it looks like.
// Depends on: how `argspec` is read, and which codes run the built-in one inside their sub (measured with `rs274 -i`).
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <map>

#include "rules/driver/remap_sub.h"

namespace owlint::rules::ow418 {
namespace {

class Checker {
 public:
  using Subs = std::map<std::string_view, RemapSub>;  ///< by their name: several codes may run one

  Checker(const SetupInput& in, Reporter& out, const Remap& remap, Subs& subs)
      : in_(in), out_(out), remap_(remap), subs_(subs) {}

  void run() {
    const std::string_view argspec = remap_.read.argspec;
    const bool positional = argspec.find('@') != std::string_view::npos;
    bool omittable = false;
    for (size_t i = 0; i < argspec.size(); ++i) {
      const char c = argspec[i];
      if (std::isalpha(static_cast<unsigned char>(c)) == 0) continue;
      const char other =
          static_cast<char>(std::isupper(static_cast<unsigned char>(c)) != 0 ? std::tolower(c) : std::toupper(c));
      const std::string_view before = argspec.substr(0, i);
      if (const bool same = before.find(c) != std::string_view::npos;
          same || before.find(other) != std::string_view::npos) {
        Finding& f = add(argspec.substr(i, 1),
                         same ? "`" + std::string(1, c) + "` is in the `argspec` already"
                              : "`" + std::string(1, c) + "` and `" + std::string(1, other) +
                                 "` in one `argspec`: the word is required then");
        f.help = "write the letter once: in capitals if it is required, small if it may be left out";
        return;
      }
      if (positional && omittable && c != 'N' && c != 'n') {
        Finding& f = add(argspec,
                         "with `@`, a word that is left out moves those behind it: `" + std::string(1, c) +
                             "` is then in another parameter");
        f.help = "put the words that may be left out, in small letters, last; or pass them by name, without `@`";
        return;
      }
      omittable = omittable || std::islower(static_cast<unsigned char>(c)) != 0;
    }
    check_itself();
    if (check_passable()) check_sub();
  }

 private:
  /// Measured: neither is passed, nor is a line without them refused. False where `argspec` has one.
  bool check_passable() {
    const std::string_view argspec = remap_.read.argspec;
    const size_t at = argspec.find_first_of("GgMm");
    if (at == std::string_view::npos) return true;
    Finding& f = add(argspec.substr(at, 1),
                     "LinuxCNC never passes `G` and `M` words to a sub: `" + std::string(argspec.substr(at, 1)) +
                         "` in `argspec` has no effect");
    f.help = "remove the letter from `argspec`, and pass the number as another word, such as `P`";
    return false;
  }

  /// What the sub reads, against what it gets. Python before it may give it more, or read for it.
  void check_sub() {
    const RemapLine& remap = remap_.read;
    if (remap.ngc.empty() || !remap.prolog.empty() || !remap.epilog.empty()) return;
    const auto [known, added] = subs_.try_emplace(remap.ngc);
    if (added) known->second = remap_sub(in_, remap.ngc);
    const RemapSub& sub = known->second;
    if (sub.region == kNoRegion) return;
    const bool positional = remap.argspec.find('@') != std::string_view::npos;
    std::string letters;  // words that are passed, small
    for (const char c : remap.argspec) {
      if (std::isalpha(static_cast<unsigned char>(c)) != 0)
        letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (!check_read(sub, letters, positional)) return;
    if (positional) {
      check_positions(sub);
    } else {
      check_unread(sub, letters);
    }
  }

  void relate_line(Finding& f, const RemapSub& sub, StatementId id, std::string message) const {
    f.related.push_back({sub.program->at(id).whole(), std::move(message), sub.program->source});
  }

  /// The sub reads what no word gives it. False where it does.
  bool check_read(const RemapSub& sub, const std::string& letters, bool positional) {
    const std::string_view argspec = remap_.read.argspec;
    for (const RemapSub::Name& name : sub.names) {
      const bool special = (name.letter == 'f' && argspec.find('>') != std::string_view::npos) ||
          (name.letter == 's' && argspec.find('^') != std::string_view::npos);
      const bool given = special || letters.find(name.letter) != std::string::npos;
      if (name.may_lack || (given && !positional)) continue;
      const std::string read = "`#<" + std::string(1, name.letter) + ">`";
      Finding& f =
          add(argspec.empty() ? remap_.read.code : argspec,
              positional ? "with `@` the words are in `#1`, `#2` …, but the sub reads " + read
                         : "the sub reads " + read + ", which " +
                      (argspec.empty() ? "a `REMAP` without `argspec` does not pass" : "`argspec` does not pass"));
      const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(name.letter)));
      f.help = positional ? "remove the `@`, or read the values by their numbers"
                          : "add `" + std::string(1, capital) + "` to `argspec`, or `" + std::string(1, name.letter) +
              "` if the word may be left out and the sub asks for it with `EXISTS`";
      if (name.letter == 'g' || name.letter == 'm')
        f.help = "pass the number as another word, such as `P`: LinuxCNC never passes `G` and `M` words";
      f.interpreter = "Named parameter #<" + std::string(1, name.letter) + "> not defined";
      relate_line(f, sub, name.first, "read here");
      return false;
    }
    if (positional || !sub.known || sub.arguments == 0) return true;
    const auto number = static_cast<uint32_t>(std::countr_zero(sub.arguments));
    Finding& f =
        add(argspec.empty() ? remap_.read.code : argspec,
            "the sub reads `#" + std::to_string(number) + "`, but words are passed as names, such as `#<p>`: it is 0");
    f.help = "write `argspec=@…` to pass words as `#1`, `#2` …, or read the names";
    if (argspec.empty()) {
      f.message = "this `REMAP` has no `argspec`, so it passes no words, and `#" + std::to_string(number) +
          "`, which the sub reads, is 0";
      f.help = "write `argspec=@P`, with the letter of each word that the sub gets, in the order of `#1`, `#2` …";
    }
    relate_line(f, sub, sub.argument_lines[number], "read here");
    return false;
  }

  /// With `@`: more numbers than words, or fewer.
  void check_positions(const RemapSub& sub) {
    if (!sub.known) return;
    const std::string_view argspec = remap_.read.argspec;
    const auto words = static_cast<uint32_t>(argspec.size() - std::ranges::count(argspec, '@'));
    const auto last = static_cast<uint32_t>(31 - std::countl_zero(sub.arguments | 1U));
    if (last == words) return;
    const std::string passed = std::to_string(words) + (words == 1 ? " value" : " values");
    Finding& f = add(argspec,
                     last > words ? "`argspec` passes " + passed + ", but the sub reads `#" + std::to_string(last) + "`"
                                  : "`argspec` passes " + passed + ", but the sub reads " +
                             (last == 0       ? "none"
                                  : last == 1 ? "only `#1`"
                                              : "only `#1` to `#" + std::to_string(last) + "`"));
    f.help = last > words ? "add the missing words to `argspec`, or correct the sub"
                          : "remove the words that nobody reads, or use them in the sub";
    if (last > 0) relate_line(f, sub, sub.argument_lines[last], "the last value that it reads");
  }

  /// A word that the sub never reads.
  void check_unread(const RemapSub& sub, const std::string& letters) {
    for (const char letter : letters) {
      if (sub.reads(letter)) continue;
      const std::string_view argspec = remap_.read.argspec;
      const size_t at = small_letters(argspec).find(letter);
      const bool required = std::isupper(static_cast<unsigned char>(argspec[at])) != 0 && letter != 'n';
      Finding& f = add(argspec.substr(at, 1),
                       "the sub never reads `#<" + std::string(1, letter) + ">`" +
                           (required ? ", but every line with the code must have the word" : ""));
      f.help = "remove the letter from `argspec`, or use the value in the sub";
      relate_line(f, sub, sub.program->regions[sub.region].opener, "the sub begins here");
      return;
    }
  }

  Finding& add(std::string_view part, std::string message) {
    return add_at(in_, out_, *remap_.line, span_in(in_.setup.text, *remap_.line, part), std::move(message));
  }

  /// A code in its own sub, where it calls that sub again.
  void check_itself() {
    const int number = remap_.read.m_number();
    const int group = remap_.read.group.value_or(-1) == -1 ? 10 : *remap_.read.group;
    if (number < 0 || remap_.read.ngc.empty()) return;
    const bool plain = remap_.read.code.size() == std::to_string(number).size() + 1;
    if (plain && is_built_in_inside(number, group)) return;
    if (plain && in_.profile.version >= Version::k2_10 && group == 8 && number >= 7 && number <= 9) return;
    const std::string path = remap_file(in_.setup, remap_.read.ngc);
    if (path.empty()) return;
    const std::shared_ptr<const Program> program = in_.library.load_called(path, in_.profile);
    for (const Statement& s : program->syntax.statements) {
      if (!has_code(program->source->slice(s.whole()), number)) continue;
      Finding& f = add(remap_.read.code,
                       "the sub uses `" + std::string(remap_.read.code) +
                           "` itself, and there it calls the sub again, until LinuxCNC gives up");
      f.help = help_for_own_code(number);
      f.related.push_back({s.whole(), "used here", program->source});
      f.interpreter = "maximum nesting of remapped blocks exceeded";
      return;
    }
  }

  static bool has_code(std::string_view line, int number) {
    line = line.substr(0, line.find_first_of("(;"));
    for (size_t at = line.find_first_of("Mm"); at != std::string_view::npos; at = line.find_first_of("Mm", at + 1)) {
      if (at > 0 &&
          (std::isalnum(static_cast<unsigned char>(line[at - 1])) != 0 &&
           std::isdigit(static_cast<unsigned char>(line[at - 1])) == 0))
        continue;
      if (at > 0 && (line[at - 1] == '<' || line[at - 1] == '_')) continue;
      size_t end = at + 1;
      while (end < line.size() && line[end] >= '0' && line[end] <= '9') ++end;
      const std::string_view digits = line.substr(at + 1, end - at - 1);
      const size_t first = std::min(digits.find_first_not_of('0'), digits.empty() ? 0 : digits.size() - 1);
      if (!digits.empty() && digits.substr(first) == std::to_string(number)) return true;
    }
    return false;
  }

  const SetupInput& in_;
  Reporter& out_;
  const Remap& remap_;
  Subs& subs_;
};

void check_setup(const SetupInput& in, Reporter& out) {
  Checker::Subs subs;
  for (const Remap& remap : remaps_of(in.setup.text)) {
    if (remap.read.problem == RemapLine::Problem::kNone && remap.earlier == nullptr)
      Checker(in, out, remap, subs).run();
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW418",
    .name = "remap-arguments",
    .summary = "a REMAP line whose sub gets other words than intended",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(An `argspec` with a letter twice, or with `@` and an optional word that is not the last; words that
do not fit what the sub reads: `#<p>` without a P in `argspec`, a letter that the sub never reads,
more or fewer values than it has numbers; a code that is used in its own sub and calls that sub
again.)",
            .why = R"(The sub gets only the words of `argspec`: as names, `#<p>` for P, or with `@` as numbers. Reading
another name stops it with `Named parameter #<p> not defined`. owlint reports nothing about a sub
with `prolog=` or `epilog=`: the Python function may pass and read more. With `@` the values are in
#1, #2 … in the order of `argspec`: if an optional one is left out, those after it move up. In its
own sub a code is the built-in one only for M0, M1 and M60 in group 4, M6 and M61 in group 6, M62 to
M68 in group 5, T, S and F. Every other code, such as M6 in group 10, calls its sub again and again
until LinuxCNC stops with `maximum nesting of remapped blocks exceeded`. G and M words are never passed, and a line
without them is not refused.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
REMAP = M400 modalgroup=10 argspec=@pQ ngc=greet
; file: greet.ngc
o<greet> sub
  G4 P[#1 + #2]
o<greet> endsub
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
REMAP = M400 modalgroup=10 argspec=@Qp ngc=greet
; file: greet.ngc
o<greet> sub
  G4 P[#1 + #2]
o<greet> endsub
)",
            .fix =
                R"(Put optional words last, or pass them by name. Give `argspec` the words that the sub reads. Use the
group in which the built-in code can be used.)",
            .level_reason = "Warning: LinuxCNC starts; the sub gets other values, or stops.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow418
