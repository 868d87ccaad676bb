// What the lines behind a statement set and need, which have no statement themselves.
#include <algorithm>

#include "analyzer/syntax/statement.h"

namespace owlint {
namespace {

/// The entries of a statement in a list that is in the order of statements. It is asked for nearly all statements of a large
/// program, so the search begins where the entries would be if all statements had as many, and moves on from there.
template <typename Entry>
std::span<const Entry> entries_of(const std::vector<Entry>& list, StatementId id, size_t statements) {
  if (list.empty()) return {};
  const auto before = [&](size_t at) { return list[at].after < id; };
  const double share = static_cast<double>(id) / static_cast<double>(statements);
  const size_t guess = std::min(list.size() - 1, static_cast<size_t>(share * static_cast<double>(list.size())));
  size_t low = 0, high = list.size(), step = 1;
  if (before(guess)) {
    for (low = guess + 1; low + step <= list.size() && before(low + step - 1); step *= 2) low += step;
    high = std::min(list.size(), low + step);
  } else {
    for (high = guess; high >= step && !before(high - step); step *= 2) high -= step;
    low = high < step ? 0 : high - step + 1;
  }
  const auto at = [&](size_t index) { return list.begin() + static_cast<std::ptrdiff_t>(index); };
  const auto first = std::partition_point(at(low), at(high), [id](const Entry& entry) { return entry.after < id; });
  auto last = first;
  while (last != list.end() && last->after == id) ++last;
  return {first, last};
}

}  // namespace

std::span<const ModeChange> Syntax::changes_after(StatementId id) const {
  return entries_of(mode_changes, id, statements.size());
}

std::span<const PlaceChange> Syntax::places_after(StatementId id) const {
  return entries_of(place_changes, id, statements.size());
}

std::span<const ModeNeed> Syntax::needs_after(StatementId id) const {
  return entries_of(mode_needs, id, statements.size());
}

}  // namespace owlint
