#pragma once

#include <cstdint>

#include "render/cpu/kernels.h"

namespace brume {

// The inner loops of the marched airlight in single precision (Highway).

// The medium of the batch at the point t[k] of every ray k, for padded_size() rays:
// densities[k] = b(x) of the Gaussians [1/u], depths[k] = T(eye, x), exact. Returns the
// Gaussian x ray pairs evaluated.
std::uint64_t sample_medium(const GaussianBatch& gaussians, const PathBatch& rays, const float* t,
                            float* densities, float* depths);

// Samples on rays, one per ray, as one light shines on them.
struct LitSamples {
  const float* t;             // where on the ray [u]
  const float* weights;       // density times length of the step; 0 for a sample in the dark
  const float* depths;        // T(eye, x), b0 included
  const float* light_depths;  // T(light, x) of the Gaussians
};

// radiance[k] += weight exp(-T(eye, x) - T(light, x)) / (4 pi r^2), times henyey_greenstein() at
// x, per unit of the light's intensity [1/u^2]. `light` is relative to the eye; h_min: see
// LightPath.
void add_scattered(const PathBatch& rays, const LitSamples& samples, const glm::vec3& light,
                   float h_min, float b0, float anisotropy, float* radiance);

}  // namespace brume
