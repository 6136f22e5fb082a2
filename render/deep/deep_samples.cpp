#include "render/deep/deep_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>

namespace brume {
namespace {

// Beyond this optical depth a channel's light is less than the rounding of what is before.
constexpr double invisible_depth = 16.0;

// The first x of a volume's length. See DeepSample.
struct PartOfVolume {
  double transmittance;
  double light;  // relative to all of its light
};
PartOfVolume part_of_volume(double alpha, double x) {
  if (x >= 1.0) return {1.0 - alpha, 1.0};
  if (x <= 0.0) return {1.0, 0.0};
  if (alpha >= 1.0) return {0.0, 1.0};
  if (!(alpha > 0.0)) return {1.0, x};
  const double minus_part = std::expm1(x * std::log1p(-alpha));
  return {1.0 + minus_part, -minus_part / alpha};
}

double channel_mean(const glm::dvec3& channels) {
  return (channels.r + channels.g + channels.b) / 3.0;
}

// From point a to point b.
DeepSample sample_between(const RayProfile& ray, std::size_t a, std::size_t b) {
  DeepSample sample;
  sample.z = ray.distances[a];
  sample.z_back = ray.distances[b];
  for (int c = 0; c < 3; ++c) {
    sample.alpha[c] = static_cast<float>(-std::expm1(ray.depths[a][c] - ray.depths[b][c]));
    if (ray.depths[a][c] < invisible_depth) {
      sample.color[c] =
          static_cast<float>((ray.airlight[b][c] - ray.airlight[a][c]) / ray.transmittance[a][c]);
    }
  }
  const bool is_grey = sample.alpha.r == sample.alpha.g && sample.alpha.g == sample.alpha.b;
  const double before = channel_mean(ray.transmittance[a]);
  sample.mean_alpha = is_grey ? sample.alpha.r
                      : before > 0.0
                          ? static_cast<float>(1.0 - channel_mean(ray.transmittance[b]) / before)
                          : 1.0f;
  return sample;
}

// Whether the sample from a to b keeps the tolerance at all points between.
bool keeps(const RayProfile& ray, const DeepTolerance& tolerance, std::size_t a, std::size_t b) {
  if (b == a + 1) return true;
  const DeepSample sample = sample_between(ray, a, b);
  const double length = static_cast<double>(sample.z_back) - static_cast<double>(sample.z);
  const bool is_grey = sample.alpha.r == sample.alpha.g && sample.alpha.g == sample.alpha.b;
  for (std::size_t i = a + 1; i < b; ++i) {
    const double x =
        length > 0.0
            ? (static_cast<double>(ray.distances[i]) - static_cast<double>(sample.z)) / length
            : 1.0;
    PartOfVolume part = part_of_volume(static_cast<double>(sample.mean_alpha), x);
    const double mean_off = channel_mean(ray.transmittance[a]) * part.transmittance -
                            channel_mean(ray.transmittance[i]);
    if (std::abs(mean_off) > tolerance.transmittance) return false;
    for (int c = 0; c < 3; ++c) {
      if (!is_grey) part = part_of_volume(static_cast<double>(sample.alpha[c]), x);
      const double before = ray.transmittance[a][c];
      const double off = before * part.transmittance - ray.transmittance[i][c];
      const double light = before * static_cast<double>(sample.color[c]) * part.light;
      const double light_off = light - (ray.airlight[i][c] - ray.airlight[a][c]);
      if (std::abs(off) > tolerance.transmittance) return false;
      if (std::abs(light_off) > tolerance.airlight[c]) return false;
    }
  }
  return true;
}

// Whether nothing is between neighbouring points.
bool is_empty(const RayProfile& ray, std::size_t a) {
  return ray.depths[a] == ray.depths[a + 1] && ray.airlight[a] == ray.airlight[a + 1];
}

// The last point up to which a sample from `a` keeps the tolerance: doubling, then bisecting.
std::size_t last_kept(const RayProfile& ray, const DeepTolerance& tolerance, std::size_t a,
                      std::size_t end) {
  std::size_t kept = a + 1;
  std::size_t broken = end + 1;
  for (std::size_t step = 2; kept < end; step *= 2) {
    const std::size_t next = std::min(a + step, end);
    if (!keeps(ray, tolerance, a, next)) {
      broken = next;
      break;
    }
    kept = next;
  }
  while (broken - kept > 1 && kept < end) {
    const std::size_t middle = kept + (broken - kept) / 2;
    (keeps(ray, tolerance, a, middle) ? kept : broken) = middle;
  }
  return kept;
}

}  // namespace

void RayProfile::clear() {
  distances.clear();
  depths.clear();
  airlight.clear();
  transmittance.clear();
}

void RayProfile::add(float distance, const glm::dvec3& depth, const glm::dvec3& light) {
  distances.push_back(distance);
  depths.push_back(depth);
  airlight.push_back(light);
  transmittance.push_back(glm::exp(-depth));
}

double error_between_points(const RayProfile& ray, const DeepTolerance& tolerance) {
  // A parabola is off a quarter as much over halves of an interval as over the whole.
  constexpr double halves = 0.25;
  double error = 0.0;
  for (std::size_t i = 1; i + 1 < ray.size(); i += 2) {
    if (is_empty(ray, i - 1) && is_empty(ray, i)) continue;
    const DeepSample sample = sample_between(ray, i - 1, i + 1);
    for (int c = 0; c < 3; ++c) {
      const double alpha = static_cast<double>(sample.alpha[c]);
      const PartOfVolume part = part_of_volume(alpha, 0.5);
      const double before = ray.transmittance[i - 1][c];
      const double off = std::abs(before * part.transmittance - ray.transmittance[i][c]);
      const double lost = before * alpha;  // of transmittance, in all of the sample
      const double light = ray.airlight[i + 1][c] - ray.airlight[i - 1][c];
      error = std::max(error, halves * off / tolerance.transmittance);
      if (lost > 0.0 && light > 0.0) {
        error = std::max(error, halves * light * (off / lost) / tolerance.airlight[c]);
      }
    }
  }
  return error;
}

void fit_deep_samples(const RayProfile& ray, const DeepTolerance& tolerance,
                      std::vector<DeepSample>& samples) {
  if (ray.size() < 2) return;
  std::size_t end = ray.size() - 1;
  while (end > 0 && is_empty(ray, end - 1)) --end;
  for (std::size_t a = 0; a < end;) {
    if (is_empty(ray, a)) {
      ++a;
      continue;
    }
    const std::size_t b = last_kept(ray, tolerance, a, end);
    samples.push_back(sample_between(ray, a, b));
    a = b;
  }
}

}  // namespace brume
