#include "omega_slam/io/rover_log.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/io/plain_text.h"

namespace omega_slam::io {
namespace {

using geometry::kPi;
using geometry::Pose2;

constexpr std::size_t kBeforeRanges = 25;  // numbers of a line
constexpr std::size_t kBeams = 682;
constexpr int kFirstStep = -340;              // of the mirror, from straight ahead
constexpr double kStep = 2.0 * kPi / 1024.0;  // [rad]
constexpr double kNearest = 0.02;             // [m]
constexpr double kFarthest = 5.6;             // [m]

/// What one line says.
struct Reading {
  sensing::LaserScan scan;
  double left{0.0};  // [ticks]
  double right{0.0};
};

/// Numbers of a line, or why they are no reading.
std::string parseNumbers(std::string_view line, std::vector<double>& numbers) {
  for (auto word = takeWord(line); !word.empty(); word = takeWord(line)) {
    numbers.push_back(parseDecimal(word));
    if (!std::isfinite(numbers.back())) {
      return fmt::format("number {} can't be read", numbers.size());
    }
  }
  if (numbers.size() != kBeforeRanges + kBeams) {
    return fmt::format("{} numbers where {} are expected", numbers.size(), kBeforeRanges + kBeams);
  }
  return {};
}

float rangeOf(double millimetres) {
  const double range = 1e-3 * millimetres;
  if (millimetres == 0.0) {
    return std::numeric_limits<float>::infinity();
  }
  return range >= kNearest ? static_cast<float>(range) : std::numeric_limits<float>::quiet_NaN();
}

Reading readingOf(const std::vector<double>& numbers) {
  Reading reading;
  reading.scan.stamp = 1e-6 * numbers[0];
  reading.scan.angle_min = kFirstStep * kStep;
  reading.scan.angle_increment = kStep;
  reading.scan.range_min = kNearest;
  reading.scan.range_max = kFarthest;
  for (std::size_t k = kBeforeRanges; k < numbers.size(); ++k) {
    reading.scan.ranges.push_back(rangeOf(numbers[k]));
  }
  reading.left = numbers[2];
  reading.right = numbers[3];
  return reading;
}

/// The base's motion while its wheels turn steadily: along an arc, here by its chord.
Pose2 motionBetween(const Reading& before, const Reading& after, const RoverGeometry& rover) {
  const double way_per_tick = 2.0 * kPi * rover.wheel_radius / rover.ticks_per_turn;
  const double left = way_per_tick * (after.left - before.left);
  const double right = way_per_tick * (after.right - before.right);
  const double turn = (right - left) / (2.0 * rover.half_axle);
  const double half = 0.5 * turn;
  const double chord = 0.5 * (left + right) * (half == 0.0 ? 1.0 : std::sin(half) / half);
  return {chord * std::cos(half), chord * std::sin(half), geometry::normalizeAngle(turn)};
}

}  // namespace

RoverLog parseRoverLog(std::string_view text, const std::string& name, const RoverGeometry& rover) {
  RoverLog log;
  std::optional<Reading> before;
  Pose2 T_odom_base;
  forEachLine(text, [&](std::size_t number, std::string_view line) {
    std::vector<double> numbers;
    const std::string why = parseNumbers(line, numbers);
    if (numbers.empty()) {
      return;
    }
    if (!why.empty()) {
      log.first_fault =
          log.malformed_lines++ == 0 ? fmt::format("line {}: {}", number, why) : log.first_fault;
      return;
    }
    Reading reading = readingOf(numbers);
    if (before) {
      T_odom_base = T_odom_base * motionBetween(*before, reading, rover);
    }
    log.records.push_back({reading.scan, {rover.T_base_laser, false}, T_odom_base, {}});
    before = std::move(reading);
  });
  if (log.records.empty()) {
    throw std::runtime_error(
        fmt::format("{}: no usable line is in it{}.", name,
                    log.malformed_lines == 0 ? "" : "; the first fault is in " + log.first_fault));
  }
  return log;
}

RoverLog readRoverLog(const std::filesystem::path& path, const RoverGeometry& rover) {
  return parseRoverLog(grid::readFile(path), path.string(), rover);
}

}  // namespace omega_slam::io
