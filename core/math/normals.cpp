#include "core/math/normals.h"

#include <glm/matrix.hpp>

namespace brume {
namespace {

// The cofactors: the inverse transpose up to its length and sign, for singular matrices too.
glm::dmat3 normal_matrix(const glm::dmat3& m) {
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                             glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0.0 ? -cofactors : cofactors;
}

}  // namespace

glm::dvec3 direction_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 && length <= 1e150 ? v / length : glm::dvec3(0.0);
}

glm::dvec3 moved_normal(const glm::dmat3& to_world, const glm::dvec3& normal) {
  return direction_or_zero(normal_matrix(to_world) * direction_or_zero(normal));
}

}  // namespace brume
