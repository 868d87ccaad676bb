// The XML formats: Checkstyle and JUnit.
#include <fmt/format.h>
#include <pugixml.hpp>

#include "analyzer/report/formats.h"

namespace owlint {
namespace {

void save(const pugi::xml_document& document, std::ostream& out) {
  document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
}

pugi::xml_document fresh() {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  return document;
}

/// XML has no U+FFFE and U+FFFF.
std::string allowed(std::string_view text) {
  std::string out(text);
  for (const char* forbidden : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
    for (size_t at = 0; (at = out.find(forbidden, at)) != std::string::npos; at += 3)
      out.replace(at, 3, "\xEF\xBF\xBD");
  }
  return out;
}

void set(pugi::xml_node node, const char* name, std::string_view value) {
  node.append_attribute(name) = allowed(value).c_str();
}

}  // namespace

void write_checkstyle(std::ostream& out, const Reports& files, const ReportStyle& style) {
  pugi::xml_document document = fresh();
  pugi::xml_node root = document.append_child("checkstyle");
  set(root, "version", "4.3");
  for (const FileReport& report : files) {
    pugi::xml_node file = root.append_child("file");
    set(file, "name", shown_path(*report.source, style));
    for (const Finding& f : report.findings) {
      const Position at = source_of(report, f).position(f.span.begin);
      pugi::xml_node error = file.append_child("error");
      set(error, "line", std::to_string(at.line));
      set(error, "column", std::to_string(at.column));
      set(error, "severity", severity_text(f.severity));
      set(error, "message", whole_message(f, "; "));
      set(error, "source", fmt::format("owlint.{}", f.code));
    }
  }
  save(document, out);
}

void write_junit(std::ostream& out, const Reports& files, const ReportStyle& style) {
  pugi::xml_document document = fresh();
  pugi::xml_node root = document.append_child("testsuites");
  size_t tests = 0;
  size_t failures = 0;
  for (const FileReport& file : files) {
    tests += std::max<size_t>(1, file.findings.size());
    failures += file.findings.size();
  }
  set(root, "name", kToolName);
  set(root, "tests", std::to_string(tests));
  set(root, "failures", std::to_string(failures));
  set(root, "errors", "0");
  for (const FileReport& file : files) {
    const std::string path = shown_path(*file.source, style);
    pugi::xml_node suite = root.append_child("testsuite");
    set(suite, "name", path);
    set(suite, "tests", std::to_string(std::max<size_t>(1, file.findings.size())));
    set(suite, "failures", std::to_string(file.findings.size()));
    set(suite, "errors", "0");
    const auto add_case = [&](const std::string& name) {
      pugi::xml_node one = suite.append_child("testcase");
      set(one, "name", name);
      set(one, "classname", path);
      set(one, "file", path);
      return one;
    };
    if (file.findings.empty()) add_case("owlint");
    for (const Finding& f : file.findings) {
      const Source& source = source_of(file, f);
      const Position at = source.position(f.span.begin);
      pugi::xml_node one = add_case(fmt::format("{} {} at {}:{}", f.code, f.rule, at.line, at.column));
      set(one, "line", std::to_string(at.line));
      pugi::xml_node failure = one.append_child("failure");
      set(failure, "message", printable(f.message));
      set(failure, "type", severity_text(f.severity));
      failure.text() =
          allowed(fmt::format("{}:{}:{}\n{}", shown_path(source, style), at.line, at.column, whole_message(f))).c_str();
    }
  }
  save(document, out);
}

}  // namespace owlint
