#include "omega_slam/slam/relocaliser.h"

#include <algorithm>
#include <cmath>

namespace omega_slam::slam {

using geometry::Pose2;
using graph::NodeId;

namespace {

constexpr double kSpacing = 2.0;   // [m] of the places that are tried
constexpr NodeId kReach = 3;       // keyframes on each side that belong to a place
constexpr int kPlacesPerLook = 3;  // of which each takes a wide search

/// Around a place, up to the next one; the robot may look anywhere.
constexpr matching::SearchWindow kAnywhere{kSpacing, 3.15};
/// Fits nearer to each other than this are one.
constexpr double kSame = 0.4;  // [m], [rad]
/// Of the confidence of the best fit: another one with more may be it as well.
constexpr double kRival = 0.9;

/// A guess is looked at again whenever the robot has moved on by so much, and has to be confirmed
/// so many times more than not: three metres lead out of a room that looks like another.
constexpr double kMovedOn = 0.5;   // [m]
constexpr double kTurnedOn = 0.7;  // [rad]
constexpr int kConfirmations = 6;
/// Where a guess puts the robot then.
constexpr matching::SearchWindow kThere{0.4, 0.2};

bool isSame(const Pose2& a, const Pose2& b) {
  const Pose2 gap = relativePose(a, b);
  return std::hypot(gap.x, gap.y) < kSame && std::abs(gap.theta) < kSame;
}

/// Places all over the graph, with some distance between them.
std::vector<NodeId> placesOf(const std::vector<Pose2>& poses) {
  std::vector<NodeId> places;
  for (NodeId id = 0; id < poses.size(); ++id) {
    const bool is_new = std::none_of(places.begin(), places.end(), [&](NodeId other) {
      return distance(poses[other], poses[id]) < kSpacing;
    });
    if (is_new) {
      places.push_back(id);
    }
  }
  return places;
}

NodeId nearestTo(const Pose2& pose, const std::vector<Pose2>& poses) {
  const auto nearest = std::min_element(
      poses.begin(), poses.end(),
      [&](const Pose2& a, const Pose2& b) { return distance(a, pose) < distance(b, pose); });
  return static_cast<NodeId>(nearest - poses.begin());
}

}  // namespace

Relocaliser::Relocaliser(const PlaceMatcherConfig& config) : matcher_(config) {}

std::optional<Relocation> Relocaliser::look(const matching::View& scan, const Pose2& T_odom_base,
                                            const KnownPlaces& known) {
  if (known.poses.empty()) {
    return std::nullopt;
  }
  if (guess_) {
    return confirm(scan, T_odom_base, known);
  }
  if (places_.empty()) {
    round_ = {scan, T_odom_base};
    fits_.clear();
    places_ = placesOf(known.poses);
  }
  for (int i = 0; i < kPlacesPerLook && !places_.empty(); ++i) {
    const NodeId place = places_.back();
    places_.pop_back();
    if (const auto fit = tryAt(place, round_.scan, known.poses[place], kAnywhere, known)) {
      fits_.push_back({known.poses[place] * fit->match.T_reference_scan, fit->match.confidence});
    }
  }
  if (places_.empty()) {
    guessFromRound();
  }
  return std::nullopt;
}

/// All places have been tried: it is one of them, or none, or several look alike.
void Relocaliser::guessFromRound() {
  const auto best = std::max_element(fits_.begin(), fits_.end(), [](const Fit& a, const Fit& b) {
    return a.confidence < b.confidence;
  });
  const bool has_rival = std::any_of(fits_.begin(), fits_.end(), [&](const Fit& fit) {
    return fit.confidence > kRival * best->confidence && !isSame(fit.T_map_base, best->T_map_base);
  });
  if (!fits_.empty() && !has_rival) {
    guess_ = Guess{best->T_map_base, round_.T_odom_base, 0};
  }
}

/// Looks again once the robot has moved on.
std::optional<Relocation> Relocaliser::confirm(const matching::View& scan, const Pose2& T_odom_base,
                                               const KnownPlaces& known) {
  const Pose2 motion = relativePose(guess_->T_odom_base, T_odom_base);
  if (std::hypot(motion.x, motion.y) < kMovedOn && std::abs(motion.theta) < kTurnedOn) {
    return std::nullopt;
  }
  const Pose2 expected = guess_->T_map_base * motion;
  const NodeId place = nearestTo(expected, known.poses);
  const auto found = tryAt(place, scan, expected, kThere, known);
  const int confirmations = guess_->confirmations + (found ? 1 : -1);
  guess_ = Guess{found ? known.poses[place] * found->match.T_reference_scan : expected, T_odom_base,
                 confirmations};
  if (confirmations < 0) {
    guess_.reset();
  }
  return confirmations >= kConfirmations ? found : std::nullopt;
}

void Relocaliser::rest() {
  places_.clear();
  guess_.reset();
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

}  // namespace omega_slam::slam
