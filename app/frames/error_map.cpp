#include "app/frames/error_map.h"

#include <QElapsedTimer>
#include <algorithm>
#include <cmath>
#include <span>

#include "app/frames/frame_service.h"
#include "render/quality/view_reference.h"

namespace brume {
namespace {

constexpr int coarsest = 32;         // pixels apart
constexpr double tolerance = 1e-3;   // of the reference: far below what is to be seen
constexpr int paths = 256;           // per pixel, of what is scattered more than once
constexpr std::size_t at_once = 64;  // pixels between two looks at the clock
constexpr qint64 told_every = 200;   // milliseconds

// The pixels of a level that no coarser one had.
std::vector<std::size_t> pixels_of_level(const Film& film, int step) {
  std::vector<std::size_t> pixels;
  for (int y = 0; y < film.height; y += step) {
    for (int x = 0; x < film.width; x += step) {
      const bool known = step < coarsest && x % (2 * step) == 0 && y % (2 * step) == 0;
      if (!known) {
        pixels.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                         static_cast<std::size_t>(x));
      }
    }
  }
  return pixels;
}

// Into the block right of and below a pixel, which finer levels fill with better.
void fill_block(ErrorMap& map, std::size_t pixel, int step, float error) {
  const auto width = static_cast<std::size_t>(map.film.width);
  const int x0 = static_cast<int>(pixel % width);
  const int y0 = static_cast<int>(pixel / width);
  for (int y = y0; y < std::min(y0 + step, map.film.height); ++y) {
    const auto row = map.error.begin() + static_cast<std::ptrdiff_t>(y) * map.film.width;
    std::fill(row + x0, row + std::min(x0 + step, map.film.width), error);
  }
}

// RGB rms difference of a pixel's airlight, what the noise of its reference adds subtracted.
double difference(const Frame& frame, std::size_t pixel, const PixelRadiance& truth) {
  const glm::dvec3 d = CenterLight::airlight(frame).at(pixel) - truth.radiance;
  return std::sqrt(std::max(glm::dot(d, d) - truth.variance, 0.0) / 3.0);
}

double rms(const std::vector<float>& values) {
  double square = 0.0;
  for (const float v : values) square += static_cast<double>(v) * static_cast<double>(v);
  return std::sqrt(square / static_cast<double>(std::max<std::size_t>(values.size(), 1)));
}

}  // namespace

ErrorMapper::ErrorMapper(QObject* parent) : QObject(parent) {
  connect(&job_, &BackgroundJob::failed, this, &ErrorMapper::failed);
}

void ErrorMapper::start(const std::shared_ptr<const RenderedFrame>& frame) {
  job_.start([this, frame](const Job& job) -> BackgroundJob::Apply {
    work(frame, job);
    return {};
  });
}

void ErrorMapper::work(const std::shared_ptr<const RenderedFrame>& rendered, const Job& job) {
  const Frame& frame = rendered->frame;
  const FrameRequest& request = rendered->request;
  const bool all_orders = frame.statistics.scattering.has_value();
  ErrorMap map{frame.film, std::vector<float>(frame.depth.size(), 0.0F), 0.0, all_orders};
  const double unit = rms(frame.center_airlight());
  const auto tell = [&] {
    job_.deliver(job, [this, rendered, copy = std::make_shared<const ErrorMap>(map)] {
      Q_EMIT grown(rendered, copy);
    });
  };
  ViewReference reference(*request.scene, request.camera, frame.film, tolerance,
                          all_orders ? Scattering::multiple : Scattering::single);
  const auto paths_of = [](std::size_t) { return paths; };
  QElapsedTimer clock;
  clock.start();
  std::size_t done = 0;
  for (int step = coarsest; step >= 1; step /= 2) {
    const std::vector<std::size_t> pixels = pixels_of_level(frame.film, step);
    for (std::size_t k = 0; k < pixels.size(); k += at_once) {
      const auto some = std::span(pixels).subspan(k, std::min(at_once, pixels.size() - k));
      if (!reference.evaluate(some, paths_of, job.stop)) return;
      for (const std::size_t pixel : some) {
        const double error =
            unit > 0.0 ? difference(frame, pixel, reference.airlight(pixel)) / unit : 0.0;
        fill_block(map, pixel, step, static_cast<float>(error));
      }
      reference.forget();
      done += some.size();
      map.done = static_cast<double>(done) / static_cast<double>(map.error.size());
      // The first level at once, or else there is hardly anything to see.
      if (step < coarsest && clock.elapsed() >= told_every) {
        tell();
        clock.restart();
      }
    }
  }
  tell();
}

}  // namespace brume
