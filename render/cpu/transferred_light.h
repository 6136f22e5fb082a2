#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "render/cpu/surface_points.h"
#include "render/cpu/visibility.h"
#include "render/job.h"
#include "render/medium_index.h"
#include "render/settings.h"
#include "render/transfer/radiance_transfer.h"
#include "render/transfer/sh_material.h"

namespace brume {

struct SurfaceLighting;
struct SurfaceShading;

// The light that a surface with radiance transfer sends to the eye, but for what comes straight
// from lamps: the environment's and what the medium scatters of lamps (eqs. 25 and 27), shadowed
// by the object and, with interreflection, reflected between its parts; and what lamps light
// straight, reflected so. Light is taken at the vertices, which holds for every view.
class TransferredLight {
 public:
  // Takes the light at all vertices, in parallel. `shading` is the surface's, its transfer and
  // material not null; both outlive this. `pairs` += the Gaussian x path pairs evaluated.
  TransferredLight(const MediumIndex& medium, const SurfaceLighting& lighting,
                   const Surface& surface, const SurfaceShading& shading,
                   Settings::Arithmetic arithmetic, const Job& job, std::uint64_t& pairs);

  // radiance += what the surface sends from `points`, those of `hits`. >= 0. Thread-safe.
  void add(std::span<const SurfaceHit> hits, const SurfacePoints& points,
           PointRadiance& radiance) const;

  // ReceivedLight of all vertices; empty where the transfer is.
  struct Side {
    std::vector<glm::vec3> radiance;
    std::vector<glm::vec3> incident;  // [vertex][coefficient], in the world; of diffuse ones empty
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
