#pragma once

namespace brume {

// Neighbouring samples whose distances differ by less than this share may be on one surface.
inline constexpr float continuous_share = 0.05f;

// How far the middle between two samples is from the line between them, per second difference of
// three in a row.
inline constexpr float middle_per_second_difference = 0.125f;

// Curvature where fewer than three samples in a row tell nothing: more than is tolerated.
inline constexpr float unknown_curvature = 2.0f;

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
