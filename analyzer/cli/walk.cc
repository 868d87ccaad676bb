#include "analyzer/cli/walk.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <unordered_set>

#include "analyzer/text/source.h"

namespace owlint::cli {
namespace {

namespace fs = std::filesystem;

bool is_program(const fs::path& path) {
  static constexpr std::array<std::string_view, 5> kEndings = {".ngc", ".nc", ".tap", ".cnc", ".gcode"};
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

void walk_folder(const std::string& folder, Walk* out) {
  std::vector<std::string> found;
  std::error_code problem;
  fs::recursive_directory_iterator at(folder, problem);
  if (problem) {
    out->problems.push_back(folder + ": " + problem.message());
    return;
  }
  while (at != fs::recursive_directory_iterator()) {
    const fs::path& path = at->path();
    std::error_code unreadable;
    const bool hidden = path.filename().string().starts_with(".");
    if (at->is_directory(unreadable)) {
      if (hidden) at.disable_recursion_pending();
    } else if (!hidden && is_program(path) && at->is_regular_file(unreadable)) {
      found.push_back(path.lexically_normal().string());
    }
    const fs::path current = path;
    at.increment(problem);
    if (problem) {
      out->problems.push_back(current.string() + ": " + problem.message());
      problem.clear();
    }
  }
  std::ranges::sort(found);
  if (found.empty()) out->empty.push_back(folder);
  std::ranges::move(found, std::back_inserter(out->files));
}

}  // namespace

Walk walk(const std::vector<std::string>& paths) {
  Walk out;
  for (const std::string& path : paths) {
    std::error_code problem;
    if (path != "-" && fs::is_directory(path, problem)) {
      walk_folder(path, &out);
    } else {
      out.files.push_back(path);
    }
  }
  std::unordered_set<std::string> seen;
  std::erase_if(out.files, [&](const std::string& file) { return !seen.insert(file_key(file)).second; });
  return out;
}

}  // namespace owlint::cli
