#include "analyzer/machine/ini_text.h"

#include <algorithm>

#include "analyzer/machine/ini.h"
#include "analyzer/text/paths.h"

namespace owlint {
namespace {

constexpr std::string_view kIniBlanks = " \t\r\n\v\f";
constexpr std::string_view kIncludeWord = "#INCLUDE";

/// The part of a text without blanks at its ends, as offsets in it.
Span trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(kIniBlanks);
  if (first == std::string_view::npos) return {text.size(), text.size()};
  return {first, text.find_last_not_of(kIniBlanks) + 1};
}

Span moved(Span span, uint64_t by) { return {span.begin + by, span.end + by}; }

}  // namespace

std::string_view ini_include(std::string_view line) {
  if (!line.starts_with(kIncludeWord)) return {};
  const std::string_view rest = line.substr(kIncludeWord.size());
  const Span name = trimmed(rest);
  return rest.substr(name.begin, name.end - name.begin);
}

std::string_view section_family(std::string_view section) {
  for (const std::string_view family : {"JOINT_", "AXIS_", "SPINDLE_"}) {
    if (section.starts_with(family)) return family;
  }
  return section;
}

void IniText::parse(const Files& files, const std::shared_ptr<const Source>& source) {
  read(files, source, false);
  for (size_t i = 0; i < sections_.size(); ++i) sections_[i].first = first_.emplace(sections_[i].name, i).second;
}

void IniText::read(const Files& files, const std::shared_ptr<const Source>& source, bool included) {
  const auto index = static_cast<uint32_t>(sources_.size());
  sources_.push_back(source);
  const std::string_view bytes = source->bytes();
  uint32_t number = 1;
  for (size_t at = 0; at < bytes.size(); ++number) {
    if (lines_.size() >= kMostIniLines || number > kMostIniLines) {
      cut_short_ = true;
      return;
    }
    const size_t feed = bytes.find('\n', at);
    const std::string_view text = bytes.substr(at, feed == std::string_view::npos ? feed : feed - at);
    const std::string_view name = included ? std::string_view{} : ini_include(text);
    std::string error;
    const auto found =
        name.empty() ? nullptr : files.read(joined_path(folder_of(source->path()), expand_home(name)), &error);
    if (found != nullptr && sources_.size() < kMostIniLines) {
      read(files, found, true);
    } else {
      add(text, index, at, number, feed != std::string_view::npos);
    }
    if (feed == std::string_view::npos) return;
    at = feed + 1;
  }
}

void IniText::add(std::string_view text, uint32_t source, uint64_t offset, uint32_t number, bool ended) {
  IniLine line;
  line.continuation = continued_;
  line.continued = continued_ = text.ends_with('\\');
  line.source = source;
  line.number = number;
  line.ended = ended;
  const Span inner = trimmed(text);
  if (inner.begin == inner.end) return;
  line.span = moved(inner, offset);
  const std::string_view body = text.substr(inner.begin, inner.end - inner.begin);
  const size_t equals = body.find('=');
  if (body[0] == '#' || body[0] == ';') {
    line.kind = IniLine::Kind::kComment;
  } else if (body[0] == '[') {
    const size_t close = body.find(']');
    line.kind = close == std::string_view::npos ? IniLine::Kind::kOpenSection : IniLine::Kind::kSection;
    const size_t end = std::min(close, body.size());
    line.name = moved({1, end}, line.span.begin);
    const std::string_view rest = close == std::string_view::npos ? std::string_view{} : body.substr(close + 1);
    line.value = moved(trimmed(rest), line.span.end - rest.size());
    if (close != std::string_view::npos) sections_.push_back({std::string(body.substr(1, end - 1)), lines_.size()});
  } else if (equals != std::string_view::npos) {
    line.kind = IniLine::Kind::kKey;
    line.name = moved({0, body.find_first_of(" \t=")}, line.span.begin);
    line.value = moved(trimmed(body.substr(equals + 1)), line.span.begin + equals + 1);
  } else {
    line.name = moved({0, std::min(body.find_first_of(" \t"), body.size())}, line.span.begin);
    line.value = {line.span.end, line.span.end};
  }
  line.section = static_cast<int32_t>(sections_.size()) - 1;
  lines_.push_back(line);
}

const IniLine* IniText::line_at(const Source& source, uint64_t offset) const {
  const auto found = std::ranges::find_if(lines_, [&](const IniLine& line) {
    return sources_[line.source]->path() == source.path() && line.span.begin <= offset && offset <= line.span.end;
  });
  return found == lines_.end() ? nullptr : &*found;
}

}  // namespace owlint
