#pragma once

#include "core/math/spherical_harmonics.h"
#include "core/scene/brdf.h"
#include "core/scene/scene.h"
#include "render/transfer/radiance_transfer.h"

namespace brume {

// The radiance that a material sends to the eye, of incident light given as spherical harmonics
// (section 4.3 of the paper); all of one order. Light, unit normal n, on the side that is seen, and
// unit direction wo to the eye share one frame. For a RadianceTransfer that is the frame of the
// mesh: turn what is in the world by the inverse of Surface::rotate, with sh_rotate() the light
// (once for the object if it is distant and no medium is between).
//
// Sums of few bands overshoot beside bright small lights, so that radiance may come out a little
// negative. Not so from transferred(), which ends at 0.
class ShMaterial {
 public:
  // Takes as long as a BrdfSh.
  ShMaterial(const Material& material, int order);

  // Without shadows: sh_dot(L, B).
  [[nodiscard]] glm::dvec3 unshadowed(const ShVector<glm::dvec3>& light, const glm::dvec3& n,
                                      const glm::dvec3& wo) const;

  // Eq. 23, the triple product of light, visibility and BRDF.
  [[nodiscard]] glm::dvec3 shadowed(const ShVector<glm::dvec3>& light,
                                    const ShVector<double>& visibility, const glm::dvec3& n,
                                    const glm::dvec3& wo) const;

  // With all the shadows and reflections that the transfer holds. Light that was reflected before
  // the last time was so diffusely, by albedo(). A diffuse material needs dot products only, and is
  // spared the error of the triple product's bands.
  [[nodiscard]] glm::dvec3 transferred(const ShVector<glm::dvec3>& light,
                                       const RadianceTransfer& transfer, MeshSide side,
                                       const MeshPoint& at, const glm::dvec3& n,
                                       const glm::dvec3& wo) const;

  // The share of light that is reflected, RGB in [0, 1]: of a diffuse material its reflectance, of
  // others that of light along the normal.
  [[nodiscard]] const glm::dvec3& albedo() const { return albedo_; }

 private:
  bool diffuse_;
  BrdfSh brdf_;
  glm::dvec3 albedo_;
};

}  // namespace brume
