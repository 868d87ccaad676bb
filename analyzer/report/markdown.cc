#include "analyzer/report/markdown.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm.h>
#include <fmt/format.h>

#include "analyzer/text/width.h"

namespace owlint {
namespace {

struct Style {
  std::string_view heading, strong, emphasis, code, dim, reset;
};
constexpr Style kPlainStyle{"", "", "", "`", "", ""};
constexpr Style kAnsiStyle{"\x1b[1;4m", "\x1b[1m", "\x1b[3m", "\x1b[36m", "\x1b[2m", "\x1b[0m"};

constexpr size_t kNarrowestText = 24;  // of text beside an indent

std::vector<cmark_node*> children(cmark_node* node) {
  std::vector<cmark_node*> out;
  for (cmark_node* child = cmark_node_first_child(node); child != nullptr; child = cmark_node_next(child))
    out.push_back(child);
  return out;
}

std::string_view literal(cmark_node* node) {
  const char* const text = cmark_node_get_literal(node);
  return text == nullptr ? std::string_view() : text;
}

class Renderer {
 public:
  Renderer(bool color, size_t width) : s_(color ? kAnsiStyle : kPlainStyle), color_(color), width_(width) {}

  /// Blocks one below the other; each line begins with `indent`.
  std::string blocks(cmark_node* parent, const std::string& indent) const {
    std::string out;
    for (cmark_node* node : children(parent)) {
      if (!out.empty()) out += indent.substr(0, indent.find_last_not_of(' ') + 1) + "\n";
      out += block(node, indent);
    }
    return out;
  }

 private:
  std::string block(cmark_node* node, const std::string& indent) const {
    const std::string_view type = cmark_node_get_type_string(node);
    if (type == "heading") return heading(node, indent);
    if (type == "code_block") return code_block(literal(node), indent);
    if (type == "list") return list(node, indent);
    if (type == "block_quote") return blocks(node, indent + "| ");
    if (type == "thematic_break") return indent + "---\n";
    if (type == "table") return table(node, indent);
    return styled("", text_in(node, ""), indent);
  }

  /// Without colours, what is below a title ends in a colon: it would look like a sentence.
  std::string heading(cmark_node* node, const std::string& indent) const {
    const bool plain = !color_ && cmark_node_get_heading_level(node) > 1;
    return styled(s_.heading, text_in(node, s_.heading) + (plain ? ":" : ""), indent);
  }

  std::string styled(std::string_view style, const std::string& text, const std::string& indent) const {
    return fmt::format("{}{}{}{}\n", indent, style, wrapped(text, room(indent), indent, 0),
                       style.empty() ? "" : s_.reset);
  }

  /// For wrapped(): where lines end. An indent that leaves no room is taken as it is.
  size_t room(const std::string& indent) const {
    return width_ == 0 ? 0 : std::max(width_, columns(indent) + kNarrowestText);
  }

  static std::string code_block(std::string_view code, const std::string& indent) {
    std::string out;
    while (!code.empty()) {
      const size_t feed = std::min(code.find('\n'), code.size());
      out += fmt::format("{}    {}\n", indent, code.substr(0, feed));
      code.remove_prefix(std::min(feed + 1, code.size()));
    }
    return out;
  }

  std::string list(cmark_node* node, const std::string& indent) const {
    std::string out;
    int number = cmark_node_get_list_start(node);
    const bool ordered = cmark_node_get_list_type(node) == CMARK_ORDERED_LIST;
    for (cmark_node* item : children(node)) {
      const std::string mark = ordered ? fmt::format("{}. ", number++) : "- ";
      std::string text = blocks(item, indent + std::string(mark.size(), ' '));
      out += text.replace(indent.size(), mark.size(), mark);
    }
    return out;
  }

  /// Text on one line; `around` is the style to go back to.
  std::string text_in(cmark_node* parent, std::string_view around) const {
    std::string out;
    const auto inside = [&](std::string_view style, const std::string& text) {
      out += fmt::format("{}{}{}{}", style, text, style.empty() ? "" : s_.reset, style.empty() ? "" : around);
    };
    for (cmark_node* node : children(parent)) {
      switch (cmark_node_get_type(node)) {
        case CMARK_NODE_TEXT:
        case CMARK_NODE_HTML_INLINE: out += literal(node); break;
        case CMARK_NODE_SOFTBREAK:
        case CMARK_NODE_LINEBREAK: out += ' '; break;
        case CMARK_NODE_CODE:
          color_ ? inside(s_.code, std::string(literal(node))) : inside("", fmt::format("`{}`", literal(node)));
          break;
        case CMARK_NODE_STRONG: inside(s_.strong, text_in(node, s_.strong)); break;
        case CMARK_NODE_EMPH: inside(s_.emphasis, text_in(node, s_.emphasis)); break;
        case CMARK_NODE_LINK: out += link(node, around); break;
        default: out += text_in(node, around);
      }
    }
    return out;
  }

