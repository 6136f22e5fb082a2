#pragma once

#include <optional>

#include "core/math/spherical_harmonics.h"
#include "core/scene/brdf.h"
#include "core/scene/scene.h"
#include "render/cpu/reflection_kernels.h"
#include "render/transfer/radiance_transfer.h"

namespace brume {

// What transfer makes of light at a place of a mesh.
struct ReceivedLight {
  ShVector<glm::dvec3> incident;  // still to be reflected by the BRDF; of order 0: none
  glm::dvec3 radiance{0.0};       // sent diffusely
};

// The radiance that a material sends to the eye, of incident light given as spherical harmonics
// (section 4.3 of the paper); all of one order. Light, unit normal n, on the side that is seen, and
// unit direction wo to the eye share one frame. For a RadianceTransfer that is the frame of the
// mesh: turn what is in the world by the inverse of Surface::rotate, with sh_rotate() the light
// (once for the object if it is distant and no medium is between).
//
// Sums of few bands overshoot beside bright small lights, so that radiance may come out a little
// negative. Not so from reflected(), which ends at 0.
class ShMaterial {
 public:
  // Takes as long as a BrdfSh.
  ShMaterial(const Material& material, int order);

  // Without shadows: sh_dot(L, B).
  [[nodiscard]] glm::dvec3 unshadowed(const ShVector<glm::dvec3>& light, const glm::dvec3& n,
                                      const glm::dvec3& wo) const;

  // With all the shadows and reflections that the transfer holds, in two steps: the first is the
  // same for every direction to the eye. Light that was reflected before the last time was so
  // diffusely, by albedo(). A diffuse material needs dot products only, and is spared the error of
  // the triple product's bands (eq. 23).
  //
  // Of `traced` only what the object reflects onto itself counts: light whose first reflection is
  // found elsewhere, with sharper shadows than few bands have.
  [[nodiscard]] ReceivedLight received(const ShVector<glm::dvec3>& light,
                                       const ShVector<glm::dvec3>& traced,
                                       const RadianceTransfer& transfer, MeshSide side,
                                       const MeshPoint& at) const;
  [[nodiscard]] glm::dvec3 reflected(const ReceivedLight& light, const glm::dvec3& n,
                                     const glm::dvec3& wo) const;

  [[nodiscard]] bool is_diffuse() const { return diffuse_; }
  // Of what is not diffuse; the same for many points at once.
  [[nodiscard]] const ReflectionTable& table() const { return *table_; }

  // The share of light that is reflected, RGB in [0, 1]: of a diffuse material its reflectance, of
  // others that of light along the normal.
  [[nodiscard]] const glm::dvec3& albedo() const { return albedo_; }

 private:
  bool diffuse_;
  BrdfSh brdf_;
  std::optional<ReflectionTable> table_;
  glm::dvec3 albedo_;
};

}  // namespace brume
