#pragma once

#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "core/io/import/gltf_file.h"
#include "core/number_domain.h"

namespace brume {

// Numbers of materials and lights as exporters write them: 1.0000001 for 1, a negative intensity.
// The nearest allowed one is taken, with a warning; what is no number throws InputError.
double nearest_number(GltfFile& file, JsonObject& object, std::string_view key,
                      const NumberDomain& domain, double fallback);
std::vector<double> nearest_numbers(GltfFile& file, JsonObject& object, std::string_view key,
                                    const NumberDomain& domain, std::vector<double> fallback);
glm::dvec3 nearest_vector(GltfFile& file, JsonObject& object, std::string_view key,
                          const NumberDomain& domain, const glm::dvec3& fallback);

}  // namespace brume
