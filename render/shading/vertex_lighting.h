#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "render/geometry/medium_index.h"
#include "render/settings.h"
#include "render/simd/surface_points.h"
#include "render/transfer/radiance_transfer.h"
#include "render/transfer/sh_material.h"
#include "render/util/job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

struct SurfaceLighting;
struct SurfaceShading;

// Vertex lighting of a surface with radiance transfer, without direct light of point lights:
// environment light and light scattered by the medium (eqs. 25 and 27), self-shadowed and, with
// interreflection, reflected between parts of the object; and interreflected direct light.
// View-independent.
class VertexLighting {
 public:
  // Lights all vertices, in parallel. `shading` belongs to the surface; its transfer and material
  // are not null and outlive this. `pairs` += Gaussian x path pairs evaluated.
  VertexLighting(const MediumIndex& medium, const SurfaceLighting& lighting, const Surface& surface,
                 const SurfaceShading& shading, Settings::Precision precision, const Job& job,
                 std::uint64_t& pairs);

  // radiance += outgoing radiance at `points`, those of `hits`; >= 0. Thread-safe.
  void add(std::span<const SurfaceHit> hits, const SurfacePoints& points,
           PointRadiance& radiance) const;

  // ReceivedLight of all vertices; empty if the transfer is.
  struct Side {
    std::vector<glm::vec3> radiance;
    std::vector<glm::vec3>
        incident;  // [vertex][coefficient], world space; empty for diffuse materials
  };
  [[nodiscard]] const Side& side(MeshSide which) const {
    return sides_[static_cast<std::size_t>(which)];
  }
  [[nodiscard]] int order() const { return order_; }

 private:
  void receive(const RadianceTransfer& transfer, std::size_t vertex,
               const ShVector<glm::dvec3>& light, const ShVector<glm::dvec3>& traced);

  glm::dquat rotate_;
  std::vector<glm::uvec3> triangles_;
  const ShMaterial* material_;
  int order_;
  std::array<Side, 2> sides_;  // by MeshSide
};

}  // namespace brume
