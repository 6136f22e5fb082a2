#include "render/cpu/lamp_sights.h"

namespace brume {

LampSights::LampSights(const TriangleBeams& beams, const glm::dvec3& lamp)
    : beams_(beams), lamp_(lamp), sights_(beams.size()) {}

SideSight LampSights::find(std::uint32_t triangle) const {
  if (triangle % rounds != frame_ % rounds) return {};
  const SideSight sight = beams_.sight(lamp_, triangle);
  sights_[triangle].store(sight, std::memory_order_relaxed);
  return sight;
}

}  // namespace brume
