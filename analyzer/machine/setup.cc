#include "analyzer/machine/setup.h"

#include <algorithm>
#include <charconv>

#include "analyzer/text/paths.h"

namespace owlint {
namespace {

constexpr size_t kMaxSubroutineFolders = 10;  // measured: of those that exist, the eleventh is not searched

std::string_view without_blanks(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Measured: the whole value is one decimal number, or there is none.
std::optional<int32_t> integer_of(const Ini::Entry* entry) {
  if (entry == nullptr) return std::nullopt;
  std::string_view text = entry->value;
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  int32_t number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Switches are compared as integers (measured): `yes`, `true` and 2 switch nothing on, `no` and `false` nothing off.
bool is_number(const Ini::Entry* entry, int wanted) { return integer_of(entry) == wanted; }

class SetupReader {
 public:
  SetupReader(const Files& files, MachineSetup& setup, const std::string& path,
              const std::vector<std::string>& sub_path)
      : files_(files), m_(setup), sub_path_(sub_path), folder_(folder_of(path)) {
    if (folder_.empty()) folder_ = ".";
  }

  void run() {
    const auto rs274 = [&](std::string_view key) { return m_.ini.find("RS274NGC", key); };
    for (const char* key : {"FEATURE", "FEATURES"}) {
      const Ini::Entry* entry = rs274(key);
      if (entry == nullptr || m_.mask) continue;
      m_.mask = parse_mask(entry->value);
      m_.mask_entry = entry;
    }
    m_.warnonly = is_number(rs274("OWORD_WARNONLY"), 1);
    m_.counts_arguments = is_number(rs274("OWORD_NARGS"), 1);
    m_.reads_ini = !is_number(rs274("INI_VARS"), 0);
    m_.reads_hal = !is_number(rs274("HAL_PIN_VARS"), 0);
    m_.no_fanuc = integer_of(rs274("DISABLE_FANUC_STYLE_SUB")).value_or(0) != 0;
    m_.has_remaps = !m_.ini.all("RS274NGC", "REMAP").empty();
    m_.has_python = m_.ini.has_section("PYTHON");
    m_.spindles = integer_of(m_.ini.find("TRAJ", "SPINDLES")).value_or(1);
    m_.change_keeps_spindle = is_on("TOOL_CHANGE_WITH_SPINDLE_ON");
    m_.change_stays = !is_on("TOOL_CHANGE_AT_G30") && !is_on("TOOL_CHANGE_QUILL_UP") &&
        m_.ini.find("EMCIO", "TOOL_CHANGE_POSITION") == nullptr;
    m_.retains_offset = is_number(rs274("RETAIN_G43"), 1);
    read_folders();
    read_user_codes();
    read_calls();
    read_tools();
  }

 private:
  /// Measured: in this section 2 is on as well.
  bool is_on(std::string_view emcio_key) const { return integer_of(m_.ini.find("EMCIO", emcio_key)).value_or(0) != 0; }

  /// LinuxCNC works in the INI's folder.
  std::string seen_from_ini(const std::string& path) const { return joined_path(folder_, expand_home(path)); }

  /// A part of a continued value: where its text is there once, that is the place.
  static Span place_in(const Ini::Entry& entry, std::string_view part) {
    const std::string_view text = entry.source->slice(entry.span);
    part = without_blanks(part);
    const size_t at = part.empty() ? std::string_view::npos : text.find(part);
    if (at == std::string_view::npos || text.find(part, at + 1) != std::string_view::npos) return entry.span;
    return {entry.span.begin + at, entry.span.begin + at + part.size()};
  }

  IniFolder& add_folder(std::string_view key, const Ini::Entry& entry, size_t from, size_t size) {
    IniFolder folder;
    folder.text = entry.value.substr(from, size);
    folder.key = key;
    const std::string path = seen_from_ini(folder.text);
    folder.path = normal_path(path);
    if (folder.path.size() > 1 && folder.path.ends_with('/')) folder.path.pop_back();
    folder.source = entry.source;
    const bool whole = entry.span.end - entry.span.begin != entry.value.size();
    folder.span = whole ? place_in(entry, folder.text) : Span{entry.span.begin + from, entry.span.begin + from + size};
    folder.exists = files_.is_folder(path);
    return m_.folders.emplace_back(std::move(folder));
  }

  void add_list(std::string_view key, const Ini::Entry* entry) {
    if (entry == nullptr) return;
    const std::string& text = entry->value;
    for (size_t at = 0; at <= text.size();) {
      const size_t colon = std::min(text.find(':', at), text.size());
      if (colon > at) add_folder(key, *entry, at, colon - at);
      at = colon + 1;
    }
  }

  void read_folders() {
    std::vector<SearchFolder> search;
    const auto add = [&](const std::string& path, bool tree = false) {
      if (SearchFolder folder{path, tree}; std::ranges::find(search, folder) == search.end())
        search.push_back(std::move(folder));
    };
    add(normal_path(folder_));
    if (const Ini::Entry* prefix = m_.ini.find("DISPLAY", "PROGRAM_PREFIX")) {
      const IniFolder& folder = add_folder("PROGRAM_PREFIX", *prefix, 0, prefix->value.size());
      if (folder.exists) add(folder.path);
      // Measured: for called files, not for user M codes, the value ends at the first blank.
      const std::string word = prefix->value.substr(0, prefix->value.find_first_of(" \t"));
      if (!folder.exists && word != prefix->value && files_.is_folder(seen_from_ini(word)))
        add(normal_path(seen_from_ini(word)));
    }
    const size_t first = m_.folders.size();
    add_list("SUBROUTINE_PATH", m_.ini.find("RS274NGC", "SUBROUTINE_PATH"));
    size_t used = 0;
    for (size_t i = first; i < m_.folders.size(); ++i) {
      if (m_.folders[i].exists && used++ < kMaxSubroutineFolders) add(m_.folders[i].path);
    }
    add_list("NGCGUI_SUBFILE_PATH", m_.ini.find("DISPLAY", "NGCGUI_SUBFILE_PATH"));
    add_list("USER_M_PATH", m_.ini.find("RS274NGC", "USER_M_PATH"));
    if (const Ini::Entry* root = m_.ini.find("WIZARD", "WIZARD_ROOT"))
      add(normal_path(seen_from_ini(root->value)), true);
    for (const std::string& folder : sub_path_) add(folder);
    m_.search_path = std::make_shared<SearchPath>(files_, std::move(search));
  }

  /// Measured: looked for in PROGRAM_PREFIX, `nc_files` if it is not set, and in five folders of USER_M_PATH.
  void read_user_codes() {
    constexpr size_t kMaxFolders = 5;
    std::vector<std::string> folders;
    bool has_prefix = false;
    size_t used = 0;
    for (const IniFolder& folder : m_.folders) {
      const bool prefix = folder.key == "PROGRAM_PREFIX";
      if (!prefix && (folder.key != "USER_M_PATH" || used++ >= kMaxFolders)) continue;
      has_prefix = has_prefix || prefix;
      if (folder.exists) folders.push_back(folder.path);
      m_.user_folders_known = m_.user_folders_known && folder.exists;
    }
    if (!has_prefix) folders.push_back(seen_from_ini("nc_files"));
    for (const std::string& folder : folders) {
      std::string error;
      for (const FolderEntry& entry : files_.list(folder, &error)) {
        int code = 0;
        const std::string& name = entry.name;
        const auto [end, problem] = std::from_chars(name.data() + 1, name.data() + name.size(), code);
        const bool fits = name.size() == 4 && name[0] == 'M' && problem == std::errc{} && end == name.data() + 4;
        if (!fits || code < 100 || code > 199) continue;
        const FileInfo info = files_.info(joined_path(folder, name));
        if (info.executable && info.kind != FileKind::kFolder) m_.user_codes.set(static_cast<size_t>(code - 100));
      }
    }
  }

  void add_call(std::string_view key, const Ini::Entry& entry, std::string name, size_t from, size_t size) {
    const std::string code = "o<" + name + "> call";
    const bool whole = entry.span.end - entry.span.begin != entry.value.size();
    m_.calls.push_back({key, code, std::move(name), entry.source,
                        whole ? entry.span : Span{entry.span.begin + from, entry.span.begin + from + size}});
  }

  void read_calls() {
    for (const Ini::Entry* remap : m_.ini.all("RS274NGC", "REMAP")) {
      constexpr std::string_view kNgc = "ngc=";
      const size_t at = remap->value.find(kNgc);
      if (at == std::string::npos) continue;
      const size_t from = at + kNgc.size();
      const size_t size = std::min(remap->value.find_first_of(" \t", from), remap->value.size()) - from;
      if (size == 0) continue;  // LinuxCNC refuses the line
      add_call("REMAP", *remap, remap->value.substr(from, size), from, size);
    }
    for (const Ini::Entry* file : m_.ini.all("DISPLAY", "NGCGUI_SUBFILE")) {
      if (ending_of(file->value) == ".ngc")
        add_call("NGCGUI_SUBFILE", *file, std::string(stem_of(file->value)), 0, file->value.size());
    }
    const auto add_code = [&](std::string_view section, std::string_view key) {
      for (const Ini::Entry* entry : m_.ini.all(section, key)) {
        m_.calls.push_back({key, std::string(without_blanks(entry->value)), "", entry->source, entry->span});
      }
    };
    add_code("RS274NGC", "RS274NGC_STARTUP_CODE");
    add_code("RS274NGC", "ON_ABORT_COMMAND");
    add_code("HALUI", "MDI_COMMAND");
  }

  /// Measured: the path begins in the INI's folder, `~` is a folder of that name, and without the key it is `tool.tbl`.
  void read_tools() {
    if (m_.ini.find("EMCIO", "DB_PROGRAM") != nullptr) return;
    const Ini::Entry* table = m_.ini.find("EMCIO", "TOOL_TABLE");
    const std::string path = normal_path(joined_path(folder_, table == nullptr ? "tool.tbl" : table->value));
    std::string error;
    m_.tools_source = files_.read(path, &error);
    if (m_.tools_source == nullptr) return;
    const bool random = is_on("RANDOM_TOOLCHANGER");
    m_.tools = read_tool_table(m_.tools_source->bytes(), random ? ToolChanger::kRandom : ToolChanger::kFixed);
  }

  const Files& files_;
  MachineSetup& m_;
  const std::vector<std::string>& sub_path_;
  std::string folder_;
};

}  // namespace

std::optional<uint32_t> parse_mask(std::string_view text) {
  text = without_blanks(text);
  int base = 10;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    text.remove_prefix(2);
    base = 16;
  }
  uint32_t mask = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), mask, base);
  if (problem != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return mask;
}

UserCode MachineSetup::user_code(int code) const {
  if (user_codes.test(static_cast<size_t>(code - 100))) return UserCode::kThere;
  return user_folders_known ? UserCode::kMissing : UserCode::kUnknown;
}

bool has_file(const MachineSetup& setup, const IniCall& call, const std::string& name) {
  if (setup.search_path->find(name)) return true;
  const Files& files = setup.search_path->files();
  return call.key == "NGCGUI_SUBFILE" && std::ranges::any_of(setup.folders, [&](const IniFolder& folder) {
           return folder.key == "NGCGUI_SUBFILE_PATH" && files.exists(joined_path(folder.path, name + ".ngc"));
         });
}

std::shared_ptr<const MachineSetup> read_setup(const Files& files, const std::string& path, std::string* error,
                                               const std::vector<std::string>& sub_path) {
  auto setup = std::make_shared<MachineSetup>();
  setup->path = path;
  if (!setup->ini.read(files, path, error)) return nullptr;
  setup->text.parse(files, setup->ini.source());
  SetupReader(files, *setup, path, sub_path).run();
  return setup;
}

}  // namespace owlint
