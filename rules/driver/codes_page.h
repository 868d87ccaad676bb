// The page about codes and words, docs/codes.md, made from the table that the reader checks by.
#pragma once

#include <string>

namespace owlint {

std::string codes_page();

}  // namespace owlint
