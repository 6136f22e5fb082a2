#include "core/authoring/contribution.h"

#include <algorithm>
#include <cmath>

#include "core/transport/optical_depth.h"

namespace brume {

std::vector<Contribution> contributions(const Medium& medium, const glm::dvec3& eye,
                                        const glm::dvec3& direction, double distance,
                                        double least) {
  struct Met {
    double t = 0.0;
    Contribution contribution;
  };
  std::vector<Met> met;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const GaussianTerm<double> g(medium.gaussian(i));
    const LineProfile<double> line = line_profile(g, eye, direction);
    // At most this: most Gaussians are far from the ray.
    if (1.7725 * medium.radii()[i] * medium.densities()[i] * std::exp(-line.e) < least) continue;
    const double depth = optical_depth(g, line, distance);
    if (depth >= least) met.push_back({truncated_mean(g, line, distance), {i, depth, 0.0}});
  }
  std::sort(met.begin(), met.end(), [](const Met& a, const Met& b) { return a.t < b.t; });
  double before = 0.0;
  std::vector<Contribution> result;
  result.reserve(met.size());
  for (Met& m : met) {
    m.contribution.share = -std::exp(-before) * std::expm1(-m.contribution.optical_depth);
    before += m.contribution.optical_depth;
    result.push_back(m.contribution);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Contribution& a, const Contribution& b) { return a.share > b.share; });
  return result;
}

}  // namespace brume
