#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "render/cpu/kernels.h"
#include "render/cpu/light_table.h"
#include "render/cpu/ray_slices.h"
#include "render/cpu/shadow_map.h"

namespace brume {

// The inner loops of the sliced airlight in single precision (Highway). Rays are cut at ascending
// boundaries t_0 <= t_1 <= ... <= t_K; a ray's slice ends where the ray ends.

// Half the depth of a line through a Gaussian from which on its tails need more than
// coefficient::erf_fast knows: below it, what that is off makes at most 3e-4 of depth.
constexpr float exact_above = 10.0f;

// increments[k * rays.padded_size() + i] += the optical depth of the Gaussians on slice k of ray i.
// What lies before t_0 or after t_K is left out. Returns the Gaussian x ray pairs evaluated.
std::uint64_t accumulate_increments(const GaussianBatch& gaussians, const PathBatch& rays,
                                    const RaySlices& slices, float* increments);

// depths[k] = what a light's table has for the end of path k, which starts at the light. For
// padded_size() paths; 0 for a table without Gaussians.
void look_up_depths(const LightTable& table, const PathBatch& paths, float* depths);

struct SliceLight {
  glm::vec3 position{0.0f};            // relative to the rays' origin [u]
  float h_min = 0.0f;                  // see LightPath [u]
  const LightTable* table = nullptr;   // null: no Gaussian takes light on its way
  const ShadowMap* shadows = nullptr;  // null: no surface does
};

// What slices scatter towards the eye of light from far away; null: not asked for.
struct SliceShares {
  // shares[k * rays.padded_size() + i] = exp(-T_k) (1 - exp(-dT_k)): slice k of ray i, of light
  // that is 1 all around.
  float* of_slices = nullptr;
  // [i]: all slices of ray i together, of light that comes along the ray and that only Gaussians
  // dim: from the eye, where it is 1, if the anisotropy is negative, else from behind, where it is
  // exp(their depth on the ray).
  float* along_rays = nullptr;
};

// Single scattering summed front to back over the slices (K = slices.count() - 1):
//   sum_k exp(-T_k) (1 - exp(-dT_k)) * mean of 1/r^2 over the slice * exp(-T(s, x_k)) / (4 pi)
//   (times henyey_greenstein() at x_k, the middle of the slice)
// radiance[l][i] += that per unit of the light's intensity [1/u^2]; depths[i] = T(v, p) of
// Gaussians and b0 up to t_K. A slice whose depth is below `negligible` gives no light. At most
// light_pack lights.
void sum_slices(const PathBatch& rays, const RaySlices& slices, const float* increments, float b0,
                float anisotropy, float negligible, std::span<const SliceLight> lights,
                float* depths, const SliceShares& shares,
                const std::array<float*, light_pack>& radiance);

}  // namespace brume
