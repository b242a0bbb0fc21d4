#pragma once

#include <string>

#include "omega_slam/evaluation/report.h"

namespace omega_slam::evaluation::detail {

/// The report as a page for people; see toMarkdown.
[[nodiscard]] std::string reportAsMarkdown(const Report& report);

}  // namespace omega_slam::evaluation::detail
