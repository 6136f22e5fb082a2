#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/scene/lights/light_falloff.h"
#include "render/optical_depth/optical_depth_table.h"
#include "render/optical_depth/ray_slices.h"
#include "render/simd/gaussian_kernels.h"
#include "render/slices/lobe_broadening.h"
#include "render/slices/shadow_map.h"

namespace brume {

// SIMD kernels of the sliced airlight (Highway, single precision). Rays are cut at ascending
// boundaries t_0 <= ... <= t_K, clamped to the ray's end.

// depths[k] = the light table's optical depth at the end of path k, which starts at the light. For
// padded_size() paths; 0 for an empty table.
void lookup_depths(const OpticalDepthTable& table, const PathBatch& paths, float* depths);

// Gauss' rule of three points over [-1, 1], its weights adding up to 1.
constexpr float gauss_3_place = 0.774596669f;
constexpr float gauss_3_end = 5.0f / 18.0f;
constexpr float gauss_3_middle = 8.0f / 18.0f;

// Where a slice spans a wide angle at its light, falloff and phase function are integrated over the
// angle, over which light arrives evenly, by that rule on panels [radians]: of what is smooth
// between the edges of a cone, of a photometric profile, of a picture in a beam, times the tangent
// of the cone, and, times 1 - |g|, of the phase function, whose peak is about so wide. What is
// narrower than a share of a panel is taken at its middle.
constexpr float falloff_panel = 1.0f;
constexpr float profile_panel = 0.13f;
constexpr float picture_panel = 0.06f;
constexpr float phase_panel = 2.0f;
constexpr float wide_falloff = 0.5f;
constexpr float wide_phase = 0.25f;

struct SliceLight {
  glm::vec3 position{0.0f};                  // relative to the rays' origin [u]
  float h_min = 0.0f;                        // see PointLightRay [u]
  float extinction = 1.0f;                   // factor of optical depths towards the light
  const OpticalDepthTable* table = nullptr;  // null: no attenuation by Gaussians
  const ShadowMap* shadows = nullptr;        // null: no surfaces
  LightFalloff falloff{};
  // The ball of homogeneous fog that its light passes, as the position is; radius 0: all the way.
  glm::vec3 fog_center{0.0f};
  float fog_radius = 0.0f;
  // Points are looked up relative to this: the position, or of a far light the rays' origin, whose
  // place in the maps of table and shadows follows. Far from their origin floats are too coarse.
  glm::vec3 map_origin{0.0f};
  glm::vec3 in_table{0.0f}, in_shadows{0.0f};
  float shadow_depth = 0.0f;  // of map_origin in the shadow map
};

// Neighbouring slices share a look-up of the source function at their mean position: half the work,
// and more accurate than the middle of each.
constexpr std::size_t slices_per_lookup = 2;

// How slices scatter light towards the eye.
struct SliceScattering {
  float anisotropy = 0.0f;
  // Extinction on the way to the eye of what the truncated phase function scatters, relative to the
  // medium's: below 1 what its forward lobe scatters goes on.
  float view_extinction = 1.0f;
  // The truncated phase function times 4 pi, see PhaseBands: coefficients of powers of the cosine.
  std::array<float, 4> truncated_phase{};
  const float* lobe_broadening = nullptr;  // LobeBroadening::values(); null: none
  float albedo = 1.0f;                     // of the medium, for it
};

// The light of slices of Gaussians with optics, beside that from point lights.
struct SliceOptics {
  bool has = false;                  // the increments are followed by those of optics
  std::array<float*, 3> emission{};  // radiance of ray i that the Gaussians emit, or null
};

// In-scattered fractions for distant light; null: not needed.
struct SliceWeights {
  // [j * rays.padded_size() + i], of the slices k of ray i that share look-up j: the sum of
  // exp(-T_k) (1 - exp(-dT_k)), in-scattering of a unit uniform light, see sum_slices(), and the
  // mean distance of their centers weighted by it.
  float* lookups = nullptr;
  float* lookup_distances = nullptr;
  // The same sum with the whole extinction, of what a forward lobe scatters; see SliceScattering.
  float* lobe_lookups = nullptr;
  // [i], see SliceSums: sum over the slices of ray i for light along the ray, attenuated by
  // Gaussians only, their densities times `extinction`: from the eye, where it is 1, if the
  // anisotropy is negative, else from behind, where it is exp(that optical depth of the ray).
  float* along_rays = nullptr;
  float extinction = 1.0f;
  float fog_extinction = 0.0f;  // the same for homogeneous fog; 0: it attenuates light evenly
};

// Whether sums are of all slices of a ray, [i], or have a row for each slice, of those up to its
// end: [k * rays.padded_size() + i].
enum class SliceSums { total, running };

// Single scattering summed front to back over the slices (K = slices.count() - 1):
//   sum_k exp(-T_k) (1 - exp(-dT_k)) * mean of 1/r^2 over the slice * exp(-T(s, x_k)) / (4 pi)
//   (times henyey_greenstein() at x_k, or its mean over the angle that the slice spans)
// where x_k is the mean of what the slice holds, by `moments`, see accumulate_increments(), moved
// to the front by what attenuates it in the slice, and the mean of 1/r^2 is taken around it as far
// as what has that mean reaches, where the mean is of the falloff over r^2 for a spot, x_k then the
// middle of what it lights, and with a view extinction e below 1 for the truncated phase function
//   exp(-e T_k) (1 - exp(-e dT_k)) / e, as for look-ups, and for the rest of it, less what a lobe
//   broadening takes from it, the same as without.
// and with optics the fraction times the slice's mean albedo; emission[c][i] is set to the sum of
// exp(-T_k) (1 - exp(-dT_k)) times its mean emission.
// radiance[l][i] += that, per unit of radiant intensity [1/u^2], or running sums are set; depths[i]
// = T(v, p) of Gaussians and b0 up to t_K. Slices of optical depth below `negligible` are skipped.
// At most light_pack lights.
void sum_slices(const PathBatch& rays, const RaySlices& slices, const float* increments,
                const float* moments, const BatchFog& fog, const SliceScattering& scattering,
                float negligible, std::span<const SliceLight> lights, float* depths,
                const SliceWeights& weights, const SliceOptics& optics,
                const std::array<float*, light_pack>& radiance, SliceSums sums = SliceSums::total);

}  // namespace brume
