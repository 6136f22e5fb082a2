#include "render/grid/scattering_solver.h"
#include "render/grid/sweep_kernels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

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

namespace {

// What surfaces reflect of the light at the nodes; nothing without surfaces.
std::vector<float> reflected(const GridMedium& medium, const NodeLight& incident) {
  return medium.surfaces ? reflected_light(*medium.surfaces, incident) : std::vector<float>{};
}

// The light at each node matters as much as it is scattered to the eye there. Without a medium it
// falls on surfaces.
std::vector<float> weights_of(const GridMedium& medium) {
  std::vector<float> weights(medium.density.begin(), medium.density.end());
  const auto is_zero = [](float density) { return density == 0.0f; };
  if (std::ranges::all_of(weights, is_zero)) std::ranges::fill(weights, 1.0f);
  return weights;
}

// How much the light at nodes changes relative to what is there, or to a hundredth of the
// brightest, as a root mean square by these weights. In deep fog the eye may be where little light
// is.
double relative_change(std::span<const float> weights, const NodeLight& before,
                       const NodeLight& after) {
  constexpr double dimmest_share = 0.01;
  const std::size_t nodes = weights.size();
  if (nodes == 0) return 0.0;
  std::vector<double> squares(nodes, 0.0);
  std::vector<double> changes(nodes, 0.0);
  const auto square = [](float x) { return static_cast<double>(x) * static_cast<double>(x); };
  for (std::size_t c = 0; c < after.channels; ++c) {
    const std::span<const float> mean = after.row(c, 0);
    const std::span<const float> last = before.row(c, 0);
    for (std::size_t i = 0; i < nodes; ++i) {
      squares[i] += square(mean[i]);
      changes[i] += square(mean[i] - last[i]);
    }
  }
  const double least = dimmest_share * dimmest_share * *std::ranges::max_element(squares);
  double sum = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; least > 0.0 && i < nodes; ++i) {
    const auto weight = static_cast<double>(weights[i]);
    sum += weight * changes[i] / (squares[i] + least);
    all += weight;
  }
  return all > 0.0 ? std::sqrt(sum / all) : 0.0;
}

}  // namespace

Convergence solve_scattering(const GridMedium& medium, const TruncatedScattering& scattering,
                             const UnscatteredLight& unscattered, const SweepDegrees& degrees,
                             const ScatteringLimits& limits, NodeLight& scattered, const Job& job) {
  std::vector<double> phase = scattering.phase;
  for (double& factor : phase) factor *= scattering.albedo;

  const NodeLight& incident = unscattered.incident;
  // A sweep changes less where light that has left comes back: 2% would be missing.
  const double tolerance = (medium.beyond ? 0.3 : 1.0) * limits.tolerance;
  const std::vector<float> weights = weights_of(medium);
  std::vector<float> padded_weights = weights;
  padded_weights.resize(incident.stride, 0.0f);
  AndersonAcceleration acceleration(padded_weights);

  NodeLight first(incident.bands, incident.channels, medium.nodes.size());
  if (limits.sweeps == 1 && !scattered.values.empty()) {
    // One sweep for what was scattered and what was not.
    NodeLight all = scattered;
    add(incident.values, all.values);
    std::vector<float> all_reflected = reflected(medium, scattered);
    add(unscattered.reflected, all_reflected);
    scatter_once(medium, all, all_reflected, phase, degrees.first, first, job);
    scattered = std::move(first);
    return {.sweeps = 1};
  }
  scatter_once(medium, incident, unscattered.reflected, phase, degrees.first, first, job);
  if (scattered.values.empty()) scattered = first;
  NodeLight next = first;
  Convergence convergence{.sweeps = 1};
  while (convergence.sweeps < limits.sweeps && !job.stop.stop_requested()) {
    scatter_once(medium, scattered, reflected(medium, scattered), phase, degrees.rest, next, job);
    add(first.values, next.values);
    ++convergence.sweeps;
    convergence.residual = relative_change(weights, scattered, next);
    acceleration.advance(scattered.values, next.values);
    if (convergence.residual <= tolerance) break;
  }
  return convergence;
}

}  // namespace brume
