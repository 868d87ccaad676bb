#include "analyzer/machine/ini.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace owlint {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr std::string_view kInclude = "#INCLUDE";

std::string_view trim(std::string_view text) {
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// Measured: what stands behind this many bytes counts as a line of its own.
constexpr size_t kLongestLine = 255;

/// The bytes of the line at `from`, without its end; moves `from` behind it.
std::string_view next_line(std::string_view bytes, size_t* from) {
  std::string_view line = bytes.substr(*from, kLongestLine);
  const size_t feed = line.find('\n');
  line = line.substr(0, feed);
  *from += line.size() + (feed == std::string_view::npos ? 0 : 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

std::string expand_home(std::string_view path) {
  const char* home = std::getenv("HOME");
  if (home == nullptr || (path != "~" && !path.starts_with("~/"))) return std::string(path);
  return home + std::string(path.substr(1));
}

bool Ini::read(const std::string& path, std::string* error) {
  const auto source = Source::map(path, error);
  if (source == nullptr) return false;
  parse(source);
  return true;
}

void Ini::parse(const std::shared_ptr<const Source>& source) {
  source_ = source;
  parse_file(source, false);
}

void Ini::open_section(std::string_view name) {
  section_ = name;
  // LinuxCNC looks no further than the end of the first section of a name; a line `[` without `]` ends one too.
  counts_ = !name.empty() && std::ranges::find(sections_, name) == sections_.end();
  if (counts_) sections_.emplace_back(name);
}

/// Measured: the start script puts the file's text in the place of the line; an `#INCLUDE` in it is a comment.
void Ini::include(const std::shared_ptr<const Source>& source, Span name) {
  std::filesystem::path file = expand_home(source->slice(name));
  if (file.is_relative()) file = std::filesystem::path(source->path()).parent_path() / file;
  std::string error;
  if (const auto included = Source::map(file.string(), &error); included != nullptr) {
    parse_file(included, true);
  } else {
    missing_includes_.push_back({"", std::string(kInclude), std::string(source->slice(name)), source, name});
  }
}

void Ini::parse_file(const std::shared_ptr<const Source>& source, bool included) {
  const std::string_view bytes = source->bytes();
  const auto span_of = [&](std::string_view piece) {
    const auto begin = static_cast<uint64_t>(piece.data() - bytes.data());
    return Span{begin, begin + piece.size()};
  };
  std::string joined;  // of a continued line
  for (size_t at = 0; at < bytes.size();) {
    const std::string_view raw = next_line(bytes, &at);
    if (raw.starts_with(kInclude) && !included) {
      const std::string_view name = trim(raw.substr(kInclude.size()));
      if (!name.empty()) include(source, span_of(name));
      continue;
    }
    std::string_view line = trim(raw);
    std::string_view last = raw;
    if (raw.ends_with('\\') && at < bytes.size()) {
      joined.clear();
      while (last.ends_with('\\') && at < bytes.size()) {
        joined += last.substr(0, last.size() - 1);
        last = next_line(bytes, &at);
      }
      joined += last;
      line = trim(joined);
    }
    if (line.empty() || line[0] == '#' || line[0] == ';') continue;
    if (line[0] == '[') {
      const size_t close = line.find(']');
      open_section(close == std::string_view::npos ? std::string_view{} : line.substr(1, close - 1));
      continue;
    }
    const size_t equals = line.find('=');
    if (equals == std::string_view::npos || !counts_) continue;
    const std::string_view key = line.substr(0, line.find_first_of(" \t="));
    const std::string_view value = trim(line.substr(equals + 1));
    Span span = span_of(trim(raw));
    if (last.data() == raw.data()) {
      span = {span.end - value.size(), span.end};
    } else {
      span.end = span_of(trim(last)).end;
    }
    entries_.push_back({section_, std::string(key), std::string(value), source, span});
  }
}

const Ini::Entry* Ini::find(std::string_view section, std::string_view key) const {
  const auto found = std::ranges::find_if(entries_, [&](const Entry& e) { return e.section == section && e.key == key; });
  return found == entries_.end() || found->value.empty() ? nullptr : &*found;
}

std::vector<const Ini::Entry*> Ini::all(std::string_view section, std::string_view key) const {
  std::vector<const Entry*> found;
  for (const Entry& e : entries_) {
    if (e.section == section && e.key == key && !e.value.empty()) found.push_back(&e);
  }
  return found;
}

bool Ini::has_section(std::string_view section) const { return std::ranges::find(sections_, section) != sections_.end(); }

}  // namespace owlint
