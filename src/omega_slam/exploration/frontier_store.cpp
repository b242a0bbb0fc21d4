#include "omega_slam/exploration/frontier_store.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace omega_slam::exploration {
namespace {

/// How much of an old frontier lives on in a fresh one.
struct Claim {
  std::size_t shared{0};  ///< cells of the fresh one that were the old one's, or touch it
  FrontierId old{0};
  std::size_t fresh{0};  ///< index

  bool operator<(const Claim& other) const {
    return std::tie(other.shared, old, fresh) < std::tie(shared, other.old, other.fresh);
  }
};

}  // namespace

FrontierId FrontierStore::ownerOf(const Cell& cell) const {
  const auto owner = owners_.find(cell);
  return owner == owners_.end() ? 0 : owner->second;
}

void FrontierStore::insert(Frontier frontier) {
  for (const Cell& cell : frontier.cells) {
    owners_[cell] = frontier.id;
  }
  const FrontierId id = frontier.id;
  frontiers_[id] = std::move(frontier);
}

void FrontierStore::replace(const std::vector<FrontierId>& old, std::vector<Frontier> fresh) {
  const std::set<FrontierId> replaced(old.begin(), old.end());
  std::vector<Claim> claims;
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    std::map<FrontierId, std::size_t> shared;
    for (const Cell& cell : fresh[i].cells) {
      FrontierId owner = ownerOf(cell);
      for (std::size_t k = 0; owner == 0 && k < kNeighbours.size(); ++k) {
        owner = ownerOf(cell + kNeighbours[k]);
      }
      if (replaced.count(owner) > 0) {
        ++shared[owner];
      }
    }
    for (const auto& [owner, count] : shared) {
      claims.push_back({count, owner, i});
    }
  }
  std::sort(claims.begin(), claims.end());
  std::set<FrontierId> taken;
  for (const Claim& claim : claims) {
    if (fresh[claim.fresh].id == 0 && taken.insert(claim.old).second) {
      fresh[claim.fresh].id = claim.old;
    }
  }
  for (const FrontierId id : replaced) {
    for (const Cell& cell : frontiers_[id].cells) {
      owners_.erase(cell);
    }
    frontiers_.erase(id);
  }
  for (Frontier& frontier : fresh) {
    frontier.id = frontier.id == 0 ? next_id_++ : frontier.id;
    insert(std::move(frontier));
  }
}

void FrontierStore::replaceAll(std::vector<Frontier> fresh) {
  std::vector<FrontierId> old;
  for (const auto& [id, frontier] : frontiers_) {
    old.push_back(id);
  }
  replace(old, std::move(fresh));
}

void FrontierStore::move(const geometry::MapMotion& motion, const MapView& map) {
  owners_.clear();
  for (auto& [id, frontier] : frontiers_) {
    for (Cell& cell : frontier.cells) {
      cell = map.cellAt(motion.apply(map.center(cell)));
      owners_[cell] = id;
    }
    frontier.centroid = motion.apply(frontier.centroid);
  }
}

}  // namespace omega_slam::exploration
