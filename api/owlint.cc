#include "api/owlint.hpp"

#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>

#include "analyzer/checking/settings.h"
#include "analyzer/report/report.h"
#include "api/owlint.h"

namespace owlint::api {
namespace {

std::optional<std::string> given(const std::string& text) { return text.empty() ? std::nullopt : std::optional(text); }

Place place(const Source& source, uint64_t offset) {
  const Position at = source.position(offset);
  return {at.line, at.column, at.offset};
}

}  // namespace

std::vector<Finding> check(std::string_view text, const Options& options) {
  checking::CheckRequest line;
  line.isolated = true;  // a program that embeds owlint says what it wants
  line.find_ini = false;
  line.ini = given(options.ini);
  line.linuxcnc = given(options.linuxcnc);
  line.feature = given(options.feature);
  const std::string path = options.path.empty() ? "program.ngc" : options.path;
  checking::Configuration configuration(disk(), line);
  checking::Settings settings;
  std::string error;
  if (!configuration.settings_for(path, &settings, &error)) throw std::invalid_argument(error);
  Library library(disk());
  const ProgramReport report = lint(library.load(Source::own(path, std::string(text)), settings.profile),
                                    settings.profile, settings.options, library);
  std::vector<Finding> out;
  for (const owlint::Finding& f : report.own.findings) {
    const Severity severity = f.severity == owlint::Severity::kError ? Severity::kError
        : f.severity == owlint::Severity::kWarning                   ? Severity::kWarning
                                                                     : Severity::kInfo;
    const Source& source = *report.own.source;
    out.push_back({std::string(f.code), std::string(f.rule), severity, f.stops, printable(f.message),
                   printable(f.interpreter), printable(f.help), place(source, f.span.begin),
                   place(source, f.span.end)});
  }
  return out;
}

std::string_view version() { return kToolVersion; }

}  // namespace owlint::api

// --- for C ---

struct owlint_report {
  std::vector<owlint::api::Finding> findings;
  std::vector<owlint_finding> views;
};

owlint_report* owlint_check(const char* text, size_t size, const owlint_options* options, char** error) {
  const auto copy = [](const char* given) { return given == nullptr ? std::string() : std::string(given); };
  try {
    owlint::api::Options all;
    if (options != nullptr)
      all = {copy(options->path), copy(options->ini), copy(options->linuxcnc), copy(options->feature)};
    auto report = std::make_unique<owlint_report>();
    report->findings = owlint::api::check({text, size}, all);
    for (const owlint::api::Finding& f : report->findings) {
      report->views.push_back({f.code.c_str(), f.rule.c_str(), static_cast<owlint_severity>(f.severity),
                               f.stops ? 1 : 0, f.message.c_str(), f.interpreter.c_str(), f.help.c_str(), f.begin.line,
                               f.begin.column, f.end.line, f.end.column, f.begin.offset, f.end.offset});
    }
    return report.release();
  } catch (const std::exception& problem) {
    // No exception may get into a C program.
    if (error != nullptr) *error = ::strdup(problem.what());
    return nullptr;
  }
}

size_t owlint_count(const owlint_report* report) { return report->views.size(); }

const owlint_finding* owlint_get(const owlint_report* report, size_t index) {
  return index < report->views.size() ? &report->views[index] : nullptr;
}

void owlint_free(owlint_report* report) { delete report; }

void owlint_free_text(char* text) { std::free(text); }

const char* owlint_version(void) { return owlint::kToolVersion.data(); }
