// Bytes for terminals, JSON and XML.
#pragma once

#include <string>
#include <string_view>

namespace owlint {

/// Invalid UTF-8 is taken for Latin-1, control characters become visible.
std::string printable(std::string_view bytes);
/// The same for text of several lines: line ends and tabs stay.
std::string printable_text(std::string_view bytes);

/// Invalid UTF-8 is taken for Latin-1, and nothing else changes: for JSON, which has its own way of writing control characters.
std::string as_utf8(std::string_view bytes);

/// A path as part of a URI.
std::string percent_encoded(std::string_view path);

}  // namespace owlint
