#include "omega_slam/config/edit_distance.h"

#include <algorithm>
#include <numeric>

namespace omega_slam::config {

std::size_t editDistance(const std::string& a, const std::string& b) {
  // row[j] is the distance of the letters of `a` seen so far to the first j letters of `b`.
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : a) {
    std::size_t diagonal = row[0];
    ++row[0];
    for (std::size_t j = 1; j < row.size(); ++j) {
      const std::size_t replaced = diagonal + (letter == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

std::string nearestWord(const std::string& word, const std::vector<std::string>& words) {
  const auto nearer = [&word](const std::string& a, const std::string& b) {
    return editDistance(word, a) < editDistance(word, b);
  };
  const auto nearest = std::min_element(words.begin(), words.end(), nearer);
  return nearest == words.end() ? std::string{} : *nearest;
}

}  // namespace omega_slam::config
