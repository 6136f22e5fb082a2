#include "render/deep/deep_file.h"

#include <chrono>
#include <tuple>

#include "core/io/disk/file_bytes.h"
#include "render/samples/brightness.h"

namespace brume {
namespace {

struct Stopped {};

}  // namespace

std::optional<DeepSettings> deep_settings(FrameRenderer& renderer, const Scene& scene,
                                          const Camera& camera, const Film& film,
                                          const Settings& settings, double error, const Job& job) {
  const std::optional<Brightness> brightness =
      settings.brightness ? settings.brightness
                          : find_brightness(renderer, scene, camera, film, settings, job);
  if (!brightness) return std::nullopt;
  Settings exact = settings;
  exact.merge_error = 0.0;  // its own error is bounded for each pixel
  return DeepSettings{exact, error, brightness->airlight_rms};
}

std::optional<DeepFileStatistics> write_deep_frame(const std::filesystem::path& file,
                                                   const Scene& scene, const Frame& frame,
                                                   const FrameInfo& info, const DeepSettings& deep,
                                                   const TransferStore& transfers, const Job& job) {
  const auto start = std::chrono::steady_clock::now();
  const auto& [film, camera] = std::tie(frame.film, frame.camera);
  const DeepExrHeader header{film.width, film.height, has_colored_alpha(scene),
                             frame_metadata(frame, info),
                             exr_view(camera, film, frame.frames_per_second)};
  DeepFileStatistics statistics;
  const auto produce = [&](const TakeDeepRows& take) {
    const auto made = render_deep(scene, camera, film, deep, transfers, take, job);
    if (!made) throw Stopped();
    statistics.image = *made;
  };
  try {
    write_deep_exr(file, header, produce);
  } catch (const Stopped&) {
    return std::nullopt;
  }
  statistics.bytes = regular_file_size(file);
  statistics.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return statistics;
}

}  // namespace brume
