#include "render/scattering/source_view.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "render/simd/coefficients.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/scattering/source_view.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/sh_basis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Nodes whose directions are found at a time.
constexpr std::size_t max_nodes = 16;
using Nodes = hn::CappedTag<float, max_nodes>;

constexpr int view_bands = PhaseBands::max_bands;
constexpr std::size_t view_functions = sh_size(view_bands);

// R G B 0 of `count` nodes in a row along x, the first at `first` from the eye, or all in that
// direction if `spacing` is 0: their values times the basis at their directions and `factors` per
// band.
void SumRow(const float* values, std::size_t count, const glm::vec3& first, float spacing,
            std::span<const float> factors, float* sums) {
  constexpr std::size_t size = SourceGrid::node_size(view_bands);
  const Nodes d;
  using V = hn::Vec<Nodes>;
  const hn::CappedTag<float, 4> rgb;
  alignas(64) float basis[view_functions][max_nodes];
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V x =
        hn::MulAdd(hn::Iota(d, static_cast<float>(i)), hn::Set(d, spacing), hn::Set(d, first.x));
    const V y = hn::Set(d, first.y);
    const V z = hn::Set(d, first.z);
    const V square = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
    const V scale = hn::Div(
        hn::Set(d, 1.0f),
        hn::Sqrt(hn::Max(square, hn::Set(d, static_cast<float>(coefficient::tiny_square)))));
    FindBasis<view_bands>(d, hn::Mul(x, scale), hn::Mul(y, scale), hn::Mul(z, scale), factors,
                          basis);
    for (std::size_t k = 0; k < std::min(hn::Lanes(d), count - i); ++k) {
      const float* node = values + (i + k) * size;
      for (std::size_t c = 0; c < 4; c += hn::Lanes(rgb)) {
        auto even = hn::Zero(rgb);
        auto odd = hn::Zero(rgb);
        for (std::size_t f = 0; f < view_functions; f += 2) {
          const float* value = node + 4 * f + c;
          even = hn::MulAdd(hn::Set(rgb, basis[f][k]), hn::LoadU(rgb, value), even);
          odd = hn::MulAdd(hn::Set(rgb, basis[f + 1][k]), hn::LoadU(rgb, value + 4), odd);
        }
        hn::StoreU(hn::Add(even, odd), rgb, sums + 4 * (i + k) + c);
      }
    }
  }
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(SumRow);

void SourceView::update(const SourceFunction& function, const CameraRays& rays, const Job& job) {
  const SourceFunction::WeightParts parts = function.weight_parts(nullptr);
  const SourceGrid& grid = function.grid();
  const glm::dvec3& eye = rays.eye();
  const auto direction = rays.is_parallel() ? std::optional(rays.forward()) : std::nullopt;
  const bool same = grid_ == grid.revision() && (direction || eye_ == eye) &&
                    direction_ == direction && scale_ == parts.harmonics_scale;
  grid_ = grid.revision();
  eye_ = eye;
  direction_ = direction;
  scale_ = parts.harmonics_scale;
  if (same || !function.is_anisotropic()) return;
  std::vector<float> factors;
  for (const double factor : parts.factors) {
    factors.push_back(static_cast<float>(parts.harmonics_scale * factor));
  }
  levels_.resize(grid.levels().size());
  for (std::size_t k = 0; k < grid.levels().size(); ++k) {
    const SourceGrid::Level& level = grid.levels()[k];
    const auto width = static_cast<std::size_t>(level.nodes.count.x);
    const glm::vec3 first(level.first - eye);
    levels_[k].resize(4 * level.nodes.size());
    job.parallel_for(level.nodes.size() / width, [&](std::size_t row) {
      const std::size_t node = row * width;
      const float* values = level.values.data() + SourceGrid::node_size(grid.bands()) * node;
      float* sums = levels_[k].data() + 4 * node;
      const float spacing = direction ? 0.0f : level.nodes.spacing;
      const glm::vec3 begin =
          direction ? glm::vec3(*direction)
                    : first + spacing * glm::vec3(node_coordinates(level.nodes, node));
      HWY_DYNAMIC_DISPATCH(SumRow)(values, width, begin, spacing, factors, sums);
    });
  }
  if (job.stop.stop_requested()) grid_ = 0;
}

SourceLookup SourceView::lookup(const SourceFunction& function) const {
  SourceLookup lookup = function.from_eye(eye_, &function.eye_lobe());
  if (function.is_anisotropic()) lookup.set_view(levels_, direction_.has_value());
  return lookup;
}

}  // namespace brume
#endif
