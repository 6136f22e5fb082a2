#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/medium/splat.h"
#include "tests/core/io/import/gltf_builder.h"

namespace brume {

// Makes small files of splats: a scene of one node with two of them, to change and to add to.
class SplatGltfBuilder : public GltfBuilder {
 public:
  SplatGltfBuilder() {
    Json points;
    points["mode"] = 0;
    points["extensions"]["KHR_gaussian_splatting"] = {{"kernel", "ellipse"},
                                                      {"colorSpace", "srgb_rec709_display"}};
    primitive() = points;
    attributes()["POSITION"] = add({1, 2, 3, -1, 0.5, 0}, "VEC3");
    set("ROTATION", add({0, 0, 0, 1, 0.5, -0.5, 0.5, 0.5}, "VEC4"));
    set("SCALE", add({0.5, 0.5, 0.5, 1, 0.25, 0.5}, "VEC3"));
    set("OPACITY", add({0.75, 0.5}, "SCALAR"));
    set("SH_DEGREE_0_COEF_0", add({0, 0, 0, 1, 1, 1}, "VEC3"));
    json["extensionsUsed"] = {"KHR_gaussian_splatting"};
  }

  Json& attributes() { return primitive()["attributes"]; }
  Json& extension() { return primitive()["extensions"]["KHR_gaussian_splatting"]; }
  // Its accessor.
  void set(const char* attribute, std::size_t accessor) {
    attributes()[std::string("KHR_gaussian_splatting:") + attribute] = accessor;
  }
  // The accessor of an attribute.
  Json& accessor_of(const char* attribute) {
    return json["accessors"][attributes()[attribute].get<std::size_t>()];
  }

  template <class Integer>
  std::size_t add_normalized(const std::vector<Integer>& numbers, const char* type) {
    const std::size_t accessor = add_integers(numbers, type);
    json["accessors"][accessor]["normalized"] = true;
    if (std::is_signed_v<Integer>) {
      json["accessors"][accessor]["componentType"] = sizeof(Integer) == 1 ? 5120 : 5122;
    }
    return accessor;
  }

  // The second of the two.
  static Splat second() {
    return {{-1.0, 0.5, 0.0}, {1.0, 0.25, 0.5}, {0.5, 0.5, -0.5, 0.5}, std::log(2.0)};
  }
};

}  // namespace brume
