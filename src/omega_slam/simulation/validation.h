#pragma once

#include <string>
#include <vector>

namespace omega_slam::simulation {

/// Collects what is wrong with a configuration, one sentence for each key.
class Violations {
 public:
  void requirePositive(const std::string& key, double value);     ///< finite and > 0
  void requireNotNegative(const std::string& key, double value);  ///< finite and >= 0
  void require(bool condition, const std::string& sentence);

  [[nodiscard]] const std::vector<std::string>& sentences() const { return sentences_; }

 private:
  std::vector<std::string> sentences_;
};

/// @throws std::invalid_argument with all sentences, if there are any
void throwIfAny(const std::vector<std::string>& violations);

}  // namespace omega_slam::simulation
