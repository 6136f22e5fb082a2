#include "render/prepare/merged_medium.h"

#include <vector>

#include "core/authoring/simplify.h"

namespace brume {
namespace {

// Of fewer Gaussians frames are fast, and merging them after each edit would be felt.
constexpr std::size_t min_gaussians = 20'000;

// With more of them left the time that frames save does not make up for the merging.
constexpr double max_share = 0.8;

}  // namespace

std::optional<Medium> merged_medium(const Medium& medium, double max_error) {
  if (!(max_error > 0.0) || medium.size() < min_gaussians) return std::nullopt;
  std::vector<Gaussian> gaussians;
  gaussians.reserve(medium.size());
  for (std::size_t i = 0; i < medium.size(); ++i) {
    Gaussian& g = gaussians.emplace_back(medium.gaussian(i));
    g.group = 0;  // of the editor's
  }
  if (estimated_share(gaussians, max_error) > max_share) return std::nullopt;
  Medium merged;
  merged.set_homogeneous_density(medium.homogeneous_density());
  const std::vector<Gaussian> fewer = simplify(gaussians, max_error)->of(gaussians);
  for (const Gaussian& g : fewer) merged.append(g);
  return merged;
}

}  // namespace brume
