// How far a program goes, in words and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "analyzer/program/linker.h"
#include "analyzer/syntax/extents.h"

namespace owlint {

/// What they are a part of: for `owlint extents --format json`, and the page of an audit. `linked`: with the files of the lines.
nlohmann::ordered_json extents_json(const Extents& extents, const Linked& linked);

/// A table for each origin, then what is not in them.
std::string extents_text(const Extents& extents, const Linked& linked);

}  // namespace owlint
