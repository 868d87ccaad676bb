// OW423 python-missing: a REMAP needs Python that the INI does not provide.
// Depends on: the interpreter asks its Python plugin for `python=` when it starts, and for prolog and epilog when the code runs;
// where `TOPLEVEL` names a file that is not there, none of the three starts (measured).
#include <algorithm>

#include "analyzer/machine/ini_keys.h"
#include "rules/driver/remap_rules.h"

namespace owlint::rules::ow423 {
namespace {

/// What is known of `[PYTHON]TOPLEVEL`.
enum class Plugin : uint8_t { kThere, kNoKey, kNoFile, kUnknown };

bool is_word_in(std::string_view text, std::string_view word) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const size_t end = at + word.size();
    if ((at == 0 || !in_word(text[at - 1])) && (end == text.size() || !in_word(text[end]))) return true;
  }
  return false;
}

class Checker {
 public:
  Checker(const SetupInput& in, Reporter& out) : in_(in), out_(out), text_(in.setup.text), files_(in.library.files()) {}

  void run() {
    find_plugin();
    for (const Remap& remap : remaps_of(text_)) {
      if (remap.read.problem != RemapLine::Problem::kNone || remap.earlier != nullptr) continue;
      if (!remap.read.python.empty()) check_function(remap);
      if (!remap.read.prolog.empty()) note_hook(remap, "prolog", remap.read.prolog);
      if (!remap.read.epilog.empty()) note_hook(remap, "epilog", remap.read.epilog);
    }
    if (plugin_ == Plugin::kNoKey) return add_missing();
    if (plugin_ == Plugin::kNoFile && !said_) {
      Finding& f = add_at(in_, out_, *toplevel_, toplevel_->value,
                          "the file `" + std::string(text_.value(*toplevel_)) + "` of `TOPLEVEL` does not exist");
      f.help = "correct the name, or remove `[PYTHON]`";
      f.missing = text_.value(*toplevel_);
      f.group = f.missing;  // copies of one configuration lack the same file
      f.habit_severity = Severity::kInfo;
      f.interpreter = message_of_file();
    }
  }

 private:
  static std::string place(const IniText& text, const IniLine& line) {
    return std::to_string(line.number) + ":REMAP = " + std::string(text.value(line));
  }

  std::string message_of_file() const { return "can't resolve path to '" + std::string(text_.value(*toplevel_)) + "'"; }

  std::string in_folder(std::string_view path) const {
    const std::string folder(folder_of(in_.setup.path));
    const std::string found = normal_path(joined_path(folder, expand_home(path)));
    return found.empty() ? "." : found;
  }

  void find_plugin() {
    toplevel_ = find_line(text_, "PYTHON", "TOPLEVEL");
    if (toplevel_ == nullptr) {
      plugin_ = Plugin::kNoKey;
      return;
    }
    const std::string_view value = text_.value(*toplevel_);
    if (files_.is_file(in_folder(value))) return;
    // What begins at the root or at somebody's home may be on the machine only.
    plugin_ = value.starts_with('/') || value.starts_with('~') || value.starts_with("..") ? Plugin::kUnknown
                                                                                          : Plugin::kNoFile;
  }

  /// The text of the module `remap`, as far as it is here and says all of itself.
  std::shared_ptr<const Source> module() const {
    std::vector<std::string> folders;
    for (const IniLine* line : lines_of(text_, "PYTHON")) {
      const std::string_view name = text_.name(*line);
      if (name == "PATH_PREPEND" || name == "PATH_APPEND") folders.push_back(in_folder(text_.value(*line)));
    }
    folders.push_back(in_folder(folder_of(text_.value(*toplevel_))));
    for (const std::string& folder : folders) {
      std::string error;
      const std::string path = joined_path(folder, "remap.py");
      if (!files_.is_file(path)) continue;
      const auto source = files_.read(path, &error);
      return source == nullptr || source->bytes().find("import *") != std::string_view::npos ? nullptr : source;
    }
    return nullptr;
  }

  void check_function(const Remap& remap) {
    const std::string name(remap.read.python);
    const std::string message = "'" + name + "' is not a Python callable function - " + place(text_, *remap.line);
    const Span span = span_in(text_, *remap.line, remap.read.python);
    if (plugin_ == Plugin::kNoKey) {
      functions_.push_back({remap.line, span, "python=" + name, message});
    } else if (plugin_ == Plugin::kNoFile) {
      miss_file(remap, "python=" + name);
    } else if (const auto source = plugin_ == Plugin::kThere ? module() : nullptr;
               source != nullptr && !is_word_in(source->bytes(), name)) {
      Finding& f =
          add_at(in_, out_, *remap.line, span, "`remap.py` has no function `" + name + "`: LinuxCNC does not start");
      f.help = "write `def " + name + "(self, **words):` in " + source->path();
      refuses(f, message);
    }
  }

