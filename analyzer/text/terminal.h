// What the reader's terminal can show.
#pragma once

#include <cstddef>
#include <string>

namespace owlint {

/// Whether a stream is a terminal that does more than print line after line.
bool is_terminal(int stream);

/// Whether a stream gets colours. `wanted` is what --color says; `auto`: where it is a terminal, and the
/// environment does not ask for none. Stream -1 is a file.
bool use_color(const std::string& wanted, int stream);

/// The columns of the terminal that a stream is; 0 where it is none, or does not say.
size_t columns_of(int stream);

}  // namespace owlint
