// How well Gaussians make a sequence of volumes; figures of resources/manual/volumes.md.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "brume/error.h"
#include "brume/fit.h"
#include "core/fit/fit_error.h"
#include "core/fit/next_start.h"
#include "core/io/frame_pattern.h"
#include "core/io/volume/volume_file.h"
#include "core/math/max_component.h"
#include "tools/fit_report/sequence_view.h"

namespace brume {
namespace {

// The seconds of all threads together: what other programs do meanwhile does not count.
double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The greatest radius over the least.
double median_elongation(std::vector<Gaussian> gaussians) {
  const auto least = [](const Gaussian& g) { return min_component(g.shape.stretch); };
  const auto middle = gaussians.begin() + static_cast<std::ptrdiff_t>(gaussians.size() / 2);
  std::ranges::nth_element(gaussians, middle, {}, least);
  return 1.0 / least(*middle);
}

void print_errors_by_count(const DensityGrid& grid) {
  std::puts(
      "| Gaussians | balls: density | optical depth | CPU seconds | ellipsoids: density | optical "
      "depth | CPU seconds | median elongation |\n|---|---|---|---|---|---|---|---|");
  for (const std::size_t count : {50, 100, 200, 500, 1000, 2000, 5000}) {
    std::printf("| %zu |", count);
    for (const FitShape shape : {FitShape::ball, FitShape::ellipsoid}) {
      const double start = cpu_seconds();
      const Fit fit = *fit_gaussians(grid, {count, 0.0, shape});
      const double seconds = cpu_seconds() - start;
      std::printf(" %.1f%% | %.1f%% | %.1f |", 100.0 * fit.density_error,
                  100.0 * depth_error(grid, fit.gaussians), seconds);
      if (shape == FitShape::ellipsoid) std::printf(" %.1f |", median_elongation(fit.gaussians));
      std::fflush(stdout);
    }
    std::puts("");
  }
}

// Fits frame by frame as `brume fit` does and renders fit and volume. The change between frames
// shows whether Gaussians flicker.
void print_coherence(const FramePattern& files, int first, int last, std::size_t count,
                     FitShape shape) {
  std::optional<SequenceView> view;
  std::vector<Gaussian> gaussians;
  std::optional<VelocityGrid> velocity;
  std::vector<float> last_volume, last_fit;
  double change_volume = 0.0, change_fit = 0.0, apart = 0.0, brightness = 0.0;
  std::puts(
      "| frame | CPU seconds | picture apart | change, volume | change, Gaussians |\n"
      "|---|---|---|---|---|");
  for (int number = first; number <= last; ++number) {
    const DensityGrid grid = read_volume(files.file_of(number), "density");
    if (!view) view.emplace(grid, Film{96, 96});
    const double start = cpu_seconds();
    if (gaussians.empty()) {
      gaussians = fit_gaussians(grid, {count, 0.0, shape})->gaussians;
    } else {
      if (velocity) gaussians = next_start(grid, gaussians, *velocity, 1.0 / 24.0);
      gaussians = refit_gaussians(grid, gaussians)->fit.gaussians;
    }
    const double seconds = cpu_seconds() - start;
    velocity = read_velocity(files.file_of(number));
    std::vector<float> volume = view->render(grid);
    std::vector<float> fit = view->render(gaussians);
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
                 "Prints the errors of the middle frame by number of Gaussians, then how much the "
                 "pictures of\nCOUNT (500) Gaussians change from frame to frame, compared with "
                 "those of the volume.\n";
    return 2;
  }
  const int first = std::stoi(arguments[1]);
  const int last = std::stoi(arguments[2]);
  const std::size_t count = arguments.size() == 4 ? std::stoul(arguments[3]) : 500;
  print_errors_by_count(read_volume(files->file_of((first + last) / 2), "density"));
  for (const FitShape shape : {FitShape::ball, FitShape::ellipsoid}) {
    std::puts(shape == FitShape::ball ? "\nballs\n" : "\nellipsoids\n");
    print_coherence(*files, first, last, count, shape);
  }
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
