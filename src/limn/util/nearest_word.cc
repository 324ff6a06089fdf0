// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/nearest_word.h"

#include <algorithm>
#include <utility>

namespace limn {
namespace {

// Optimal string alignment.
size_t NumChanges(std::string_view a, std::string_view b) {
  std::vector<size_t> before, above(b.size() + 1), row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t other = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, other});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

}  // namespace

std::string NearestWord(std::string_view word, const std::vector<std::string>& words) {
  constexpr size_t kLongest = 100;
  if (word.size() > kLongest) return "";
  std::string nearest;
  size_t least = word.size() / 3 + 1;
  for (const std::string& candidate : words) {
    const size_t changes = NumChanges(word, candidate);
    if (changes >= least) continue;
    least = changes;
    nearest = candidate;
  }
  if (!nearest.empty() || word.empty()) return nearest;
  const std::string end = "." + std::string(word);
  const auto has_end = [&](const std::string& candidate) { return candidate.ends_with(end); };
  if (std::ranges::count_if(words, has_end) != 1) return "";
  return *std::ranges::find_if(words, has_end);
}

std::string DidYouMean(std::string_view word, const std::vector<std::string>& words) {
  const std::string nearest = NearestWord(word, words);
  return nearest.empty() ? "" : ": did you mean " + nearest + "?";
}

}  // namespace limn
