// Base64 without line ends, as data URIs and pages have it.
#pragma once

#include <string>
#include <string_view>

namespace owlint {

std::string base64(std::string_view bytes);

}  // namespace owlint
