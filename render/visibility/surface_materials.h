#pragma once

#include <span>

#include "render/simd/surface_points.h"
#include "render/visibility/surface_point.h"

namespace brume {

// A pixel's cone at a grazing angle is taken to be no longer than at this one.
inline constexpr double min_grazing_cosine = 0.02;

// Sets points.ggx and turns normals by normal maps. `frames` of the points, if is_varied();
// `distances` from the eye [u].
void find_materials(std::span<const MeshFrame> frames, std::span<const double> distances,
                    SurfacePoints& points);

}  // namespace brume
