// Depends on: which bytes LinuxCNC's reader of INIs takes for line ends, and what its start script makes of `#INCLUDE` (measured
// with `inivar` and with LinuxCNC itself).
#include "rules/driver/ini_form.h"

#include <algorithm>

#include "analyzer/machine/ini_hidden.h"
#include "analyzer/text/paths.h"
#include "rules/driver/ini_values.h"

namespace owlint::rules {

namespace {

bool is_here(const SetupInput& in, std::string_view name) {
  return in.library.files().is_file(joined_path(folder_of(in.setup.path), expand_home(name)));
}

}  // namespace

std::string as_code(std::string_view text) {
  constexpr size_t kShown = 40;
  const char quote = text.find('`') == std::string_view::npos ? '`' : '"';
  return quote + std::string(text.substr(0, kShown)) + (text.size() > kShown ? "…" : "") + quote;
}

bool check_hidden_ini(const SetupInput& in, Reporter& out) {
  const auto& source = in.setup.ini.source();
  const IniHidden hidden = how_hidden(source->bytes());
  if (hidden == IniHidden::kNone) return false;
  const bool wide = hidden == IniHidden::kUtf16;
  if (reads_strictly(in) && !wide) return true;  // not known
  const std::string_view bytes = source->bytes();
  const size_t at = wide ? 0 : bytes.find('\r');
  Finding& f = out.add(source, {at, at + 2},
                       wide ? "the file is saved as UTF-16: LinuxCNC finds no section and no key in it"
                           : bytes[at + 1] == '\r'
                           ? "the lines end with two carriage returns: LinuxCNC finds no section and no key in the file"
                           : "the lines end with a carriage return alone: LinuxCNC finds no section and no key in "
                             "the file");
  f.help = wide ? "save the file as UTF-8 without BOM" : "save the file with Unix line endings (LF)";
  if (!wide) f.interpreter = "inifile: error: File contains ambiguous carriage returns";
  Ini meant;
  meant.parse(in.library.files(), Source::own(source->path(), text_as_seen(bytes)));
  const Ini::Entry* version = meant.find("EMC", "VERSION");
  if (version == nullptr || version->value != "1.1" || in.profile.version < Version::k2_8) return true;
  f.message += ", and does not start";
  refuses(f,
          wide ? "INI file [EMC]VERSION indicates update is needed, but the update GUI can't run without an X display"
               : f.interpreter);
  return true;
}

void check_bytes(const SetupInput& in, Reporter& out, const std::shared_ptr<const Source>& source) {
  const std::string_view bytes = source->bytes();
  for (size_t at = bytes.find('\r'); at != std::string_view::npos; at = bytes.find('\r', at + 1)) {
    if (at + 1 == bytes.size() || bytes[at + 1] == '\n') continue;
    const size_t behind = bytes.find_first_not_of('\r', at);
    const bool at_end = behind == std::string_view::npos || bytes[behind] == '\n';
    Finding& f = out.add(source, {at, at + 1},
                         at_end ? "two carriage returns at the end of a line: LinuxCNC finds no key on this line or "
                                  "below it"
                                : "a carriage return inside a line: LinuxCNC finds no key on this line or below it");
    f.help = "save the file with Unix line endings (LF)";
    f.interpreter = "inifile: error: File contains ambiguous carriage returns";
    const IniLine* units = find_line(in.setup.text, "TRAJ", "LINEAR_UNITS");
    if (is_whole_machine(in) && units != nullptr && in.setup.text.source(*units) == source && units->span.end > at)
      refuses(f, f.interpreter);
    break;
  }
  if (const size_t at = bytes.find('\0'); at != std::string_view::npos) {
    Finding& f = out.add(source, {at, at + 1}, "a NUL byte: LinuxCNC ignores the rest of the line");
    f.help = "remove it; the file may be damaged, or saved as UTF-16";
  }
}

/// `#include machine.inc`, `# INCLUDE machine.inc`, where there is that file.
void check_near_include(const SetupInput& in, Reporter& out, const IniLine& line) {
  const std::string_view text = in.setup.text.text(line);
  constexpr std::string_view kWord = "include";
  const size_t begin = text.find_first_not_of("# \t");
  if (!text.starts_with('#') || begin == std::string_view::npos) return;
  std::string_view rest = text.substr(begin);
  if (small_letters(rest.substr(0, kWord.size())) != kWord) return;
  rest.remove_prefix(kWord.size());
  const size_t first = rest.find_first_not_of(" \t");
  if (first == 0 || first == std::string_view::npos || !is_here(in, rest.substr(first))) return;
  Finding& f = add_at(in, out, line, line.span, "LinuxCNC takes " + as_code(text) + " for a comment");
  f.help = "write `#INCLUDE " + std::string(rest.substr(first)) + "` to include the file";
}

void check_include(const SetupInput& in, Reporter& out, const IniLine& line) {
  const std::string_view name = ini_include(in.setup.text.text(line));
  if (name.find_first_of("`;|&<>") == std::string_view::npos && name.find("$(") == std::string_view::npos) {
    // A file of another computer, or one whose name the shell makes, is not to be known; with blanks it is a comment.
    const std::string_view plain = name.substr(std::min(name.find_first_not_of("= \t"), name.size()));
    if (plain.find_first_of(" \t") != std::string_view::npos) return;
    if (name.find_first_of("$*?[\"'\\") != std::string_view::npos || name.starts_with('/') || name.starts_with('~'))
      return;
    Finding& f =
        add_at(in, out, line, line.span,
               "there is no file " + as_code(name) + ": LinuxCNC says so on the console, and goes on without it");
    f.help = plain != name && is_here(in, plain) ? "write `#INCLUDE " + std::string(plain) + "`"
                                                 : "put the file there, or correct the name";
    f.interpreter = "CANNOT READ " + std::string(name);
    return;
  }
  Finding& f = add_at(in, out, line, line.span,
                      "LinuxCNC passes the file name of `#INCLUDE` to a shell, which would run " + as_code(name));
  f.help = "write a plain file name; owlint ran nothing, and did not read the file";
}

}  // namespace owlint::rules
