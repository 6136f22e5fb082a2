#include "core/io/import/gltf_instances.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "brume/limits.h"
#include "core/io/import/gltf_mesh.h"
#include "core/number_domain.h"

namespace brume {

std::vector<glm::dmat4> gltf_instances(GltfFile& file, JsonObject& node) {
  auto extensions = node.find_object("extensions");
  auto instancing = extensions ? extensions->find_object("EXT_mesh_gpu_instancing") : std::nullopt;
  if (!instancing) return {glm::dmat4(1.0)};
  JsonObject attributes = instancing->object("attributes");
  const auto translations = gltf_vectors<glm::vec3>(file, attributes, "TRANSLATION");
  const auto rotations = gltf_vectors<glm::vec4>(file, attributes, "ROTATION");
  const auto scales = gltf_vectors<glm::vec3>(file, attributes, "SCALE");
  const std::size_t count = std::max({translations.size(), rotations.size(), scales.size()});
  for (const std::size_t size : {translations.size(), rotations.size(), scales.size()}) {
    if (size == 0 || size == count) continue;
    file.context().fail(attributes.path(), "found " + std::to_string(size) + " values for " +
                                               std::to_string(count) + " instances");
  }
  if (count > limits::copies) {
    file.context().fail(attributes.path(), "the instances take more memory than the allowed " +
                                               std::to_string(limits::scene_bytes) + " bytes");
  }
  std::vector<glm::dmat4> transforms;
  for (std::size_t i = 0; i < count; ++i) {
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    if (!rotations.empty()) {
      const glm::dvec4 q(rotations[i]);
      rotation = glm::dquat(q.w, q.x, q.y, q.z);
      if (!(glm::length(rotation) > 0.0)) {
        attributes.fail("ROTATION", "found length 0; allowed: unit quaternions");
      }
    }
    const glm::dvec3 scale = scales.empty() ? glm::dvec3(1.0) : glm::dvec3(scales[i]);
    glm::dmat4 instance(glm::mat4_cast(glm::normalize(rotation)));
    for (int k = 0; k < 3; ++k) instance[k] *= scale[k];
    if (!translations.empty()) instance[3] = glm::dvec4(glm::dvec3(translations[i]), 1.0);
    transforms.push_back(instance);
  }
  return transforms;
}

CopyPlacements placements_of(std::span<const glm::dmat4> transforms) {
  CopyPlacements result;
  for (const glm::dmat4& transform : transforms) {
    const glm::dmat3 axes(transform);
    const double scale = glm::length(axes[0]);
    // Roundings of float.
    constexpr double rounding = 1e-5;
    const glm::dmat3 turn = (1.0 / scale) * axes;
    const glm::dmat3 difference = glm::transpose(turn) * turn - glm::dmat3(1.0);
    double greatest = 0.0;
    for (int k = 0; k < 9; ++k) {
      greatest = std::max(greatest, std::abs(difference[k / 3][k % 3]));
    }
    const glm::dvec3 translate(transform[3]);
    const bool is_placed =
        domain::length.contains(scale) && greatest < rounding && glm::determinant(turn) > 0.0 &&
        domain::coordinate.contains(translate.x) && domain::coordinate.contains(translate.y) &&
        domain::coordinate.contains(translate.z);
    if (!is_placed) return {};
    result.push_back({translate, glm::normalize(glm::quat_cast(turn)), scale});
  }
  return result;
}

}  // namespace brume
