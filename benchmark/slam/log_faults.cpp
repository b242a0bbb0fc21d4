#include "slam/log_faults.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>

#include "omega_slam/geometry/angle.h"

namespace omega_slam::experiments {

using geometry::Pose2;

namespace {

constexpr double kFrozen = 10.0;         // [s]
constexpr float kBlockedAt = 0.15F;      // [m]
constexpr double kLegRadius = 0.07;      // [m]
constexpr double kLegsApart = 0.25;      // [m]
constexpr double kPersonAhead = 1.2;     // [m]
constexpr double kPersonSways = 0.6;     // [m] to each side
constexpr double kPersonSwayTime = 7.0;  // [s] to and fro
constexpr double kPersonStays = 120.0;   // [s], and is away as long
constexpr double kCarried = 20.0;        // [s] of the robot's way
constexpr double kOverstated = 1.05;
constexpr double kUnderstated = 0.9;
constexpr double kAskew = 0.05;  // [rad]

/// Calls `fault` for each record with whether it is among the unlucky.
template <class Fault>
void forUnlucky(const Records& records, double share, std::uint64_t seed, Fault fault) {
  std::mt19937_64 random(seed);
  std::bernoulli_distribution unlucky(share);
  for (std::size_t k = 0; k < records.size(); ++k) {
    fault(k, unlucky(random));
  }
}

Records duplicated(const Records& records, double share, std::uint64_t seed) {
  Records spoilt;
  forUnlucky(records, share, seed, [&](std::size_t k, bool twice) {
    spoilt.insert(spoilt.end(), twice ? 2 : 1, records[k]);
  });
  return spoilt;
}

Records missing(const Records& records, double share, std::uint64_t seed) {
  Records spoilt;
  forUnlucky(records, share, seed, [&](std::size_t k, bool lost) {
    if (!lost) {
      spoilt.push_back(records[k]);
    }
  });
  return spoilt;
}

Records reordered(const Records& records, double share, std::uint64_t seed) {
  Records spoilt = records;
  forUnlucky(records, share, seed, [&](std::size_t k, bool late) {
    if (late && k + 1 < spoilt.size()) {
      std::swap(spoilt[k], spoilt[k + 1]);
    }
  });
  return spoilt;
}

/// Whether a time [s] lies in the so many seconds after a quarter, half and three quarters.
class Spells {
 public:
  Spells(const Records& records, double seconds)
      : first_(records.front().scan.stamp),
        span_(records.back().scan.stamp - first_),
        seconds_(seconds) {}

  [[nodiscard]] bool contain(double stamp) const {
    const auto after = [&](double share) { return stamp - (first_ + share * span_); };
    return isWithin(after(0.25)) || isWithin(after(0.5)) || isWithin(after(0.75));
  }

 private:
  [[nodiscard]] bool isWithin(double since) const { return since >= 0.0 && since < seconds_; }

