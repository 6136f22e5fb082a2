#include "render/paths/majorant_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/math/infinity.h"
#include "core/math/max_component.h"

namespace brume {
namespace {

// Points on a cell's border may be rounded into it: its majorant is that of a slightly larger one.
constexpr double border = 1e-6;

}  // namespace

MajorantGrid::MajorantGrid(std::span<const GaussianTerm<double>> gaussians,
                           std::span<const double> cutoff_radii, std::size_t readable_past_end) {
  glm::dvec3 low(infinity);
  glm::dvec3 high(-infinity);
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    if (!(cutoff_radii[i] > 0.0)) continue;
    const Ellipsoid<double>* ellipsoid = gaussians[i].ellipsoid;
    const glm::dvec3 reach = cutoff_radii[i] * (ellipsoid ? ellipsoid->reach() : glm::dvec3(1.0));
    low = glm::min(low, gaussians[i].b - reach);
    high = glm::max(high, gaussians[i].b + reach);
  }
  if (!(low.x < high.x)) return;
  bounds_ = {low, high};
  choose_size(cutoff_radii);

  const auto cells = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                     static_cast<std::size_t>(size_.z);
  majorants_.assign(cells, 0.0);
  offsets_.assign(cells + 1, 0);
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    const GaussianTerm<double>& g = gaussians[i];
    each_cell(g, cutoff_radii[i], [&](std::size_t cell, double e) {
      ++offsets_[cell + 1];
      majorants_[cell] += g.c * std::exp(-e);
    });
  }
  for (std::size_t cell = 0; cell < cells; ++cell) offsets_[cell + 1] += offsets_[cell];
  entries_.resize(offsets_.back() + readable_past_end);
  std::vector<std::size_t> filled(offsets_.begin(), offsets_.end() - 1);
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    each_cell(gaussians[i], cutoff_radii[i], [&](std::size_t cell, double) {
      entries_[filled[cell]++] = static_cast<std::uint32_t>(i);
    });
  }
}

void MajorantGrid::choose_size(std::span<const double> cutoff_radii) {
  const glm::dvec3 extent = bounds_.high - bounds_.low;
  const double wanted = 2.0 * std::cbrt(static_cast<double>(cutoff_radii.size()));
  for (double cells = std::clamp(wanted, double{min_cells}, double{max_cells});; cells *= 0.8) {
    const double edge = max_component(extent) / cells;
    double entries = 0.0;
    for (const double radius : cutoff_radii) {
      if (!(radius > 0.0)) continue;
      const glm::dvec3 crossed = glm::min(glm::dvec3(2.0 * radius), extent) / edge + 1.0;
      entries += crossed.x * crossed.y * crossed.z;
    }
    size_ = glm::clamp(glm::ivec3(glm::ceil(extent / edge)), 1, max_cells);
    if (entries <= static_cast<double>(max_entries) || size_ == glm::ivec3(1)) break;
  }
  cell_ = extent / glm::dvec3(size_);
}

glm::ivec3 MajorantGrid::cell_of(const glm::dvec3& x) const {
  const glm::dvec3 place =
      glm::clamp((x - bounds_.low) / cell_, glm::dvec3(0.0), glm::dvec3(size_));
  return glm::min(glm::ivec3(place), size_ - 1);
}

double MajorantGrid::exponent_in(const GaussianTerm<double>& g, const glm::ivec3& cell) const {
  const glm::dvec3 half = (0.5 + border) * cell_;
  const glm::dvec3 middle = bounds_.low + (glm::dvec3(cell) + 0.5) * cell_;
  const glm::dvec3 q = (middle - g.b) * g.ellipsoid->axes;
  glm::dvec3 nearest(0.0);
  for (int k = 0; k < 3; ++k) {
    nearest[k] = std::max(std::abs(q[k]) - glm::dot(glm::abs(g.ellipsoid->axes[k]), half), 0.0);
  }
  nearest *= g.a / g.ellipsoid->stretch;
  return glm::dot(nearest, nearest);
}

