#include "omega_slam/io/carmen_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/atomic_file.h"
#include "omega_slam/io/plain_text.h"

namespace omega_slam::io {
namespace {

using geometry::kPi;

/// Thrown where a line can't be used; never leaves this file.
struct BadLine {
  std::string why;
};

/// Walks over the fields of one message.
class Fields {
 public:
  explicit Fields(std::string_view line) : rest_(line) {}

  std::string_view word(const char* what) {
    const std::string_view word = takeWord(rest_);
    if (word.empty()) {
      throw BadLine{fmt::format("{} is missing", what)};
    }
    return word;
  }

  /// NaN if the word is no number.
  double anyNumber(const char* what) {
    const std::string_view word = this->word(what);
    const double special = infinite(word);
    return special != 0.0 ? special : parseDecimal(word);
  }

  double number(const char* what) {
    const double value = anyNumber(what);
    if (!std::isfinite(value)) {
      throw BadLine{fmt::format("{} is not a finite number", what)};
    }
    return value;
  }

  std::size_t count(const char* what) {
    const double value = number(what);
    constexpr double kMost = 1e6;
    if (value < 0.0 || value > kMost || value != std::floor(value)) {
      throw BadLine{fmt::format("{} is not a whole number from 0 to 1000000", what)};
    }
    return static_cast<std::size_t>(value);
  }

  geometry::Pose2 pose(const char* what) {
    const double x = number(what);
    const double y = number(what);
    return {x, y, geometry::normalizeAngle(number(what))};
  }

 private:
  static double infinite(std::string_view word) {
    const bool negative = !word.empty() && word.front() == '-';
    word.remove_prefix(negative ? 1 : 0);
    const double infinity = std::numeric_limits<double>::infinity();
    return word == "inf" || word == "Inf" || word == "INF" ? (negative ? -infinity : infinity)
                                                           : 0.0;
  }

  std::string_view rest_;
};

std::vector<float> readRanges(Fields& fields, std::size_t count, double no_return_range) {
  if (count == 0) {
    throw BadLine{"the scan has no beams"};
  }
  std::vector<float> ranges;
  for (std::size_t beam = 0; beam < count; ++beam) {
    const double range = fields.anyNumber("a range");
    if (range >= no_return_range) {
      ranges.push_back(std::numeric_limits<float>::infinity());
    } else {
      ranges.push_back(range > 0.0 ? static_cast<float>(range)
                                   : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return ranges;
}

/// FLASER num_readings [readings] x y theta odom_x odom_y odom_theta stamp host logger_stamp
CarmenRecord readFlaser(Fields fields, const CarmenLogOptions& options) {
  CarmenRecord record;
  const std::size_t beams = fields.count("the number of beams");
  record.scan.ranges = readRanges(fields, beams, options.no_return_range);
  record.scan.angle_min = -kPi / 2.0;
  const std::size_t steps = beams % 2 == 1 ? beams - 1 : beams;
  record.scan.angle_increment = kPi / static_cast<double>(std::max<std::size_t>(steps, 1));
  static_cast<void>(fields.pose("the laser's pose"));
  record.T_odom_base = fields.pose("the odometry");
  record.scan.stamp = fields.number("the time stamp");
  return record;
}

/// ROBOTLASER1 type start_angle field_of_view resolution max_range accuracy remission_mode
/// num_readings [readings] num_remissions [remissions] laser_x laser_y laser_theta robot_x robot_y
/// robot_theta tv rv forward_safety side_safety turn_axis stamp host logger_stamp
CarmenRecord readRobotLaser(Fields fields, const CarmenLogOptions& options) {
  CarmenRecord record;
  static_cast<void>(fields.word("the laser's type"));
  record.scan.angle_min = fields.number("the start angle");
  static_cast<void>(fields.number("the field of view"));
  record.scan.angle_increment = fields.number("the angular resolution");
  const double max_range = fields.number("the maximal range");
  static_cast<void>(fields.word("the accuracy"));
  static_cast<void>(fields.word("the remission mode"));
  const double limit =
      max_range > 0.0 ? std::min(max_range, options.no_return_range) : options.no_return_range;
  record.scan.ranges = readRanges(fields, fields.count("the number of beams"), limit);
  for (std::size_t left = fields.count("the number of remissions"); left > 0; --left) {
    static_cast<void>(fields.word("a remission"));
  }
  static_cast<void>(fields.pose("the laser's pose"));
  record.T_odom_base = fields.pose("the odometry");
  for (const char* what : {"tv", "rv", "forward_safety", "side_safety", "turn_axis"}) {
    static_cast<void>(fields.word(what));
  }
  record.scan.stamp = fields.number("the time stamp");
  return record;
}

bool isMessage(std::string_view line, std::string_view tag) {
  return line.substr(0, tag.size()) == tag && line.substr(tag.size(), 1) == " ";
}

using Reader = CarmenRecord (*)(Fields, const CarmenLogOptions&);

CarmenLog readMessages(std::string_view text, std::string_view tag, Reader reader,
                       const CarmenLogOptions& options) {
  CarmenLog log;
  forEachLine(text, [&](std::size_t number, std::string_view line) {
    if (!isMessage(line, tag)) {
      return;
    }
    try {
      CarmenRecord record = reader(Fields(line.substr(tag.size())), options);
      record.scan.range_max = options.no_return_range;
      const bool backward =
          !log.records.empty() && record.scan.stamp < log.records.back().scan.stamp;
      log.backward_stamps += backward ? 1U : 0U;
      log.records.push_back(std::move(record));
    } catch (const BadLine& bad) {
      ++log.malformed_lines;
      if (log.first_fault.empty()) {
        log.first_fault = fmt::format("line {}: {}", number, bad.why);
      }
    }
  });
  return log;
}

}  // namespace

std::vector<std::string> CarmenLogOptions::validate() const {
  if (std::isfinite(no_return_range) && no_return_range > 0.0) {
    return {};
  }
  return {fmt::format("no_return_range must be above 0 m, but it is {}.", no_return_range)};
}

CarmenLog parseCarmenLog(std::string_view text, const std::string& name,
                         const CarmenLogOptions& options) {
  if (const std::vector<std::string> faults = options.validate(); !faults.empty()) {
    throw std::invalid_argument(fmt::format("{}", fmt::join(faults, " ")));
  }
  CarmenLog log = readMessages(text, "FLASER", readFlaser, options);
  if (log.records.empty() && log.malformed_lines == 0) {
    log = readMessages(text, "ROBOTLASER1", readRobotLaser, options);
  }
  if (log.records.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: no usable laser message (FLASER or ROBOTLASER1) is in it{}.", name,
        log.malformed_lines == 0
            ? ""
            : fmt::format("; {} are malformed, first {}", log.malformed_lines, log.first_fault)));
  }
  return log;
}

CarmenLog readCarmenLog(const std::filesystem::path& path, const CarmenLogOptions& options) {
  return parseCarmenLog(grid::readFile(path), path.string(), options);
}

}  // namespace omega_slam::io
