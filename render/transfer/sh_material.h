#pragma once

#include <optional>

#include "brume/scene.h"
#include "core/math/spherical_harmonics.h"
#include "core/scene/materials/brdf.h"
#include "render/simd/reflection_kernels.h"
#include "render/transfer/radiance_transfer.h"

namespace brume {

// Light at a point of a mesh after transfer.
struct ReceivedLight {
  ShVector<glm::dvec3> incident;  // to be reflected by the BRDF; order 0: none
  glm::dvec3 radiance{0.0};       // outgoing, diffuse
};

// Outgoing radiance of a material under incident light given as spherical harmonics (section 4.3 of
// the paper), all of one order. Light, unit normal n on the visible side and unit direction wo to
// the eye share one frame; with RadianceTransfer it is object space: rotate by the inverse of
// Surface::rotate, light with sh_rotate().
//
// Few bands overshoot next to small bright lights, so radiance may be slightly negative, except
// from reflected(), which clamps to 0.
class ShMaterial {
 public:
  // Costs as much as a BrdfSh.
  ShMaterial(const Material& material, int order);

  // Without shadows: sh_dot(L, B).
  [[nodiscard]] glm::dvec3 unshadowed(const ShVector<glm::dvec3>& light, const glm::dvec3& n,
                                      const glm::dvec3& wo) const;

  // With shadows and interreflections of the transfer, in two steps: the first is view-independent.
  // Interreflections before the last are diffuse, with albedo(). Diffuse materials need dot
  // products only, avoiding the truncation error of the triple product (eq. 23).
  //
  // `traced` contributes interreflections only: its first reflection is shaded elsewhere, with
  // sharper shadows than few bands allow.
  [[nodiscard]] ReceivedLight received(const ShVector<glm::dvec3>& light,
                                       const ShVector<glm::dvec3>& traced,
                                       const RadianceTransfer& transfer, MeshSide side,
                                       const MeshPoint& point) const;
  [[nodiscard]] glm::dvec3 reflected(const ReceivedLight& light, const glm::dvec3& n,
                                     const glm::dvec3& wo) const;

  [[nodiscard]] bool is_diffuse() const { return diffuse_; }
  // For non-diffuse materials: the same for many points at once.
  [[nodiscard]] const ReflectionTable& table() const { return *table_; }

  // Albedo, RGB in [0, 1]: the reflectance of a diffuse material, else at normal incidence.
  [[nodiscard]] const glm::dvec3& albedo() const { return albedo_; }

 private:
  bool diffuse_;
  BrdfSh brdf_;
  std::optional<ReflectionTable> table_;
  glm::dvec3 albedo_;
};

}  // namespace brume
