#include "nodes/common/run_recorder_accounts.h"

#include <cstdlib>

namespace omega_slam {
namespace {

constexpr char kInput[] = ": input";
constexpr char kFaults[] = ": faults";
constexpr char kAccepted[] = "accepted";
constexpr char kRejected[] = "rejected: ";
constexpr char kRepaired[] = "repaired: ";

/// What stands before `ending`; empty if the text does not end so.
std::string stem(const std::string& text, const std::string& ending) {
  const std::size_t length = text.size() - ending.size();
  const bool fits = text.size() > ending.size() && text.compare(length, ending.size(), ending) == 0;
  return fits ? text.substr(0, length) : std::string();
}

/// What stands behind `beginning`; empty if the text does not begin so.
std::string rest(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0 ? text.substr(beginning.size())
                                                           : std::string();
}

/// 0 for what is no number.
std::size_t toCount(const std::string& text) { return std::strtoull(text.c_str(), nullptr, 10); }

void readFaults(const diagnostic_msgs::DiagnosticStatus& status, evaluation::ScanFigures& figures) {
  for (const diagnostic_msgs::KeyValue& value : status.values) {
    if (const std::string cause = rest(value.key, kRejected); !cause.empty()) {
      figures.rejections[cause] = toCount(value.value);
    } else if (const std::string mended = rest(value.key, kRepaired); !mended.empty()) {
      figures.repairs[mended] = toCount(value.value);
    }
  }
}

}  // namespace

void RunAccounts::update(const diagnostic_msgs::DiagnosticArray& message) {
  for (const diagnostic_msgs::DiagnosticStatus& status : message.status) {
    if (const std::string node = stem(status.name, kFaults); !node.empty()) {
      readFaults(status, nodes_[node]);
    } else if (const std::string counted = stem(status.name, kInput); !counted.empty()) {
      for (const diagnostic_msgs::KeyValue& value : status.values) {
        if (value.key == kAccepted) {
          nodes_[counted].used = toCount(value.value);
        }
      }
    }
  }
}

}  // namespace omega_slam
