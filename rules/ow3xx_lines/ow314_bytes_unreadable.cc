// OW314 bytes-unreadable: bytes that the interpreter refuses or silently stops reading at.
// Depends on: outside comments and names only ASCII is known; a NUL ends its line; lines end at line
// feed, not at CR.
#include <algorithm>

#include "analyzer/syntax/look_alike.h"
#include "rules/driver/idioms.h"
#include "rules/driver/words.h"

namespace owlint::rules::ow314 {
namespace {

/// How to write what a character outside ASCII stands for.
std::string help_for(char32_t character) {
  switch (character) {
    case U'\u00B0': return "remove it: angles are in degrees";
    case U'\u00B2': return "write `[... ** 2]` for a square";
    case U'\u00B3': return "write `[... ** 3]` for a cube";
    default: return "remove it, or put it in a comment";
  }
}

/// `,C2` and `,R2` behind a move.
bool tell_corner(const Source& source, Span rest, Finding& f) {
  const std::string text = shown(source, rest).substr(0, 2);
  if (text != ",C" && text != ",R") return false;
  f.message = "`" + text + (text == ",C" ? "` is a chamfer" : "` is a rounded corner") + " on Fanuc and Haas";
  f.help = text == ",C" ? "write the chamfer as a move of its own" : "write the corner as `G2` or `G3`";
  return true;
}

/// The line number that a text begins with, `N120`; empty if it is none.
std::string number_behind(std::string_view text) {
  const size_t digits = text.find_first_not_of(" \t", 1);
  const size_t end = std::min(text.find_first_not_of("0123456789", std::min(digits, text.size())), text.size());
  return digits == std::string_view::npos || end == digits ? std::string()
                                                           : "N" + std::string(text.substr(digits, end - digits));
}

/// A second line number, or one behind other words.
bool tell_number(const Program& p, const Statement& s, Span at, Finding& f) {
  const std::string_view letter = p.source->slice(at);
  if (letter != "N" && letter != "n") return false;
  f.message = "a line number stands first on its line, and only once";
  f.help = "remove this one";
  const std::string number = number_behind(p.source->slice({at.begin, s.end()}));
  const std::vector<WrittenWord> before = words_of(*p.source, {s.offset, at.begin});
  if (number.empty() || std::ranges::all_of(before, [](const WrittenWord& w) { return w.letter == 'n'; })) return true;
  f.help = "write two lines: a line feed may be missing before `" + number + "`";
  f.fixes.push_back(split_line(p, s, at.begin, "write two lines"));
  f.fixes.back().safe = false;  // or it is no line number
  return true;
}

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  const LineError* error = p.syntax.error(s);
  if (s.inner_cr) {
    const size_t at = p.source->bytes().find('\r', s.offset);
    Finding& f = out.add({at, at + 1}, "a carriage return inside the line: for LinuxCNC only a line feed ends a line");
    f.help = "save the file with line feeds";
    return &f;
  }
  const Span span = error == nullptr ? s.whole() : error->span;
  const std::string_view bytes = p.source->slice(span);
  const uint64_t length = character_at(p.source->slice({span.begin, s.end()})).length;
  Finding& f = out.add({span.begin, std::max(span.end, span.begin + length)}, "");
  if (bytes.starts_with("\xEF\xBB\xBF") && span.begin == 0) {
    f.message = "the file begins with a byte order mark";
    f.help = "save it as UTF-8 without a byte order mark (BOM), or as plain text";
    f.fixes.push_back({"remove the byte order mark", true, {{{0, 3}, ""}}});
  } else if (!bytes.empty() && is_foreign(bytes[0])) {
    f.message = "LinuxCNC does not know this character outside comments and names";
    f.help = help_for(character_at(p.source->slice({span.begin, s.end()})).code);
    explain_idiom(in, id, f);
  } else if (!bytes.empty() && (static_cast<unsigned char>(bytes[0]) < 0x20 || bytes[0] == 0x7F)) {
    f.message = "a control character";
    f.help = "remove it";
  } else {
    f.message = "`" + std::string(bytes) + "` has no meaning here";
    f.help = "remove it, or put it in a comment";
    if (!tell_corner(*p.source, {span.begin, s.end()}, f) && !tell_number(p, s, span, f)) explain_idiom(in, id, f);
  }
  return &f;
}

/// A file that is no text: one finding, whatever its lines come to.
void report_file(const Input& in, Reporter& out) {
  const bool utf16 = in.index.nature.kind == Nature::kUtf16;
  const std::string_view bytes = in.program.source->bytes();
  Finding& f = out.add({0, std::min<uint64_t>(bytes.size(), 2)},
                       utf16 ? "this is a UTF-16 file; LinuxCNC cannot read it" : "this is not a text file");
  f.help = utf16 ? "save it as UTF-8 without a byte order mark (BOM), or as plain text"
                 : "check that it is the right file; a program is plain text";
  for (const FlowStop& stop : in.flow.stops) {
    if (f.stops && f.reach >= stop.reach) continue;
    f.stops = true;
    f.reach = stop.reach;
    f.interpreter = stop.interpreter;
  }
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  if (in.index.nature.kind == Nature::kUtf16 || in.index.nature.kind == Nature::kNoText) return report_file(in, out);
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  bool nul_reported = false;
  for (const StatementId id : in.index.odd_lines) {
    const Statement& s = p.at(id);
    const LineError* error = p.syntax.error(s);
    const bool refused = error != nullptr && error->kind == StopKind::kBadCharacter;
    if (s.nul && !nul_reported) {
      nul_reported = true;  // a damaged file has thousands
      if (has_stop(in, id)) continue;
      const size_t at = p.source->bytes().find('\0', s.offset);
      Finding& f = out.add({at, at + 1}, "a NUL byte: LinuxCNC ignores the rest of the line without a message");
      f.help = "the file is damaged, or not a program";
      f.reach = in.flow.reach(id);
    } else if ((refused || s.inner_cr) && !has_stop(in, id) && !in.index.spoken_for.contains(id)) {
      report(in, out, id)->reach = in.flow.reach(id);
    }
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW314",
    .name = "bytes-unreadable",
    .summary = "a byte order mark, NUL, CR-only line ends, or characters that LinuxCNC does not know",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A byte order mark at the start of the file, no-break spaces, typographic minus signs or quotes from
a web page or a manual, letters with accents outside comments and names, control characters, NUL
bytes, or a file whose lines end with CR only. A file that is UTF-16, or not text at all, is
reported once. The example has a no-break space between `G0` and `X10`, which no editor shows.)",
            .why = R"(The interpreter stops with `Bad character '\357' used` (a byte order mark), `'\302'` (a no-break
space), `'\303'` (an accented letter); the number is the first byte in octal. A typographic minus
in a value gives `bad number format (conversion failed) parsing ''`.

In some cases there is no message. A NUL byte **cuts off the rest of its line**: a `Y` word after it
is lost. A file with only CR is one long line to LinuxCNC: if it starts with a `;` comment,
everything is comment. In comments, and in names between `< >`, accented letters are allowed.)",
            .bad = "G21 G90\n"
                   "G0\xC2\xA0X10 Y10 Z5\n"
                   "G1 Z-2 F80\n"
                   "G0 Z5\n"
                   "M2\n",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G1 Z-2 F80
G0 Z5
M2
)",
            .fix =
                R"(Save the file as plain text: ASCII or UTF-8 without a byte order mark, with lines ending in LF or CR
LF. Type the marked character again.)",
            .level_reason = "Error if the program stops at the byte. Warning if LinuxCNC ignores the rest without a "
                            "message, or no run gets here.",
            .interpreter = "Bad character '\\302' used",
            .options = "",
        },
    .check = check,
    .any_file = true,
};

}  // namespace owlint::rules::ow314
