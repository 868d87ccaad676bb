// The part of {fmt} that is no template, compiled here once. Debian has it as a shared library only, and as a header every
// file that formats a text would compile all of it again: two thirds of the time that such a file takes.
#include <fmt/format-inl.h>

namespace fmt::detail {

// These are declared in the header as being compiled elsewhere.
template auto thousands_sep_impl<char>(locale_ref) -> thousands_sep_result<char>;
template auto decimal_point_impl<char>(locale_ref) -> char;
template auto locale_ref::get<std::locale>() const -> std::locale;

}  // namespace fmt::detail
