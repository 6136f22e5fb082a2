#include "render/transfer/radiance_transfer.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <span>
#include <utility>

#include "brume/mesh_arrays.h"
#include "core/math/normals.h"
#include "core/math/sphere_rule.h"
#include "core/scene/materials/brdf.h"
#include "core/scene/mesh.h"
#include "render/geometry/rounding.h"
#include "render/visibility/ray_caster.h"

namespace brume {
namespace {

// The neighbours of triangles and vertices in a mesh, by OpenMesh's half-edges. Triangles that do
// not fit a manifold are no neighbours of the others at their edges, which are borders.
class MeshTopology {
 public:
  explicit MeshTopology(const MeshArrays& mesh);
  ~MeshTopology();
  MeshTopology(const MeshTopology&) = delete;
  MeshTopology& operator=(const MeshTopology&) = delete;

  // The triangles around a vertex, in their order.
  [[nodiscard]] std::vector<std::uint32_t> triangles_at(std::size_t vertex) const;
  // Whether an edge at a vertex is that of one triangle only.
  [[nodiscard]] bool is_on_border(std::size_t vertex) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

using OpenMesh::VertexHandle;

VertexHandle handle(std::size_t vertex) {
  return VertexHandle(static_cast<int>(vertex));
}

// OpenMesh reports each triangle that does not fit on its error stream, one for all threads.
class QuietErrors {
 public:
  QuietErrors() : lock_(mutex_) { omerr().disable(); }
  ~QuietErrors() {
    if (was_enabled_) omerr().enable();
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  static inline std::mutex mutex_;
  const std::lock_guard<std::mutex> lock_;
  const bool was_enabled_ = omerr().is_enabled();
};

struct MeshTopology::Impl {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  std::vector<std::uint32_t> triangle_of_face;
  std::multimap<std::size_t, std::uint32_t> apart;  // triangles that do not fit, by vertex
};

MeshTopology::MeshTopology(const MeshArrays& mesh) : impl_(std::make_unique<Impl>()) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v) impl_->mesh.add_vertex({});
  const QuietErrors quiet;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::uvec3& corners = mesh.triangles[t];
    const std::array vertices{handle(corners.x), handle(corners.y), handle(corners.z)};
    if (impl_->mesh.add_face(vertices.data(), 3).is_valid()) {
      impl_->triangle_of_face.push_back(t);
    } else {
      for (int k = 0; k < 3; ++k) impl_->apart.emplace(corners[k], t);
    }
  }
}

MeshTopology::~MeshTopology() = default;

std::vector<std::uint32_t> MeshTopology::triangles_at(std::size_t vertex) const {
  std::vector<std::uint32_t> triangles;
  for (const auto face : impl_->mesh.vf_range(handle(vertex))) {
    triangles.push_back(impl_->triangle_of_face[static_cast<std::size_t>(face.idx())]);
  }
  const auto [begin, end] = impl_->apart.equal_range(vertex);
  for (auto entry = begin; entry != end; ++entry) triangles.push_back(entry->second);
  std::ranges::sort(triangles);
  return triangles;
}

bool MeshTopology::is_on_border(std::size_t vertex) const {
  return impl_->apart.contains(vertex) || impl_->mesh.is_boundary(handle(vertex));
}

constexpr std::size_t vertex_block = 64;  // vertices between two looks at a stop

// Rays start this share of the coordinates around a vertex off it, which is more than those of
// planes that are seen edge-on.
constexpr double vertex_margin = 10.0 * position_rounding;

// A vertex on a border may lie in the plane of another part, as the edge of a floor does in that of
// the wall, and would see behind it: rays start this share of the way into its triangles.
constexpr double border_inset = 0.01;

class MeshGeometry {
 public:
  explicit MeshGeometry(const TriangleMesh& mesh) : arrays_(mesh), topology_(mesh) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-std::numeric_limits<double>::infinity());
    for (const glm::vec3& p : arrays_.points) {
      low = glm::min(low, glm::dvec3(p));
      high = glm::max(high, glm::dvec3(p));
    }
    center_ = 0.5 * (low + high);
  }

  [[nodiscard]] const std::vector<glm::uvec3>& triangles() const { return arrays_.triangles; }
  [[nodiscard]] glm::dvec3 position(std::size_t vertex) const {
    return glm::dvec3(arrays_.points[vertex]);
  }
  // That of a triangle where the mesh has none; any direction where nothing has.
  [[nodiscard]] glm::dvec3 normal(std::size_t vertex) const {
    glm::dvec3 n(arrays_.normals[vertex]);
    for (const std::uint32_t triangle : topology_.triangles_at(vertex)) {
      if (n != glm::dvec3(0.0)) break;
      n = area_normal(arrays_.points, arrays_.triangles[triangle]);
    }
    const double length = glm::length(n);
    return length > 0.0 ? n / length : glm::dvec3(0.0, 0.0, 1.0);
  }

  // Where rays from a vertex start on the side of n.
  [[nodiscard]] glm::dvec3 ray_origin(std::size_t vertex, const glm::dvec3& n) const {
    double size = max_component(glm::abs(position(vertex) - center_));
    glm::dvec3 inward(0.0);
    double corner_count = 0.0;
    for (const std::uint32_t triangle : topology_.triangles_at(vertex)) {
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 p = position(arrays_.triangles[triangle][k]);
        size = std::max(size, max_component(glm::abs(p - center_)));
        inward += p - position(vertex);
        corner_count += 1.0;
      }
    }
    const glm::dvec3 origin = position(vertex) + vertex_margin * size * n;
    if (!topology_.is_on_border(vertex)) return origin;
    inward *= border_inset / corner_count;
    return origin + inward - std::min(0.0, glm::dot(inward, n)) * n;
  }

  // The side of a triangle that rays in the direction w meet.
  [[nodiscard]] MeshSide seen_side(const MeshPoint& point, const glm::dvec3& w) const {
    const glm::dvec3 flat = area_normal(arrays_.points, point.corners);
    glm::dvec3 smooth(0.0);
    for (int k = 0; k < 3; ++k) {
      smooth += point.weights[k] * glm::dvec3(arrays_.normals[point.corners[k]]);
    }
    if (smooth == glm::dvec3(0.0)) smooth = flat;
    const bool against = (glm::dot(flat, w) < 0.0) == (glm::dot(flat, smooth) > 0.0);
    return against ? MeshSide::front : MeshSide::back;
  }

 private:
  const MeshArrays& arrays_;
  MeshTopology topology_;
  glm::dvec3 center_{0.0};  // that rays are traced around
};

