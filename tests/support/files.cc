#include "support/files.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>

namespace owlint::test {

namespace fs = std::filesystem;

std::string repository(const std::string& path) { return path.empty() ? OWLINT_SOURCE : OWLINT_SOURCE "/" + path; }

std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  INFO("reading " << path);
  REQUIRE(in.good());
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_file(const std::string& path, const std::string& bytes) {
  // Renamed into place: tests that run at the same time never see half a file.
  const fs::path beside = fs::path(path).parent_path() / (".owlint-new-" + std::to_string(::getpid()));
  std::ofstream out(beside, std::ios::binary | std::ios::trunc);
  out << bytes;
  out.close();
  INFO("writing " << path);
  REQUIRE(out.good());
  fs::rename(beside, path);
}

std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().filename().string()[0] != '.') files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  return files;
}

bool updating() {
  const char* value = std::getenv("OWLINT_UPDATE");
  return value != nullptr && *value != '\0' && *value != '0';
}

Scratch::Scratch() {
  std::string pattern = (fs::temp_directory_path() / "owlint-test-XXXXXX").string();
  REQUIRE(::mkdtemp(pattern.data()) != nullptr);
  path_ = pattern;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string Scratch::write(const std::string& name, const std::string& bytes) const {
  const fs::path path = fs::path(path_) / name;
  fs::create_directories(path.parent_path());
  write_file(path.string(), bytes);
  return path.string();
}

}  // namespace owlint::test
