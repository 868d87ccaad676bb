// Data as a page holds them: gzip, which every browser can undo, in base64.
#pragma once

#include <string>
#include <string_view>

namespace owlint::audit {

std::string packed(std::string_view text);

}  // namespace owlint::audit
