#pragma once

namespace brume {

// Maximum curvature of a surface's samples along each axis for extrapolating from them;
// extrapolation over one cell errs by up to four times that.
inline constexpr float max_curvature_of_surroundings = 0.125f;

// Minimum total bilinear weight of the samples that lie on a pixel's surface.
inline constexpr float min_surface_share = 0.25f;

// Allowed depth difference of a pixel per unit of tolerance: in radii of the smallest relevant
// Gaussian, and in mean free paths of b0.
inline constexpr float radii_per_tolerance = 5.0f;

inline constexpr float free_paths_per_tolerance = 2.0f;

}  // namespace brume
