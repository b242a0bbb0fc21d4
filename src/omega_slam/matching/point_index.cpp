#include "omega_slam/matching/point_index.h"

#include <algorithm>
#include <array>
#include <nanoflann.hpp>
#include <utility>

namespace omega_slam::matching {

namespace {

/// What nanoflann wants to know of a set of points. Its names, not ours.
struct Adaptor {
  const Points& points;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t axis) const {
    return points[index][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

using KdTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>,
                                                   Adaptor, 2, std::size_t>;

}  // namespace

struct PointIndex::Tree {
  explicit Tree(const Points& points) : adaptor{points}, tree(2, adaptor, {10}) {
    tree.buildIndex();
  }
  Adaptor adaptor;
  KdTree tree;
};

PointIndex::PointIndex(const Points& points) : tree_(std::make_unique<Tree>(points)) {}
PointIndex::~PointIndex() = default;

void PointIndex::nearest(const Eigen::Vector2d& query, std::size_t count,
                         std::vector<Neighbour>& neighbours) const {
  constexpr std::size_t kMost = 16;
  std::array<std::size_t, kMost> indices{};
  std::array<double, kMost> distances{};
  const std::size_t wanted = std::min({count, kMost, tree_->adaptor.points.size()});
  neighbours.clear();
  if (wanted == 0) {
    return;
  }
  const std::size_t found =
      tree_->tree.knnSearch(query.data(), wanted, indices.data(), distances.data());
  for (std::size_t i = 0; i < found; ++i) {
    neighbours.push_back({indices[i], distances[i]});
  }
}

void PointIndex::within(const Eigen::Vector2d& query, double radius,
                        std::vector<Neighbour>& neighbours) const {
  neighbours.clear();
  if (tree_->adaptor.points.empty()) {
    return;
  }
  std::vector<std::pair<std::size_t, double>> found;
  nanoflann::SearchParams unsorted;
  unsorted.sorted = false;
  tree_->tree.radiusSearch(query.data(), radius * radius, found, unsorted);
  for (const auto& [index, squared_distance] : found) {
    neighbours.push_back({index, squared_distance});
  }
}

}  // namespace omega_slam::matching
