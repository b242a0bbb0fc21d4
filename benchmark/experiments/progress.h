#pragma once

#include <cstddef>
#include <functional>

namespace omega_slam::experiments {

/// Told how much of the work is done, now and then: (done, all).
using Progress = std::function<void(std::size_t, std::size_t)>;

}  // namespace omega_slam::experiments
