#include "omega_slam/slam/relocaliser.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace omega_slam::slam {

using geometry::Pose2;
using graph::NodeId;

namespace {

constexpr double kSpacing = 2.0;  // [m] of the places that are tried
constexpr NodeId kReach = 3;      // keyframes on each side that belong to a place

/// Around a place, up to the next one; the robot may look anywhere.
constexpr matching::SearchWindow kAnywhere{kSpacing, 3.15};
constexpr matching::SearchWindow kWhereRivalsMayBe{6.0, 3.15};
/// Where a guess puts the robot after it has moved on.
constexpr matching::SearchWindow kThere{0.4, 0.2};
constexpr double kMovedOn = 0.2;  // [m], [rad]

NodeId nearestTo(const Pose2& pose, const std::vector<Pose2>& poses) {
  const auto nearest = std::min_element(
      poses.begin(), poses.end(),
      [&](const Pose2& a, const Pose2& b) { return distance(a, pose) < distance(b, pose); });
  return static_cast<NodeId>(nearest - poses.begin());
}

}  // namespace

Relocaliser::Relocaliser(const PlaceMatcherConfig& config) : matcher_(config) {}

std::optional<Relocation> Relocaliser::look(const matching::View& scan, const Pose2& T_odom_base,
                                            const Pose2& believed, const KnownPlaces& known) {
  if (known.poses.empty()) {
    return std::nullopt;
  }
  if (guess_) {
    const Pose2 motion = relativePose(guess_->T_odom_base, T_odom_base);
    if (std::hypot(motion.x, motion.y) < kMovedOn && std::abs(motion.theta) < kMovedOn) {
      return std::nullopt;
    }
    const Pose2 expected = std::exchange(guess_, std::nullopt)->T_map_base * motion;
    return tryAt(nearestTo(expected, known.poses), scan, expected, kThere, known);
  }
  if (places_.empty()) {
    listPlaces(believed, known);
  }
  const NodeId place = places_.back();
  places_.pop_back();
  if (!tryAt(place, scan, known.poses[place], kAnywhere, known)) {
    return std::nullopt;
  }
  // It may be the far end of the room that looks alike.
  const auto found = tryAt(place, scan, known.poses[place], kWhereRivalsMayBe, known);
  if (found) {
    guess_ = Guess{known.poses[place] * found->match.T_reference_scan, T_odom_base};
  }
  return std::nullopt;
}

/// @param guess `T_map_base`
std::optional<Relocation> Relocaliser::tryAt(NodeId place, const matching::View& scan,
                                             const Pose2& guess,
                                             const matching::SearchWindow& window,
                                             const KnownPlaces& known) const {
  const auto around = placeAround(place, kReach, known);
  const auto match = matcher_.match(around, scan, relativePose(known.poses[place], guess), window);
  return match ? std::optional<Relocation>({place, *match}) : std::nullopt;
}

/// Places all over the graph, with some distance between them.
void Relocaliser::listPlaces(const Pose2& believed, const KnownPlaces& known) {
  std::vector<std::pair<double, NodeId>> by_distance;
  for (NodeId id = 0; id < known.poses.size(); ++id) {
    by_distance.emplace_back(distance(known.poses[id], believed), id);
  }
  std::sort(by_distance.begin(), by_distance.end());
  for (const auto& [away, id] : by_distance) {
    const Pose2& pose = known.poses[id];
    const bool is_new = std::none_of(places_.begin(), places_.end(), [&](NodeId other) {
      return distance(known.poses[other], pose) < kSpacing;
    });
    if (is_new) {
      places_.push_back(id);
    }
  }
  std::reverse(places_.begin(), places_.end());
}

}  // namespace omega_slam::slam
