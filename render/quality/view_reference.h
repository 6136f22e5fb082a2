#pragma once

#include <functional>
#include <optional>
#include <unordered_map>

#include "render/quality/center_light.h"
#include "render/quality/path_pixels.h"
#include "render/reference/reference_pixels.h"
#include "render/settings.h"

namespace brume {

// Caches what the pixels of one view ought to be. Not thread-safe.
class ViewReference {
 public:
  // Scattered once: converged, see ReferencePixels, but for area lights and light through panes.
  // These, and what is scattered more often, by PathPixels, which are noisy; all orders where
  // surfaces keep an environment out or fog ends, which the former do not know, or where they would
  // take too long. The picture has all orders, by PathPixels too where they are not known exactly.
  ViewReference(const Scene& scene, const Camera& camera, const Film& film, double tolerance,
                Scattering scattering = Scattering::single, Measured measured = Measured::airlight);

  // Evaluates pixels that are not cached, in parallel, milliseconds each; those by paths with at
  // least so many of them, of each pixel. False if `stop` was requested. `progress`: see
  // FrameRenderer.
  bool evaluate(std::span<const std::size_t> pixels, const std::function<int(std::size_t)>& paths,
                const std::stop_token& stop, const std::function<void(double)>& progress = {});

  // Airlight of an evaluated pixel, and its picture if that is measured.
  [[nodiscard]] const PixelRadiance& airlight(std::size_t pixel) const {
    return known_.at(pixel).airlight;
  }
  [[nodiscard]] const PixelRadiance& picture(std::size_t pixel) const {
    return known_.at(pixel).picture;
  }
  [[nodiscard]] bool has_picture() const { return has_picture_; }

  // Forgets all pixels.
  void forget() { known_.clear(); }

  // Whether more paths make pixels surer.
  [[nodiscard]] bool is_noisy() const { return path_pixels_.has_value(); }
  // Whether they do in the airlight.
  [[nodiscard]] bool has_noisy_airlight() const { return has_noisy_airlight_; }

  // Number of evaluated pixels.
  [[nodiscard]] std::size_t size() const { return known_.size(); }

  // What all evaluations have cost, those of paths apart; see work.h.
  struct Work {
    double integrals = 0.0;
    double paths = 0.0;

    [[nodiscard]] double sum() const { return integrals + paths; }
  };
  [[nodiscard]] const Work& work() const { return work_; }
  // What the integral of one more pixel costs.
  [[nodiscard]] double integral_work() const { return integral_work_; }

 private:
  struct Pixel {
    glm::dvec3 exact{0.0};  // converged
    PixelPaths paths;
    PixelRadiance airlight;  // of both
    PixelRadiance picture;
  };

  bool has_picture_;
  bool has_noisy_airlight_ = false;
  bool keeps_integrals_ = false;  // in the picture
  double integral_work_ = 0.0;
  Work work_;
  std::optional<ReferencePixels> reference_;
  std::optional<PathPixels> path_pixels_;
  std::unordered_map<std::size_t, Pixel> known_;
};

}  // namespace brume