template <class Visit>
void MajorantGrid::each_cell(const GaussianTerm<double>& g, double radius, Visit visit) const {
  if (!(radius > 0.0)) return;
  const glm::dvec3& center = g.b;
  const glm::dvec3 reach = radius * (g.ellipsoid ? g.ellipsoid->reach() : glm::dvec3(1.0));
  const glm::ivec3 first = cell_of(center - reach - border * cell_);
  const glm::ivec3 last = cell_of(center + reach + border * cell_);
  const double a2 = g.a * g.a;
  // Squared distance of the cells of one axis.
  const auto distance2 = [&](int axis, int i) {
    const double low = bounds_.low[axis] + (i - border) * cell_[axis];
    const double high = bounds_.low[axis] + (i + 1 + border) * cell_[axis];
    const double d = std::max({low - center[axis], center[axis] - high, 0.0});
    return d * d;
  };
  for (int z = first.z; z <= last.z; ++z) {
    const double dz = distance2(2, z);
    for (int y = first.y; y <= last.y; ++y) {
      const double dy = dz + distance2(1, y);
      if (dy > radius * radius) continue;
      for (int x = first.x; x <= last.x; ++x) {
        const double d = dy + distance2(0, x);
        if (d > radius * radius) continue;
        const double e = g.ellipsoid ? exponent_in(g, {x, y, z}) : a2 * d;
        if (e <= a2 * radius * radius) visit(index({x, y, z}), e);
      }
    }
  }
}

std::span<const std::uint32_t> MajorantGrid::gaussians_at(const glm::dvec3& x) const {
  if (empty()) return {};
  for (int k = 0; k < 3; ++k) {
    if (!(x[k] >= bounds_.low[k] && x[k] <= bounds_.high[k])) return {};
  }
  return list(index(cell_of(x)));
}

MajorantGrid::Walk::Walk(const MajorantGrid& grid, const glm::dvec3& origin, const glm::dvec3& w,
                         double length)
    : grid_(&grid), end_(length) {
  if (grid.empty()) {
    end_ = 0.0;
    return;
  }
  for (int k = 0; k < 3; ++k) {
    const double low = grid.bounds_.low[k] - origin[k];
    const double high = grid.bounds_.high[k] - origin[k];
    if (w[k] == 0.0) {
      if (low > 0.0 || high < 0.0) end_ = 0.0;
      continue;
    }
    t_ = std::max(t_, std::min(low / w[k], high / w[k]));
    end_ = std::min(end_, std::max(low / w[k], high / w[k]));
  }
  if (!in_cell()) return;
  at_ = grid.cell_of(origin + t_ * w);
  for (int k = 0; k < 3; ++k) {
    step_[k] = w[k] > 0.0 ? 1 : -1;
    if (w[k] == 0.0) {
      next_[k] = delta_[k] = infinity;
      continue;
    }
    delta_[k] = grid.cell_[k] / std::abs(w[k]);
    const int plane = at_[k] + (w[k] > 0.0 ? 1 : 0);
    next_[k] = (grid.bounds_.low[k] + plane * grid.cell_[k] - origin[k]) / w[k];
  }
  find_exit();
}

void MajorantGrid::Walk::find_exit() {
  cell_ = grid_->index(at_);
  exit_ = std::min(std::min({next_.x, next_.y, next_.z}), end_);
}

void MajorantGrid::Walk::next() {
  const int axis = next_.x < next_.y ? (next_.x < next_.z ? 0 : 2) : (next_.y < next_.z ? 1 : 2);
  t_ = std::max(t_, exit_);
  at_[axis] += step_[axis];
  next_[axis] += delta_[axis];
  if (at_[axis] < 0 || at_[axis] >= grid_->size_[axis]) t_ = end_;
  if (in_cell()) find_exit();
}

}  // namespace brume
