#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>

#include <cstddef>
#include <map>
#include <string>

#include "omega_slam/evaluation/report.h"

namespace omega_slam {

/// What the nodes say of their own work on /diagnostics: the newest of every count.
class RunAccounts {
 public:
  /// Takes statuses named "<node>: input" and "<node>: faults"; others are not counts.
  void update(const diagnostic_msgs::DiagnosticArray& message);

  /// By node.
  [[nodiscard]] const std::map<std::string, evaluation::ScanFigures>& nodes() const {
    return nodes_;
  }

 private:
  std::map<std::string, evaluation::ScanFigures> nodes_;
};

}  // namespace omega_slam
