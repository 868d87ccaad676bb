#include "support/bundle.h"

#include <sstream>

#include <catch2/catch.hpp>

#include "support/process.h"

namespace owlint::test {
namespace {

const std::string kMark = "; file: ";
const std::string kMain = "program.ngc";

}  // namespace

bool is_bundle(const std::string& text) { return text.find("\n" + kMark) != std::string::npos; }

void unpack(const std::string& text, const Scratch& folder) {
  std::istringstream in(text);
  std::string name = kMain;
  std::string bytes;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kMark)) {
      folder.write(name, bytes);
      name = line.substr(kMark.size());
      bytes.clear();
    } else {
      bytes += line + "\n";
    }
  }
  folder.write(name, bytes);
}

nlohmann::json findings_of_bundle(const std::string& text, const std::string& options) {
  const Scratch folder;
  unpack(text, folder);
  std::vector<std::string> arguments{"check", "--isolated", "--no-find-ini", "--format", "json", "."};
  const std::vector<std::string> more = words(options);
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Run run = owlint(arguments, "", folder.path());
  INFO(text << run.err);
  REQUIRE(run.status < 2);
  nlohmann::json findings = nlohmann::json::array();
  const nlohmann::json report = nlohmann::json::parse(run.out);
  for (const auto& file : report["files"]) {
    for (nlohmann::json finding : file["findings"]) {
      if (file["path"] != kMain) finding["file"] = file["path"];
      findings.push_back(std::move(finding));
    }
  }
  return findings;
}

}  // namespace owlint::test
