// Markdown for terminals: headings and code in colours, paragraphs and tables as wide as there is room.
#pragma once

#include <string>
#include <string_view>

namespace owlint {

/// `width` 0: paragraphs are lines without end. Without `color` code keeps its backticks, so that nothing is lost.
std::string render_markdown(std::string_view markdown, bool color, size_t width);

}  // namespace owlint
