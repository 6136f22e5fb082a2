#include "render/cpu/raster.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "render/cpu/kernels.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/raster.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/gaussian-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

constexpr float infinite = std::numeric_limits<float>::infinity();

using D = hn::CappedTag<float, Raster::block * Raster::block>;
using V = hn::Vec<D>;

HWY_INLINE V set(float x) {
  return hn::Set(D(), x);
}
HWY_INLINE V3<V> set(const glm::vec3& v) {
  return {set(v.x), set(v.y), set(v.z)};
}

// Where rounding leaves a coordinate [pixels].
HWY_INLINE float Below(float x) {
  return x - (0.01f + 1e-5f * std::abs(x));
}
HWY_INLINE float Above(float x) {
  return x + (0.01f + 1e-5f * std::abs(x));
}

// Where on the film a triangle is.
struct Extent {
  glm::vec2 low{infinite};
  glm::vec2 high{-infinite};

  HWY_INLINE void add(const glm::vec2& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  // An edge that runs on to behind the eye: where it leaves, in that direction on the film.
  HWY_INLINE void add_beyond(const glm::vec2& direction, float rounding) {
    for (int k = 0; k < 2; ++k) {
      if (direction[k] > -rounding) high[k] = infinite;
      if (direction[k] < rounding) low[k] = -infinite;
    }
  }
};

HWY_INLINE Raster::Bounds BoundsOf(const RasterTriangles& triangles, const Raster::View& view,
                                   const Raster::Projected& projected, const glm::uvec3& corners) {
  Extent extent;
  int seen = 0;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t i = corners[k];
    if (!(projected.z[i] > 0.0f)) continue;
    ++seen;
    extent.add({projected.x[i], projected.y[i]});
  }
  if (seen == 0) return {};
  for (int k = 0; seen < 3 && k < 3; ++k) {
    for (const int l : {(k + 1) % 3, (k + 2) % 3}) {
      const std::uint32_t from = corners[k];
      const std::uint32_t to = corners[l];
      if (!(projected.z[from] > 0.0f) || projected.z[to] > 0.0f) continue;
      const glm::vec3 crossing = -projected.z[to] * triangles.relative(from, view.eye) +
                                 projected.z[from] * triangles.relative(to, view.eye);
      const glm::vec3 size = glm::abs(crossing);
      extent.add_beyond({glm::dot(crossing, view.to_x), glm::dot(crossing, view.to_y)},
                        1e-4f * (size.x + size.y + size.z) * glm::length(view.to_x));
    }
  }
  const auto width = static_cast<float>(view.width);
  const auto height = static_cast<float>(view.height);
  const auto first = [](float x, float end) HWY_ATTR {
    return static_cast<std::int16_t>(std::ceil(std::min(std::max(Below(x), 0.0f), end)));
  };
  const auto last = [](float x, float end) HWY_ATTR {
    return static_cast<std::int16_t>(std::floor(std::min(std::max(Above(x), -1.0f), end - 1.0f)));
  };
  return {first(extent.low.x, width), last(extent.high.x, width), first(extent.low.y, height),
          last(extent.high.y, height)};
}

void FindBounds(const RasterTriangles& triangles, const Raster::View& view,
                const Raster::Projected& projected, std::size_t first, std::size_t last,
                Raster::Bounds* bounds) {
  for (std::size_t i = first; i < last; ++i) {
    bounds[i] = BoundsOf(triangles, view, projected, triangles.corners[i]);
  }
}

