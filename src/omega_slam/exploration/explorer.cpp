#include "omega_slam/exploration/explorer.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "omega_slam/exploration/strategy_factory.h"
#include "omega_slam/grid/pane.h"
#include "omega_slam/sensing/contact.h"

namespace omega_slam::exploration {
namespace {

using geometry::Pose2;

constexpr int kContourMargin = 2;    // [cells] a map may be drawn with poses of a moment before
constexpr double kGoalMoved = 0.1;   // [m] a goal that has moved so far with the map is given anew
constexpr double kSameMark = 0.02;   // [m] marks of contacts that are nearer are one
constexpr double kViewMoved = 0.75;  // [m] a frontier that is now better seen from elsewhere,
constexpr double kOtherWay = 2.0;    // [m] and from so much farther on by the robot's way

ExplorerConfig checked(const ExplorerConfig& config) {
  if (const auto violations = config.validate(); !violations.empty()) {
    throw std::invalid_argument(fmt::format("{}", fmt::join(violations, " ")));
  }
  return config;
}

bool isOption(FrontierId frontier, const std::vector<Option>& options) {
  return std::any_of(options.begin(), options.end(),
                     [frontier](const Option& option) { return option.frontier == frontier; });
}

}  // namespace

Explorer::Explorer(const ExplorerConfig& config)
    : config_(checked(config)),
      strategy_(makeStrategy(config.strategy)),
      wall_follower_(config.switch_probability, static_cast<std::uint64_t>(config.seed)) {}

void Explorer::showMap(std::shared_ptr<const grid::OccupancyGrid> map,
                       const std::vector<PlacedSweep>& news, const geometry::MapMotion* motion) {
  if (!map || map->cells.empty()) {
    return;
  }
  const MapView view(*map);
  const bool is_drawn_on = map_ && motion == nullptr && view.sharesCellsWith(MapView(*map_));
  if (map_ && motion != nullptr) {
    moveAlong(*motion, MapView(*map_));
  }
  map_ = std::move(map);
  map_is_new_ = true;
  if (!is_drawn_on || news.empty()) {
    detector_.searchAll(view);
    return;
  }
  for (const PlacedSweep& placed : news) {
    detector_.update(view, contourOf(*placed.sweep, placed.T_map_base, view, kContourMargin));
  }
}

void Explorer::moveAlong(const geometry::MapMotion& motion, const MapView& old) {
  detector_.move(motion, old);
  set_aside_.move(motion);
  for (Eigen::Vector2d& mark : touched_) {
    mark = motion.apply(mark);
  }
  if (home_) {
    home_ = motion.apply(*home_);
  }
  if (goal_) {
    const Pose2 moved = motion.apply(goal_->T_map_base);
    goal_moved_ = goal_moved_ || geometry::distance(moved, goal_->T_map_base) > kGoalMoved;
    goal_->T_map_base = moved;
  }
}

void Explorer::touch(const std::vector<Eigen::Vector2d>& contacts) {
  if (!last_pose_) {
    return;
  }
  auto marks = sensing::contactMarks(contacts, *last_pose_, config_.robot_radius);
  if (map_) {
    const auto panes = grid::paneMarks(*map_, contacts, *last_pose_, config_.robot_radius);
    marks.insert(marks.end(), panes.begin(), panes.end());
  }
  for (const Eigen::Vector2d& mark : marks) {
    const bool is_new = std::none_of(
        touched_.begin(), touched_.end(),
        [&mark](const Eigen::Vector2d& other) { return (mark - other).norm() < kSameMark; });
    if (is_new) {
      touched_.push_back(mark);
    }
  }
}

Survey Explorer::surveyFrom(const Pose2& T_map_base) const {
  return {*map_, touched_, T_map_base, config_.robot_radius, config_.sensor_range};
}

void Explorer::goalEnded(std::uint64_t id, bool reached) {
  if (driven_ == id) {
    driven_.reset();
  }
  if (goal_ && goal_->id == id && goal_state_ == GoalState::kDriving) {
    goal_state_ = reached ? GoalState::kReached : GoalState::kFailed;
    goal_ended_ = last_now_;
  }
}

Order Explorer::update(double now, const std::optional<Pose2>& T_map_base) {
  account(now, T_map_base);
  if (cancel_is_due_) {
    cancel_is_due_ = false;
    return cancel();
  }
  const bool active = phase_ == Phase::kExploring || phase_ == Phase::kReturning;
  if (!active || !T_map_base || !map_) {
    return {};
  }
  home_ = home_ ? home_ : T_map_base;
  if (goal_moved_ && goal_state_ == GoalState::kDriving) {
    const Goal goal = *goal_;
    return goTo(goal.T_map_base, goal.frontier);
  }
  if (phase_ == Phase::kReturning) {
    return comeHome(now, *T_map_base);
  }
  if (std::string spent = spentBudget(); !spent.empty()) {
    return endExploring(Ending::kBudget, std::move(spent));
  }
  return isDecisionDue(now) ? decide(now, *T_map_base) : Order{};
}

bool Explorer::isStepDone() const {
  constexpr double kAhead = 0.3;  // [m] before its end the next one is given: the robot drives on
  return !strategy_ && goal_state_ == GoalState::kDriving && last_pose_ &&
         geometry::distance(*last_pose_, goal_->T_map_base) < kAhead;
}

bool Explorer::isDecisionDue(double now) const {
  if (isStepDone()) {
    return true;
  }
  if (goal_state_ == GoalState::kReached) {
    return map_is_new_ || now - *goal_ended_ >= config_.settle_time;
  }
  if (goal_state_ == GoalState::kDriving) {
    return !last_decision_ || now - *last_decision_ >= config_.decision_interval;
  }
  return true;
}

Order Explorer::decide(double now, const Pose2& T_map_base) {
  last_decision_ = now;
  const bool map_is_new = std::exchange(map_is_new_, false);
  const bool step_is_done = isStepDone();
  const Pose2 from = step_is_done ? goal_->T_map_base : T_map_base;  // steps join
  goal_state_ = step_is_done ? GoalState::kReached : goal_state_;
  const Survey survey = surveyFrom(T_map_base);
  watchApproach(survey, now);
  judgeGoal(now);
  if (failures_ >= config_.max_failures) {
    return endExploring(Ending::kStuck,
                        fmt::format("{} goals in a row could not be reached.", failures_));
  }
  const std::vector<Option> options = optionsAtAll(survey, now);
  measureProgress(survey, options);
  if (goal_ && !isWorthwhile(survey)) {
    dropGoal();
  }
  const bool chooses_under_way = map_is_new && strategy_ && strategy_->choosesUnderWay();
  if (goal_ && !(chooses_under_way && isOption(goal_->frontier, options))) {
    return {};
  }
  if (!options.empty()) {
    return choose(survey, options, from);
  }
  return set_aside_.isWaiting(now, config_.max_attempts) ? cancel() : whenNothingIsLeft();
}

Order Explorer::whenNothingIsLeft() {
  constexpr double kUnderWay = 0.5;  // [m] a robot that has not driven so far has explored nothing
  const auto& entries = set_aside_.entries();
  const bool failed = std::any_of(entries.begin(), entries.end(),
                                  [](const SetAside& entry) { return entry.failures > 0; });
  if (progress_.goals == 0 || (failed && progress_.distance < kUnderWay)) {
    return endExploring(Ending::kStuck, "No frontier can be reached from the start.");
  }
  return endExploring(Ending::kDone, "No frontier that can be reached is left.");
}

void Explorer::watchApproach(const Survey& survey, double now) {
  constexpr double kNearer = 0.1;  // [m]
  if (goal_state_ != GoalState::kDriving) {
    return;
  }
  const auto left = survey.travelTo(goal_->T_map_base.translation());
  if (left && *left < least_left_ - kNearer) {
    least_left_ = *left;
    nearer_at_ = now;
  } else if (now - nearer_at_ > config_.give_up_time) {
    goal_state_ = GoalState::kFailed;  // the next goal takes its place
  }
}

void Explorer::judgeGoal(double now) {
  if (goal_state_ != GoalState::kReached && goal_state_ != GoalState::kFailed) {
    return;
  }
  const bool reached = goal_state_ == GoalState::kReached;
  failures_ = reached ? 0 : failures_ + 1;
  if (const auto frontier = frontiers().find(goal_->frontier); frontier != frontiers().end()) {
    set_aside_.add(frontier->second.centroid, goal_->T_map_base.translation(),
                   now + config_.set_aside_time, reached);
  }
  dropGoal();
}

bool Explorer::isWorthwhile(const Survey& survey) const {
  if (goal_->frontier == 0) {
    return survey.travelTo(goal_->T_map_base.translation()).has_value();
  }
  const auto found = frontiers().find(goal_->frontier);
  if (found == frontiers().end() || found->second.size < config_.min_frontier) {
    return false;
  }
  const auto option = survey.optionFor(found->second, set_aside_.triedFor(found->second.centroid));
  return option && isStillTheBest(option->viewpoint, found->second, survey);
}

bool Explorer::isStillTheBest(const Viewpoint& other, const Frontier& frontier,
                              const Survey& survey) const {
  const Eigen::Vector2d place = goal_->T_map_base.translation();
  const Eigen::Vector2d other_place = other.T_map_base.translation();
  if ((place - other_place).norm() <= kViewMoved) {
    return true;
  }
  // A viewpoint that moves on along the way is followed. To one that can only be reached by another
  // way the robot would turn round, and might again soon: that must be worth it.
  const auto left = survey.travelTo(place);
  return left && *left <= other.travel + kViewMoved &&
         survey.travelBetween(other_place, place) > kOtherWay && survey.isSeenFrom(frontier, place);
}

std::vector<Option> Explorer::optionsNow(const Survey& survey, double now) const {
  std::vector<Option> options;
  for (const auto& [id, frontier] : frontiers()) {
    const Eigen::Vector2d& place = frontier.centroid;
    if (frontier.size < config_.min_frontier || !isInArea(place) ||
        set_aside_.isLeftAlone(place, now, config_.max_attempts)) {
      continue;
    }
    if (auto option = survey.optionFor(frontier, set_aside_.triedFor(place))) {
      options.push_back(*option);
    }
  }
  return options;
}

std::vector<Option> Explorer::optionsAtAll(const Survey& survey, double now) {
  std::vector<Option> options = optionsNow(survey, now);
  if (!options.empty()) {
    return options;
  }
  detector_.searchAll(MapView(*map_));
  options = optionsNow(survey, now);
  if (options.empty() && set_aside_.release(now, config_.max_attempts)) {
    options = optionsNow(survey, now);
  }
  return options;
}

bool Explorer::isInArea(const Eigen::Vector2d& point) const {
  // How often a ray to the right crosses the polygon's edges tells inside from outside.
  const std::vector<double>& corners = config_.area;
  bool inside = corners.empty();
  for (std::size_t i = 0; i < corners.size(); i += 2) {
    const std::size_t k = (i + 2) % corners.size();
    const Eigen::Vector2d a(corners[i], corners[i + 1]);
    const Eigen::Vector2d b(corners[k], corners[k + 1]);
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y())) {
      inside = !inside;
    }
  }
  return inside;
}

