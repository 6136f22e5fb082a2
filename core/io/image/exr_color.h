#pragma once

#include <ImfChromaticities.h>

#include <glm/mat3x3.hpp>
#include <optional>

namespace brume {

// From linear RGB of primaries and a white to linear Rec. 709, whose white it becomes (Bradford).
// Colours whose primaries are the axes of CIE XYZ have no white: they are not adapted. nullopt: the
// primaries span no colours, or the white is none of them.
std::optional<glm::dmat3> to_rec709(const Imf::Chromaticities& chromaticities);

}  // namespace brume