// Light that a vertex receives from a place of the mesh; the weight is its share of the irradiance
// under the same radiance from everywhere.
struct Exchange {
  std::uint32_t triangle : 31;
  std::uint32_t from_back : 1;
  float u, v;
  float weight;
};
using Exchanges = std::vector<std::vector<Exchange>>;  // of each vertex

struct Ray {
  glm::dvec3 direction;  // around +z
  double weight;         // [sr]
  ShVector<double> basis;
};

std::vector<Ray> rays_around_z(const TransferSettings& settings) {
  std::vector<Ray> rays;
  for (const SphereNode& node : hemisphere_rule(settings.directions)) {
    rays.push_back({node.direction, node.weight, sh_basis(settings.order, node.direction)});
  }
  return rays;
}

template <class Real>
void store(const ShVector<Real>& f, std::vector<float>& values, std::size_t index) {
  std::transform(f.values().begin(), f.values().end(),
                 values.begin() + static_cast<std::ptrdiff_t>(index * f.size()),
                 [](Real x) { return static_cast<float>(x); });
}

ShVector<double> interpolate(int order, const std::vector<float>& values, const MeshPoint& point,
                             std::size_t stride, std::size_t offset) {
  ShVector<double> result(order);
  if (values.empty()) return result;
  for (int k = 0; k < 3; ++k) {
    const float* const f = values.data() + (point.corners[k] * stride + offset) * result.size();
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] += point.weights[k] * static_cast<double>(f[i]);
    }
  }
  return result;
}

