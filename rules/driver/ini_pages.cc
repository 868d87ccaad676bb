// Depends on (read in their source): where ngcgui looks for its files, and which it refuses.
#include "rules/driver/ini_pages.h"

#include <algorithm>

#include "analyzer/machine/ngcgui_file.h"
#include "analyzer/text/paths.h"

namespace owlint::rules {
namespace {

constexpr size_t kMostPages = 200;  // a machine has a few

class Pages {
 public:
  Pages(const SetupInput& in, Reporter& out) : in_(in), out_(out), text_(in.setup.text) {}

  /// Files of which ngcgui makes pages.
  void check_pages() {
    size_t count = 0;
    for (const IniLine* line : lines_of(text_, "DISPLAY")) {
      const std::string_view key = text_.name(*line);
      const bool sub = key == "NGCGUI_SUBFILE";
      if (!sub && key != "NGCGUI_PREAMBLE" && key != "NGCGUI_POSTAMBLE") continue;
      if (line->continued || ++count > kMostPages) continue;
      const std::string name(text_.value(*line));
      const std::string ending(ending_of(name));
      if (name.find('/') != std::string::npos || (ending != ".ngc" && ending != ".nc")) continue;
      std::string path = file_in(in_, "NGCGUI_SUBFILE_PATH", name);
      if (path.empty()) path = file_in(in_, "PROGRAM_PREFIX", name);
      if (!path.empty() && sub) check_page(*line, name, path);
      const bool missing = path.empty() && !sub && in_.setup.ini.find("DISPLAY", "NGCGUI_SUBFILE_PATH") != nullptr &&
          has_all_folders(in_, "NGCGUI_SUBFILE_PATH") && has_all_folders(in_, "PROGRAM_PREFIX");
      if (!missing) continue;
      Finding& f = add_at(in_, out_, *line, line->value,
                          "there is no file `" + name + "` in the folders of `NGCGUI_SUBFILE_PATH`");
      f.help = "put the file there, or correct the name";
    }
  }

 private:
  void check_page(const IniLine& line, const std::string& name, const std::string& path) {
    using Kind = NgcguiProblem::Kind;
    std::string error;
    const auto source = in_.library.files().read(path, &error);
    if (source == nullptr) return;
    const std::string stem(stem_of(name));
    const auto problem = ngcgui_problem(stem, source->bytes());
    if (!problem) return;
    const auto [message, help] = [&]() -> std::pair<std::string, std::string> {
      switch (problem->kind) {
        case Kind::kGenerated: return {"ngcgui has written this file itself", "name the file with the sub"};
        case Kind::kNotASubfile: return {"the file is marked `(not_a_subfile)`", "name another file"};
        case Kind::kNumberedSub: return {"a numbered sub is in the file", "put it into a file of its own"};
        case Kind::kSeveralSubs: return {"the file has a second sub", "put it into a file of its own"};
        case Kind::kOtherName:
          return {"the label is not the file's name, `" + stem + "`", "write it so: capitals count here"};
        case Kind::kCodeBefore: return {"there is code before the sub", "only comments may be there"};
        case Kind::kCodeBehind: return {"there is code behind the sub", "only comments and `M2` may be there"};
        case Kind::kOutOfSequence:
          return {"arguments get their names out of order", "name `#1` first, then `#2` and so on"};
        case Kind::kNoSub: return {"the file has no sub", "write one with the file's name"};
        case Kind::kNoEnd: break;
      }
      return {"the sub has no `endsub`", "close it"};
    }();
    Finding& f = add_at(in_, out_, line, line.value, "ngcgui refuses this file: " + message);
    f.help = help;
    f.interpreter = problem->message;
    if (problem->span.end > problem->span.begin) f.related.push_back({problem->span, "this line", source});
  }

  const SetupInput& in_;
  Reporter& out_;
  const IniText& text_;
};

}  // namespace

bool has_all_folders(const SetupInput& in, std::string_view key) {
  const auto& folders = in.setup.folders;
  return std::ranges::all_of(folders, [&](const IniFolder& folder) { return folder.key != key || folder.exists; });
}

std::string file_in(const SetupInput& in, std::string_view key, const std::string& name) {
  for (const IniFolder& folder : in.setup.folders) {
    std::string path = joined_path(folder.path, name);
    if (folder.key == key && in.library.files().is_file(path)) return path;
  }
  return {};
}

void check_ngcgui_pages(const SetupInput& in, Reporter& out) { Pages(in, out).check_pages(); }

}  // namespace owlint::rules
