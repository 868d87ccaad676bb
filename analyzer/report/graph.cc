#include "analyzer/report/graph.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analyzer/report/report.h"

namespace owlint {
namespace {

using Json = nlohmann::ordered_json;

std::string escaped(std::string_view text, bool mermaid) {
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
  if (region.opener == kNoStatement) return "main program";
  return fmt::format("{} line {}", p.head(region.opener), p.at(region.opener).line);
}

std::string block_title(const Program& p, const Block& b) {
  std::string lines = fmt::format("{}", p.at(b.opener).line);
  lines += b.end == kNoStatement ? "-?" : fmt::format("-{}", p.at(b.end).line);
  return fmt::format("{} {}", p.head_of(b), lines);
}

}  // namespace

void write_graph_dot(std::ostream& out, const Program& p) {
  out << fmt::format("digraph \"{}\" {{\n  rankdir=TB;\n  node [shape=box, fontname=\"monospace\"];\n", escaped(p.source->path(), false));
  for (RegionId r = 0; r < p.regions.size(); ++r) {
    out << fmt::format("  subgraph cluster_{0} {{\n    label=\"{1}\";\n    r{0} [label=\"{1}\", shape=oval];\n", r, escaped(region_title(p, r), false));
    for (BlockId b = 0; b < p.blocks.size(); ++b) {
      if (p.blocks[b].region == r) out << fmt::format("    b{} [label=\"{}\"];\n", b, escaped(block_title(p, p.blocks[b]), false));
    }
    out << "  }\n";
  }
  for (BlockId b = 0; b < p.blocks.size(); ++b) {
    const Block& block = p.blocks[b];
    if (block.parent == kNoBlock) {
      out << fmt::format("  r{} -> b{};\n", block.region, b);
    } else {
      out << fmt::format("  b{} -> b{};\n", block.parent, b);
    }
  }
  for (const Call& call : p.calls) {
    const uint32_t line = p.at(call.statement).line;
    if (call.target != UINT32_MAX) {
      out << fmt::format("  r{} -> r{} [style=dashed, label=\"line {}\"];\n", call.caller, call.target, line);
    } else {
      out << fmt::format("  x{0} [label=\"{1}\", style=dotted];\n  r{2} -> x{0} [style=dashed, label=\"line {3}\"];\n", call.statement,
                         escaped(call.callee == kNoName ? "computed" : p.label_text(call.callee), false), call.caller, line);
    }
  }
  out << "}\n";
}

void write_graph_mermaid(std::ostream& out, const Program& p) {
  out << "flowchart TB\n";
  for (RegionId r = 0; r < p.regions.size(); ++r) {
    out << fmt::format("  subgraph s{0}[\"{1}\"]\n    r{0}([\"{1}\"])\n", r, escaped(region_title(p, r), true));
    for (BlockId b = 0; b < p.blocks.size(); ++b) {
      if (p.blocks[b].region == r) out << fmt::format("    b{}[\"{}\"]\n", b, escaped(block_title(p, p.blocks[b]), true));
    }
    out << "  end\n";
  }
  for (BlockId b = 0; b < p.blocks.size(); ++b) {
    const Block& block = p.blocks[b];
    const bool top = block.parent == kNoBlock;
    out << fmt::format("  {}{} --> b{}\n", top ? "r" : "b", top ? block.region : block.parent, b);
  }
  for (const Call& call : p.calls) {
    const uint32_t line = p.at(call.statement).line;
    if (call.target != UINT32_MAX) {
      out << fmt::format("  r{} -.->|line {}| r{}\n", call.caller, line, call.target);
    } else {
      out << fmt::format("  r{} -.->|line {}| x{}[\"{}\"]\n", call.caller, line, call.statement,
                         escaped(call.callee == kNoName ? "computed" : p.label_text(call.callee), true));
    }
  }
}

void write_graph_json(std::ostream& out, const Program& p) {
  const auto line_of = [&](StatementId id) { return id == kNoStatement ? Json(nullptr) : Json(p.at(id).line); };
  Json graph;
  graph["schema"] = "owlint-graph-1";
  graph["path"] = printable(p.source->path());
  graph["kind"] = p.sub_file ? "sub file" : "program";
  graph["scopes"] = Json::array();
  for (RegionId r = 0; r < p.regions.size(); ++r) {
    const Region& region = p.regions[r];
    graph["scopes"].push_back({{"id", r}, {"sub", region.name == kNoName ? Json(nullptr) : Json(printable(p.name(region.name)))},
                               {"line", line_of(region.opener)}, {"end", line_of(region.end)}});
  }
  graph["blocks"] = Json::array();
  for (BlockId b = 0; b < p.blocks.size(); ++b) {
    const Block& block = p.blocks[b];
    Json parts = Json::array();
    for (const StatementId part : block.parts) parts.push_back({{"keyword", spelling(p.at(part).keyword)}, {"line", p.at(part).line}});
    graph["blocks"].push_back({{"id", b}, {"keyword", spelling(block.kind)}, {"label", printable(p.name(block.label))},
                               {"scope", block.region}, {"parent", block.parent == kNoBlock ? Json(nullptr) : Json(block.parent)},
                               {"line", p.at(block.opener).line}, {"parts", std::move(parts)}, {"end", line_of(block.end)}});
  }
  graph["calls"] = Json::array();
  for (const Call& call : p.calls) {
    graph["calls"].push_back({{"line", p.at(call.statement).line}, {"from", call.caller},
                              {"label", call.callee == kNoName ? Json(nullptr) : Json(printable(p.name(call.callee)))},
                              {"to", call.target == UINT32_MAX ? Json(nullptr) : Json(call.target)}});
  }
  out << graph.dump(2) << '\n';
}

}  // namespace owlint
