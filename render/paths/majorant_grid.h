#pragma once

#include <cstdint>
#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/transport/optical_depth.h"
#include "render/geometry/box.h"

namespace brume {

// A uniform grid over the cutoff spheres of Gaussians. Each cell knows the Gaussians that touch it
// and a majorant, an upper bound of the sum of their densities in it.
class MajorantGrid {
 public:
  // Cells along the longest axis: two for each of an even row of the Gaussians, within these
  // bounds; fewer where lists would exceed max_entries.
  static constexpr int min_cells = 48;
  static constexpr int max_cells = 128;
  static constexpr std::size_t max_entries = 16'000'000;

  MajorantGrid() = default;
  // Gaussians of cutoff radius 0 are ignored. `readable_past_end`: indices that may be read behind
  // any list.
  MajorantGrid(std::span<const GaussianTerm<double>> gaussians,
               std::span<const double> cutoff_radii, std::size_t readable_past_end);

  [[nodiscard]] bool empty() const { return majorants_.empty(); }
  [[nodiscard]] const glm::ivec3& size() const { return size_; }
  [[nodiscard]] const Box& bounds() const { return bounds_; }

  // The Gaussians of the cell that contains x; empty outside.
  [[nodiscard]] std::span<const std::uint32_t> gaussians_at(const glm::dvec3& x) const;

  // A walk along a ray through the cells, from `t` on.
  class Walk {
   public:
    // `w` unit; up to `length`, which may be +inf.
    Walk(const MajorantGrid& grid, const glm::dvec3& origin, const glm::dvec3& w, double length);

    // Whether there is a cell; else the ray has left the grid or ended.
    [[nodiscard]] bool in_cell() const { return t_ < end_; }
    [[nodiscard]] double enter() const { return t_; }
    [[nodiscard]] double exit() const { return exit_; }
    [[nodiscard]] double majorant() const { return grid_->majorants_[cell_]; }
    [[nodiscard]] std::span<const std::uint32_t> gaussians() const { return grid_->list(cell_); }
    void next();

   private:
    void find_exit();

    const MajorantGrid* grid_;
    double t_ = 0.0;
    double end_ = 0.0;
    double exit_ = 0.0;
    glm::dvec3 next_{0.0};   // parameter of the next plane per axis
    glm::dvec3 delta_{0.0};  // between planes
    glm::ivec3 step_{0};
    glm::ivec3 at_{0};
    std::size_t cell_ = 0;
  };

 private:
  [[nodiscard]] std::size_t index(const glm::ivec3& cell) const {
    return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(size_.y) +
            static_cast<std::size_t>(cell.y)) *
               static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(cell.x);
  }
  [[nodiscard]] glm::ivec3 cell_of(const glm::dvec3& x) const;
  [[nodiscard]] std::span<const std::uint32_t> list(std::size_t cell) const {
    return std::span(entries_).subspan(offsets_[cell], offsets_[cell + 1] - offsets_[cell]);
  }
  void choose_size(std::span<const double> cutoff_radii);
  // Calls visit(cell index, minus the greatest exponent in it) for the cells in which a Gaussian is
  // up to its cutoff radius.
  template <class Visit>
  void each_cell(const GaussianTerm<double>& g, double radius, Visit visit) const;
  // A bound of minus the exponent of an ellipsoid in a cell: along each of its own axes.
  [[nodiscard]] double exponent_in(const GaussianTerm<double>& g, const glm::ivec3& cell) const;

  Box bounds_;
  glm::ivec3 size_{0};
  glm::dvec3 cell_{1.0};  // edges [u]
  std::vector<double> majorants_;
  std::vector<std::size_t> offsets_;
  std::vector<std::uint32_t> entries_;
};

}  // namespace brume
