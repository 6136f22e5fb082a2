#pragma once

#include <cstdint>

namespace brume {

// The radius of an ellipsoid along which a medium is as opaque as the splat that it is read from or
// written as. A splat has one opacity, from wherever it is seen; a medium is more opaque along its
// longer axes, so the two agree along one length only.
enum class OpacityAlong : std::uint8_t { shortest, mean, longest };

// How the splats of a file become Gaussians.
struct SplatInput {
  OpacityAlong along = OpacityAlong::mean;
  // Their colors, as they are from all sides, become albedos.
  bool has_albedos = false;
};

}  // namespace brume
