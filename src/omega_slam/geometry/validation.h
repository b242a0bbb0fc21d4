#pragma once

#include <string>
#include <vector>

namespace omega_slam::geometry {

/// Collects what is wrong with a configuration, a sentence a fault, each naming its field. NaN is
/// always a fault.
class Violations {
 public:
  void requireAtLeast(const std::string& name, double value, double min);
  void requireAbove(const std::string& name, double value, double bound);
  void requireWithin(const std::string& name, double value, double min, double max);
  /// Takes over the faults of a part, with the part's name in front.
  void include(const std::string& part, const std::vector<std::string>& sentences);

  [[nodiscard]] const std::vector<std::string>& sentences() const { return sentences_; }

 private:
  std::vector<std::string> sentences_;
};

/// @throws std::invalid_argument with all sentences, if there are any
void throwIfAny(const std::vector<std::string>& sentences);

}  // namespace omega_slam::geometry
