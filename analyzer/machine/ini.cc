#include "analyzer/machine/ini.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_set>

#include "analyzer/machine/ini_hidden.h"
#include "analyzer/machine/ini_text.h"
#include "analyzer/text/paths.h"

namespace owlint {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr std::string_view kInclude = "#INCLUDE";

bool is_blank(char c) { return kBlanks.find(c) != std::string_view::npos; }

std::string_view trim(std::string_view text) {
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return text.substr(0, 0);  // with its place
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// Measured: the rest after this many bytes counts as a line of its own, and a line can be continued this often.
constexpr size_t kLongestLine = kLongestIniLine;
constexpr size_t kMaxContinued = kMostContinued;

}  // namespace

bool is_machine_ini(const Files& files, const std::string& path) {
  std::string error;
  Ini ini;
  const auto source = files.read(path, &error);
  if (source == nullptr) return false;
  const bool hidden = how_hidden(source->bytes()) != IniHidden::kNone;
  ini.parse(files, hidden ? Source::own(path, text_as_seen(source->bytes())) : source);
  return ini.has_section("RS274NGC") || ini.has_section("EMC");
}

std::string expand_home(std::string_view path) {
  const char* home = std::getenv("HOME");
  if (home == nullptr || (path != "~" && !path.starts_with("~/"))) return std::string(path);
  return home + std::string(path.substr(1));
}

bool Ini::read(const Files& files, const std::string& path, std::string* error) {
  const auto source = files.read(path, error);
  if (source == nullptr) return false;
  parse(files, source);
  return true;
}

/// Splits a file into lines, with those of the files that it includes in their places: measured, the start script puts
/// the text there, and an `#INCLUDE` in it is a comment.
void Ini::read_lines(const Files& files, const std::shared_ptr<const Source>& source, bool included,
                     std::vector<Line>& lines) {
  const std::string_view bytes = source->bytes();
  for (size_t at = 0; at < bytes.size() && lines.size() < kMostIniLines;) {
    std::string_view text = bytes.substr(at, kLongestLine);
    const size_t feed = text.find('\n');
    text = text.substr(0, feed);
    at += text.size() + (feed == std::string_view::npos ? 0 : 1);
    const std::string_view name =
        text.starts_with(kInclude) && !included ? trim(text.substr(kInclude.size())) : std::string_view{};
    if (name.empty()) {
      lines.push_back({text, source, feed != std::string_view::npos});
      continue;
    }
    const std::string file = joined_path(folder_of(source->path()), expand_home(name));
    std::string error;
    if (const auto found = files.read(file, &error); found != nullptr) {
      read_lines(files, found, true, lines);
    } else {
      const auto begin = static_cast<uint64_t>(name.data() - bytes.data());
      missing_includes_.push_back({"", std::string(kInclude), std::string(name), source, {begin, begin + name.size()}});
    }
  }
}

void Ini::parse(const Files& files, const std::shared_ptr<const Source>& source) {
  source_ = source;
  std::vector<Line> lines;
  read_lines(files, source, false, lines);
  // Measured: at a carriage return that is not the last character of its line LinuxCNC gives up, also at two of them.
  const auto stray = std::ranges::find_if(lines, [](const Line& line) {
    const size_t first = line.text.find('\r');
    return first != std::string_view::npos && first + 1 < line.text.size();
  });
  lines.erase(stray, lines.end());
  // LinuxCNC looks for the line of a section first, where a continued line is no different from others, and reads on
  // from there; it knows only the first section of a name.
  std::unordered_set<std::string_view> seen;
  for (size_t i = 0; i < lines.size(); ++i) {
    const std::string_view text = trim(lines[i].text);
    const size_t close = text.find(']');
    if (!text.starts_with('[') || close == std::string_view::npos) continue;
    const std::string_view name = text.substr(1, close - 1);
    if (!seen.insert(name).second) continue;
    sections_.emplace_back(name);
    read_section(lines, i + 1);
  }
}

/// The entries of one section, up to the next line that begins with a bracket.
void Ini::read_section(const std::vector<Line>& lines, size_t at) {
  std::string joined;  // of a continued line
  while (at < lines.size()) {
    const Line& first = lines[at];
    std::string_view text = trim(first.text);
    if (text.starts_with('[')) return;
    const size_t at_first = at;
    size_t last = at;
    if (first.text.ends_with('\\') && (first.ended || at + 1 < lines.size())) {
      joined.clear();
      for (last = at; last < lines.size() && lines[last].text.ends_with('\\'); ++last) {
        joined += lines[last].text.substr(0, lines[last].text.size() - 1);
        if (last - at > kMaxContinued - 1) return;  // an error, after which LinuxCNC knows nothing more of the section
        if (last + 1 == lines.size()) break;
      }
      if (lines[last].text.ends_with('\\')) {
        if (lines[last].ended) return;  // continued by nothing: not there
      } else {
        // Measured: of a last line without line feed the last character is lost.
        const std::string_view piece = lines[last].text;
        joined += lines[last].ended ? piece : piece.substr(0, piece.empty() ? 0 : piece.size() - 1);
      }
      text = trim(joined);
    }
    at = last + 1;
    if (text.empty() || text[0] == '#' || text[0] == ';') continue;
    const size_t equals = text.find('=');  // a key without it, but with a blank after it, is one without a value
    if (equals == std::string_view::npos && text.find_first_of(" \t") == std::string_view::npos &&
        (last != at_first || !is_blank(first.text.back())))
      continue;
    const std::string_view value =
        equals == std::string_view::npos ? std::string_view{} : trim(text.substr(equals + 1));
    const auto end_of = [](const Line& line) {
      const std::string_view piece = trim(line.text);
      return static_cast<uint64_t>(piece.data() - line.source->bytes().data()) + piece.size();
    };
    Span span{end_of(first) - value.size(), end_of(first)};
    if (&lines[last] != &first) {
      span.begin = end_of(first) - trim(first.text).size();
      span.end = lines[last].source == first.source ? std::max(span.begin, end_of(lines[last])) : end_of(first);
    }
    entries_.push_back({sections_.back(), std::string(text.substr(0, text.find_first_of(" \t="))), std::string(value),
                        first.source, span});
  }
}

const Ini::Entry* Ini::find(std::string_view section, std::string_view key) const {
  const auto found =
      std::ranges::find_if(entries_, [&](const Entry& e) { return e.section == section && e.key == key; });
  return found == entries_.end() || found->value.empty() ? nullptr : &*found;
}

std::vector<const Ini::Entry*> Ini::all(std::string_view section, std::string_view key) const {
  std::vector<const Entry*> found;
  for (const Entry& e : entries_) {
    if (e.section != section || e.key != key) continue;
    if (e.value.empty()) break;
    found.push_back(&e);
  }
  return found;
}

bool Ini::has_section(std::string_view section) const {
  return std::ranges::find(sections_, section) != sections_.end();
}

}  // namespace owlint
