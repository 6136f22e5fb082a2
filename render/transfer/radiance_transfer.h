#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/math/spherical_harmonics.h"
#include "render/transfer/enclosed_sides.h"
#include "render/util/job.h"

namespace brume {

struct TriangleMesh;

// Precomputed radiance transfer (section 4 of the paper; Sloan, Kautz and Snyder 2002):
// self-shadowing and interreflection of an object under distant light.

struct TransferSettings {
  int order = 6;                 // bands of the spherical harmonics, 1 to 6
  std::size_t directions = 256;  // rays per side and vertex: 64 to 65536, a multiple of 8
  int bounces = 0;               // interreflections, 0 to 16; 0: shadows only

  bool operator==(const TransferSettings&) const = default;
};

// A point on a mesh: the vertices of a triangle and barycentric weights.
struct MeshPoint {
  glm::uvec3 corners;
  glm::dvec3 weights;
};

MeshPoint at_vertex(std::uint32_t vertex);

// Transfer at the vertices of a mesh, in object space: invariant under rotation, translation and
// scaling. Excludes shadows and light of other objects.
struct RadianceTransfer {
  TransferSettings settings;
  std::size_t vertices = 0;

  // Zero at vertices inside a closed part of the mesh; both empty if all are.
  struct Side {
    // V of eq. 23, [vertex][coefficient]: 1 for directions where distant light arrives, 0 where the
    // object occludes it. Below the horizon, which no BRDF evaluates, V is mirrored from above: so
    // it is 1 everywhere at an unoccluded vertex, without a discontinuity at the horizon.
    std::vector<float> visibility;
    // P of the paper, [vertex][bounce][coefficient]: under light L a diffuse surface of reflectance
    // rho has outgoing radiance sum over b of rho^(b+1) sh_dot(P_b, L), b counting
    // interreflections. Independent of rho, so one set serves all colours.
    std::vector<float> reflected;
  };
  std::array<Side, 2> sides;  // by MeshSide

  [[nodiscard]] const Side& side(MeshSide which) const {
    return sides[static_cast<std::size_t>(which)];
  }
  // Interpolated between vertices.
  [[nodiscard]] ShVector<double> visibility(MeshSide side, const MeshPoint& point) const;
  [[nodiscard]] ShVector<double> reflected(MeshSide side, int bounce, const MeshPoint& point) const;
};

// Computes the transfer. The error of V and P_0 is that of hemisphere_rule(directions): none
// without occlusion; near the shadow of a ball, 2% rms with 256 directions, 0.7% with 1024.
// Deterministic for any number of threads. With bounces, needs temporary memory: 16 bytes per ray
// that hits. nullopt if stopped.
std::optional<RadianceTransfer> radiance_transfer(const std::shared_ptr<const TriangleMesh>& mesh,
                                                  const TransferSettings& settings,
                                                  const Job& job = {});

}  // namespace brume