  std::string link(cmark_node* node, std::string_view around) const {
    const std::string text = text_in(node, around);
    const std::string url = cmark_node_get_url(node);
    return url.find("://") == std::string::npos || url == text
        ? text
        : fmt::format("{} ({})", text, url);  // others lead to pages beside this one
  }

  using Row = std::vector<std::string>;

  std::string table(cmark_node* node, const std::string& indent) const {
    std::vector<Row> rows;
    for (cmark_node* row : children(node)) {
      Row& cells = rows.emplace_back();
      for (cmark_node* cell : children(row)) cells.push_back(text_in(cell, ""));
    }
    const std::vector<size_t> wide = column_widths(rows, columns(indent));
    std::string out;
    for (size_t i = 0; i < rows.size(); ++i) {
      out += table_row(rows[i], wide, indent, i == 0 ? s_.strong : "");
      if (i == 0) {
        std::string rule = indent;
        for (const size_t one : wide) rule += std::string(one, '-') + "  ";
        out += rule.substr(0, rule.find_last_not_of(' ') + 1) + "\n";
      }
    }
    return out;
  }

  /// As wide as the widest cells; where that is too much, the widest columns give way.
  std::vector<size_t> column_widths(const std::vector<Row>& rows, size_t indent) const {
    constexpr size_t kLeast = 8;
    std::vector<size_t> wide;
    for (const Row& row : rows) {
      wide.resize(std::max(wide.size(), row.size()));
      for (size_t i = 0; i < row.size(); ++i) wide[i] = std::max(wide[i], columns(row[i]));
    }
    const auto sum = [&] {
      size_t all = indent;
      for (const size_t one : wide) all += one + 2;
      return all - 2;
    };
    while (width_ != 0 && !wide.empty() && sum() > width_) {
      const auto widest = std::ranges::max_element(wide);
      if (*widest <= kLeast) break;
      --*widest;
    }
    return wide;
  }

  /// The lines of a cell; a style that goes over a line's end is switched off there and on again, for other cells come between.
  std::vector<std::string> lines_of(const std::string& text) const {
    std::vector<std::string> lines;
    std::string open;
    for (size_t at = 0; at <= text.size();) {
      const size_t feed = std::min(text.find('\n', at), text.size());
      std::string line = open + text.substr(at, feed - at);
      if (const size_t escape = line.rfind("\x1b["); escape != std::string::npos)
        open = line.substr(escape, line.find('m', escape) + 1 - escape);
      if (open == s_.reset) open.clear();
      lines.push_back(line + std::string(open.empty() ? "" : s_.reset));
      at = feed + 1;
    }
    return lines;
  }

  std::string table_row(const Row& row, const std::vector<size_t>& wide, const std::string& indent,
                        std::string_view style) const {
    std::vector<std::vector<std::string>> cells;  // by column, its lines
    size_t lines = 1;
    for (size_t i = 0; i < row.size(); ++i) {
      cells.push_back(lines_of(wrapped(row[i], wide[i], "")));
      lines = std::max(lines, cells.back().size());
    }
    std::string out;
    for (size_t line = 0; line < lines; ++line) {
      std::string text = indent;
      for (size_t i = 0; i < cells.size(); ++i) {
        const std::string cell = line < cells[i].size() ? cells[i][line] : std::string();
        text += fmt::format("{}{}{}", style, cell, style.empty() ? "" : s_.reset);
        const size_t used = columns(cell);
        if (i + 1 < cells.size()) text.append(wide[i] - std::min(wide[i], used) + 2, ' ');
      }
      out += text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
    }
    return out;
  }

  const Style& s_;
  bool color_;
  size_t width_;
};

}  // namespace

std::string render_markdown(std::string_view markdown, bool color, size_t width) {
  cmark_gfm_core_extensions_ensure_registered();
  const std::unique_ptr<cmark_parser, decltype(&cmark_parser_free)> parser(cmark_parser_new(CMARK_OPT_DEFAULT),
                                                                           &cmark_parser_free);
  cmark_parser_attach_syntax_extension(parser.get(), cmark_find_syntax_extension("table"));
  cmark_parser_feed(parser.get(), markdown.data(), markdown.size());
  const std::unique_ptr<cmark_node, decltype(&cmark_node_free)> page(cmark_parser_finish(parser.get()),
                                                                     &cmark_node_free);
  return Renderer(color, width).blocks(page.get(), "");
}

}  // namespace owlint
