#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "brume/lights.h"
#include "core/scene/lights/intensity_map.h"

namespace brume {

// The picture in the beam of a spot as intensities by direction: one for all channels where it is
// gray, else one for each. Linear light, relative to the brightest texel, which `factor` is.
struct BeamPattern {
  std::shared_ptr<const IntensityMap> map;
  glm::dvec3 factor{1.0};  // RGB
};

// The tangent of the angle of the cone around which the picture lies: that of the spot, below 90
// degrees, which keyframes may pass.
double beam_tangent(const light::Spot& spot);

// Those of a spot whose texture has a content. A profile is in them too. Blurred by three means
// over squares, which reach as far as a disc of (1 - focus) cones; nothing is around the picture.
// The last ones are kept: equal textures give the same maps.
std::vector<BeamPattern> beam_patterns(const light::Spot& spot);

}  // namespace brume
