#include "nodes/common/bag_topics.h"

#include <fmt/format.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/exceptions.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>

#include "nodes/common/tf_lookup.h"

namespace omega_slam {
namespace {

// A bag is longer than any of its messages, but where it is short and compressed [bytes].
constexpr std::uint64_t kSmallestLimit = 65536;

struct Topic {
  std::string type;
  std::string definition;  ///< MD5 sum of the message definition
};

std::map<std::string, Topic> topicsOf(const rosbag::Bag& bag) {
  std::map<std::string, Topic> topics;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    topics.insert({connection->topic, {connection->datatype, connection->md5sum}});
  }
  return topics;
}

template <class Message>
std::string typeName() {
  return ros::message_traits::datatype<Message>();
}

/// Of all that has the right name, in case the type has changed since the bag was recorded.
template <class Message>
void requireKnownDefinition(const std::string& path, const std::string& name, const Topic& topic) {
  if (topic.definition != ros::message_traits::md5sum<Message>()) {
    throw BagError(fmt::format(
        "{}: the topic {} was recorded with another definition of {} than today's; `rosbag fix` "
        "may convert it.",
        path, name, topic.type));
  }
}

std::vector<std::string> topicsOfType(const std::map<std::string, Topic>& topics,
                                      const std::string& type) {
  std::vector<std::string> names;
  for (const auto& [name, topic] : topics) {
    if (topic.type == type) {
      names.push_back(name);
    }
  }
  return names;
}

/// Whether two names are the same but for the slash in front.
bool isSameName(const std::string& a, const std::string& b) { return frameName(a) == frameName(b); }

/// The topic asked for by name, which must have the type; or all that have the type.
template <class Message>
std::vector<std::string> candidates(const rosbag::Bag& bag, const std::string& path,
                                    const std::string& wanted) {
  const auto topics = topicsOf(bag);
  std::vector<std::string> names = topicsOfType(topics, typeName<Message>());
  if (!wanted.empty()) {
    names.erase(std::remove_if(names.begin(), names.end(),
                               [&](const auto& name) { return !isSameName(name, wanted); }),
                names.end());
    if (names.empty()) {
      throw BagError(fmt::format("{}: there is no topic {} of type {}. {}", path, wanted,
                                 typeName<Message>(), listTopics(bag)));
    }
  }
  for (const std::string& name : names) {
    requireKnownDefinition<Message>(path, name, topics.at(name));
  }
  return names;
}

std::string chooseScan(const rosbag::Bag& bag, const std::string& path, const std::string& wanted) {
  const auto names = candidates<sensor_msgs::LaserScan>(bag, path, wanted);
  if (names.empty()) {
    throw BagError(fmt::format("{}: there are no laser scans. {}", path, listTopics(bag)));
  }
  if (names.size() > 1) {
    throw BagError(
        fmt::format("{}: there are several topics of laser scans: {}. Choose one with "
                    "--scan-topic.",
                    path, fmt::join(names, ", ")));
  }
  return names.front();
}

std::string chooseOdometry(const rosbag::Bag& bag, const std::string& path,
                           const std::string& wanted) {
  if (isSameName(wanted, "tf")) {
    return "";
  }
  const auto names = candidates<nav_msgs::Odometry>(bag, path, wanted);
  const auto usual = std::find_if(names.begin(), names.end(),
                                  [](const auto& name) { return isSameName(name, "odom"); });
  if (usual != names.end()) {
    return *usual;
  }
  if (names.size() > 1) {
    throw BagError(
        fmt::format("{}: there are several topics of odometry: {}. Choose one with "
                    "--odom-topic, or tf.",
                    path, fmt::join(names, ", ")));
  }
  return names.empty() ? "" : names.front();
}

/// tf has been recorded under two names of the same type; the definition tells.
std::vector<std::string> chooseTf(const rosbag::Bag& bag) {
  std::vector<std::string> names;
  for (const auto& [name, topic] : topicsOf(bag)) {
    const bool is_transform =
        topic.definition == ros::message_traits::md5sum<tf2_msgs::TFMessage>();
    if (is_transform && (isSameName(name, "tf") || isStaticTf(name))) {
      names.push_back(name);
    }
  }
  return names;
}

/// Bags of all versions begin with the same letters.
bool startsLikeABag(const std::string& path) {
  const std::string magic = "#ROSBAG";
  std::string start(magic.size(), ' ');
  std::ifstream file(path, std::ios::binary);
  return file.read(&start[0], static_cast<std::streamsize>(start.size())) && start == magic;
}

}  // namespace

void openBag(rosbag::Bag& bag, const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    throw BagError(path + ": there is no such file.");
  }
  try {
    bag.open(path, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw BagError(path +
                   ": the bag has no index, as one whose recording was cut short; `rosbag "
                   "reindex` makes a new one.");
  } catch (const std::exception& error) {
    if (!startsLikeABag(path)) {
      throw BagError(fmt::format("{}: this is not a bag ({}).", path, error.what()));
    }
    throw BagError(fmt::format(
        "{}: the bag is damaged or cut short ({}); `rosbag reindex` may save what is left.", path,
        error.what()));
  }
}

BagTopics chooseTopics(const rosbag::Bag& bag, const std::string& path,
                       const std::string& scan_topic, const std::string& odometry_topic) {
  BagTopics topics;
  topics.scan = chooseScan(bag, path, scan_topic);
  topics.odometry = chooseOdometry(bag, path, odometry_topic);
  topics.tf = chooseTf(bag);
  if (topics.odometry.empty() && topics.tf.empty()) {
    throw BagError(fmt::format("{}: there is no odometry, neither {} nor tf. {}", path,
                               typeName<nav_msgs::Odometry>(), listTopics(bag)));
  }
  return topics;
}

void requireSaneSize(const rosbag::MessageInstance& instance, const rosbag::Bag& bag,
                     const std::string& path) {
  if (instance.size() > std::max(bag.getSize(), kSmallestLimit)) {
    throw BagError(path + ": the bag is damaged: a message is longer than all of it.");
  }
}

bool isStaticTf(const std::string& topic) { return isSameName(topic, "tf_static"); }

std::string listTopics(const rosbag::Bag& bag) {
  std::vector<std::string> names;
  for (const auto& [name, topic] : topicsOf(bag)) {
    names.push_back(fmt::format("{} ({})", name, topic.type));
  }
  return names.empty() ? "It is empty." : fmt::format("It holds: {}.", fmt::join(names, ", "));
}

}  // namespace omega_slam
