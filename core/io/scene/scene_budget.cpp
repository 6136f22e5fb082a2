#include "core/io/scene/scene_budget.h"

#include <string>

#include "core/limits.h"
#include "core/medium/gaussian.h"
#include "core/scene/measured_brdf.h"
#include "core/scene/mesh_arrays.h"
#include "core/scene/radiance_map.h"

namespace brume {

void SceneBudget::reserve_gaussians(const JsonPath& place, std::size_t count) {
  if (count > gaussians_left()) {
    context_.fail(
        place,
        "found " + std::to_string(gaussians_ + count) +
            " Gaussians in the scene so far, including emitters and sequences; allowed: at most " +
            std::to_string(limits::gaussians));
  }
  gaussians_ += count;
  reserve_bytes(place, count * (sizeof(Gaussian) + sizeof(GaussianId)));
}

void SceneBudget::reserve(const JsonPath& place, const RadianceMap& map) {
  reserve_bytes(place, map.pixels.size() * sizeof(glm::vec3));
}

void SceneBudget::reserve(const JsonPath& place, const MeasuredBrdf& measured) {
  reserve_bytes(place, measured.values().size() * sizeof(glm::vec3));
}

void SceneBudget::reserve(const JsonPath& place, const TriangleMesh& mesh) {
  reserve_bytes(place, mesh_bytes(mesh));
}

void SceneBudget::reserve_bytes(const JsonPath& place, std::size_t bytes) {
  bytes_ += bytes;
  if (bytes_ <= limits::scene_bytes) return;
  context_.fail(place, "the files of the scene take " + std::to_string(bytes_) +
                           " bytes of memory so far; allowed: at most " +
                           std::to_string(limits::scene_bytes));
}

std::size_t SceneBudget::gaussians_left() const {
  return limits::gaussians - gaussians_;
}

}  // namespace brume
