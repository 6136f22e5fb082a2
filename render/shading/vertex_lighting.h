#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brume/revision.h"
#include "brume/scene.h"
#include "render/geometry/medium_index.h"
#include "render/geometry/point_source.h"
#include "render/settings.h"
#include "render/simd/surface_points.h"
#include "render/transfer/radiance_transfer.h"
#include "render/transfer/sh_material.h"
#include "render/util/job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

struct SurfaceLighting;
struct SurfaceShading;
class ScatterTable;

// The inputs of vertex lighting besides its surface: with equal inputs it is equal.
struct VertexLightingInputs {
  struct Light {
    glm::dvec3 position{0.0};
    glm::dvec3 intensity{0.0};
    LightFalloff falloff{};
    FogBall fog{};
    double density = 0.0;
    Revision table = 0;  // 0: exact sums

    bool operator==(const Light&) const = default;
  };
  Revision medium = 0;
  std::vector<Light> lights;
  const ScatterTable* point = nullptr;  // these outlive every renderer
  const ScatterTable* distant = nullptr;
  Revision environment = 0;  // 0: none
  Revision incident = 0;     // 0: average optical depth
  double fog_depth = 0.0;
  FogBall fog;
  double albedo = 1.0;
  Settings::Precision precision = Settings::Precision::simd_float;

  VertexLightingInputs() = default;
  VertexLightingInputs(const MediumIndex& index, const SurfaceLighting& lighting,
                       Settings::Precision arithmetic);
  bool operator==(const VertexLightingInputs&) const = default;
};

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
