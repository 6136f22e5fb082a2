#pragma once

namespace brume {

// Neighbouring samples whose distances differ by a smaller fraction than this may be on one
// surface.
inline constexpr float max_relative_step = 0.05f;

// Deviation from linear of the midpoint between two samples, per second difference of three in a
// row.
inline constexpr float middle_per_second_difference = 0.125f;

// Curvature where an axis has fewer than three samples: above the tolerance, so that nothing is
// interpolated.
inline constexpr float unknown_curvature = 2.0f;

// Maximum curvature of a surface's samples along each axis for extrapolating from them;
// extrapolation over one cell errs by up to four times that.
inline constexpr float max_local_fit_curvature = 0.125f;

// Pixels that halving a cell evaluates, some of them for its neighbours too: with no more missing
// it gains nothing.
inline constexpr int halving_samples = 5;

// Minimum total bilinear weight of the samples that lie on a pixel's surface.
inline constexpr float min_surface_weight = 0.25f;

// Allowed distance difference of a pixel per unit of tolerance: in radii of the smallest relevant
// Gaussian, and in mean free paths of b0.
inline constexpr float radii_per_tolerance = 5.0f;

inline constexpr float free_paths_per_tolerance = 2.0f;

}  // namespace brume
