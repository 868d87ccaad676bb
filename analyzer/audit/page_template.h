// The page without its data; see page_template.cc.
#pragma once

#include <string_view>

namespace owlint::audit {

/// Empty where owlint was built without the page.
std::string_view page_template();

inline constexpr std::string_view kDataMark = "<!--owlint:data-->";

}  // namespace owlint::audit
