#include "analyzer/report/graph.h"

#include <algorithm>
#include <sstream>
#include <unordered_map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analyzer/report/report.h"
#include "analyzer/report/summary.h"
#include "analyzer/text/process.h"

namespace owlint {
namespace {

using Json = nlohmann::ordered_json;

/// Text for a label; Mermaid has its own way of hiding characters.
std::string label_text(std::string_view text, bool mermaid) {
  std::string out;
  for (const char c : printable(text)) {
    if (mermaid && (c == '"' || c == '<' || c == '>' || c == '&' || c == '#')) {
      out += c == '"' ? "&quot;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : "#35;";
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string region_title(const Program& p, RegionId id) {
  const Region& region = p.regions[id];
  if (region.opener == kNoStatement) return p.sub_file ? "outside of subs" : "main program";
  return fmt::format("{} line {}", p.head(region.opener), p.at(region.opener).line);
}

std::string block_title(const Program& p, const Block& b) {
  std::string lines = fmt::format("{}", p.at(b.opener).line);
  lines += b.end == kNoStatement ? "-?" : fmt::format("-{}", p.at(b.end).line);
  return fmt::format("{} {}", p.head_of(b), lines);
}

struct Node {
  std::string id;
  std::string title;
  uint32_t line = 0;                // 0: none
  Severity worst = Severity::kOff;  // of its findings
  std::string findings;             // a line each
};

/// One scope with the blocks that it holds.
struct Scope {
  Node node;
  std::vector<Node> blocks;
};

struct Link {
  std::string from;
  std::string to;
  std::string words;
  bool call = false;
};

/// What is drawn, whatever the format: files with their scopes, and what leads where.
struct Drawing {
  struct File {
    std::string path;
    std::vector<Scope> scopes;
  };
  std::vector<File> files;
  std::vector<std::pair<std::string, std::string>> unknown;  // called, and nowhere found: id, title
  std::vector<Link> links;
};

std::string scope_id(size_t file, RegionId region) {
  return file == 0 ? fmt::format("r{}", region) : fmt::format("f{}r{}", file, region);
}

/// Where a call leads: a scope of this file, or of the file that it finds.
std::string callee_id(const Linked& linked, size_t file, const Call& call) {
  if (call.target != kNoRegion) return scope_id(file, call.target);
  const Program& p = *linked.files()[file].program;
  if (call.callee == kNoName) return {};
  const CallTarget target = linked.target(p.name(call.callee));
  if (target.file == CallTarget::kNotFound) return {};
  const Program& called = *linked.files()[target.file].program;
  const std::string name(called_label(p.name(call.callee), Version::k2_9));
  for (RegionId r = 1; r < called.regions.size(); ++r) {
    if (called.name(called.regions[r].name) == name) return scope_id(target.file, r);
  }
  return scope_id(target.file, kMainRegion);  // a file without the sub
}

Drawing draw(const Linked& linked) {
  Drawing out;
  for (size_t f = 0; f < linked.files().size(); ++f) {
    const Program& p = *linked.files()[f].program;
    Drawing::File file{p.source->path(), {}};
    for (RegionId r = 0; r < p.regions.size(); ++r) {
      const StatementId opener = p.regions[r].opener;
      file.scopes.push_back(
          {{scope_id(f, r), region_title(p, r), opener == kNoStatement ? 1 : p.at(opener).line, Severity::kOff, ""},
           {}});
    }
    // The inside of called files is left to a drawing of their own.
    for (BlockId b = 0; f == 0 && b < p.blocks.size(); ++b) {
      const Block& block = p.blocks[b];
      const std::string id = fmt::format("b{}", b);
      file.scopes[block.region].blocks.push_back(
          {id, block_title(p, block), p.at(block.opener).line, Severity::kOff, ""});
      out.links.push_back(
          {block.parent == kNoBlock ? scope_id(f, block.region) : fmt::format("b{}", block.parent), id, "", false});
    }
    for (const Call& call : p.calls) {
      std::string to = callee_id(linked, f, call);
      if (to.empty()) {
        to = f == 0 ? fmt::format("x{}", call.statement) : fmt::format("f{}x{}", f, call.statement);
        out.unknown.emplace_back(to, call.callee == kNoName ? "computed" : p.label_text(call.callee));
      }
      out.links.push_back(
          {scope_id(f, call.caller), std::move(to), fmt::format("line {}", p.at(call.statement).line), true});
    }
    // Lines outside the subs of a called file do not run; they are drawn only if something leads there.
    if (f > 0) {
      const bool used = std::ranges::any_of(out.links, [&](const Link& link) {
        return link.from == file.scopes[0].node.id || link.to == file.scopes[0].node.id;
      });
      if (!used && file.scopes.size() > 1) file.scopes.erase(file.scopes.begin());
    }
    out.files.push_back(std::move(file));
  }
  return out;
}

/// Puts findings on the innermost block that their line belongs to, else on the sub or the main program.
void mark(Drawing& drawing, const Program& p, const std::vector<Finding>& findings) {
  std::unordered_map<std::string_view, Node*> nodes;
  for (Scope& scope : drawing.files[0].scopes) {
    nodes.emplace(scope.node.id, &scope.node);
    for (Node& node : scope.blocks) nodes.emplace(node.id, &node);
  }
  for (const Finding& f : findings) {
    if (f.source != nullptr && f.source->path() != p.source->path()) continue;
    const auto after = std::ranges::upper_bound(p.syntax.statements, f.span.begin, {}, &Statement::offset);
    const bool before_all = after == p.syntax.statements.begin();
    const auto statement = static_cast<StatementId>(after - p.syntax.statements.begin() - (before_all ? 0 : 1));
    const BlockId block = before_all || p.block_of.empty() ? kNoBlock : p.block_of[statement];
    const RegionId region = before_all || p.region_of.empty() ? kMainRegion : p.region_of[statement];
    const auto node = nodes.find(block != kNoBlock ? fmt::format("b{}", block) : scope_id(0, region));
    if (node == nodes.end()) continue;
    node->second->worst = std::max(node->second->worst, f.severity);
    node->second->findings += fmt::format("{}{} on line {}: {}", node->second->findings.empty() ? "" : "\n", f.code,
                                          p.source->position(f.span.begin).line, f.message);
  }
}

/// The attributes of a node. Findings are marked by a sign as well as by colour.
std::string dot_attributes(const Node& node, size_t file, std::string_view shape) {
  static constexpr std::string_view kColors[] = {"", "#2f6fb0", "#b26a00", "#c62828"};
  static constexpr std::string_view kSigns[] = {"", "(i) ", "(!) ", "(X) "};
  const auto level = static_cast<size_t>(node.worst);
  std::string classes = fmt::format("line-{}", node.line);
  if (file > 0) classes += fmt::format(" file-{}", file);
  std::string out = fmt::format("label=\"{}{}\"{}", kSigns[level], label_text(node.title, false), shape);
  if (node.worst != Severity::kOff) {
    classes += fmt::format(" {}", severity_text(node.worst));
    std::string words;
    for (size_t at = 0; at <= node.findings.size();) {
      const size_t feed = std::min(node.findings.find('\n', at), node.findings.size());
      words += (at == 0 ? "" : "\\n") + label_text(std::string_view(node.findings).substr(at, feed - at), false);
      at = feed + 1;
    }
    out += fmt::format(", color=\"{}\", penwidth=2, tooltip=\"{}\"", kColors[level], words);
  }
  return out + fmt::format(", class=\"{}\"", classes);
}

}  // namespace

void write_graph_dot(std::ostream& out, const Linked& linked, const std::vector<Finding>& findings) {
  Drawing drawing = draw(linked);
  mark(drawing, *linked.files()[0].program, findings);
  const auto text = [](std::string_view words) { return label_text(words, false); };
  out << fmt::format(
      "digraph \"{}\" {{\n  rankdir=TB;\n  fontname=\"Courier\";\n  node [shape=box, fontname=\"Courier\"];\n  edge "
      "[fontname=\"Courier\", fontsize=10];\n",
      text(drawing.files[0].path));
  for (size_t f = 0; f < drawing.files.size(); ++f) {
    const std::string indent(f == 0 ? 2 : 4, ' ');
    if (f > 0)
      out << fmt::format("  subgraph cluster_f{} {{\n    label=\"{}\";\n    style=filled; color=\"#eeeeee\";\n", f,
                         text(drawing.files[f].path));
    for (const Scope& scope : drawing.files[f].scopes) {
      const std::string node = fmt::format("{} [{}];\n", scope.node.id, dot_attributes(scope.node, f, ", shape=oval"));
      if (scope.blocks.empty()) {
        out << indent << node;
        continue;
      }
      out << fmt::format("{0}subgraph cluster_{1} {{\n{0}  color=\"#bbbbbb\";\n{0}  {2}", indent, scope.node.id, node);
      for (const Node& block : scope.blocks)
        out << fmt::format("{}  {} [{}];\n", indent, block.id, dot_attributes(block, f, ""));
      out << indent << "}\n";
    }
    if (f > 0) out << "  }\n";
  }
  for (const auto& [id, title] : drawing.unknown)
    out << fmt::format("  {} [label=\"{}\", style=dotted];\n", id, text(title));
  for (const Link& link : drawing.links) {
    out << fmt::format("  {} -> {}{};\n", link.from, link.to,
                       link.call ? fmt::format(" [style=dashed, label=\"{}\"]", link.words) : "");
  }
  out << "}\n";
}

void write_graph_mermaid(std::ostream& out, const Linked& linked) {
  const Drawing drawing = draw(linked);
  const auto text = [](std::string_view words) { return label_text(words, true); };
  out << "flowchart TB\n";
  for (size_t f = 0; f < drawing.files.size(); ++f) {
    const std::string indent(f == 0 ? 2 : 4, ' ');
    if (f > 0) out << fmt::format("  subgraph file{}[\"{}\"]\n", f, text(drawing.files[f].path));
    for (const Scope& scope : drawing.files[f].scopes) {
      out << fmt::format("{0}subgraph s{1}[\"{2}\"]\n{0}  {1}([\"{2}\"])\n", indent, scope.node.id,
                         text(scope.node.title));
      for (const Node& block : scope.blocks)
        out << fmt::format("{}  {}[\"{}\"]\n", indent, block.id, text(block.title));
      out << indent << "end\n";
    }
    if (f > 0) out << "  end\n";
  }
  for (const auto& [id, title] : drawing.unknown) out << fmt::format("  {}[\"{}\"]\n", id, text(title));
  for (const Link& link : drawing.links) {
    out << (link.call ? fmt::format("  {} -.->|{}| {}\n", link.from, link.words, link.to)
                      : fmt::format("  {} --> {}\n", link.from, link.to));
  }
}

namespace {

Json graph_of(const Linked& linked, size_t file) {
  const Program& p = *linked.files()[file].program;
  const auto line_of = [&](StatementId id) { return id == kNoStatement ? Json(nullptr) : Json(p.at(id).line); };
  Json graph;
  if (file == 0) graph["schema"] = "owlint-graph-1";
  graph["path"] = as_utf8(p.source->path());
  graph["kind"] = p.sub_file ? "sub file" : "program";
  graph["scopes"] = Json::array();
  const flow::DataFlow data(p);
  for (RegionId r = 0; r < p.regions.size(); ++r) {
    const Region& region = p.regions[r];
    graph["scopes"].push_back({{"id", r},
                               {"sub", region.name == kNoName ? Json(nullptr) : Json(printable(p.name(region.name)))},
                               {"line", line_of(region.opener)},
                               {"end", line_of(region.end)},
                               {"summary", summary_json(p, data.of(r))},
                               {"modes", modes_json(p, r)}});
  }
  graph["blocks"] = Json::array();
  for (BlockId b = 0; b < p.blocks.size(); ++b) {
    const Block& block = p.blocks[b];
    Json parts = Json::array();
    for (const StatementId part : p.parts[static_cast<size_t>(&block - p.blocks.data())])
      parts.push_back({{"keyword", spelling(p.at(part).keyword)}, {"line", p.at(part).line}});
    graph["blocks"].push_back({{"id", b},
                               {"keyword", spelling(block.kind)},
                               {"label", printable(p.name(block.label))},
                               {"scope", block.region},
                               {"parent", block.parent == kNoBlock ? Json(nullptr) : Json(block.parent)},
                               {"line", p.at(block.opener).line},
                               {"parts", std::move(parts)},
                               {"end", line_of(block.end)}});
  }
  graph["calls"] = Json::array();
  for (const Call& call : p.calls) {
    const CallTarget target =
        call.callee == kNoName || call.target != kNoRegion ? CallTarget{} : linked.target(p.name(call.callee));
    graph["calls"].push_back(
        {{"line", p.at(call.statement).line},
         {"from", call.caller},
         {"label", call.callee == kNoName ? Json(nullptr) : Json(printable(p.name(call.callee)))},
         {"to", call.target == kNoRegion ? Json(nullptr) : Json(call.target)},
         {"file",
          target.file == CallTarget::kNotFound ? Json(nullptr)
                                               : Json(as_utf8(linked.files()[target.file].program->source->path()))}});
  }
  return graph;
}

}  // namespace

void write_graph_json(std::ostream& out, const Linked& linked) {
  Json graph = graph_of(linked, 0);
  graph["files"] = Json::array();
  for (size_t file = 1; file < linked.files().size(); ++file) graph["files"].push_back(graph_of(linked, file));
  out << graph.dump(2) << '\n';
}

std::string write_graph_svg(std::ostream& out, const Linked& linked, const std::vector<Finding>& findings) {
  std::ostringstream dot;
  write_graph_dot(dot, linked, findings);
  const Ran ran = run_program({"dot", "-Tsvg"}, dot.str());
  if (!ran.started)
    return "SVG needs Graphviz's `dot`, which cannot be started: install the package graphviz, or use --format dot";
  if (ran.status != 0) return "Graphviz's `dot` failed";
  out << ran.out;
  return "";
}

}  // namespace owlint
