// Files that are not bags, and bags that were: a sentence, never a crash.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "nodes/common/bag_log.h"
#include "ros_unit/bag_writer.h"
#include "support/temporary_folder.h"

namespace omega_slam::test {

/// tf as it was before 2013: the same message under another name.
struct OldTfMessage : tf2_msgs::TFMessage {};

}  // namespace omega_slam::test

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<omega_slam::test::OldTfMessage> : MD5Sum<tf2_msgs::TFMessage> {
  static const char* value(const omega_slam::test::OldTfMessage&) { return MD5Sum::value(); }
  static const char* value() { return MD5Sum<tf2_msgs::TFMessage>::value(); }
};
template <>
struct Definition<omega_slam::test::OldTfMessage> : Definition<tf2_msgs::TFMessage> {
  static const char* value(const omega_slam::test::OldTfMessage&) {
    return Definition<tf2_msgs::TFMessage>::value();
  }
};
template <>
struct DataType<omega_slam::test::OldTfMessage> {
  static const char* value() { return "tf/tfMessage"; }
  static const char* value(const omega_slam::test::OldTfMessage&) { return value(); }
};

}  // namespace message_traits
namespace serialization {

template <>
struct Serializer<omega_slam::test::OldTfMessage> : Serializer<tf2_msgs::TFMessage> {};

}  // namespace serialization
}  // namespace ros

namespace omega_slam {
namespace {

using testing::HasSubstr;

class HostileBag : public testing::Test {
 protected:
  /// Two seconds of a robot that drives, with its laser's place; the bytes of that bag.
  [[nodiscard]] std::string goodBag() const {
    const auto path = folder_.path() / "good.bag";
    test::BagWriter writer(path);
    writer.transform(100.0, "base_link", "laser", {0.2, 0.0, 0.0});
    for (int i = 0; i <= 20; ++i) {
      writer.odometry(100.0 + 0.1 * i, {0.1 * i, 0.0, 0.0});
      writer.scan(100.05 + 0.1 * i);
    }
    writer.close();
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// @return why it was refused; empty if it was read to its end
  [[nodiscard]] std::string read(const std::string& bytes) const {
    return readFile(folder_.write("hostile.bag", bytes).string());
  }

  [[nodiscard]] static std::string readFile(const std::string& path) {
    try {
      BagLog log(path, BagLogOptions{});
      while (log.next()) {
      }
    } catch (const BagError& error) {
      return error.what();
    }
    return "";
  }

  test::TemporaryFolder folder_;
};

TEST_F(HostileBag, GoodBagIsReadToItsEnd) { EXPECT_EQ(read(goodBag()), ""); }

TEST_F(HostileBag, MissingFileIsNamed) {
  EXPECT_EQ(readFile("/nowhere/log.bag"), "/nowhere/log.bag: there is no such file.");
}

TEST_F(HostileBag, FolderIsNoFile) {
  EXPECT_THAT(readFile(folder_.path().string()), HasSubstr("there is no such file."));
}

TEST_F(HostileBag, TextIsNotABag) {
  EXPECT_THAT(read("FLASER 3 1.0 1.0 1.0 0 0 0 0 0 0 1 host 1\n"),
              HasSubstr("hostile.bag: this is not a bag"));
  EXPECT_THAT(read(""), HasSubstr("hostile.bag: this is not a bag"));
}

TEST_F(HostileBag, BagWithoutIndexSaysHowToMendIt) {
  std::string bytes = goodBag();
  // The header's field index_pos is 0 until a recording is closed.
  const std::string field = "index_pos=";
  bytes.replace(bytes.find(field) + field.size(), 8, 8, '\0');
  EXPECT_THAT(read(bytes), HasSubstr("the bag has no index, as one whose recording was cut short; "
                                     "`rosbag reindex` makes a new one."));
}

TEST_F(HostileBag, BagCutShortSaysHowToMendIt) {
  const std::string bytes = goodBag();
  EXPECT_THAT(read(bytes.substr(0, bytes.size() / 2)),
              HasSubstr("`rosbag reindex` may save what is left."));
}

TEST_F(HostileBag, BagCutShortAnywhereIsRefused) {
  const std::string bytes = goodBag();
  for (std::size_t size = 0; size + 1 < bytes.size(); size += 97) {
    EXPECT_NE(read(bytes.substr(0, size)), "") << size << " of " << bytes.size() << " bytes";
  }
}

TEST_F(HostileBag, MessageLongerThanTheBagIsDamage) {
  std::string bytes = goodBag();
  // A message's record: the fields conn, op = 2 and time (8 bytes), then its length (4 bytes).
  const std::string op = "op=\x02";
  const std::string time = "time=";
  const std::size_t length = bytes.find(time, bytes.find(op)) + time.size() + 8;
  bytes[length + 3] = '\x7f';
  EXPECT_THAT(read(bytes), HasSubstr("the bag is damaged"));
}

TEST_F(HostileBag, OldTypeOfTfIsRead) {
  const auto path = folder_.path() / "old.bag";
  test::BagWriter writer(path);
  test::OldTfMessage message;
  for (const double stamp : {100.0, 102.0}) {
    message.transforms = {
        test::BagWriter::transformMessage(stamp, "odom", "base_link", transformToRos({}))
            .transforms[0],
        test::BagWriter::transformMessage(stamp, "base_link", "laser", transformToRos({}))
            .transforms[0]};
    writer.message(stamp, "/tf", message);
  }
  writer.scan(101.0);
  writer.close();
  BagLog log(path.string(), BagLogOptions{});
  EXPECT_TRUE(log.next());
}

TEST_F(HostileBag, AnotherDefinitionOfTheScanIsNamed) {
  std::string bytes = goodBag();
  const std::string md5 = ros::message_traits::md5sum<sensor_msgs::LaserScan>();
  for (std::size_t at = bytes.find(md5); at != std::string::npos; at = bytes.find(md5, at + 1)) {
    bytes[at] = bytes[at] == '0' ? '1' : '0';
  }
  EXPECT_THAT(read(bytes), HasSubstr("the topic /scan was recorded with another definition of "
                                     "sensor_msgs/LaserScan than today's"));
}

}  // namespace
}  // namespace omega_slam