// Vertices [first, last) of whole vectors. What is behind the eye, or as good as beside it, has
// z <= 0.
void Project(const RasterTriangles& triangles, const Raster::View& view, std::size_t first,
             std::size_t last, Raster::Projected& projected) {
  const D d;
  for (std::size_t i = first; i < last; i += hn::Lanes(d)) {
    const V3<V> p{hn::Sub(hn::LoadU(d, triangles.x.data() + i), set(view.eye.x)),
                  hn::Sub(hn::LoadU(d, triangles.y.data() + i), set(view.eye.y)),
                  hn::Sub(hn::LoadU(d, triangles.z.data() + i), set(view.eye.z))};
    const V z = dot(p, set(view.forward));
    const V size = hn::Add(hn::Abs(p.x), hn::Add(hn::Abs(p.y), hn::Abs(p.z)));
    const auto ahead = hn::Gt(z, hn::Mul(set(1e-5f), size));
    const V inverse = hn::IfThenElseZero(ahead, hn::Div(set(1.0f), z));
    hn::StoreU(hn::MulSub(dot(p, set(view.to_x)), inverse, set(glm::dot(view.corner, view.to_x))),
               d, projected.x.data() + i);
    hn::StoreU(hn::MulSub(dot(p, set(view.to_y)), inverse, set(glm::dot(view.corner, view.to_y))),
               d, projected.y.data() + i);
    hn::StoreU(hn::IfThenElse(ahead, z, hn::Min(z, hn::Zero(d))), d, projected.z.data() + i);
  }
}

// The plane through the eye and an edge from p to q, as a function of the pixel: value + x per_x +
// y per_y. Of the edge from q to p it is exactly the negative, as no compiler chooses which
// products to round.
struct EdgePlane {
  float value, per_x, per_y;

  HWY_INLINE EdgePlane(const glm::vec3& from, const glm::vec3& to, const Raster::View& view) {
    const hn::CappedTag<float, 1> d;
    using V1 = hn::Vec<decltype(d)>;
    const auto vector = [&](const glm::vec3& v) HWY_ATTR {
      return V3<V1>{hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
    };
    const V3<V1> edge = vector(to - from);
    const V3<V1> sum = vector(to + from);
    const V3<V1> n{hn::MulSub(edge.y, sum.z, hn::Mul(edge.z, sum.y)),
                   hn::MulSub(edge.z, sum.x, hn::Mul(edge.x, sum.z)),
                   hn::MulSub(edge.x, sum.y, hn::Mul(edge.y, sum.x))};
    value = hn::GetLane(dot(n, vector(view.corner)));
    per_x = hn::GetLane(dot(n, vector(view.per_x)));
    per_y = hn::GetLane(dot(n, vector(view.per_y)));
  }
};

// The same in the pixels of a vector.
struct EdgeLanes {
  V first, per_x, per_y;

