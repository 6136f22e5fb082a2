#include "core/io/scene_budget.h"

#include <string>

#include "core/io/limits.h"
#include "core/io/mesh_file.h"
#include "core/medium/gaussian.h"
#include "core/scene/measured_brdf.h"
#include "core/scene/radiance_map.h"

namespace brume {

void SceneBudget::take_gaussians(const JsonPlace& place, std::size_t count) {
  if (count > gaussians_left()) {
    context_.fail(place, "found " + std::to_string(gaussians_ + count) +
                             " Gaussians in the scene up to here, with those of emitters and "
                             "sequences; allowed: at most " +
                             std::to_string(limits::gaussians));
  }
  gaussians_ += count;
  take_bytes(place, count * (sizeof(Gaussian) + sizeof(GaussianId)));
}

void SceneBudget::take(const JsonPlace& place, const RadianceMap& map) {
  take_bytes(place, map.pixels.size() * sizeof(glm::vec3));
}

void SceneBudget::take(const JsonPlace& place, const MeasuredBrdf& measured) {
  take_bytes(place, measured.values().size() * sizeof(glm::vec3));
}

void SceneBudget::take(const JsonPlace& place, const TriangleMesh& mesh) {
  take_bytes(place, mesh_bytes(mesh));
}

void SceneBudget::take_bytes(const JsonPlace& place, std::size_t bytes) {
  bytes_ += bytes;
  if (bytes_ <= limits::scene_bytes) return;
  context_.fail(place, "what the scene refers to takes " + std::to_string(bytes_) +
                           " bytes of memory up to here; allowed: at most " +
                           std::to_string(limits::scene_bytes));
}

std::size_t SceneBudget::gaussians_left() const {
  return limits::gaussians - gaussians_;
}

}  // namespace brume
