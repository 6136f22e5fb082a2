#include "render/lighting/scattering_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/util/anderson.h"

namespace brume {

TruncatedScattering::TruncatedScattering(double full_albedo, double anisotropy, int bands,
                                         bool albedo_varies)
    : albedo(full_albedo), phase(phase_bands(anisotropy, bands)) {
  if (bands == 1 || albedo_varies) return;  // isotropic, or cut off
  const double lobe = forward_lobe(anisotropy, bands);
  for (double& factor : phase) factor = (factor - lobe) / (1.0 - lobe);
  extinction = 1.0 - full_albedo * lobe;
  albedo = full_albedo * (1.0 - lobe) / extinction;
}

Convergence solve_scattering(const GridMedium& medium, const TruncatedScattering& scattering,
                             const UnscatteredLight& unscattered, const SweepDegrees& degrees,
                             const ScatteringLimits& limits, NodeLight& scattered, const Job& job) {
  std::vector<double> phase = scattering.phase;
  for (double& factor : phase) factor *= scattering.albedo;

  const NodeLight& incident = unscattered.incident;
  // What matters is what is scattered to the eye.
  std::vector<float> weights(incident.stride, 0.0f);
  std::copy(medium.density.begin(), medium.density.end(), weights.begin());
  AndersonAcceleration acceleration(weights);

  NodeLight first(incident.bands, incident.channels, medium.nodes.size());
  scatter_once(medium, incident, unscattered.reflected, phase, degrees.first, first, job);
  if (scattered.values.empty()) scattered = first;
  NodeLight next = first;
  Convergence convergence{.sweeps = 1};
  while (convergence.sweeps < limits.sweeps && !job.stop.stop_requested()) {
    const std::vector<float> reflected =
        medium.surfaces ? reflected_light(*medium.surfaces, scattered) : std::vector<float>{};
    scatter_once(medium, scattered, reflected, phase, degrees.rest, next, job);
    for (std::size_t i = 0; i < next.values.size(); ++i) next.values[i] += first.values[i];
    ++convergence.sweeps;
    const double size = acceleration.norm(next.values);
    const double residual = acceleration.advance(scattered.values, next.values);
    convergence.residual = size > 0.0 ? residual / size : 0.0;
    if (convergence.residual <= limits.tolerance) break;
  }
  return convergence;
}

}  // namespace brume