  /// The option needs a file that is not there.
  void miss_file(const Remap& remap, const std::string& option) {
    if (said_) return;
    said_ = true;
    Finding& f = add_at(in_, out_, *toplevel_, toplevel_->value,
                        "the file `" + std::string(text_.value(*toplevel_)) + "` of `TOPLEVEL` does not exist, and `" +
                            option + "` needs it: LinuxCNC does not start");
    f.help = "correct the name";
    f.missing = text_.value(*toplevel_);
    f.related.push_back({remap.line->span, "needed here",
                         remap.line->source == toplevel_->source ? nullptr : text_.source(*remap.line)});
    refuses(f, message_of_file());
    f.unproven = !files_.is_folder(in_folder(folder_of(text_.value(*toplevel_))));  // nor is anything beside it
  }

  void note_hook(const Remap& remap, const std::string& option, std::string_view name) {
    if (plugin_ == Plugin::kNoFile) return miss_file(remap, option + "=" + std::string(name));
    hooks_.push_back({remap.line, span_in(text_, *remap.line, name), option + "=" + std::string(name),
                      "call(remap." + std::string(name) + "): "});
  }

  /// One finding for all of them: they lack the same thing.
  void add_missing() {
    const bool start = !functions_.empty();
    const std::vector<Need>& needs = start ? functions_ : hooks_;
    if (needs.empty()) return;
    Finding& f = add_at(in_, out_, *needs[0].line, needs[0].span,
                        "`" + needs[0].option + "` needs `[PYTHON]TOPLEVEL`, which this INI does not have: LinuxCNC " +
                            (start ? "does not start" : "starts, and the code stops the program"));
    f.help = "add `[PYTHON]` with `TOPLEVEL = python/toplevel.py`" + std::string(start ? "" : ", or remove the option");
    if (const IniText::Section* const section = text_.find_section("PYTHON")) {
      const IniLine& line = text_.lines()[section->line];
      f.help = "add `TOPLEVEL = python/toplevel.py` to `[PYTHON]` on line " + std::to_string(line.number) +
          std::string(start ? "" : ", or remove the option");
      f.related.push_back({line.span, "`TOPLEVEL` is missing in this section",
                           line.source == needs[0].line->source ? nullptr : text_.source(line)});
    }
    constexpr size_t kMostShown = 10;
    for (size_t i = 1; i < std::min(needs.size(), kMostShown); ++i)
      f.related.push_back({needs[i].span, "needed here as well",
                           needs[i].line->source == needs[0].line->source ? nullptr : text_.source(*needs[i].line)});
    f.interpreter = needs[0].message;
    if (start) refuses(f, needs[0].message);
  }

  /// What needs Python, and what LinuxCNC prints without it.
  struct Need {
    const IniLine* line;
    Span span;
    std::string option;
    std::string message;
  };

  const SetupInput& in_;
  Reporter& out_;
  const IniText& text_;
  const Files& files_;
  Plugin plugin_ = Plugin::kThere;
  const IniLine* toplevel_ = nullptr;
  bool said_ = false;
  std::vector<Need> functions_, hooks_;
};

void check_setup(const SetupInput& in, Reporter& out) { Checker(in, out).run(); }

}  // namespace

extern const Rule kRule{
    .code = "OW423",
    .name = "python-missing",
    .summary = "a REMAP needs Python that the INI does not provide",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A `REMAP` with `python=`, `prolog=` or `epilog=` in an INI without `[PYTHON]TOPLEVEL`; a `TOPLEVEL`
that does not exist; a function that `remap.py` does not have.)",
            .why = R"(The functions of `REMAP` lines come from the module `remap`, which `TOPLEVEL` imports. LinuxCNC
looks for `python=` when it starts and gives up if the function is not there. For `prolog=` and
`epilog=` it looks when a program uses the code: then the program stops. If `TOPLEVEL` names a file
that is not there, LinuxCNC does not start if a `REMAP` has one of the three.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
REMAP = M400 modalgroup=10 prolog=before ngc=greet
; file: greet.ngc
o<greet> sub
  G4 P0
o<greet> endsub
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
REMAP = M400 modalgroup=10 ngc=greet
; file: greet.ngc
o<greet> sub
  G4 P0
o<greet> endsub
)",
            .fix =
                R"(Add `[PYTHON]` with `TOPLEVEL = python/toplevel.py` and `PATH_PREPEND = python`, and write the functions in
`remap.py` there. owlint reads `remap.py` and runs nothing; where it says `import *`, nothing is reported.)",
            .level_reason = "Error where LinuxCNC does not start: for `python=`, and for a missing `TOPLEVEL` that a "
                            "`REMAP` needs. Warning if the whole folder of `TOPLEVEL` is not here, if no `REMAP` needs "
                            "it, and for `prolog=` and `epilog=` in an INI without it. Info if three INIs or more lack "
                            "a file that no `REMAP` needs.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow423
