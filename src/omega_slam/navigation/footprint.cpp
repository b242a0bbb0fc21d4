#include "omega_slam/navigation/footprint.h"

#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "omega_slam/geometry/angle.h"
#include "omega_slam/grid/atomic_file.h"

namespace omega_slam::navigation {
namespace {

constexpr int kDirections = 720;  // in which the outline is measured

/// A convex body with its pose in the base: how far it reaches in a direction.
struct Part {
  std::shared_ptr<const urdf::Geometry> shape;
  Eigen::Isometry3d T_base_part;

  /// The support function: the greatest p . direction of its points. @param direction of length 1
  [[nodiscard]] double reach(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d local = T_base_part.linear().transpose() * direction;
    const double center = direction.dot(T_base_part.translation());
    if (shape->type == urdf::Geometry::SPHERE) {
      return center + static_cast<const urdf::Sphere&>(*shape).radius;
    }
    if (shape->type == urdf::Geometry::CYLINDER) {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(*shape);
      return center + cylinder.radius * local.head<2>().norm() +
             0.5 * cylinder.length * std::abs(local.z());
    }
    const urdf::Vector3& size = static_cast<const urdf::Box&>(*shape).dim;
    return center + 0.5 * local.cwiseAbs().dot(Eigen::Vector3d(size.x, size.y, size.z));
  }
};

Eigen::Isometry3d toEigen(const urdf::Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() << pose.position.x, pose.position.y, pose.position.z;
  result.linear() =
      Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z)
          .normalized()
          .toRotationMatrix();
  return result;
}

/// Adds the parts of a link and of all links below it.
void collectParts(const urdf::Link& link, const Eigen::Isometry3d& T_base_link,
                  std::vector<Part>& parts) {
  for (const auto& collision : link.collision_array) {
    if (!collision || !collision->geometry) {
      continue;
    }
    if (collision->geometry->type == urdf::Geometry::MESH) {
      throw std::runtime_error("the collision geometry of link '" + link.name +
                               "' is a mesh; the footprint needs spheres, cylinders or boxes");
    }
    parts.push_back({collision->geometry, T_base_link * toEigen(collision->origin)});
  }
  for (const auto& joint : link.child_joints) {
    const auto child =
        std::find_if(link.child_links.begin(), link.child_links.end(),
                     [&](const auto& other) { return other->name == joint->child_link_name; });
    if (child != link.child_links.end()) {
      collectParts(**child, T_base_link * toEigen(joint->parent_to_joint_origin_transform), parts);
    }
  }
}

/// The pose of a link in the description's root.
Eigen::Isometry3d poseInRoot(const urdf::ModelInterface& model, const urdf::Link& link) {
  Eigen::Isometry3d T_root_link = Eigen::Isometry3d::Identity();
  for (auto joint = link.parent_joint; joint;) {
    T_root_link = toEigen(joint->parent_to_joint_origin_transform) * T_root_link;
    joint = model.getLink(joint->parent_link_name)->parent_joint;
  }
  return T_root_link;
}

Footprint outlineOf(const std::vector<Part>& parts) {
  Footprint footprint{std::numeric_limits<double>::infinity(), 0.0};
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * geometry::kPi * i / kDirections;
    const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
    double reach = -std::numeric_limits<double>::infinity();
    for (const Part& part : parts) {
      reach = std::max(reach, part.reach(direction));
    }
    footprint.inscribed_radius = std::min(footprint.inscribed_radius, reach);
    footprint.circumscribed_radius = std::max(footprint.circumscribed_radius, reach);
  }
  // Between two directions a corner may reach a little farther than seen, and an edge less far.
  const double between = std::cos(geometry::kPi / kDirections);
  return {std::max(0.0, footprint.inscribed_radius * between),
          footprint.circumscribed_radius / between};
}

}  // namespace

Footprint footprintFromUrdf(const std::string& urdf, const std::string& base_frame) {
  const auto model = urdf::parseURDF(urdf);
  if (!model || !model->getRoot()) {
    throw std::runtime_error("the robot's description is no URDF that can be read");
  }
  const auto base = model->getLink(base_frame);
  if (!base) {
    throw std::runtime_error("the robot's description has no link '" + base_frame + "'");
  }
  std::vector<Part> parts;
  collectParts(*model->getRoot(), poseInRoot(*model, *base).inverse(), parts);
  if (parts.empty()) {
    throw std::runtime_error("the robot's description has no collision geometry");
  }
  const Footprint footprint = outlineOf(parts);
  if (!std::isfinite(footprint.circumscribed_radius) || footprint.circumscribed_radius <= 0.0) {
    throw std::runtime_error("the collision geometry of the robot's description has no size");
  }
  return footprint;
}

Footprint readFootprint(const std::filesystem::path& path, const std::string& base_frame) {
  const std::string text = grid::readFile(path);
  try {
    return footprintFromUrdf(text, base_frame);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path.string() + ": " + error.what() + ".");
  }
}

}  // namespace omega_slam::navigation
