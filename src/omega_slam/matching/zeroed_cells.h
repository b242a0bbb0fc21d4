#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace omega_slam::matching {

/// Cells, all bits of which are zero to begin with. The system hands out zeroed memory where it is
/// first written to: a wide window costs only what is drawn in it. (A std::vector writes all.)
template <typename CellType>
class ZeroedCells {
  static_assert(std::is_trivially_copyable_v<CellType> &&
                std::is_trivially_destructible_v<CellType>);

 public:
  ZeroedCells() = default;

  /// @throws std::bad_alloc
  explicit ZeroedCells(std::size_t size)
      : size_(size), cells_(static_cast<CellType*>(std::calloc(size, sizeof(CellType)))) {
    if (size > 0 && !cells_) {
      throw std::bad_alloc();
    }
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  CellType& operator[](std::size_t i) { return cells_.get()[i]; }
  const CellType& operator[](std::size_t i) const { return cells_.get()[i]; }
  CellType* begin() { return cells_.get(); }
  CellType* end() { return begin() + size_; }
  [[nodiscard]] const CellType* begin() const { return cells_.get(); }
  [[nodiscard]] const CellType* end() const { return begin() + size_; }

 private:
  struct Release {
    void operator()(CellType* cells) const { std::free(cells); }
  };

  std::size_t size_{0};
  std::unique_ptr<CellType, Release> cells_;
};

}  // namespace omega_slam::matching
