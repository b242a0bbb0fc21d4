#include "exploration/held_karp.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace omega_slam::experiments {
namespace {

constexpr int kSteps = 300;
constexpr int kPatience = 20;  // steps without a better bound, after which they become shorter

struct OneTree {
  double length{0.0};
  Eigen::VectorXd degrees;
};

/// The least spanning tree of all places but the first (Prim), and the two shortest edges from
/// there: no closed tour is shorter, since a tour is such a tree, too.
OneTree leastOneTree(const Eigen::MatrixXd& lengths) {
  const Eigen::Index count = lengths.rows();
  OneTree tree{0.0, Eigen::VectorXd::Zero(count)};
  const auto take = [&](Eigen::Index a, Eigen::Index b) {
    tree.length += lengths(a, b);
    tree.degrees[a] += 1.0;
    tree.degrees[b] += 1.0;
  };
  std::vector<bool> in_tree(static_cast<std::size_t>(count), false);
  std::vector<Eigen::Index> nearest(static_cast<std::size_t>(count), 1);
  in_tree[1] = true;
  for (Eigen::Index taken = 2; taken < count; ++taken) {
    Eigen::Index best = 0;
    for (Eigen::Index i = 2; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (!in_tree[at] &&
          (best == 0 ||
           lengths(i, nearest[at]) < lengths(best, nearest[static_cast<std::size_t>(best)]))) {
        best = i;
      }
    }
    take(best, nearest[static_cast<std::size_t>(best)]);
    in_tree[static_cast<std::size_t>(best)] = true;
    for (Eigen::Index i = 2; i < count; ++i) {
      Eigen::Index& other = nearest[static_cast<std::size_t>(i)];
      other = lengths(i, best) < lengths(i, other) ? best : other;
    }
  }
  std::vector<std::pair<double, Eigen::Index>> edges;
  for (Eigen::Index i = 1; i < count; ++i) {
    edges.emplace_back(lengths(0, i), i);
  }
  std::sort(edges.begin(), edges.end());
  take(0, edges[0].second);
  take(0, edges[1].second);
  return tree;
}

}  // namespace

double tourBound(const Eigen::MatrixXd& distances) {
  const Eigen::Index count = distances.rows();
  if (count < 3) {
    return count < 2 ? 0.0 : 2.0 * distances(0, 1);
  }
  Eigen::VectorXd taxes = Eigen::VectorXd::Zero(count);
  double best = 0.0;
  double step = 0.1 * distances.mean();
  int idle = 0;
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::MatrixXd lengths =
        distances + taxes.replicate(1, count) + taxes.transpose().replicate(count, 1);
    const OneTree tree = leastOneTree(lengths);
    const double bound = tree.length - 2.0 * taxes.sum();
    idle = bound > best ? 0 : idle + 1;
    best = std::max(best, bound);
    if (idle == kPatience) {
      step *= 0.7;
      idle = 0;
    }
    taxes += step * (tree.degrees.array() - 2.0).matrix();
  }
  return best;
}

}  // namespace omega_slam::experiments