  HWY_INLINE EdgeLanes(const EdgePlane& plane, V column, V row)
      : per_x(set(plane.per_x)), per_y(set(plane.per_y)) {
    first = hn::MulAdd(per_x, column, hn::MulAdd(per_y, row, set(plane.value)));
  }
  // Of the block that starts at a pixel.
  HWY_INLINE V at(V x, V y) const { return hn::MulAdd(per_x, x, hn::MulAdd(per_y, y, first)); }
};

// `part` numbers the vectors of a block.
HWY_INLINE void DrawTriangle(const RasterTriangles& triangles, const Raster::View& view,
                             std::uint32_t index, const Raster::Bounds& bounds, int first_row,
                             std::size_t part, Raster::Buffer& buffer) {
  const D d;
  const hn::RebindToUnsigned<D> du;
  constexpr int side = Raster::block;
  const glm::uvec3& corners = triangles.corners[index];
  const glm::vec3 a = triangles.relative(corners.x, view.eye);
  const glm::vec3 b = triangles.relative(corners.y, view.eye);
  const glm::vec3 c = triangles.relative(corners.z, view.eye);
  const V lane = hn::Iota(d, static_cast<float>(part * hn::Lanes(d)));
  const V row = hn::Floor(hn::Mul(lane, set(1.0f / side)));
  const V column = hn::NegMulAdd(set(side), row, lane);
  const EdgeLanes of_a({b, c, view}, column, row);
  const EdgeLanes of_b({c, a, view}, column, row);
  const EdgeLanes of_c({a, b, view}, column, row);
  const V za = set(glm::dot(a, view.forward));
  const V zb = set(glm::dot(b, view.forward));
  const V zc = set(glm::dot(c, view.forward));
  const V zero = hn::Zero(d);
  const int blocks = (view.width + side - 1) / side;
  const int y0 = std::max(bounds.y0 - first_row, 0) / side;
  const int y1 = std::min(bounds.y1 - first_row, Raster::band_rows - 1) / side;
  for (int y = y0; y <= y1; ++y) {
    for (int x = bounds.x0 / side; x <= bounds.x1 / side; ++x) {
      const V left = set(static_cast<float>(x * side));
      const V top = set(static_cast<float>(first_row + y * side));
      const V ea = of_a.at(left, top);
      const V eb = of_b.at(left, top);
      const V ec = of_c.at(left, top);
      const V sum = hn::Add(ea, hn::Add(eb, ec));
      const auto inside = hn::Or(hn::Ge(hn::Min(ea, hn::Min(eb, ec)), zero),
                                 hn::Le(hn::Max(ea, hn::Max(eb, ec)), zero));
      const auto there = hn::And(inside, hn::Ne(sum, zero));
      if (hn::AllFalse(d, there)) continue;
      const V inverse = hn::Div(set(1.0f), sum);
      const V depth = hn::Mul(inverse, hn::MulAdd(ea, za, hn::MulAdd(eb, zb, hn::Mul(ec, zc))));
      const std::size_t k =
          static_cast<std::size_t>(y * blocks + x) * (side * side) + part * hn::Lanes(d);
      const V known = hn::LoadU(d, buffer.distance.data() + k);
      const auto nearer = hn::And(there, hn::And(hn::Gt(depth, zero), hn::Lt(depth, known)));
      if (hn::AllFalse(d, nearer)) continue;
      hn::BlendedStore(depth, nearer, d, buffer.distance.data() + k);
      hn::BlendedStore(hn::Mul(eb, inverse), nearer, d, buffer.u.data() + k);
      hn::BlendedStore(hn::Mul(ec, inverse), nearer, d, buffer.v.data() + k);
      hn::BlendedStore(hn::Set(du, index), hn::RebindMask(du, nearer), du,
                       buffer.triangle.data() + k);
    }
  }
}

// Depths along forward become distances.
HWY_INLINE void Lengthen(const Raster::View& view, int first_row, Raster::Buffer& buffer) {
  const D d;
  constexpr int side = Raster::block;
  std::size_t k = 0;
  for (int y = 0; y < Raster::band_rows; y += side) {
    for (int x = 0; x < view.width; x += side) {
      for (std::size_t part = 0; part < side * side; part += hn::Lanes(d), k += hn::Lanes(d)) {
        const V lane = hn::Iota(d, static_cast<float>(part));
        const V row = hn::Floor(hn::Mul(lane, set(1.0f / side)));
        const V column = hn::NegMulAdd(set(side), row, lane);
        const V px = hn::Add(column, set(static_cast<float>(x)));
        const V py = hn::Add(row, set(static_cast<float>(first_row + y)));
        const auto along = [&](float from, float per_x, float per_y) HWY_ATTR {
          return hn::MulAdd(px, set(per_x), hn::MulAdd(py, set(per_y), set(from)));
        };
        const V3<V> w{along(view.corner.x, view.per_x.x, view.per_y.x),
                      along(view.corner.y, view.per_x.y, view.per_y.y),
                      along(view.corner.z, view.per_x.z, view.per_y.z)};
        float* distance = buffer.distance.data() + k;
        hn::StoreU(hn::Mul(hn::Sqrt(dot(w, w)), hn::LoadU(d, distance)), d, distance);
      }
    }
  }
}

void DrawBand(const RasterTriangles& triangles, const Raster::View& view,
              std::span<const Raster::Bounds> bounds, std::span<const std::uint32_t> drawn,
              int first_row, Raster::Buffer& buffer) {
  for (const std::uint32_t index : drawn) {
    for (std::size_t part = 0; part < Raster::block * Raster::block / hn::Lanes(D()); ++part) {
      DrawTriangle(triangles, view, index, bounds[index], first_row, part, buffer);
    }
  }
  Lengthen(view, first_row, buffer);
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {

HWY_EXPORT(Project);
HWY_EXPORT(FindBounds);
HWY_EXPORT(DrawBand);

namespace {
constexpr std::size_t chunk = 4096;  // vertices or triangles taken together
}  // namespace

void RasterTriangles::add_vertex(const glm::vec3& p) {
  x.push_back(p.x);
  y.push_back(p.y);
  z.push_back(p.z);
}

void RasterTriangles::pad() {
  const std::size_t size = padded(x.size());
  for (std::vector<float>* of : {&x, &y, &z}) of->resize(size, 0.0f);
}

Raster::Raster(const RasterTriangles& triangles, const CameraRays& rays, const glm::dvec3& eye,
               const Film& film, const Job& job)
    : triangles_(triangles),
      film_(film),
      bands_(static_cast<std::size_t>((film.height + band_rows - 1) / band_rows)) {
  const CameraRays::FilmPlane plane = rays.plane();
  view_ = {glm::vec3(eye),
           glm::vec3(rays.forward()),
           glm::vec3(plane.corner + 0.5 * plane.per_x + 0.5 * plane.per_y),
           glm::vec3(plane.per_x),
           glm::vec3(plane.per_y),
           glm::vec3(plane.per_x / glm::dot(plane.per_x, plane.per_x)),
           glm::vec3(plane.per_y / glm::dot(plane.per_y, plane.per_y)),
           film.width,
           film.height};
  const std::size_t vertices = triangles.x.size();
  for (std::vector<float>* of : {&projected_.x, &projected_.y, &projected_.z}) of->resize(vertices);
  job.each((vertices + chunk - 1) / chunk, [&](std::size_t i) {
    HWY_DYNAMIC_DISPATCH(Project)
    (triangles, view_, i * chunk, std::min((i + 1) * chunk, vertices), projected_);
  });
  sort(job);
}

// By counting, in chunks.
void Raster::sort(const Job& job) {
  const std::size_t count = triangles_.corners.size();
  const std::size_t chunks = (count + chunk - 1) / chunk;
  // Calls visit(triangle, band) for all of a chunk.
  const auto each = [&](std::size_t c, auto visit) {
    for (std::size_t i = c * chunk; i < std::min((c + 1) * chunk, count); ++i) {
      const Bounds& b = bounds_[i];
      if (b.empty()) continue;
      for (int y = b.y0 / band_rows; y <= b.y1 / band_rows; ++y) {
        visit(static_cast<std::uint32_t>(i), static_cast<std::size_t>(y));
      }
    }
  };
  bounds_.resize(count);
  std::vector<std::size_t> next(chunks * bands_, 0);
  job.each(chunks, [&](std::size_t c) {
    HWY_DYNAMIC_DISPATCH(FindBounds)
    (triangles_, view_, projected_, c * chunk, std::min((c + 1) * chunk, count), bounds_.data());
    each(c, [&](std::uint32_t, std::size_t band) { ++next[c * bands_ + band]; });
  });
  std::size_t sum = 0;
  for (std::size_t band = 0; band < bands_; ++band) {
    offsets_.push_back(sum);
    for (std::size_t c = 0; c < chunks; ++c) {
      sum += std::exchange(next[c * bands_ + band], sum);
    }
  }
  offsets_.push_back(sum);
  sorted_.resize(sum);
  job.each(chunks, [&](std::size_t c) {
    each(c, [&](std::uint32_t i, std::size_t band) { sorted_[next[c * bands_ + band]++] = i; });
  });
}

const Raster::Buffer& Raster::draw_band(std::size_t band) const {
  thread_local Buffer buffer;
  const auto blocks = static_cast<std::size_t>((film_.width + block - 1) / block);
  const std::size_t pixels = blocks * block * band_rows;
  buffer.distance.assign(pixels, std::numeric_limits<float>::infinity());
  buffer.u.resize(pixels);
  buffer.v.resize(pixels);
  buffer.triangle.resize(pixels);
  HWY_DYNAMIC_DISPATCH(DrawBand)
  (triangles_, view_, bounds_,
   std::span(sorted_).subspan(offsets_[band], offsets_[band + 1] - offsets_[band]),
   static_cast<int>(band) * band_rows, buffer);
  return buffer;
}

}  // namespace brume
#endif
