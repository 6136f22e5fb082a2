#include "render/environment_source.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/scene/environment.h"
#include "core/scene/radiance_map.h"
#include "core/transport/phase_function.h"

namespace brume {
namespace {

constexpr double pi = std::numbers::pi;

// The map convolved with the phase function, in rows as fine as the function is narrow.
std::shared_ptr<const RadianceMap> convolved(const RadianceMap& map, double g, const Job& job) {
  const int rows =
      std::clamp(static_cast<int>(std::ceil(pi / (0.25 * (1.0 - std::abs(g))))), 24, 64);
  const std::vector<DistantLight> lights = even_distant_lights(map, rows);
  auto result = std::make_shared<RadianceMap>(RadianceMap{2 * rows, rows, {}});
  const auto width = static_cast<std::size_t>(result->width);
  result->pixels.resize(width * static_cast<std::size_t>(rows));
  job.each(static_cast<std::size_t>(rows), [&](std::size_t y) {
    for (std::size_t x = 0; x < width; ++x) {
      const glm::dvec3 w =
          map_direction(*result, {static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5});
      glm::dvec3 sum(0.0);
      for (const DistantLight& light : lights) {
        sum += henyey_greenstein(glm::dot(w, light.direction), g) * light.flux;
      }
      result->pixels[y * width + x] = glm::vec3(sum / (4.0 * pi));
    }
  });
  return result;
}

}  // namespace

bool EnvironmentSource::update(const Input& input, const Job& job) {
  const Environment& environment = input.environment;
  const bool same_light = grid_ && environment_.map == environment.map &&
                          anisotropy_ == input.anisotropy && size_ == input.size;
  const bool same = same_light && environment_.rotation == environment.rotation &&
                    has_same(input.receivers) && medium_ == input.medium;
  environment_ = environment;
  scattered_.intensity = environment.intensity;
  scattered_.rotation = environment.rotation;
  attenuation_ = std::exp(-input.fog_depth);
  if (same) return true;
  if (!same_light) read_map(*environment.map, input.anisotropy, input.size.directions, job);
  medium_ = input.medium;
  anisotropy_ = input.anisotropy;
  receivers_ = input.receivers;
  size_ = input.size;

  std::vector<DistantLight> lights = lights_;
  light_ = ShVector<glm::dvec3>(phase_.count());
  for (DistantLight& light : lights) {
    light.direction = environment_rotation(environment) * light.direction;
    const ShVector<double> basis = sh_basis(light_.order(), light.direction);
    for (std::size_t i = 0; i < light_.size(); ++i) light_[i] += basis[i] * light.flux;
  }
  std::vector<GaussianTerm<double>> gaussians;
  for (std::size_t i = 0; i < medium_.size(); ++i) gaussians.emplace_back(medium_.gaussian(i));
  const bool has_fog = medium_.homogeneous_density() > 0.0;
  grid_.emplace(gaussians, lights, SourceGrid::Content{phase_.count(), has_fog, receivers_},
                input.size, job);
  if (job.stop.stop_requested()) grid_.reset();
  return grid_.has_value();
}

// Of where receivers are only that counts which decides on the grid.
bool EnvironmentSource::has_same(const std::optional<SourceGrid::Receivers>& receivers) const {
  if (!receivers_ || !receivers) return receivers_.has_value() == receivers.has_value();
  return receivers_->optics == receivers->optics &&
         grid_->holds(receivers_->box) == grid_->holds(receivers->box);
}

void EnvironmentSource::read_map(const RadianceMap& map, double anisotropy, std::size_t directions,
                                 const Job& job) {
  lights_ = distant_lights(map, directions);
  phase_ = PhaseBands(anisotropy);
  scattered_.map = phase_.count() > 1 ? convolved(map, anisotropy, job) : nullptr;
}

SourceWeights EnvironmentSource::weights(const glm::dvec3& w) const {
  // Sums of what is beyond float would not be numbers.
  const double power = glm::length(light_[0]);
  const double scale =
      std::min(attenuation_ * environment_.intensity, 1e30 / std::max(power, 1e-30));
  const auto bands = phase_.at(w);
  SourceWeights weights{};
  glm::dvec3 kept(0.0);
  for (std::size_t i = 0; i < light_.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      weights[4 * i + c] = static_cast<float>(scale * static_cast<double>(bands[i]));
    }
    kept += static_cast<double>(bands[i]) * light_[i];
  }
  if (!scattered_.map) return weights;
  const glm::dvec3 all = environment_radiance(scattered_, w) / environment_.intensity;
  for (int c = 0; c < 3; ++c) {
    if (!(light_[0][c] > 0.0)) continue;
    weights[static_cast<std::size_t>(c)] +=
        static_cast<float>(scale * (all[c] - kept[c]) / light_[0][c]);
  }
  return weights;
}

}  // namespace brume
