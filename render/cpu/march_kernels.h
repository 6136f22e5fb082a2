#pragma once

#include <cstdint>

#include "render/simd/gaussian_kernels.h"

namespace brume {

// SIMD kernels of the marched airlight (Highway, single precision).

// Samples the medium at parameter t[k] of every ray k, for padded_size() rays: densities[k] = b(x)
// of the Gaussians [1/u], depths[k] = T(eye, x), exact. Returns the Gaussian x ray pairs evaluated.
std::uint64_t sample_medium(const GaussianBatch& gaussians, const PathBatch& rays, const float* t,
                            float* densities, float* depths);

// One sample per ray, lit by one light.
struct LitSamples {
  const float* t;             // ray parameter [u]
  const float* weights;       // density times step length; 0 for an occluded sample
  const float* depths;        // T(eye, x), b0 included
  const float* light_depths;  // T(light, x) of the Gaussians
};

// radiance[k] += weight exp(-T(eye, x) - T(light, x)) / (4 pi r^2) times henyey_greenstein(), per
// unit of radiant intensity [1/u^2]. `light` is relative to the eye; h_min: see PointLightRay.
void add_scattered(const PathBatch& rays, const LitSamples& samples, const glm::vec3& light,
                   float h_min, float anisotropy, float* radiance);

}  // namespace brume
