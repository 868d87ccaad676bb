#include "analyzer/audit/hashes.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include "analyzer/report/report.h"
#include "analyzer/text/files.h"
#include "analyzer/text/paths.h"

namespace owlint::audit {
namespace {

/// The INI as it was read, with where its folders are.
std::string machine_text(const MachineSetup& setup) {
  std::string text = setup.path;
  for (const Ini::Entry& entry : setup.ini.entries())
    text += fmt::format("\n{}\n{}\n{}\n{}\n{}", entry.source->path(), entry.span.begin, entry.section, entry.key,
                        entry.value);
  for (const Ini::Entry& entry : setup.ini.missing_includes())
    text += fmt::format("\n{}\n{}", entry.source->path(), entry.value);
  for (const SearchFolder& folder : setup.search_path->folders()) text += "\n" + file_key(folder.path);
  // What is complained of may hang on whether a folder is there.
  for (const IniFolder& folder : setup.folders) text += folder.exists ? '+' : '-';
  if (setup.tools) text += fmt::format("\n{}\n{}", setup.tools_source->path(), hash_of(setup.tools_source->bytes()));
  return text;
}

}  // namespace

std::string hash_of(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

const std::string& tool_hash() {
  static const std::string hash = [] {
    std::string error;
    const auto self = disk().read("/proc/self/exe", &error);
    return hash_of(self == nullptr ? kToolVersion : self->bytes());
  }();
  return hash;
}

std::string settings_hash(const checking::Settings& settings) {
  const Profile& profile = settings.profile;
  const LintOptions& options = settings.options;
  std::string text = fmt::format(
      "{}\n{} {} {} {} {}\n", tool_hash(), version_text(profile.version), profile.version_given, options.all_versions,
      profile.feature.has_value() ? fmt::format("{}", *profile.feature) : "-", static_cast<int>(options.detail));
  text += fmt::format("{}\n{}\n{}\n", fmt::join(options.select, ","), fmt::join(options.extend_select, ","),
                      fmt::join(options.ignore, ","));
  for (const auto& [code, severity] : options.severity) text += fmt::format("{}={},", code, severity_text(severity));
  for (const std::string& folder : profile.sub_path) text += "\nsub-path " + file_key(folder);
  if (profile.setup != nullptr) text += "\n" + machine_text(*profile.setup);
  if (profile.remapped_perhaps != nullptr)
    text += fmt::format("\nperhaps {}", fmt::join(*profile.remapped_perhaps, ","));
  return hash_of(text);
}

}  // namespace owlint::audit
