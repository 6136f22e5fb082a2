// How well Gaussians make a sequence of volumes; figures of resources/manual/volumes.md.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <glm/common.hpp>
#include <iostream>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/fit/fit_error.h"
#include "core/fit/gaussian_fit.h"
#include "core/fit/next_start.h"
#include "core/io/frame_pattern.h"
#include "core/io/volume_file.h"
#include "render/renderer.h"
#include "tools/fit_report/grid_picture.h"

namespace brume {
namespace {

// Of all threads together: what other programs do meanwhile does not count.
double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void print_errors_by_count(const DensityGrid& grid) {
  std::puts("| Gaussians | density | optical depth | CPU seconds |\n|---|---|---|---|");
  for (const std::size_t count : {50, 100, 200, 500, 1000, 2000, 5000}) {
    const double start = cpu_seconds();
    const Fit fit = *fit_gaussians(grid, {count, 0.0});
    const double seconds = cpu_seconds() - start;
    std::printf("| %zu | %.1f%% | %.1f%% | %.1f |\n", count, 100.0 * fit.density_error,
                100.0 * depth_error(grid, fit.gaussians), seconds);
    std::fflush(stdout);
  }
}

// One view of a sequence, from where its first frame is seen, and lit, from the sides.
struct View {
  Camera camera;
  Film film{96, 96};
  PointLight light;

  explicit View(const DensityGrid& grid) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const DensityGrid::Block& block : grid.blocks) {
      for (int i = 0; i < 8; ++i) {
        const glm::ivec3 corner =
            block.corner + DensityGrid::side * glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
        const glm::dvec3 p = grid.to_world(glm::dvec3(corner));
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
    const glm::dvec3 middle = 0.5 * (low + high);
    const double size = glm::length(high - low);
    camera.target = middle;
    camera.eye = middle + size * glm::dvec3(1.3, 0.4, 0.9);
    camera.up = {0.0, 0.0, 1.0};
    light.position = middle + size * glm::dvec3(-0.7, 1.0, 0.8);
    light.intensity = glm::dvec3(size * size);
  }
};

std::vector<float> picture_of(std::span<const Gaussian> gaussians, const View& view) {
  Scene scene;
  for (const Gaussian& g : gaussians) scene.medium.append(g);
  scene.lights.push_back(view.light);
  Settings settings;
  settings.airlight = AirlightMethod::sliced;
  const Frame frame =
      *Renderer().render(scene, view.camera, view.film, sliced_settings(std::move(settings), 64));
  std::vector<float> red;
  for (std::size_t i = 0; i < frame.airlight.size(); i += 3) red.push_back(frame.airlight[i]);
  return red;
}

double squares_between(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += d * d;
  }
  return sum;
}

// Fits frame after frame as `brume fit` does and renders each, and the volume itself. How much
// pictures change from frame to frame says whether the Gaussians flicker.
void print_coherence(const FramePattern& files, int first, int last, std::size_t count) {
  std::optional<View> view;
  std::vector<Gaussian> gaussians;
  std::optional<VelocityGrid> velocity;
  std::vector<float> last_volume, last_fit;
  double change_volume = 0.0, change_fit = 0.0, apart = 0.0, brightness = 0.0;
  std::puts(
      "| frame | CPU seconds | picture apart | change, volume | change, Gaussians |\n"
      "|---|---|---|---|---|");
  for (int number = first; number <= last; ++number) {
    const DensityGrid grid = read_volume(files.of(number), "density");
    if (!view) view.emplace(grid);
    const double start = cpu_seconds();
    if (gaussians.empty()) {
      gaussians = fit_gaussians(grid, {count, 0.0})->gaussians;
    } else {
      if (velocity) gaussians = next_start(grid, gaussians, *velocity, 1.0 / 24.0);
      gaussians = refit_gaussians(grid, gaussians)->fit.gaussians;
    }
    const double seconds = cpu_seconds() - start;
    velocity = read_velocity(files.of(number));
    std::vector<float> volume = grid_picture(grid, view->camera, view->film, view->light);
    std::vector<float> fit = picture_of(gaussians, *view);
    const double scale = squares_between(volume, std::vector<float>(volume.size()));
    std::printf("| %d | %.1f | %.1f%% |", number, seconds,
                100.0 * std::sqrt(squares_between(fit, volume) / scale));
    if (!last_volume.empty()) {
      const double a = squares_between(volume, last_volume);
      const double b = squares_between(fit, last_fit);
      change_volume += a;
      change_fit += b;
      std::printf(" %.1f%% | %.1f%% |", 100.0 * std::sqrt(a / scale), 100.0 * std::sqrt(b / scale));
    }
    std::puts("");
    std::fflush(stdout);
    apart += squares_between(fit, volume);
    brightness += scale;
    last_volume = std::move(volume);
    last_fit = std::move(fit);
  }
  std::printf("pictures apart %.1f%%; change from frame to frame, Gaussians over volume %.3f\n",
              100.0 * std::sqrt(apart / brightness), std::sqrt(change_fit / change_volume));
}

int run(const std::vector<std::string>& arguments) {
  const auto files = arguments.empty() ? std::nullopt : FramePattern::parse(arguments[0]);
  if (arguments.size() < 3 || arguments.size() > 4 || !files) {
    std::cerr << "usage: brume-fit-report VOLUME_%04d.vdb FIRST LAST [COUNT]\n"
                 "Prints the errors of the middle frame against the number of Gaussians, then how "
                 "much the\npictures of COUNT (500) Gaussians change from frame to frame, beside "
                 "those of the volume.\n";
    return 2;
  }
  const int first = std::stoi(arguments[1]);
  const int last = std::stoi(arguments[2]);
  const std::size_t count = arguments.size() == 4 ? std::stoul(arguments[3]) : 500;
  print_errors_by_count(read_volume(files->of((first + last) / 2), "density"));
  std::puts("");
  print_coherence(*files, first, last, count);
  return 0;
}

}  // namespace
}  // namespace brume

int main(int count, char** arguments) {
  try {
    return brume::run({arguments + 1, arguments + count});
  } catch (const std::exception& error) {
    std::cerr << "brume-fit-report: " << error.what() << "\n";
    return 2;
  }
}
