#pragma once

#include <string>
#include <vector>

// Keywords of the scene file, in the order of the enumerations.
namespace brume::scene_names {

inline constexpr const char* format = "brume-scene";
inline constexpr int version = 1;
inline const std::vector<std::string> materials{"diffuse", "phong", "measured",
                                                "metallic_roughness"};
inline const std::vector<std::string> texture_wraps{"repeat", "clamp", "mirror"};
inline const std::vector<std::string> alpha_modes{"opaque", "cutout", "blend"};
inline const std::vector<std::string> primitives{"plane", "box", "sphere", "cylinder"};
inline const std::vector<std::string> denoisings{"none", "solved"};
inline const std::vector<std::string> transfers{"none", "shadow", "interreflection"};
inline const std::vector<std::string> interpolations{"smooth", "linear", "constant"};

}  // namespace brume::scene_names
