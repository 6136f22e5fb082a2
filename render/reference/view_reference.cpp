#include "render/reference/view_reference.h"

#include <algorithm>

namespace brume {

bool ViewReference::evaluate(std::span<const std::size_t> pixels, const std::stop_token& stop,
                             const std::function<void(double)>& progress) {
  std::vector<std::size_t> unknown;
  std::ranges::copy_if(pixels, std::back_inserter(unknown),
                       [this](std::size_t pixel) { return !known_.contains(pixel); });
  const std::vector<glm::dvec3> airlight = reference_.airlight(unknown, stop, progress);
  if (airlight.size() != unknown.size()) return false;
  for (std::size_t i = 0; i < unknown.size(); ++i) known_.emplace(unknown[i], airlight[i]);
  return true;
}

}  // namespace brume
