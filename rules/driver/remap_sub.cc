#include "rules/driver/remap_sub.h"

#include <algorithm>

#include "analyzer/flow/summaries/data_flow.h"

namespace owlint::rules {
namespace {

/// Whether the file itself decides whether a name is there.
bool may_lack(const Program& program, NameId name) {
  const Syntax& syntax = program.syntax;
  return std::ranges::any_of(syntax.items, [&](const Item& item) { return item.target_name == name; }) ||
      std::ranges::any_of(syntax.exprs,
                          [&](const Expr& expr) { return expr.op == Operator::kExistsNamed && expr.name() == name; });
}

/// Local names of one letter that LinuxCNC reads in the sub's comments.
std::string shown_in(const flow::DataFlow& data, RegionId sub) {
  std::string letters;
  for (const flow::Shown& shown : data.shown()) {
    if (shown.acts && shown.region == sub && shown.local.size() == 1) letters += shown.local;
  }
  return letters;
}

}  // namespace

bool RemapSub::reads(char letter) const {
  return shown.find(letter) != std::string::npos || std::ranges::find(names, letter, &Name::letter) != names.end();
}

RemapSub remap_sub(const SetupInput& in, std::string_view ngc) {
  RemapSub out;
  const std::string path = remap_file(in.setup, ngc);
  if (path.empty()) return out;
  const std::string name = small_letters(ngc);
  out.program = in.library.load_called(path, in.profile);
  out.region = out.program->find_sub(name.substr(name.rfind('/') + 1));
  if (out.region == kNoRegion) return out;
  const Program& p = *out.program;
  const flow::DataFlow data(p);
  const auto lines = data.lines_of(out.region);
  out.argument_lines.fill(p.regions[out.region].opener);
  for (size_t i = lines.size(); i-- > 0;) {
    for (const flow::ParameterKey key : data.accesses_of(out.region).reads(i)) {
      if (key < out.argument_lines.size()) out.argument_lines[key] = lines[i];
    }
  }
  out.shown = shown_in(data, out.region);
  const flow::AccessTable table(p, lines);  // without the comments
  const flow::Accesses accesses = table.lines(0, lines.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    for (const flow::ParameterKey key : accesses.reads(i)) {
      const flow::ParameterId id = flow::parameter_of(key);
      if (!id.named || p.name(id.id).size() != 1) continue;
      const char letter = p.name(id.id)[0];
      if (letter < 'a' || letter > 'z') continue;
      if (std::ranges::find(out.names, letter, &RemapSub::Name::letter) != out.names.end()) continue;
      out.names.push_back({letter, lines[i], may_lack(p, id.id)});
    }
  }
  const flow::Summary& summary = data.of(out.region);
  out.known = summary.known && !summary.any_number;
  out.arguments = summary.arguments;
  return out;
}

}  // namespace owlint::rules
