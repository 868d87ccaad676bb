// OW401 file-lacks-sub: a called file that does not define the sub with its name.
// Depends on: LinuxCNC opens `name.ngc` and looks for `o<name> sub`; the end of that file is an error.
#include <algorithm>

#include "rules/driver/ini_places.h"
#include "rules/driver/remap_rules.h"
#include "rules/driver/stops.h"
#include "rules/driver/wrong_ends.h"

namespace owlint::rules::ow401 {
namespace {

/// A byte order mark before the first line of the sub, and a file in UTF-16, of which LinuxCNC reads no word.
bool hides_sub(const Input& in, const Program& file, const FlowStop& stop, Finding& f) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  const std::string_view bytes = file.source->bytes();
  const std::string reads = "`" + in.program.head(stop.statement) + "` reads " + file.source->path() + ", ";
  f.help = "save " + file_name(*file.source) + " as UTF-8 without a byte order mark (BOM), or as plain text";
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    f.message = reads + "a UTF-16 file, which LinuxCNC cannot read";
    return true;
  }
  if (!bytes.starts_with(kMark)) return false;
  // `O100` of a file for M98 opens no sub as it stands.
  constexpr size_t kHead = 100;
  std::string first = small_letters(bytes.substr(kMark.size(), kHead));
  first.erase(std::min(first.find_first_of("\r\n;("), first.size()));
  std::erase_if(first, [](char c) { return c == ' ' || c == '\t'; });
  const auto region = std::ranges::find_if(
      file.regions, [&](const Region& r) { return r.opener != kNoStatement && file.name(r.name) == stop.detail; });
  const std::string number = "o" + stop.detail;
  const bool bare =
      first == number || first == "o0" + stop.detail || first == "o<" + stop.detail + ">sub" || first == number + "sub";
  if (!bare && region == file.regions.end()) return false;
  f.message = reads + "but a byte order mark hides the sub's first line";
  if (region != file.regions.end())
    relate(in, f, {&file, region->opener}, "a byte order mark comes before this line; most editors do not show it");
  return true;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const Program& p = in.program;
    const Program& file = *stop.file;
    const std::string& path = file.source->path();
    Finding& f = out.add(p.at(stop.statement).head_span(),
                         "`" + p.head(stop.statement) + "` reads " + path + ", which does not define that sub");
    if (p.at(stop.statement).runs_remap()) {
      if (const Ini::Entry* const entry = remap_entry(in, stop.statement))
        relate_ini(f, *entry, "the file is named here");
    }
    if (tell_deleted_sub(p, stop.statement, f)) return &f;
    if (path == p.source->path()) {
      f.message = "`" + p.head(stop.statement) + "` opens this program itself, because the file is named " +
          file_name(*file.source) + "; it does not define the sub";
      f.help = "give the program another name";
      return &f;
    }
    const bool marked = file.source->bytes().starts_with("\xEF\xBB\xBF");
    const std::unordered_map<NameId, StatementId> misread = misread_subs(file);
    const auto line = misread.find(file.syntax.names.find(stop.detail));
    if (line != misread.end() && !marked) {
      f.message = "`" + p.head(stop.statement) + "` reads " + path + ", but " + misread_words(file, line->second);
      Finding named;
      name_misread(file, line->second, label_text(stop.detail) + " sub", named);
      f.help = named.help + " of " + file_name(*file.source);
      f.related.push_back(std::move(named.related[0]));
      f.related.back().source = file.source;
      return &f;
    }
    if (hides_sub(in, file, stop, f)) return &f;
    const Region* only = nullptr;
    for (const Region& region : file.regions) {
      if (region.opener != kNoStatement && only == nullptr) only = &region;
    }
    if (only != nullptr) {
      relate(in, f, {&file, only->opener}, "the file defines this sub");
      f.help = "give the sub the name of its file, and call it by that name";
    } else {
      f.help = file.size() == 0 && file.source->bytes().empty()
          ? "write the sub into the file: it is empty"
          : "put `o<" + stop.detail + "> sub` and its `endsub` around the lines of the file";
    }
    return &f;
  });
}

/// Subs that a `REMAP` runs: measured, LinuxCNC looks into the file only when a program uses the code.
void check_setup(const SetupInput& in, Reporter& out) {
  for (const Remap& remap : remaps_of(in.setup.text)) {
    const std::string_view ngc = remap.read.ngc;
    if (remap.read.problem != RemapLine::Problem::kNone || remap.earlier != nullptr || ngc.empty()) continue;
    const std::optional<RemappedCode> code = remapped_code(in.setup.text.value(*remap.line), release_of(in.profile));
    if (!code || (code->letter == 'g' && g_code(code->number, release_of(in.profile)) != nullptr)) continue;
    const std::string path = remap_file(in.setup, ngc);
    if (path.empty()) continue;
    const std::string name = small_letters(ngc.substr(ngc.rfind('/') + 1));
    const std::shared_ptr<const Program> program = in.library.load_called(path, in.profile);
    if (program->find_sub(name) != kNoRegion || program->syntax.runs_python) continue;
    Finding& f = add_at(in, out, *remap.line, span_in(in.setup.text, *remap.line, ngc),
                        "`" + std::string(remap.read.code) + "` runs `" + label_text(name) + "` in " + path +
                            ", but the file does not define that sub");
    f.help = "put `" + label_text(name) + " sub` and `" + label_text(name) + " endsub` around the lines of the file";
    for (const Region& region : program->regions) {
      if (region.opener == kNoStatement) continue;
      f.help = "give the sub the name of its file";
      f.related.push_back({program->at(region.opener).whole(), "the file defines this sub", program->source});
      break;
    }
    f.interpreter = "EOF in file:" + path + " seeking o-word: o<" + name + "> from line: 0";
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW401",
    .name = "file-lacks-sub",
    .summary = "the called file exists but does not define the sub",
    .group = Group::kFiles,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A call finds a file of that name on the search path, but the file has no `sub` line with the name.)",
            .why = R"(LinuxCNC reads the file from its beginning, looks for `o<name> sub`, and stops at the end of the
file. It does not look further along the search path. So an empty or forgotten file of the same name
hides the right one.)",
            .bad = R"(G21 G90
o<bore> call [12]
M2
; file: bore.ngc
o<bore_d> sub
  G2 X0 Y0 I[#1/2]
o<bore_d> endsub
)",
            .good = R"(G21 G90
o<bore> call [12]
M2
; file: bore.ngc
o<bore> sub
  G2 X0 Y0 I[#1/2] F200
o<bore> endsub
)",
            .fix = R"(Give the sub the name of its file. A copied file usually still has the old name inside.)",
            .level_reason = "Error if a run gets to the call: the program stops. Warning if no run does.",
            .interpreter = "EOF in file:FILE seeking o-word: o<bore> from line: 0",
            .options = "",
        },
    .check = check,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow401
