#include <gtest/gtest.h>

#include "omega_slam/evaluation/relations.h"
#include "omega_slam/geometry/angle.h"
#include "omega_slam/io/trajectory_file.h"
#include "support/paths.h"

namespace omega_slam::evaluation {
namespace {

constexpr const char* kOdometry = "logs/intel/intel_13631_rawodom.odom";
constexpr const char* kRelations = "logs/intel/intel.relations";

/// What an independent implementation of the metric, in Python, says of the Intel relations and the
/// raw odometry as the trajectory, printed with all digits. It reads the quaternion written with
/// all digits. Units: m, m^2, deg, deg^2.
struct Expected {
  std::size_t covered;
  double translation_mean;
  double translation_deviation;
  double translation_mean_square;
  double translation_max;
  double rotation_mean;
  double rotation_deviation;
  double rotation_mean_square;
};

void expectScore(const RelationsScore& score, const Expected& expected) {
  constexpr double kSame = 1e-6;
  const double degrees = geometry::radiansToDegrees(1.0);
  EXPECT_EQ(score.relations, 2984U);
  EXPECT_EQ(score.covered, expected.covered);
  EXPECT_NEAR(score.translation.mean, expected.translation_mean, kSame);
  EXPECT_NEAR(score.translation.deviation, expected.translation_deviation, kSame);
  EXPECT_NEAR(score.translation.mean_square, expected.translation_mean_square, kSame);
  EXPECT_NEAR(score.translation.max, expected.translation_max, kSame);
  EXPECT_NEAR(score.rotation.mean * degrees, expected.rotation_mean, kSame);
  EXPECT_NEAR(score.rotation.deviation * degrees, expected.rotation_deviation, kSame);
  EXPECT_NEAR(score.rotation.mean_square * degrees * degrees, expected.rotation_mean_square, kSame);
}

class IntelRelations : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto odometry = test::dataFile(kOdometry);
    const auto relations = test::dataFile(kRelations);
    if (!odometry || !relations) {
      GTEST_SKIP() << test::missingData(odometry ? kRelations : kOdometry);
    }
    odometry_ = io::readOdometry(*odometry);
    relations_ = io::readRelations(*relations);
    for (std::size_t k = 0; k < odometry_.size(); k += 25) {
      sparse_.push_back(odometry_[k]);
    }
  }
  geometry::Trajectory odometry_;
  geometry::Trajectory sparse_;  ///< every 25th pose: stamps fall into gaps
  std::vector<graph::Relation> relations_;
};

TEST_F(IntelRelations, RawOdometry) {
  expectScore(scoreRelations(odometry_, relations_),
              {2984, 7.392187308430798, 14.336699584133063, 260.1853881686064, 69.98422202516105,
               39.53938879857323, 53.531681076794825, 4429.004145472407});
}

TEST_F(IntelRelations, BetweenSparsePoses) {
  expectScore(scoreRelations(sparse_, relations_),
              {1990, 7.659542377776676, 14.532820248609374, 269.8714538153475, 69.91417881346416,
               42.562858817141155, 52.99706756881351, 4620.286121581286});
}

TEST_F(IntelRelations, SparsePosesCarriedByTheOdometry) {
  expectScore(scoreRelations(sparse_, relations_, odometry_),
              {1990, 7.626255981061902, 14.545401649934602, 269.72848944660257, 69.9455405713165,
               40.52246803625195, 53.9726510847128, 4555.117480861219});
}

}  // namespace
}  // namespace omega_slam::evaluation
