#include "core/io/gaussians/dropped_splats.h"

#include <numbers>

#include "brume/error.h"
#include "core/number_domain.h"

namespace brume {

std::string splat_fault(const Gaussian& g, const SplatNames& names) {
  const auto fault = [](std::string_view name, const std::string& why) {
    return std::string(name) + ": " + why;
  };
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (!domain::coordinate.contains(g.center[k])) {
      return fault(names.position[i], domain::coordinate.refusal(g.center[k]));
    }
    if (!domain::stretch.contains(g.shape.stretch[k])) {  // NaN is in no comparison
      return fault(names.scale[i], "allowed: finite standard deviations");
    }
  }
  if (!domain::length.contains(g.radius)) {
    return fault(names.scale[0], "found a standard deviation of " +
                                     quoted_text(g.radius / std::numbers::sqrt2) +
                                     "; allowed: " + domain::length.allowed);
  }
  if (!domain::density.contains(g.density)) {
    return fault(names.opacity, "makes a density of " + quoted_text(g.density) +
                                    "; allowed: " + domain::density.allowed);
  }
  for (int c = 0; g.optics.albedo && c < 3; ++c) {
    if (!domain::albedo.contains((*g.optics.albedo)[c])) {
      return fault(names.color[static_cast<std::size_t>(c)], "allowed: a finite number");
    }
  }
  return {};
}

void DroppedSplats::add(const std::string& place, const std::string& why) {
  if (count_++ > 0) return;
  first_place_ = place;
  first_reason_ = why;
}

void DroppedSplats::report(const std::filesystem::path& file, std::size_t total,
                           std::vector<std::string>* warnings) const {
  if (count_ == 0) return;
  const std::string which = std::to_string(count_) + " of " + std::to_string(total) + " splats";
  if (2 * count_ >= total) {
    throw InputError(file, first_place_, first_reason_ + " (so are " + which + ")");
  }
  if (warnings == nullptr) return;
  warnings->push_back(file.string() + ": " + which + " left out; the first: " + first_place_ +
                      ": " + first_reason_);
}

}  // namespace brume
