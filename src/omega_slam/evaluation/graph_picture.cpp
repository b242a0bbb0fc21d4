#include "omega_slam/evaluation/graph_picture.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "omega_slam/evaluation/map_canvas.h"
#include "omega_slam/grid/atomic_file.h"

namespace omega_slam::evaluation {
namespace {

// Colours are blue, green, red, as OpenCV has them.
const cv::Scalar kPaperColour(255, 255, 255);
const cv::Scalar kInkColour(70, 62, 56);
const cv::Scalar kChainColour(178, 134, 44);
const cv::Scalar kLoopColour(40, 50, 210);
const cv::Scalar kDoubtedColour(60, 170, 250);
const cv::Scalar kPointColour(84, 150, 38);

constexpr int kSize = 900;  // [pixels] of a panel, without its margin
constexpr int kMargin = 30;
constexpr int kHeader = 50;
constexpr int kShift = 4;  // binary places of a pixel

/// From metres in the map's frame to pixels of a panel.
class Frame {
 public:
  explicit Frame(const graph::PoseGraph& graph) {
    Eigen::AlignedBox2d box;
    for (const geometry::Pose2& pose : graph.poses) {
      if (pose.isFinite()) {
        box.extend(pose.translation());
      }
    }
    if (!box.isEmpty()) {
      centre_ = box.center();
      scale_ = kSize / std::max(box.sizes().maxCoeff(), 1e-6);
    }
  }

  [[nodiscard]] cv::Point place(const geometry::Pose2& pose) const {
    const Eigen::Vector2d offset = scale_ * (pose.translation() - centre_);
    const auto coordinate = [](double value) {
      // What is not finite was never inside; OpenCV's coordinates must not overflow.
      const double bounded = std::isfinite(value) ? std::clamp(value, -1e5, 1e5) : 0.0;
      return static_cast<int>(std::lround(bounded * (1 << kShift)));
    };
    return {coordinate(kMargin + kSize / 2.0 + offset.x()),
            coordinate(kHeader + kMargin + kSize / 2.0 - offset.y())};
  }

  [[nodiscard]] double metresAcross() const { return kSize / scale_; }

 private:
  Eigen::Vector2d centre_{0.0, 0.0};
  double scale_{1.0};  ///< [pixels / m]
};

const cv::Scalar& colourOf(const graph::Constraint& constraint, double weight) {
  if (constraint.kind == graph::ConstraintKind::kLandmark) {
    return kPointColour;
  }
  if (constraint.kind != graph::ConstraintKind::kLoop) {
    return kChainColour;
  }
  return weight < 0.5 ? kDoubtedColour : kLoopColour;
}

void drawConstraints(const GraphPanel& panel, const Frame& frame, bool loops, cv::Mat& canvas) {
  for (std::size_t k = 0; k < panel.graph.constraints.size(); ++k) {
    const graph::Constraint& constraint = panel.graph.constraints[k];
    if ((constraint.kind == graph::ConstraintKind::kLoop) == loops) {
      const double weight = panel.weights.empty() ? 1.0 : panel.weights.at(k);
      cv::line(canvas, frame.place(panel.graph.poses[constraint.from]),
               frame.place(panel.graph.poses[constraint.to]), colourOf(constraint, weight),
               loops ? 1 : 2, cv::LINE_AA, kShift);
    }
  }
}

cv::Mat draw(const GraphPanel& panel) {
  cv::Mat canvas(kSize + 2 * kMargin + kHeader, kSize + 2 * kMargin, CV_8UC3, kPaperColour);
  const Frame frame(panel.graph);
  drawConstraints(panel, frame, true, canvas);
  drawConstraints(panel, frame, false, canvas);
  for (const graph::NodeId point : panel.graph.points) {
    cv::circle(canvas, frame.place(panel.graph.poses[point]), 5 << kShift, kPointColour, cv::FILLED,
               cv::LINE_AA, kShift);
  }
  const std::string header =
      fmt::format("{}   ({:.4g} m across)", panel.caption, frame.metresAcross());
  cv::putText(canvas, header, {kMargin, kHeader - 14}, cv::FONT_HERSHEY_SIMPLEX, 0.6, kInkColour, 1,
              cv::LINE_AA);
  return canvas;
}

}  // namespace

std::string encodeGraphPicture(const std::vector<GraphPanel>& panels) {
  std::vector<cv::Mat> drawn;
  std::transform(panels.begin(), panels.end(), std::back_inserter(drawn), draw);
  cv::Mat picture;
  cv::hconcat(drawn, picture);
  return encodePng(picture);
}

std::string writeGraphPicture(const std::filesystem::path& path,
                              const std::vector<GraphPanel>& panels) {
  try {
    return grid::writeFileAtomically(path, encodeGraphPicture(panels));
  } catch (const std::exception& error) {  // OpenCV's among them
    return fmt::format("{} could not be written: {}.", path.string(), error.what());
  }
}

}  // namespace omega_slam::evaluation
