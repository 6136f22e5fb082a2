// A deep frame of a cloud of 3,000 Gaussians beside 64 even slices: samples, size, time, and the
// worst error when held out, against frames with a wall.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/io/image/deep_exr_file.h"
#include "render/deep/deep_renderer.h"
#include "render/deep/deep_samples.h"
#include "render/renderer.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

constexpr int even_slices = 64;
constexpr double nearest = 2.5;  // distances that hold the cloud on all rays [u]
constexpr double farthest = 5.5;
constexpr int walls = 24;

// A deep image in memory.
struct DeepImage {
  std::vector<std::size_t> first{0};
  std::vector<DeepSample> samples;

  void add(const DeepRows& rows) {
    for (const std::uint32_t count : rows.counts) first.push_back(first.back() + count);
    samples.insert(samples.end(), rows.samples.begin(), rows.samples.end());
  }
  [[nodiscard]] std::size_t pixels() const { return first.size() - 1; }
  [[nodiscard]] HeldOut at(std::size_t pixel, double distance) const {
    return held_out(samples.data() + first[pixel], first[pixel + 1] - first[pixel], distance);
  }
};

// Slices of equal length that are exact at their ends, as `image` has it.
DeepRows evenly_sliced(const DeepRows& rows) {
  DeepImage image;
  image.add(rows);
  DeepRows even{rows.first, {}, {}};
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    RayProfile ray;
    for (int k = 0; k <= even_slices; ++k) {
      const double distance = nearest + (farthest - nearest) * k / even_slices;
      const HeldOut seen = image.at(i, distance);
      ray.add(static_cast<float>(distance), -glm::log(seen.transmittance), seen.airlight);
    }
    const std::size_t before = even.samples.size();
    // No tolerance: every slice that is not empty is a sample.
    fit_deep_samples(ray, {-1.0, glm::dvec3(-1.0)}, even.samples);
    even.counts.push_back(static_cast<std::uint32_t>(even.samples.size() - before));
  }
  return even;
}

Surface wall_at(double z) {
  Surface wall;
  wall.mesh = to_mesh({{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}},
                       {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                       {{0, 1, 2}, {0, 2, 3}}});
  wall.translate = {0.0, 0.0, z};
  wall.material.reflectance = glm::dvec3(0.0);
  return wall;
}

// The worst errors: of airlight relative to the pixel's own or the frame's rms, and of alpha.
struct Worst {
  double airlight = 0.0;
  double alpha = 0.0;
};

void compare(const DeepImage& deep, const Frame& wall, double rms, Worst& worst) {
  for (std::size_t i = 0; i < deep.pixels(); ++i) {
    const HeldOut seen = deep.at(i, static_cast<double>(wall.depth[i]));
    const double own_airlight = deep.at(i, 1e9).airlight.x;
    const double light = std::abs(seen.airlight.x - static_cast<double>(wall.airlight[3 * i]));
    const double alpha =
        std::abs(seen.transmittance.x - static_cast<double>(wall.transmittance[3 * i]));
    worst.airlight = std::max(worst.airlight, light / std::max(own_airlight, rms));
    worst.alpha = std::max(worst.alpha, alpha);
  }
}

DeepSettings settings_of(double error, double rms) {
  DeepSettings deep;
  deep.settings = sliced_settings({}, 24);
  deep.error = error;
  deep.airlight_rms = rms;
  return deep;
}

void print_row(const std::string& name, double samples, double megabytes, double seconds,
               const Worst& worst) {
  std::printf("| %s | %.1f | %.0f | %.0f | %.2f%% | %.2f%% |\n", name.c_str(), samples, megabytes,
              seconds, 100.0 * worst.airlight, 100.0 * worst.alpha);
  std::fflush(stdout);
}

void report(const Film& film) {
  Scene scene = cloud(3000, 8.0, 1, 0.1);
  Renderer renderer;
  Scene small = scene;
  small.film = {film.width / 8, film.height / 8};
  const Settings fine = sliced_settings({}, 64);
  const auto render = [&](const Scene& what) {
    return renderer.render(what, what.camera, what.film, fine).value();
  };
  double rms = 0.0;
  const Frame flat = render(small);
  for (const float light : flat.airlight) rms += static_cast<double>(light * light);
  rms = std::sqrt(rms / static_cast<double>(flat.airlight.size()));
  std::vector<Frame> walled;
  for (int k = 0; k < walls; ++k) {
    Scene with_wall = small;
    with_wall.surfaces.push_back(wall_at(1.2 - 2.4 * (k + 0.5) / walls));
    walled.push_back(render(with_wall));
  }
  std::printf("%d x %d pixels; errors at %d x %d, %d walls\n\n", film.width, film.height,
              small.film.width, small.film.height, walls);
  std::printf(
      "| | samples a pixel | MB | s | worst airlight | worst alpha |\n|---|---|---|---|---|---|\n");
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("brume-report-" + std::to_string(rand()) + ".exr");
  const auto row = [&](const std::string& name, double error, bool even) {
    const DeepSettings deep = settings_of(error, rms);
    DeepImage image;
    static_cast<void>(
        render_deep(small, small.camera, small.film, deep, TransferStore(),
                    [&](const DeepRows& rows) { image.add(even ? evenly_sliced(rows) : rows); }));
    Worst worst;
    for (const Frame& frame : walled) compare(image, frame, rms, worst);
    std::size_t samples = 0;
    const auto start = std::chrono::steady_clock::now();
    write_deep_exr(file, {film.width, film.height, false, {}}, [&](const TakeDeepRows& take) {
      static_cast<void>(
          render_deep(scene, scene.camera, film, deep, TransferStore(), [&](const DeepRows& rows) {
            const DeepRows made = even ? evenly_sliced(rows) : rows;
            samples += made.samples.size();
            take(made);
          }));
    });
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    print_row(name, static_cast<double>(samples) / (static_cast<double>(film.width) * film.height),
              static_cast<double>(std::filesystem::file_size(file)) * 1e-6, seconds.count(), worst);
    std::filesystem::remove(file);
  };
  row("--deep-error 0.05", 0.05, false);
  row("--deep-error 0.01", 0.01, false);
  row("--deep-error 0.002", 0.002, false);
  row("64 even slices", 0.0005, true);
}

}  // namespace
}  // namespace brume

int main(int count, char** arguments) {
  const int width = count > 1 ? std::atoi(arguments[1]) : 2048;
  if (width < 64 || width > 4096) {
    std::fprintf(stderr, "usage: brume-deep-report [WIDTH from 64 to 4096, default 2048]\n");
    return 2;
  }
  brume::report({width, width * 9 / 16});
}
