#include "core/scene/animation/sequence_frames.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace brume {
namespace {

GaussianOptics between(const GaussianOptics& a, const GaussianOptics& b, double u,
                       const glm::dvec3& medium_albedo) {
  GaussianOptics optics;
  if (a.albedo || b.albedo) {
    optics.albedo = glm::mix(a.albedo.value_or(medium_albedo), b.albedo.value_or(medium_albedo), u);
  }
  optics.emission = glm::mix(a.emission, b.emission, u);
  return optics;
}

// Turns the ball of radius 1 into a Gaussian's.
glm::dmat3 ellipsoid_of(const Gaussian& g) {
  return g.radius * glm::inverse(warp(g.shape));
}

Gaussian between(const Gaussian& a, const Gaussian& b, double u, const glm::dvec3& medium_albedo) {
  Gaussian g{glm::mix(a.center, b.center, u), a.radius * std::pow(b.radius / a.radius, u),
             std::lerp(a.density, b.density, u), between(a.optics, b.optics, u, medium_albedo)};
  if (a.is_ball() && b.is_ball()) return g;
  // Whatever the order of their axes.
  g.radius = 1.0;
  transform(g, (1.0 - u) * ellipsoid_of(a) + u * ellipsoid_of(b));
  return g;
}

// How far between a frame, of at least one, and the next.
struct Place {
  std::size_t frame = 0;
  double share = 0.0;
};

Place place_at(const MediumSequence& sequence, double time) {
  const double last = static_cast<double>(sequence.frames->size()) - 1.0;
  const double position =
      std::clamp((time - sequence.start) * sequence.frames_per_second, 0.0, last);
  // Frames are met at moments that have no exact number.
  const double nearest = std::round(position);
  if (std::abs(position - nearest) < 1e-6) return {static_cast<std::size_t>(nearest), 0.0};
  const double before = std::floor(position);
  return {static_cast<std::size_t>(before), position - before};
}

Gaussian faded(Gaussian gaussian, double share) {
  gaussian.density *= share;
  return gaussian;
}

class FramesInMemory final : public SequenceFrames {
 public:
  explicit FramesInMemory(std::vector<SequenceFrame> frames) {
    std::size_t before = 0;
    for (SequenceFrame& frame : frames) {
      const std::size_t count = frame.gaussians.size();
      max_gaussians_ = std::max(max_gaussians_, before + count);
      before = count;
      frames_.push_back(std::make_shared<const SequenceFrame>(std::move(frame)));
    }
  }

  [[nodiscard]] std::size_t size() const override { return frames_.size(); }
  [[nodiscard]] std::shared_ptr<const SequenceFrame> frame(std::size_t index) const override {
    return frames_[index];
  }
  [[nodiscard]] std::size_t max_gaussians() const override { return max_gaussians_; }
  [[nodiscard]] bool are_in_memory() const override { return true; }

 private:
  std::vector<std::shared_ptr<const SequenceFrame>> frames_;
  std::size_t max_gaussians_ = 0;
};

}  // namespace

std::shared_ptr<const SequenceFrames> sequence_frames(std::vector<SequenceFrame> frames) {
  return std::make_shared<FramesInMemory>(std::move(frames));
}

std::vector<Gaussian> between_frames(const SequenceFrame& a, const SequenceFrame& b, double u,
                                     const glm::dvec3& medium_albedo) {
  std::vector<Gaussian> result;
  result.reserve(std::max(a.ids.size(), b.ids.size()));
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.ids.size() || j < b.ids.size()) {
    if (j == b.ids.size() || (i < a.ids.size() && a.ids[i] < b.ids[j])) {
      result.push_back(faded(a.gaussians[i++], 1.0 - u));
    } else if (i == a.ids.size() || b.ids[j] < a.ids[i]) {
      result.push_back(faded(b.gaussians[j++], u));
    } else {
      result.push_back(between(a.gaussians[i++], b.gaussians[j++], u, medium_albedo));
    }
  }
  return result;
}

std::vector<Gaussian> sequence_at(const MediumSequence& sequence, double time,
                                  const glm::dvec3& medium_albedo) {
  const SequenceFrames& frames = *sequence.frames;
  if (frames.size() == 0) return {};
  const Place place = place_at(sequence, time);
  if (place.share == 0.0) return frames.frame(place.frame)->gaussians;
  return between_frames(*frames.frame(place.frame), *frames.frame(place.frame + 1), place.share,
                        medium_albedo);
}

std::vector<int> frames_at(const MediumSequence& sequence, double time) {
  if (sequence.frames->size() == 0) return {};
  const Place place = place_at(sequence, time);
  const int frame = static_cast<int>(place.frame);
  return place.share == 0.0 ? std::vector{frame} : std::vector{frame, frame + 1};
}

std::size_t gaussian_count(const MediumSequence& sequence) {
  return sequence.frames->max_gaussians();
}

double end_of(const MediumSequence& sequence) {
  return sequence.start + (sequence.last - sequence.first) / sequence.frames_per_second;
}

}  // namespace brume