void Explorer::measureProgress(const Survey& survey, const std::vector<Option>& options) {
  double behind = 0.0;
  for (const Option& option : options) {
    behind += option.gain;
  }
  const double known = survey.knownArea();
  progress_.share = known > 0.0 ? known / (known + behind) : 0.0;
  progress_.frontiers = options.size();
}

Order Explorer::choose(const Survey& survey, const std::vector<Option>& options,
                       const Pose2& T_map_base) {
  if (!strategy_) {
    return stepAlongWall(survey, T_map_base);
  }
  const Situation situation{
      options,
      T_map_base,
      goal_ ? goal_->frontier : 0,
      home_->translation(),
      [&](std::size_t from) { return survey.travelBetween(options[from], options); },
      [&] {
        return config_.return_home ? survey.travelBetween(options, home_->translation())
                                   : std::vector<double>(options.size(), 0.0);
      }};
  const Option& chosen = options[strategy_->choose(situation)];
  if (goal_ && goal_->frontier == chosen.frontier) {
    return {};
  }
  return goTo(chosen.viewpoint.T_map_base, chosen.frontier);
}

Order Explorer::stepAlongWall(const Survey& survey, const Pose2& T_map_base) {
  const auto step = wall_follower_.next(survey.room(), T_map_base);
  if (!step) {
    return endExploring(Ending::kStuck, "There is no room for a step in any direction.");
  }
  return goTo(*step, 0);
}

Order Explorer::goTo(const Pose2& T_map_goal, FrontierId frontier) {
  dropGoal();
  goal_ = Goal{next_goal_++, T_map_goal, frontier};
  goal_state_ = GoalState::kDriving;
  least_left_ = std::numeric_limits<double>::infinity();
  nearer_at_ = last_now_.value_or(0.0);
  ++progress_.goals;
  driven_ = goal_->id;
  return {Order::Kind::kGo, *goal_};
}

}  // namespace omega_slam::exploration
