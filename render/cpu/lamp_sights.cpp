#include "render/cpu/lamp_sights.h"

namespace brume {

LampSights::LampSights(const TriangleBeams& beams, const glm::dvec3& lamp)
    : beams_(beams),
      lamp_(lamp),
      sights_(beams.size()),
      parts_(beams.size()),
      asked_(beams.size()) {}

SideSight LampSights::find(std::uint32_t triangle) const {
  if (triangle % rounds != frame_ % rounds) return {};
  const SideSight sight = beams_.sight(lamp_, triangle);
  sights_[triangle].store(sight, std::memory_order_relaxed);
  return sight;
}

TriangleSight LampSights::find_part(std::uint32_t triangle, std::uint32_t part) const {
  if ((asked_[triangle].fetch_add(1, std::memory_order_relaxed) + 1) % rays_per_part != 0) {
    return TriangleSight::unknown;
  }
  const TriangleSight sight = beams_.sight_of_part(lamp_, triangle, part);
  parts_[triangle].fetch_or(static_cast<std::uint64_t>(sight) << 2 * part,
                            std::memory_order_relaxed);
  return sight;
}

}  // namespace brume