class Transfer {
 public:
  Transfer(const std::shared_ptr<const TriangleMesh>& mesh, const TransferSettings& settings)
      : geometry_(*mesh), enclosed_(enclosed_sides(*mesh)), rays_(rays_around_z(settings)) {
    result_.settings = settings;
    result_.vertices = mesh->n_vertices();
    Surface surface;
    surface.mesh = mesh;
    ray_caster_.emplace(std::span(&surface, 1));
  }

  // All rays of one side.
  void cast(MeshSide which, const Job& job) {
    if (std::ranges::all_of(enclosed_, [&](Enclosed e) { return is_enclosed(e, which); })) return;
    RadianceTransfer::Side& side = result_.sides[static_cast<std::size_t>(which)];
    const std::size_t size = sh_size(result_.settings.order);
    side.visibility.resize(result_.vertices * size);
    side.reflected.resize(result_.vertices * terms() * size);
    Exchanges& exchanges = exchanges_[static_cast<std::size_t>(which)];
    if (terms() > 1) exchanges.resize(result_.vertices);
    each_vertex(job, [&](std::size_t v) {
      if (!is_enclosed(enclosed_[v], which)) cast(which, v);
    });
  }

  // Light that was reflected `bounce` times, from that of one time less.
  void reflect(MeshSide which, int bounce, const Job& job) {
    RadianceTransfer::Side& side = result_.sides[static_cast<std::size_t>(which)];
    if (side.reflected.empty()) return;
    const Exchanges& exchanges = exchanges_[static_cast<std::size_t>(which)];
    each_vertex(job, [&](std::size_t v) {
      ShVector<float> sum(result_.settings.order);
      for (const Exchange& e : exchanges[v]) {
        const auto& source = result_.sides[e.from_back].reflected;
        if (source.empty()) continue;
        const glm::uvec3& corners = geometry_.triangles()[e.triangle];
        const std::array weights{(1.0f - e.u - e.v) * e.weight, e.u * e.weight, e.v * e.weight};
        for (int k = 0; k < 3; ++k) {
          const std::size_t term = corners[k] * terms() + static_cast<std::size_t>(bounce) - 1;
          const float* const light = source.data() + term * sum.size();
          for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += weights[static_cast<std::size_t>(k)] * light[i];
          }
        }
      }
      store(sum, side.reflected, v * terms() + static_cast<std::size_t>(bounce));
    });
  }

  RadianceTransfer release() { return std::move(result_); }

 private:
  [[nodiscard]] std::size_t terms() const {
    return static_cast<std::size_t>(result_.settings.bounces) + 1;
  }

  template <class Body>
  void each_vertex(const Job& job, Body body) const {
    job.parallel_for_with_progress(
        (result_.vertices + vertex_block - 1) / vertex_block, [&](std::size_t b) {
          const std::size_t end = std::min(result_.vertices, (b + 1) * vertex_block);
          for (std::size_t v = b * vertex_block; v < end; ++v) body(v);
        });
  }

  // The rays of one vertex.
  void cast(MeshSide which, std::size_t vertex) {
    const auto s = static_cast<std::size_t>(which);
    const glm::dvec3 n = (which == MeshSide::front ? 1.0 : -1.0) * geometry_.normal(vertex);
    const glm::dquat frame = surface_frame(n, n);
    const glm::dmat3 matrix = glm::mat3_cast(frame);
    std::vector<glm::dvec3> directions(rays_.size());
    for (std::size_t k = 0; k < rays_.size(); ++k) directions[k] = matrix * rays_[k].direction;
    std::vector<SurfaceHit> hits(rays_.size());
    ray_caster_->first_hits(geometry_.ray_origin(vertex, n), directions, hits);

    ShVector<double> open(result_.settings.order);
    ShVector<double> irradiance(result_.settings.order);
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      const Ray& ray = rays_[k];
      const double weight = ray.weight * ray.direction.z * std::numbers::inv_pi;
      if (hits[k]) {
        if (terms() > 1) exchanges_[s][vertex].push_back(exchange(hits[k], directions[k], weight));
        continue;
      }
      for (std::size_t i = 0; i < open.size(); ++i) {
        open[i] += ray.weight * ray.basis[i];
        irradiance[i] += weight * ray.basis[i];
      }
    }
    // Mirrored at the horizon: terms odd in z cancel, even ones double.
    for (int l = 0; l < open.order(); ++l) {
      for (int m = -l; m <= l; ++m) open[sh_index(l, m)] *= (l + m) % 2 == 0 ? 2.0 : 0.0;
    }
    store(sh_rotate(open, frame), result_.sides[s].visibility, vertex);
    store(sh_rotate(irradiance, frame), result_.sides[s].reflected, vertex * terms());
  }

  [[nodiscard]] Exchange exchange(const SurfaceHit& hit, const glm::dvec3& w, double weight) const {
    const double u = static_cast<double>(hit.u);
    const double v = static_cast<double>(hit.v);
    const MeshPoint point{geometry_.triangles()[hit.triangle], {1.0 - u - v, u, v}};
    const MeshSide seen = geometry_.seen_side(point, w);
    return {hit.triangle, seen == MeshSide::back, hit.u, hit.v, static_cast<float>(weight)};
  }

  MeshGeometry geometry_;
  std::vector<Enclosed> enclosed_;
  std::vector<Ray> rays_;
  std::optional<RayCaster> ray_caster_;
  std::array<Exchanges, 2> exchanges_;  // by MeshSide
  RadianceTransfer result_;
};

}  // namespace

