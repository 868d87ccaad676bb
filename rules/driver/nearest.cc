// What a misspelt word is nearest to.
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules {

std::string nearest(std::string_view word, const std::vector<std::string>& candidates, size_t limit) {
  const std::string* best = nullptr;
  size_t best_distance = std::min(limit, std::max<size_t>(1, word.size() / 3)) + 1;
  for (const std::string& candidate : candidates) {
    const size_t longer = std::max(word.size(), candidate.size());
    if (longer - std::min(word.size(), candidate.size()) >= best_distance) continue;
    // Optimal string alignment: a swapped pair of letters is one mistake.
    std::vector<std::vector<size_t>> d(word.size() + 1, std::vector<size_t>(candidate.size() + 1));
    for (size_t i = 0; i <= word.size(); ++i) d[i][0] = i;
    for (size_t j = 0; j <= candidate.size(); ++j) d[0][j] = j;
    for (size_t i = 1; i <= word.size(); ++i) {
      for (size_t j = 1; j <= candidate.size(); ++j) {
        d[i][j] =
            std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (word[i - 1] == candidate[j - 1] ? 0 : 1)});
        if (i > 1 && j > 1 && word[i - 1] == candidate[j - 2] && word[i - 2] == candidate[j - 1]) {
          d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
      }
    }
    if (d[word.size()][candidate.size()] >= best_distance) continue;
    best_distance = d[word.size()][candidate.size()];
    best = &candidate;
  }
  return best == nullptr ? std::string() : *best;
}

}  // namespace owlint::rules
