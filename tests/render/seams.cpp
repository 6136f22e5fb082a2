#include "tests/render/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "render/geometry/tiles.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// A film, seen along x or with x and y swapped.
class FilmValues {
 public:
  FilmValues(const Frame& frame, const Frame& reference, bool swapped)
      : film_(frame.film), depth_(frame.depth), swapped_(swapped) {
    error_.resize(depth_.size());
    double square = 0.0;
    for (std::size_t i = 0; i < depth_.size(); ++i) {
      double light = 0.0;
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
        error_[i] +=
            static_cast<double>(frame.airlight[k]) - static_cast<double>(reference.airlight[k]);
        light += static_cast<double>(reference.airlight[k]);
      }
      square += light * light;
    }
    rms_ = std::sqrt(square / static_cast<double>(depth_.size()));
  }

  [[nodiscard]] int width() const { return swapped_ ? film_.height : film_.width; }
  [[nodiscard]] int height() const { return swapped_ ? film_.width : film_.height; }
  [[nodiscard]] double rms() const { return rms_; }

  // The step of the error between x - step and x, over its change before and after.
  [[nodiscard]] std::optional<double> step(int x, int y, int step) const {
    std::array<double, 4> e;
    for (int k = 0; k < 4; ++k) {
      const std::size_t i = at(x + (k - 2) * step, y);
      if (k > 0 && !continuous(at(x + (k - 3) * step, y), i)) return std::nullopt;
      e[static_cast<std::size_t>(k)] = error_[i];
    }
    return e[2] - e[1] - 0.5 * (e[1] - e[0] + e[3] - e[2]);
  }

 private:
  [[nodiscard]] std::size_t at(int x, int y) const {
    if (swapped_) std::swap(x, y);
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(film_.width) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] bool continuous(std::size_t a, std::size_t b) const {
    return depth_[a] == depth_[b] ||
           std::abs(depth_[a] - depth_[b]) < 0.05f * std::min(depth_[a], depth_[b]);
  }

  const Film& film_;
  const std::vector<float>& depth_;
  bool swapped_;
  std::vector<double> error_;
  double rms_ = 0.0;
};

// The mean over the pixels [y0, y1) of column x.
std::optional<double> step_at(const FilmValues& field, int x, int y0, int y1, int scale) {
  double sum = 0.0;
  int count = 0;
  for (int y = y0; y < y1; ++y) {
    const std::optional<double> step = field.step(x, y, scale);
    if (!step) continue;
    sum += *step;
    ++count;
  }
  if (2 * count < y1 - y0) return std::nullopt;
  return sum / count;
}

}  // namespace

Scene seam_scene(unsigned seed) {
  Random random(seed);
  Scene scene =
      cloud_scene(5 + static_cast<int>(random.uniform(0.0, 40.0)), random.power(-0.7, 0.7), seed);
  const Medium round = std::exchange(scene.medium, Medium());
  for (std::size_t i = 0; i < round.size(); ++i) {
    Gaussian g = round.gaussian(i);
    g.center *= glm::dvec3(1.5, 0.6, 1.5);
    g.radius *= random.power(-0.3, 0.3);
    scene.medium.append(g);
  }
  scene.lights.clear();
  const int lights = 1 + static_cast<int>(seed % 3);
  for (int l = 0; l < lights; ++l) {
    const glm::dvec3 place = random.point(l == 0 ? 1.0 : 3.0);
    scene.lights.push_back({place, random.point(5.0) + 6.0, {}});
  }
  if (seed % 2 == 0) scene.medium.set_homogeneous_density(random.power(-2.0, -0.7));
  if (seed % 4 == 1) scene.optics.noise.amplitude = 0.3;
  if (seed % 3 == 0) {
    scene.surfaces.push_back(ball_surface(32, 0.4, random.point(0.7)));
  }
  scene.film = {320, 256};
  return scene;
}

void Seams::add(const Seams& more) {
  borders.insert(borders.end(), more.borders.begin(), more.borders.end());
  insides.insert(insides.end(), more.insides.begin(), more.insides.end());
  std::ranges::sort(borders);
  std::ranges::sort(insides);
}

double Seams::ratio(double quantile) const {
  const auto value_at = [quantile](const std::vector<double>& steps) {
    return steps.at(static_cast<std::size_t>(quantile * static_cast<double>(steps.size() - 1)));
  };
  return value_at(borders) / value_at(insides);
}

Seams find_seams(const Frame& frame, const Frame& reference, int scale) {
  Seams seams;
  for (const bool swapped : {false, true}) {
    const FilmValues field(frame, reference, swapped);
    const int tile = scale * (swapped ? Tiles::height : Tiles::width);
    const int along = scale * (swapped ? Tiles::width : Tiles::height);
    for (int x = tile; x + tile <= field.width(); x += tile) {
      for (int y = 0; y + along <= field.height(); y += along) {
        const auto border = step_at(field, x, y, y + along, scale);
        const auto inside = step_at(field, x + tile / 4, y, y + along, scale);
        if (!border || !inside) continue;
        seams.borders.push_back(std::abs(*border) / field.rms());
        seams.insides.push_back(std::abs(*inside) / field.rms());
      }
    }
  }
  std::ranges::sort(seams.borders);
  std::ranges::sort(seams.insides);
  return seams;
}

}  // namespace brume