  double first_;
  double span_;
  double seconds_;
};

Records withGaps(Records records, double seconds) {
  const Spells spells(records, seconds);
  records.erase(std::remove_if(records.begin(), records.end(),
                               [&](const auto& it) { return spells.contain(it.scan.stamp); }),
                records.end());
  return records;
}

Records frozen(Records records) {
  const Spells spells(records, kFrozen);
  for (std::size_t k = 1; k < records.size(); ++k) {
    if (spells.contain(records[k].scan.stamp)) {
      records[k].scan.ranges = records[k - 1].scan.ranges;
    }
  }
  return records;
}

Records halfBlocked(Records records) {
  for (io::ScanRecord& record : records) {
    auto& ranges = record.scan.ranges;
    const auto half = static_cast<std::ptrdiff_t>(ranges.size() / 2);
    std::fill(ranges.begin(), ranges.begin() + half,
              std::max(kBlockedAt, static_cast<float>(record.scan.range_min)));
  }
  return records;
}

/// Where a ray from the origin meets a leg at `centre` [m]; none if it misses.
std::optional<double> meetLeg(const Eigen::Vector2d& centre, double angle) {
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  const double ahead = along.dot(centre);
  const double square = kLegRadius * kLegRadius - centre.squaredNorm() + ahead * ahead;
  return ahead > 0.0 && square >= 0.0 ? std::optional(ahead - std::sqrt(square)) : std::nullopt;
}

void walkInFront(sensing::LaserScan& scan, double time) {
  const double sway = kPersonSways * std::sin(2.0 * geometry::kPi * time / kPersonSwayTime);
  for (const double side : {-0.5, 0.5}) {
    const Eigen::Vector2d leg(kPersonAhead, sway + side * kLegsApart);
    for (std::size_t k = 0; k < scan.ranges.size(); ++k) {
      const double angle = scan.angle_min + static_cast<double>(k) * scan.angle_increment;
      const auto range = meetLeg(leg, angle);
      // A NaN says nothing about what is behind, so the leg is seen.
      if (range && !(scan.ranges[k] < *range)) {
        scan.ranges[k] = static_cast<float>(*range);
      }
    }
  }
}

Records withPerson(Records records) {
  const double first = records.front().scan.stamp;
  for (io::ScanRecord& record : records) {
    const double time = record.scan.stamp - first;
    if (std::fmod(time, 2.0 * kPersonStays) < kPersonStays) {
      walkInFront(record.scan, time);
    }
  }
  return records;
}

Records odometryReset(Records records) {
  const std::size_t half = records.size() / 2;
  const Pose2 T_odom_reset = records[half].T_odom_base;
  for (std::size_t k = half; k < records.size(); ++k) {
    records[k].T_odom_base = relativePose(T_odom_reset, records[k].T_odom_base);
  }
  return records;
}

/// As if at half of the run somebody had carried the robot along its way.
Records kidnapped(Records records) {
  const auto half = records.begin() + static_cast<std::ptrdiff_t>(records.size() / 2);
  const double end = half->scan.stamp + kCarried;
  const auto set_down = std::find_if(
      half, records.end(), [&](const io::ScanRecord& it) { return it.scan.stamp >= end; });
  if (set_down == records.end()) {
    return records;
  }
  const Pose2 T_before_after = half->T_odom_base * set_down->T_odom_base.inverse();
  for (auto record = set_down; record != records.end(); ++record) {
    record->T_odom_base = T_before_after * record->T_odom_base;
  }
  records.erase(half + 1, set_down);
  return records;
}

/// What the odometry would have made of the run if ways and turns were so many times as large.
Records odometryScaled(Records records, double ways, double turns) {
  const auto scaled = [&](const Pose2& motion) {
    return Pose2{ways * motion.x, ways * motion.y, turns * motion.theta};
  };
  Pose2 T_odom_base;
  Pose2 before = records.front().T_odom_base;
  for (io::ScanRecord& record : records) {
    const Pose2 now = record.T_odom_base;
    T_odom_base = T_odom_base * scaled(relativePose(before, now));
    before = now;
    record.T_odom_base = T_odom_base;
    record.motion_during_sweep = scaled(record.motion_during_sweep);
  }
  return records;
}

Records laserAskew(Records records) {
  for (io::ScanRecord& record : records) {
    record.mount.T_base_laser.theta += kAskew;
  }
  return records;
}

struct Fault {
  std::string name;
  std::function<Records(Records, std::uint64_t)> apply;
};

const std::vector<Fault>& faults() {
  using Seed = std::uint64_t;
  static const std::vector<Fault> faults{
      {"none", [](Records log, Seed) { return log; }},
      {"duplicated_10", [](Records log, Seed seed) { return duplicated(log, 0.1, seed); }},
      {"duplicated_30", [](Records log, Seed seed) { return duplicated(log, 0.3, seed); }},
      {"reordered_10", [](Records log, Seed seed) { return reordered(log, 0.1, seed); }},
      {"reordered_30", [](Records log, Seed seed) { return reordered(log, 0.3, seed); }},
      {"missing_10", [](Records log, Seed seed) { return missing(log, 0.1, seed); }},
      {"missing_30", [](Records log, Seed seed) { return missing(log, 0.3, seed); }},
      {"gap_1", [](Records log, Seed) { return withGaps(std::move(log), 1.0); }},
      {"gap_10", [](Records log, Seed) { return withGaps(std::move(log), 10.0); }},
      {"gap_60", [](Records log, Seed) { return withGaps(std::move(log), 60.0); }},
      {"frozen_laser", [](Records log, Seed) { return frozen(std::move(log)); }},
      {"half_blocked", [](Records log, Seed) { return halfBlocked(std::move(log)); }},
      {"person", [](Records log, Seed) { return withPerson(std::move(log)); }},
      {"kidnapped", [](Records log, Seed) { return kidnapped(std::move(log)); }},
      {"odometry_reset", [](Records log, Seed) { return odometryReset(std::move(log)); }},
      {"odometry_scale",
       [](Records log, Seed) { return odometryScaled(std::move(log), kOverstated, 1.0); }},
      {"turn_scale",
       [](Records log, Seed) { return odometryScaled(std::move(log), 1.0, kUnderstated); }},
      {"laser_askew", [](Records log, Seed) { return laserAskew(std::move(log)); }}};
  return faults;
}

}  // namespace

std::vector<std::string> faultNames() {
  std::vector<std::string> names;
  for (const Fault& fault : faults()) {
    names.push_back(fault.name);
  }
  return names;
}

Records withFault(const std::string& name, Records records, std::uint64_t seed) {
  for (const Fault& fault : faults()) {
    if (fault.name == name) {
      return records.empty() ? records : fault.apply(std::move(records), seed);
    }
  }
  throw std::invalid_argument(fmt::format("There is no fault \"{}\".", name));
}

}  // namespace omega_slam::experiments
