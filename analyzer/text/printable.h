// Bytes for terminals, JSON and XML.
#pragma once

#include <string>
#include <string_view>

namespace owlint {

/// Reads invalid UTF-8 as Latin-1, and makes control characters visible.
std::string printable(std::string_view bytes);
/// The same for text of several lines: line ends and tabs stay.
std::string printable_text(std::string_view bytes);

/// Reads invalid UTF-8 as Latin-1, and changes nothing else: for JSON, which writes control characters in its own way.
std::string as_utf8(std::string_view bytes);

/// A path as part of a URI.
std::string percent_encoded(std::string_view path);

}  // namespace owlint
