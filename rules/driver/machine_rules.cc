#include "rules/driver/machine_rules.h"

#include <algorithm>

namespace owlint::rules {

void nothing_in_programs(const Input&, Reporter&) {}

Finding& add_at(const SetupInput& in, Reporter& out, const IniLine& line, Span span, std::string message) {
  return out.add(in.setup.text.source(line), span, std::move(message));
}

Finding& add_at(const SetupInput& in, Reporter& out, const IniLine& line, std::string message) {
  return add_at(in, out, line, line.span, std::move(message));
}

void refuses(Finding& finding, std::string message) {
  finding.stops = true;
  finding.reach = Reach::kAlways;
  finding.interpreter = std::move(message);
}

void refuses_machine(const SetupInput& in, Finding& finding, std::string message) {
  if (is_whole_machine(in)) {
    refuses(finding, std::move(message));
  } else {
    finding.interpreter = std::move(message);
  }
}

bool is_whole_machine(const SetupInput& in) {
  const Ini::Entry* version = in.setup.ini.find("EMC", "VERSION");
  return version != nullptr && version_meant(version->value) == "1.1" && in.profile.version >= Version::k2_8 &&
      !reads_strictly(in);
}

std::string_view version_meant(std::string_view value) {
  const size_t comment = comment_in(value);
  return comment == std::string_view::npos ? value : value.substr(0, value.find_last_not_of(" \t", comment - 1) + 1);
}

bool reads_strictly(const SetupInput& in) { return in.profile.version >= Version::k2_10; }

std::vector<const IniLine*> lines_of(const IniText& text, std::string_view section) {
  std::vector<const IniLine*> lines;
  const IniText::Section* found = text.find_section(section);
  if (found == nullptr) return lines;
  for (size_t i = found->line + 1; i < text.lines().size(); ++i) {
    const IniLine& line = text.lines()[i];
    const bool bracket = line.kind == IniLine::Kind::kSection || line.kind == IniLine::Kind::kOpenSection;
    if (bracket && !line.continuation) break;
    if (!line.continuation && line.kind != IniLine::Kind::kComment) lines.push_back(&line);
  }
  return lines;
}

const IniLine* find_line(const IniText& text, std::string_view section, std::string_view key) {
  for (const IniLine* line : lines_of(text, section)) {
    if (text.name(*line) != key) continue;
    if (line->kind == IniLine::Kind::kKey) return line->value.begin == line->value.end ? nullptr : line;
    if (line->name.end != line->span.end) return nullptr;  // a key, a blank, and no `=`
  }
  return nullptr;
}

size_t comment_in(std::string_view value) {
  for (size_t at = 1; at < value.size(); ++at) {
    if ((value[at] == '#' || value[at] == ';') && (value[at - 1] == ' ' || value[at - 1] == '\t')) return at;
  }
  return std::string_view::npos;
}

Fix comment_above(const IniText& text, const IniLine& line, size_t comment) {
  const Source& source = *text.source(line);
  const std::string_view value = text.value(line);
  const std::string_view kept = value.substr(0, value.find_last_not_of(" \t", comment - 1) + 1);
  const Span whole = source.line(line.number);
  const std::string_view before = source.slice({whole.begin, line.value.begin});
  const std::string_view indent = before.substr(0, std::min(before.find_first_not_of(" \t"), before.size()));
  const char* const end = source.slice(whole).ends_with('\r') ? "\r\n" : "\n";
  std::string replaced(indent);
  replaced += value.substr(comment);
  replaced += end;
  replaced += before;
  replaced += kept;
  return {"move the comment onto a line of its own", true, {{{whole.begin, line.value.end}, std::move(replaced)}}};
}

Fix write_value(const IniLine& line, std::string value, bool safe) {
  std::string title = "write `" + value + "`";
  return {std::move(title), safe, {{line.value, std::move(value)}}};
}

}  // namespace owlint::rules
