#include "render/visibility/raster.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "render/simd/gaussian_kernels.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/visibility/raster.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include "render/simd/gaussian-inl.h"
#include "render/visibility/raster_bounds-inl.h"

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {

using D = hn::CappedTag<float, Raster::block * Raster::block>;
using V = hn::Vec<D>;

HWY_INLINE V set(float x) {
  return hn::Set(D(), x);
}
HWY_INLINE V3<V> set(const glm::vec3& v) {
  return {set(v.x), set(v.y), set(v.z)};
}

Raster::WindingDepths FindBounds(const RasterTriangles& triangles, const Raster::View& view,
                                 std::span<const Raster::Vertex> vertices, std::size_t first,
                                 std::size_t last, Raster::Bounds* bounds, Raster::Winding* turns) {
  Raster::WindingDepths depths;
  for (std::size_t i = first; i < last; ++i) {
    const glm::uvec3& c = triangles.corners[i];
    const std::array<Raster::Vertex, 3> corners{vertices[c.x], vertices[c.y], vertices[c.z]};
    const Raster::Bounds on_whole = BoundsOf(corners, view);
    bounds[i] = ClippedTo(view, on_whole);
    if (on_whole.empty()) continue;
    if (IsEdgeOn(triangles, c, view)) {
      bounds[i] = {};
      continue;
    }
    turns[i] = WindingOf(corners);
    depths.sum[static_cast<std::size_t>(turns[i])] += static_cast<double>(corners[0].z);
    ++depths.count[static_cast<std::size_t>(turns[i])];
  }
  return depths;
}

// Vertices [first, last) of whole vectors.
void Project(const RasterTriangles& triangles, const Raster::View& view, std::size_t first,
             std::size_t last, Raster::Vertex* vertices) {
  const D d;
  for (std::size_t i = first; i < last; i += hn::Lanes(d)) {
    const V3<V> p{hn::Sub(hn::LoadU(d, triangles.x.data() + i), set(view.eye.x)),
                  hn::Sub(hn::LoadU(d, triangles.y.data() + i), set(view.eye.y)),
                  hn::Sub(hn::LoadU(d, triangles.z.data() + i), set(view.eye.z))};
    const V z = dot(p, set(view.forward));
    const V size = hn::Add(hn::Abs(p.x), hn::Add(hn::Abs(p.y), hn::Abs(p.z)));
    const auto ahead = hn::Gt(z, hn::Mul(set(1e-5f), size));
    hn::StoreInterleaved4(dot(p, set(view.to_x)), dot(p, set(view.to_y)), z,
                          hn::IfThenElseZero(ahead, hn::Div(set(1.0f), z)), d, &vertices[i].x);
  }
}

// The plane through the eye and an edge from p to q, as a function of the pixel from the film's
// center: value + x per_x + y per_y. Of the edge from q to p it is exactly the negative, as no
// compiler chooses which products to round.
struct EdgePlane {
  float value, per_x, per_y;

  HWY_INLINE EdgePlane(const Raster::Vertex& start, const Raster::Vertex& end) {
    const hn::CappedTag<float, 1> d;
    using V1 = hn::Vec<decltype(d)>;
    const auto set1 = [&](float x) HWY_ATTR { return hn::Set(d, x); };
    const V3<V1> edge{set1(end.x - start.x), set1(end.y - start.y), set1(end.z - start.z)};
    const V3<V1> sum{set1(end.x + start.x), set1(end.y + start.y), set1(end.z + start.z)};
    per_x = hn::GetLane(hn::MulSub(edge.y, sum.z, hn::Mul(edge.z, sum.y)));
    per_y = hn::GetLane(hn::MulSub(edge.z, sum.x, hn::Mul(edge.x, sum.z)));
    value = hn::GetLane(hn::MulSub(edge.x, sum.y, hn::Mul(edge.y, sum.x)));
  }
};

// The same for whole vectors of pixels.
struct EdgeLanes {
  V value, per_x, per_y;

  HWY_INLINE explicit EdgeLanes(const EdgePlane& plane)
      : value(set(plane.value)), per_x(set(plane.per_x)), per_y(set(plane.per_y)) {}
  HWY_INLINE V at(V x, V y) const { return hn::MulAdd(per_x, x, hn::MulAdd(per_y, y, value)); }
};

// The blocks of a band that a triangle may reach.
struct Blocks {
  int x0, x1, y0, y1;

  HWY_INLINE Blocks(const Raster::Bounds& bounds, int first_row)
      : x0(bounds.x0 / Raster::block),
        x1(bounds.x1 / Raster::block),
        y0(std::max(bounds.y0 - first_row, 0) / Raster::block),
        y1(std::min(bounds.y1 - first_row, Raster::band_rows - 1) / Raster::block) {}
};

constexpr std::size_t block_pixels = Raster::block * Raster::block;

// Where the pixels of a vector are in their block.
struct LanePositions {
  V column, row;

  HWY_INLINE explicit LanePositions(std::size_t lane_group) {
    const V lane = hn::Iota(D(), static_cast<float>(lane_group * hn::Lanes(D())));
    row = hn::Floor(hn::Mul(lane, set(1.0f / Raster::block)));
    column = hn::NegMulAdd(set(Raster::block), row, lane);
  }
};

// A triangle at pixels.
struct DepthLanes {
  V depth;  // along forward
  V u, v;   // barycentric, of the second and third corner
};

// That by the planes through the eye and the edges, which weight the corners.
class CornerWeights {
 public:
  HWY_INLINE explicit CornerWeights(const std::array<Raster::Vertex, 3>& corners)
      : a_(set(corners[0].z)), b_(set(corners[1].z)), c_(set(corners[2].z)) {}

  HWY_INLINE DepthLanes at(V, V, V ea, V eb, V ec) const {
    const V inverse = hn::Div(set(1.0f), hn::Add(ea, hn::Add(eb, ec)));
    const V sum = hn::MulAdd(ea, a_, hn::MulAdd(eb, b_, hn::Mul(ec, c_)));
    return {hn::Mul(inverse, sum), hn::Mul(eb, inverse), hn::Mul(ec, inverse)};
  }

 private:
  V a_, b_, c_;
};

// The product of a vector and the direction through a pixel, which is 1 along forward.
struct Linear {
  V value{}, per_x{}, per_y{};
  Linear() = default;
  HWY_INLINE Linear(const glm::vec3& v, const Raster::View& view)
      : value(set(glm::dot(v, view.forward))),
        per_x(set(glm::dot(v, view.per_x))),
        per_y(set(glm::dot(v, view.per_y))) {}
  HWY_INLINE V at(V x, V y) const { return hn::MulAdd(per_x, x, hn::MulAdd(per_y, y, value)); }
};

// That by the triangle's plane, for one that is far larger than its distance: its corners are so
// far away that their roundings exceed the eye's distance from the plane.
class TrianglePlane {
 public:
  // Whether corner weights have too few digits.
  HWY_INLINE static bool suits(const std::array<Raster::Vertex, 3>& corners) {
    const auto& [a, b, c] = corners;
    return std::max({a.z, b.z, c.z}) > 64.0f * std::min({a.z, b.z, c.z});
  }

  HWY_INLINE TrianglePlane(const RasterTriangles& triangles, const glm::uvec3& c,
                           const Raster::View& view) {
    const glm::vec3 to_first = triangles.relative(c.x, view.eye);
    const glm::vec3 first = triangles.relative(c.x, glm::vec3(0.0f));
    const glm::vec3 along = triangles.relative(c.y, first);
    const glm::vec3 across = triangles.relative(c.z, first);
    const glm::vec3 product = glm::cross(along, across);
    const float area = glm::length(product);
    const glm::vec3 normal = product / area;
    height_ = set(glm::dot(normal, to_first));
    steepness_ = Linear(normal, view);
    const glm::vec3 per_u = glm::cross(across, normal) / area;
    const glm::vec3 per_v = glm::cross(normal, along) / area;
    u_ = Linear(per_u, view);
    v_ = Linear(per_v, view);
    first_u_ = set(glm::dot(per_u, to_first));
    first_v_ = set(glm::dot(per_v, to_first));
  }

  HWY_INLINE DepthLanes at(V x, V y, V, V, V) const {
    const V depth = hn::Div(height_, steepness_.at(x, y));
    const auto weight = [&](const Linear& w, V first) HWY_ATTR {
      return hn::Clamp(hn::MulSub(depth, w.at(x, y), first), set(0.0f), set(1.0f));
    };
    return {depth, weight(u_, first_u_), weight(v_, first_v_)};
  }

 private:
  V height_, first_u_, first_v_;
  Linear steepness_, u_, v_;
};

// Draws into the vectors `part` of blocks; where `passes_over`, not into those that are nearer.
template <bool passes_over, class Depths>
HWY_INLINE void DrawTriangle(const std::array<Raster::Vertex, 3>& corners, std::uint32_t index,
                             const Depths& depths, const Blocks& covered, const Raster::View& view,
                             int first_row, std::size_t lane_group, Raster::Buffer& buffer) {
  const D d;
  const hn::RebindToUnsigned<D> du;
  constexpr int side = Raster::block;
  const auto& [a, b, c] = corners;
  // Interpolation rounds.
  const float min_depth = std::min({a.z, b.z, c.z}) - 1e-5f * std::max({a.z, b.z, c.z});
  const int blocks = (view.width + side - 1) / side;
  const auto place = [&](int x, int y) HWY_ATTR {
    return static_cast<std::size_t>(y * blocks + x) * block_pixels + lane_group * hn::Lanes(d);
  };
  if (passes_over) {
    bool is_behind = true;
    for (int y = covered.y0; y <= covered.y1; ++y) {
      for (int x = covered.x0; x <= covered.x1; ++x) {
        is_behind = is_behind && buffer.farthest[place(x, y) / hn::Lanes(d)] <= min_depth;
      }
    }
    if (is_behind) return;
  }
  const LanePositions lanes(lane_group);
  const EdgeLanes of_a(EdgePlane(b, c));
  const EdgeLanes of_b(EdgePlane(c, a));
  const EdgeLanes of_c(EdgePlane(a, b));
  const V zero = hn::Zero(d);
  for (int y = covered.y0; y <= covered.y1; ++y) {
    const int row = view.first.y + first_row + y * side;
    const V py = hn::Add(lanes.row, set(static_cast<float>(row) - view.center.y));
    for (int x = covered.x0; x <= covered.x1; ++x) {
      const int column = view.first.x + x * side;
      const V px = hn::Add(lanes.column, set(static_cast<float>(column) - view.center.x));
      const V ea = of_a.at(px, py);
      const V eb = of_b.at(px, py);
      const V ec = of_c.at(px, py);
      const auto inside = hn::Or(hn::Ge(hn::Min(ea, hn::Min(eb, ec)), zero),
                                 hn::Le(hn::Max(ea, hn::Max(eb, ec)), zero));
      if (hn::AllFalse(d, inside)) continue;
      const auto [depth, u, v] = depths.at(px, py, ea, eb, ec);
      const std::size_t k = place(x, y);
      const V previous_depth = hn::LoadU(d, buffer.distance.data() + k);
      auto nearer = hn::And(inside, hn::And(hn::Gt(depth, zero), hn::Lt(depth, previous_depth)));
      for (const glm::vec4& plane : view.clip) {
        const V along = Linear(glm::vec3(plane), view).at(px, py);
        nearer = hn::And(nearer, hn::Gt(hn::Mul(depth, along), set(plane.w)));
      }
      if (hn::AllFalse(d, nearer)) continue;
      hn::BlendedStore(depth, nearer, d, buffer.distance.data() + k);
      hn::BlendedStore(u, nearer, d, buffer.u.data() + k);
      hn::BlendedStore(v, nearer, d, buffer.v.data() + k);
      hn::BlendedStore(hn::Set(du, index), hn::RebindMask(du, nearer), du,
                       buffer.triangle.data() + k);
    }
  }
}

template <bool passes_over>
HWY_INLINE void DrawTriangles(const RasterTriangles& triangles, const Raster::View& view,
                              std::span<const Raster::Vertex> vertices,
                              std::span<const Raster::Bounds> bounds,
                              std::span<const std::uint32_t> drawn, int first_row,
                              Raster::Buffer& buffer) {
  for (const std::uint32_t index : drawn) {
    const glm::uvec3& c = triangles.corners[index];
    const std::array<Raster::Vertex, 3> corners{vertices[c.x], vertices[c.y], vertices[c.z]};
    const Blocks covered(bounds[index], first_row);
    const auto draw = [&](const auto& depths) HWY_ATTR {
      for (std::size_t lane_group = 0; lane_group < block_pixels / hn::Lanes(D()); ++lane_group) {
        DrawTriangle<passes_over>(corners, index, depths, covered, view, first_row, lane_group,
                                  buffer);
      }
    };
    if (TrianglePlane::suits(corners)) {
      draw(TrianglePlane(triangles, c, view));
    } else {
      draw(CornerWeights(corners));
    }
  }
}

HWY_INLINE void FindFarthest(Raster::Buffer& buffer) {
  const D d;
  for (std::size_t i = 0; i < buffer.farthest.size(); ++i) {
    const V depth = hn::LoadU(d, buffer.distance.data() + i * hn::Lanes(d));
    buffer.farthest[i] = hn::GetLane(hn::MaxOfLanes(d, depth));
  }
}

// Depths along forward become distances.
HWY_INLINE void Lengthen(const Raster::View& view, int first_row, Raster::Buffer& buffer) {
  const D d;
  constexpr int side = Raster::block;
  std::size_t k = 0;
  for (int y = 0; y < Raster::band_rows; y += side) {
    for (int x = 0; x < view.width; x += side) {
      for (std::size_t lane_group = 0; lane_group < block_pixels / hn::Lanes(d);
           ++lane_group, k += hn::Lanes(d)) {
        const LanePositions lanes(lane_group);
        const V px = hn::Add(lanes.column, set(static_cast<float>(view.first.x + x)));
        const V py = hn::Add(lanes.row, set(static_cast<float>(view.first.y + first_row + y)));
        const auto along = [&](float base, float per_x, float per_y) HWY_ATTR {
          return hn::MulAdd(px, set(per_x), hn::MulAdd(py, set(per_y), set(base)));
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

// Four pixels of a block side by side.
HWY_INLINE void StoreFour(const Raster::Buffer& buffer, std::size_t k, RasterPixel* hits,
                          float* distances) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t i = 0; i < 4; ++i) {
    hits[i] = {buffer.distance[k + i], buffer.triangle[k + i], buffer.u[k + i], buffer.v[k + i]};
    distances[i] = buffer.distance[k + i];
  }
#else
  static_assert(sizeof(RasterPixel) == 4 * sizeof(float));
  const hn::FixedTag<float, 4> d;
  const hn::FixedTag<std::uint32_t, 4> du;
  const auto distance = hn::LoadU(d, buffer.distance.data() + k);
  const auto triangle = hn::BitCast(d, hn::LoadU(du, buffer.triangle.data() + k));
  hn::StoreInterleaved4(distance, triangle, hn::LoadU(d, buffer.u.data() + k),
                        hn::LoadU(d, buffer.v.data() + k), d, &hits->distance);
  hn::StoreU(distance, d, distances);
#endif
}

// From blocks to rows of the film.
HWY_INLINE void StoreRows(const Raster::View& view, int first_row, const Raster::Buffer& buffer,
                          RasterPixel* hits, float* distances) {
  constexpr int side = Raster::block;
  std::size_t k = 0;
  for (int y0 = 0; y0 < Raster::band_rows; y0 += side) {
    for (int x = 0; x < view.width; x += side, k += block_pixels) {
      for (int y = y0; y < std::min(y0 + side, view.height - first_row); ++y) {
        const auto source = k + static_cast<std::size_t>((y - y0) * side);
        const auto target =
            static_cast<std::size_t>(first_row + y) * static_cast<std::size_t>(view.width) +
            static_cast<std::size_t>(x);
        if (x + side <= view.width) {
          StoreFour(buffer, source, hits + target, distances + target);
          continue;
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(view.width - x); ++i) {
          hits[target + i] = {buffer.distance[source + i], buffer.triangle[source + i],
                              buffer.u[source + i], buffer.v[source + i]};
          distances[target + i] = buffer.distance[source + i];
        }
      }
    }
  }
}

void DrawBand(const RasterTriangles& triangles, const Raster::View& view,
              std::span<const Raster::Vertex> vertices, std::span<const Raster::Bounds> bounds,
              std::span<const std::uint32_t> nearer, std::span<const std::uint32_t> others,
              int first_row, Raster::Buffer& buffer, RasterPixel* hits, float* distances) {
  DrawTriangles<false>(triangles, view, vertices, bounds, nearer, first_row, buffer);
  buffer.farthest.resize(buffer.distance.size() / hn::Lanes(D()));
  FindFarthest(buffer);
  DrawTriangles<true>(triangles, view, vertices, bounds, others, first_row, buffer);
  Lengthen(view, first_row, buffer);
  StoreRows(view, first_row, buffer, hits, distances);
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
  for (std::vector<float>* array : {&x, &y, &z}) array->resize(size, 0.0f);
}

Raster::Raster(const RasterTriangles& triangles, const CameraRays& rays, const glm::dvec3& eye,
               const Film& film, const Job& job)
    : triangles_(triangles),
      film_(film),
      bands_(static_cast<std::size_t>((film.height + band_rows - 1) / band_rows)) {
  const CameraRays::FilmPlane plane = rays.plane();
  view_ = {glm::vec3(eye),
           eye,
           glm::vec3(rays.forward()),
           glm::vec3(plane.corner + 0.5 * plane.per_x + 0.5 * plane.per_y),
           glm::vec3(plane.per_x),
           glm::vec3(plane.per_y),
           glm::vec3(plane.per_x / glm::dot(plane.per_x, plane.per_x)),
           glm::vec3(plane.per_y / glm::dot(plane.per_y, plane.per_y)),
           glm::vec2(rays.axis() - 0.5),
           rays.whole_size(),
           rays.first_pixel(),
           film.width,
           film.height};
  for (const ClipPlane& clip : rays.clip()) {
    const double distance = glm::dot(clip.point - rays.eye(), clip.normal);
    if (distance > 0.0) view_.clip.emplace_back(glm::vec3(clip.normal), distance);
  }
  const std::size_t vertices = triangles.x.size();
  vertices_.resize(vertices);
  job.parallel_for((vertices + chunk - 1) / chunk, [&](std::size_t i) {
    HWY_DYNAMIC_DISPATCH(Project)
    (triangles, view_, i * chunk, std::min((i + 1) * chunk, vertices), vertices_.data());
  });
  sort(job);
}

// By counting, in chunks.
void Raster::sort(const Job& job) {
  const std::size_t count = triangles_.corners.size();
  const std::size_t chunks = (count + chunk - 1) / chunk;
  const std::size_t lists = 2 * bands_;
  // Calls visit(triangle, list) for all of a chunk: two lists for each band, by turns.
  const auto for_each = [&](std::size_t c, auto visit) {
    for (std::size_t i = c * chunk; i < std::min((c + 1) * chunk, count); ++i) {
      const Bounds& b = bounds_[i];
      if (b.empty()) continue;
      for (int y = b.y0 / band_rows; y <= b.y1 / band_rows; ++y) {
        visit(static_cast<std::uint32_t>(i),
              2 * static_cast<std::size_t>(y) + static_cast<std::size_t>(windings_[i]));
      }
    }
  };
  bounds_.resize(count);
  windings_.resize(count);
  std::vector<WindingDepths> depths(chunks);
  std::vector<std::size_t> next(chunks * lists, 0);
  job.parallel_for(chunks, [&](std::size_t c) {
    depths[c] = HWY_DYNAMIC_DISPATCH(FindBounds)(triangles_, view_, vertices_, c * chunk,
                                                 std::min((c + 1) * chunk, count), bounds_.data(),
                                                 windings_.data());
    for_each(c, [&](std::uint32_t, std::size_t list) { ++next[c * lists + list]; });
  });
  nearer_ = nearer_winding(depths);
  std::size_t sum = 0;
  for (std::size_t list = 0; list < lists; ++list) {
    offsets_.push_back(sum);
    for (std::size_t c = 0; c < chunks; ++c) {
      sum += std::exchange(next[c * lists + list], sum);
    }
  }
  offsets_.push_back(sum);
  sorted_.resize(sum);
  job.parallel_for(chunks, [&](std::size_t c) {
    for_each(c, [&](std::uint32_t i, std::size_t list) { sorted_[next[c * lists + list]++] = i; });
  });
}

Raster::Winding Raster::nearer_winding(std::span<const WindingDepths> depths) {
  WindingDepths all;
  for (const WindingDepths& band : depths) {
    for (std::size_t k = 0; k < 2; ++k) {
      all.sum[k] += band.sum[k];
      all.count[k] += band.count[k];
    }
  }
  // Each mean times both counts.
  const double one = all.sum[0] * static_cast<double>(all.count[1]);
  const double other = all.sum[1] * static_cast<double>(all.count[0]);
  return one <= other ? Winding::one : Winding::other;
}

void Raster::draw(std::size_t band, std::span<RasterPixel> hits, std::span<float> distances) const {
  thread_local Buffer buffer;
  const auto blocks = static_cast<std::size_t>((film_.width + block - 1) / block);
  const std::size_t pixels = blocks * block * band_rows;
  buffer.distance.assign(pixels, std::numeric_limits<float>::infinity());
  buffer.u.resize(pixels);
  buffer.v.resize(pixels);
  buffer.triangle.resize(pixels);
  const auto of_turn = [&](Winding turn) {
    const std::size_t list = 2 * band + static_cast<std::size_t>(turn);
    return std::span(sorted_).subspan(offsets_[list], offsets_[list + 1] - offsets_[list]);
  };
  HWY_DYNAMIC_DISPATCH(DrawBand)
  (triangles_, view_, vertices_, bounds_, of_turn(nearer_),
   of_turn(nearer_ == Winding::one ? Winding::other : Winding::one),
   static_cast<int>(band) * band_rows, buffer, hits.data(), distances.data());
}

}  // namespace brume
#endif
