#include "analyzer/lsp/workspace.h"

#include <fmt/format.h>

#include "analyzer/checking/groups.h"
#include "analyzer/checking/run.h"
#include "analyzer/checking/walk.h"
#include "analyzer/lsp/ini_document.h"
#include "analyzer/text/paths.h"

namespace owlint::lsp {
namespace {

/// Findings in one number, so that the client can be told that nothing has changed.
std::string fingerprint(const std::vector<Finding>& findings) {
  size_t hash = findings.size();
  const auto add = [&hash](auto value) { hash = hash * 0x9E3779B97F4A7C15ULL + std::hash<decltype(value)>()(value); };
  for (const Finding& f : findings) {
    add(f.code);
    add(f.span.begin);
    add(f.span.end);
    add(static_cast<int>(f.severity));
    add(std::string_view(f.message));
    for (const Related& r : f.related) add(r.span.begin);
  }
  return fmt::format("{:x}", hash);
}

}  // namespace

Workspace::Workspace(const Files& saved)
    : files_(saved, [this](const std::string& path) { return text_of_open(path); }) {
  forget_files();
}

void Workspace::configure(const Json& settings) {
  line_ = {};
  line_.absolute = true;  // uris are made of the paths that findings name
  line_.walk.takes_inis = true;
  const auto text = [&](const char* key, std::optional<std::string>* into) {
    if (settings.contains(key) && settings.at(key).is_string() && !settings.at(key).get<std::string>().empty())
      *into = settings.at(key).get<std::string>();
  };
  const auto list = [&](const char* key, std::vector<std::string>* into) {
    if (!settings.contains(key) || !settings.at(key).is_array()) return;
    for (const Json& entry : settings.at(key)) {
      if (entry.is_string()) into->push_back(entry.get<std::string>());
    }
  };
  if (settings.is_object()) {
    text("ini", &line_.ini);
    text("feature", &line_.feature);
    text("linuxcnc", &line_.linuxcnc);
    text("config", &line_.config);
    list("sub-path", &line_.sub_path);
    list("select", &line_.select);
    list("extend-select", &line_.extend_select);
    list("ignore", &line_.ignore);
    if (settings.contains("images") && settings.at("images").is_boolean()) client_shows_images = settings.at("images");
  }
  forget_files();
}

void Workspace::add_folder(const std::string& uri) {
  const std::string path = path_of_uri(uri);
  if (std::ranges::find(folders_, path) == folders_.end()) folders_.push_back(path);
}

void Workspace::remove_folder(const std::string& uri) { std::erase(folders_, path_of_uri(uri)); }

Document& Workspace::open(const std::string& uri, std::string text, std::optional<int64_t> version) {
  const std::string path = path_of_uri(uri);
  auto& document = open_[uri];
  document = std::make_unique<Document>(uri, path, std::move(text), encoding);
  document->version = version;
  uri_of_[file_key(path)] = uri;
  forget_file(path);
  if (is_ini(path)) forget_machines();
  return *document;
}

void Workspace::close(const std::string& uri) {
  const auto found = open_.find(uri);
  if (found == open_.end()) return;
  const std::string path = found->second->path();
  uri_of_.erase(file_key(path));
  open_.erase(found);
  checked_.erase(uri);
  known_calls_.erase(file_key(path));
  sent_tokens.erase(uri);
  forget_file(path);
  if (is_ini(path)) forget_machines();
}

Document* Workspace::find_open(const std::string& uri) {
  const auto found = open_.find(uri);
  return found == open_.end() ? nullptr : found->second.get();
}

const Document& Workspace::document(const std::string& uri) {
  if (const Document* found = find_open(uri)) return *found;
  if (const Document* found = document_of_path(path_of_uri(uri))) return *found;
  throw ResponseError{ErrorCode::kRequestFailed, "no such file: " + uri};
}

const Document* Workspace::document_of_path(const std::string& path) {
  if (const auto shadow = uri_of_.find(file_key(path)); shadow != uri_of_.end()) return open_.at(shadow->second).get();
  auto& document = on_disk_[path];
  if (document == nullptr) {
    std::string error;
    const auto source = files_.read(path, &error);
    if (source == nullptr) {
      on_disk_.erase(path);
      return nullptr;
    }
    document = std::make_unique<Document>(uri_of_path(path), path, std::string(source->bytes()), encoding);
  }
  return document.get();
}

std::vector<Document*> Workspace::open_documents() {
  std::vector<Document*> all;
  for (const auto& [uri, document] : open_) all.push_back(document.get());
  return all;
}

void Workspace::forget_files() {
  known_calls_.clear();  // the machine may be another one
  on_disk_.clear();
  called_files_.reset();
  everything_.reset();
  configuration_ = std::make_unique<checking::Configuration>(files_, line_);
  library_ = std::make_unique<Library>(files_);
}

/// An INI has changed: what was read of it, and what was found with it.
void Workspace::forget_machines() {
  known_calls_.clear();
  everything_.reset();
  configuration_ = std::make_unique<checking::Configuration>(files_, line_);
  library_ = std::make_unique<Library>(files_);
}

void Workspace::forget_file(const std::string& path) {
  everything_.reset();
  on_disk_.erase(path);
  library_->forget(path);
}

std::shared_ptr<const Source> Workspace::text_of_open(const std::string& path) const {
  const auto shadow = uri_of_.find(file_key(path));
  return shadow == uri_of_.end() ? nullptr : open_.at(shadow->second)->source();
}

std::vector<std::string> Workspace::program_files() {
  std::vector<std::string> files;
  for (checking::WalkedFile& file : checking::walk(files_, folders_, {}, [this](const std::string& folder) {
                                      return configuration_->patterns_in(folder);
                                    }).files)
    files.push_back(std::move(file.path));
  std::set<std::string> known;
  for (const std::string& file : files) known.insert(file_key(file));
  for (const auto& [key, uri] : uri_of_) {
    if (!is_ini(key) && known.insert(key).second) files.push_back(open_.at(uri)->path());
  }
  return files;
}

/// Those of machines, below the workspace folders.
std::vector<std::string> Workspace::ini_files() {
  checking::WalkOptions all;
  all.takes_inis = true;
  std::vector<std::string> files;
  for (checking::WalkedFile& file : checking::walk(files_, folders_, all, [this](const std::string& folder) {
                                      return configuration_->patterns_in(folder);
                                    }).files) {
    if (is_ini(file.path)) files.push_back(std::move(file.path));
  }
  return files;
}

std::set<std::string> Workspace::related(const Document& document) const {
  std::set<std::string> uris{document.uri()};
  const std::string key = file_key(document.path());
  for (const auto& [uri, checked] : checked_) {
    for (const std::string& path : checked.calls) {
      const auto callee = uri_of_.find(file_key(path));
      if (file_key(path) == key) uris.insert(uri);
      if (uri == document.uri() && callee != uri_of_.end()) uris.insert(callee->second);
    }
  }
  return uris;
}

bool Workspace::settings_for(const std::string& path, checking::Settings* settings) {
  std::string error;
  if (is_ini(path) && !is_machine_ini(files_, path)) return false;  // another program's
  return configuration_->settings_for(path, settings, &error);
}

/// Files that others call are not programs, whatever else is in them: for that the whole workspace has to be known.
void Workspace::read_all() {
  if (called_files_) return;
  called_files_.emplace();
  const std::vector<std::string> files = program_files();
  for (size_t i = 0; i < files.size(); ++i) {
    const std::string& path = files[i];
    progress("owlint: reading programs", i, files.size());
    const Document* document = document_of_path(path);
    if (document == nullptr) continue;
    const Program& p = document->program();
    if (p.calls.empty()) continue;
    const auto folders = search_path(*document);
    for (const Call& call : p.calls) {
      if (call.callee == kNoName || call.target != kNoRegion) continue;
      const auto called = folders->find(p.name(call.callee));
      if (called && called->regular && file_key(called->path) != file_key(path))
        called_files_->insert(file_key(called->path));
    }
  }
  progress("owlint: reading programs", files.size(), files.size());
}

/// The findings of each of `files`, with what those of them that are programs say of the others.
std::map<std::string, Checked> Workspace::run(const std::vector<std::string>& files) {
  std::vector<checking::Settings> settings(files.size());
  std::vector<const checking::Settings*> wanted;
  for (size_t i = 0; i < files.size(); ++i) {
    wanted.push_back(settings_for(files[i], &settings[i]) ? &settings[i] : nullptr);
    if (uri_of_.contains(file_key(files[i]))) settings[i].options.known_calls = &known_calls_[file_key(files[i])];
  }
  read_all();
  const char* const work = "owlint: checking programs";
  const auto tell = [&](size_t done) { progress(work, done, files.size()); };
  checking::RunResult result = checking::run_checks(files, wanted, *library_, *called_files_, tell);
  progress(work, files.size(), files.size());
  std::map<std::string, Checked> out;
  std::map<std::string, std::string> path_of;
  for (size_t i = 0; i < files.size(); ++i) {
    // Calls that were written since the workspace was read.
    for (const std::string& path : result.calls[i]) {
      if (file_key(path) != file_key(files[i])) called_files_->insert(file_key(path));
    }
    out[files[i]].calls = std::move(result.calls[i]);
    path_of[file_key(files[i])] = files[i];
  }
  for (FileReport& report : result.reports) {
    checking::fold_groups({&report, 1}, {});  // an editor shows each file by itself
    const auto found = path_of.find(file_key(report.source->path()));
    if (found != path_of.end()) out[found->second].findings = std::move(report.findings);
  }
  for (auto& [path, checked] : out) checked.result_id = fingerprint(checked.findings);
  return out;
}

/// The open programs that are checked for the machine of an INI.
std::set<std::string> Workspace::open_on_machine(const std::string& ini) {
  std::set<std::string> uris;
  for (const auto& [uri, document] : open_) {
    if (is_ini(document->path())) continue;
    const Profile profile = profile_of(*document);
    if (profile.setup != nullptr && file_key(profile.setup->path) == file_key(ini)) uris.insert(uri);
  }
  return uris;
}

std::vector<std::string> Workspace::check(const std::string& uri) {
  const Document* changed = find_open(uri);
  if (changed == nullptr) return {};
  everything_.reset();
  std::set<std::string> uris;
  if (is_ini(changed->path())) {
    uris = open_on_machine(changed->path());
    forget_machines();
    uris.merge(open_on_machine(changed->path()));
    uris.insert(uri);
  } else {
    uris = related(*changed);
  }
  std::vector<std::string> files;
  for (const std::string& one : uris) {
    files.push_back(open_.at(one)->path());
    library_->forget(files.back());
  }
  std::map<std::string, Checked> found = run(files);
  for (const std::string& one : uris) checked_[one] = std::move(found[open_.at(one)->path()]);
  return {uris.begin(), uris.end()};
}

const std::map<std::string, Checked>& Workspace::check_everything() {
  if (!everything_) {
    std::vector<std::string> files = program_files();
    std::ranges::move(ini_files(), std::back_inserter(files));
    everything_ = run(files);
  }
  return *everything_;
}

const Checked* Workspace::checked(const std::string& uri) const {
  const auto found = checked_.find(uri);
  return found == checked_.end() ? nullptr : &found->second;
}

Checked Workspace::check_alone(const std::string& path) { return run({path})[path]; }

Profile Workspace::profile_of(const Document& document) {
  checking::Settings settings;
  settings_for(document.path(), &settings);
  return settings.profile;
}

std::shared_ptr<const SearchPath> Workspace::search_path(const Document& from) {
  return library_->search_path(from.path(), profile_of(from));
}

std::string Workspace::called_file(const Document& from, const std::string& name) {
  const auto found = search_path(from)->find(name);
  return found && found->regular ? found->path : std::string();
}

std::vector<std::string> Workspace::callable_files(const Document& from) { return search_path(from)->names(); }

}  // namespace owlint::lsp
