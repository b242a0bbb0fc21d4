#include "nodes/common/bag_log.h"

#include <fmt/format.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/query.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <utility>

#include "nodes/common/conversions.h"
#include "nodes/common/tf_lookup.h"
#include "omega_slam/sensing/sweep_duration.h"

namespace omega_slam {
namespace {

// A scan waits so long for its odometry [s of the bag's time]: longer than any driver is late.
constexpr double kPatience = 10.0;
constexpr std::size_t kMostWaiting = 1000;

/// The first message of a topic.
template <class Message>
typename Message::ConstPtr firstOf(const rosbag::Bag& bag, const std::string& path,
                                   const std::string& topic) {
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  for (const rosbag::MessageInstance& instance : view) {
    requireSaneSize(instance, bag, path);
    if (const auto message = instance.instantiate<Message>()) {
      return message;
    }
  }
  throw BagError(fmt::format("{}: there are no messages on {}. {}", path, topic, listTopics(bag)));
}

std::vector<std::string> baseFrames(const BagLogOptions& options,
                                    const std::string& odometry_child) {
  if (!options.base_frame.empty()) {
    return {frameName(options.base_frame)};
  }
  if (!frameName(odometry_child).empty()) {
    return {frameName(odometry_child)};
  }
  return {"base_footprint", "base_link"};
}

/// Whatever goes wrong inside of rosbag while reading is damage to the bag.
template <class Function>
auto guarded(const std::string& path, const Function& function) {
  try {
    return function();
  } catch (const BagError&) {
    throw;
  } catch (const std::exception& error) {
    throw BagError(fmt::format("{}: the bag is damaged: {}.", path, error.what()));
  }
}

}  // namespace

BagLog::BagLog(const std::string& path, const BagLogOptions& options)
    : path_(path), waiting_(kPatience, kMostWaiting) {
  openBag(bag_, path);
  guarded(path, [&] {
    findOut(options);
    startView();
  });
}

void BagLog::findOut(const BagLogOptions& options) {
  topics_ = chooseTopics(bag_, path_, options.scan_topic, options.odometry_topic);
  BagRoleRequest request;
  request.laser_frame =
      frameName(firstOf<sensor_msgs::LaserScan>(bag_, path_, topics_.scan)->header.frame_id);
  request.laser_pose = options.laser_pose;
  std::string odometry_child;
  if (topics_.odometry.empty()) {
    request.odom_frame = frameName(options.odom_frame);
  } else {
    odometry_child = firstOf<nav_msgs::Odometry>(bag_, path_, topics_.odometry)->child_frame_id;
  }
  request.base_frames = baseFrames(options, odometry_child);
  const BagRoles roles = findRoles(bag_, path_, topics_, request);

  odom_frame_ = request.odom_frame;
  report_.scan_topic = topics_.scan;
  report_.odometry = topics_.odometry.empty()
                         ? fmt::format("tf {} -> {}", odom_frame_, roles.base_frame)
                         : topics_.odometry;
  report_.base_frame = roles.base_frame;
  report_.laser_frame = request.laser_frame;
  report_.mount = roles.mount;
}

void BagLog::startView() {
  std::vector<std::string> topics{topics_.scan};
  if (topics_.odometry.empty()) {
    topics.insert(topics.end(), topics_.tf.begin(), topics_.tf.end());
  } else {
    topics.push_back(topics_.odometry);
  }
  view_ = std::make_unique<rosbag::View>(bag_, rosbag::TopicQuery(topics));
  messages_ = view_->size();
  message_ = view_->begin();
}

std::optional<io::ScanRecord> BagLog::next() {
  return guarded(path_, [this] {
    auto record = takeReady();
    while (!record && readMessage()) {
      record = takeReady();
    }
    return record ? record : takeLast();
  });
}

double BagLog::progress() const {
  return messages_ == 0 ? 1.0
                        : static_cast<double>(messages_read_) / static_cast<double>(messages_);
}

bool BagLog::readMessage() {
  if (*message_ == view_->end()) {
    return false;
  }
  const rosbag::MessageInstance& instance = **message_;
  requireSaneSize(instance, bag_, path_);
  if (instance.getTopic() == topics_.scan) {
    readScan(instance);
  } else if (instance.getTopic() == topics_.odometry) {
    readOdometry(instance);
  } else {
    readTransforms(instance);
  }
  const std::optional<double> newest =
      odometry_.empty() ? std::nullopt : std::optional(odometry_.newest());
  for (std::size_t i = waiting_.giveUp(newest, instance.getTime().toSec()).size(); i > 0; --i) {
    dropScan("no odometry came for it");
  }
  ++*message_;
  ++messages_read_;
  return true;
}

void BagLog::readScan(const rosbag::MessageInstance& instance) {
  const auto message = instance.instantiate<sensor_msgs::LaserScan>();
  ++report_.scans;
  if (!message) {
    dropScan("another message definition");
    return;
  }
  if (frameName(message->header.frame_id) != report_.laser_frame) {
    dropScan("another laser's frame");
    return;
  }
  WaitingScan scan;
  scan.scan = scanFromRos(*message);
  scan.end = scan.scan.stamp + sensing::sweepDuration(scan.scan);
  scan.arrival = instance.getTime().toSec();
  if (waiting_.push(std::move(scan))) {
    dropScan("too many scans wait for odometry");
  }
}

void BagLog::readOdometry(const rosbag::MessageInstance& instance) {
  const auto message = instance.instantiate<nav_msgs::Odometry>();
  const auto pose = message ? poseFromRos(message->pose.pose) : std::nullopt;
  if (!pose) {
    ++report_.dropped_odometry["not a rigid motion of finite numbers"];
    return;
  }
  addOdometry(message->header.stamp.toSec(), *pose);
}

void BagLog::readTransforms(const rosbag::MessageInstance& instance) {
  const auto message = instance.instantiate<tf2_msgs::TFMessage>();
  if (!message) {
    return;
  }
  frames_.add(*message, isStaticTf(instance.getTopic()));
  if (!frames_.connects(odom_frame_, report_.base_frame)) {
    return;
  }
  const auto odometry = lookupOdometry(frames_.buffer(), odom_frame_, report_.base_frame);
  // Most messages are of other frames, and bring nothing new.
  if (odometry.value && (odometry_.empty() || odometry.value->stamp != odometry_.newest())) {
    addOdometry(odometry.value->stamp, odometry.value->pose);
  }
}

void BagLog::addOdometry(double stamp, const geometry::Pose2& T_odom_base) {
  switch (odometry_.add(stamp, T_odom_base)) {
    case motion::OdometryVerdict::kTimeJumpedBack:
      // The scans that wait belong to the time before, which nobody will tell of any more.
      for (; !waiting_.empty(); (void)waiting_.pop()) {
        dropScan("the clock jumped back");
      }
      ++report_.odometry_poses;
      break;
    case motion::OdometryVerdict::kAccepted:
      ++report_.odometry_poses;
      break;
    case motion::OdometryVerdict::kNotFinite:
      ++report_.dropped_odometry["not a rigid motion of finite numbers"];
      break;
    case motion::OdometryVerdict::kDuplicate:
      ++report_.dropped_odometry["same stamp as the one before"];
      break;
    case motion::OdometryVerdict::kOutOfOrder:
      ++report_.dropped_odometry["older than the one before"];
      break;
  }
}

std::optional<io::ScanRecord> BagLog::takeReady() {
  while (!waiting_.empty() && !odometry_.empty()) {
    const WaitingScan& scan = waiting_.front();
    if (odometry_.covers(scan.scan.stamp) && odometry_.covers(scan.end)) {
      return makeRecord(waiting_.pop());
    }
    if (scan.scan.stamp >= odometry_.oldest()) {
      return std::nullopt;
    }
    (void)waiting_.pop();
    dropScan("before the odometry begins");
  }
  return std::nullopt;
}

std::optional<io::ScanRecord> BagLog::takeLast() {
  while (!waiting_.empty()) {
    WaitingScan scan = waiting_.pop();
    if (odometry_.covers(scan.scan.stamp)) {
      return makeRecord(std::move(scan));
    }
    dropScan("after the odometry ends");
  }
  return std::nullopt;
}

io::ScanRecord BagLog::makeRecord(WaitingScan waiting) {
  io::ScanRecord record;
  record.scan = std::move(waiting.scan);
  record.mount = report_.mount;
  const double start = record.scan.stamp;
  record.T_odom_base = *odometry_.at(start);
  const double duration = waiting.end - start;
  if (const auto T_odom_end = odometry_.at(waiting.end)) {
    record.motion_during_sweep = relativePose(record.T_odom_base, *T_odom_end);
  } else if (const auto T_odom_before = odometry_.at(start - duration)) {
    // The bag ends within this sweep: it goes on as it went.
    record.motion_during_sweep = relativePose(*T_odom_before, record.T_odom_base);
  }
  ++report_.records;
  return record;
}

std::map<std::string, std::size_t> BagLog::dropped() const { return report_.dropped_scans; }

std::string BagLog::description() const {
  return fmt::format("bag with scans on {}, odometry from {}.", report_.scan_topic,
                     report_.odometry);
}

}  // namespace omega_slam