MeshPoint at_vertex(std::uint32_t vertex) {
  return {glm::uvec3(vertex), {1.0, 0.0, 0.0}};
}

ShVector<double> RadianceTransfer::visibility(MeshSide which, const MeshPoint& point) const {
  return interpolate(settings.order, side(which).visibility, point, 1, 0);
}

ShVector<double> RadianceTransfer::reflected(MeshSide which, int bounce,
                                             const MeshPoint& point) const {
  assert(0 <= bounce && bounce <= settings.bounces);
  return interpolate(settings.order, side(which).reflected, point,
                     static_cast<std::size_t>(settings.bounces) + 1,
                     static_cast<std::size_t>(bounce));
}

std::optional<RadianceTransfer> radiance_transfer(const std::shared_ptr<const TriangleMesh>& mesh,
                                                  const TransferSettings& settings,
                                                  const Job& job) {
  assert(1 <= settings.order && settings.order <= sh_max_bands);
  assert(64 <= settings.directions && settings.directions <= 65536 && settings.directions % 8 == 0);
  assert(0 <= settings.bounces && settings.bounces <= 16);
  constexpr double reflect_cost = 0.1;  // of a bounce, relative to casting the rays
  const double total_cost = 2.0 * (1.0 + reflect_cost * settings.bounces);
  double done = 0.0;
  const auto next_part = [&](double cost) {
    const double done_before = done;
    done += cost;
    return job.subrange(done_before / total_cost, done / total_cost);
  };
  if (job.stop.stop_requested()) return std::nullopt;
  Transfer transfer(mesh, settings);
  for (const MeshSide side : {MeshSide::front, MeshSide::back}) transfer.cast(side, next_part(1.0));
  for (int bounce = 1; bounce <= settings.bounces; ++bounce) {
    for (const MeshSide side : {MeshSide::front, MeshSide::back}) {
      transfer.reflect(side, bounce, next_part(reflect_cost));
    }
  }
  if (job.stop.stop_requested()) return std::nullopt;
  if (job.progress) job.progress(1.0);
  return transfer.release();
}

}  // namespace brume
