#pragma once

#include <glm/vec3.hpp>

#include "brume/scene.h"
#include "core/scene/materials/ggx.h"
#include "render/paths/path_random.h"

namespace brume {

// Draws directions of incident light at a surface roughly in proportion to brdf() cos(theta_i): a
// mixture of the cosine and of a lobe. The lobe of Phong is exact; that of a measured material
// follows its half vectors, (n.h)^e with e from where its highlight has fallen to half.
// Directions are unit, and leave the surface; those of the lobe may lie behind it.
class MaterialSampler {
 public:
  explicit MaterialSampler(const Material& material);

  // For light that is reflected towards wo.
  [[nodiscard]] glm::dvec3 sample(const glm::dvec3& n, const glm::dvec3& wo,
                                  PathRandom& random) const;
  // Probability density of sample() [1/sr].
  [[nodiscard]] double pdf(const glm::dvec3& wi, const glm::dvec3& n, const glm::dvec3& wo) const;

 private:
  enum class Lobe { none, mirrored, half_vector };

  Lobe lobe_ = Lobe::none;
  double exponent_ = 1.0;
  double lobe_share_ = 0.0;  // of the samples
};

// The same for a metallic-roughness material: a mixture of the cosine and of the normals that the
// eye sees, which is what its specular part reflects but for Fresnel's term and the light's
// masking.
class GgxSampler {
 public:
  GgxSampler(const GgxReflection& reflection, const glm::dvec3& n, const glm::dvec3& wo);

  [[nodiscard]] glm::dvec3 sample(PathRandom& random) const;
  [[nodiscard]] double pdf(const glm::dvec3& wi) const;

 private:
  const GgxReflection& reflection_;
  glm::dvec3 n_, wo_;
  double specular_share_;  // of the samples
};

}  // namespace brume
