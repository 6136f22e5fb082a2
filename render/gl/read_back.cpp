#include "render/gl/read_back.h"

#include <algorithm>
#include <limits>

namespace brume::gl {
namespace {

float depth_of(float distance) {
  return distance < 0.0f ? std::numeric_limits<float>::infinity() : distance;
}

// Where the copies of a film's textures begin, in floats: one after the other.
struct Places {
  explicit Places(std::size_t pixels)
      : beauty(4 * pixels), depth(8 * pixels), pairs(9 * pixels), end(10 * pixels) {}
  std::size_t airlight = 0;
  std::size_t beauty, depth, pairs, end;
};

}  // namespace

void read_depth(const FilmTextures& textures, Frame& frame) {
  const glm::ivec2& size = textures.depth.size();
  frame.depth.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  textures.depth.download(frame.depth);
  std::ranges::transform(frame.depth, frame.depth.begin(), depth_of);
}

void ReadBack::start(const FilmTextures& textures) {
  const glm::ivec2& size = textures.depth.size();
  const Places places(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  copies_.reserve(places.end * sizeof(float));
  textures.airlight.copy(copies_, places.airlight * sizeof(float));
  textures.beauty.copy(copies_, places.beauty * sizeof(float));
  textures.depth.copy(copies_, places.depth * sizeof(float));
  textures.pairs.copy(copies_, places.pairs * sizeof(float));
}

void ReadBack::finish(FrameContext& work, tbb::task_arena& arena) {
  Frame& frame = work.frame;
  const auto width = static_cast<std::size_t>(frame.film.width);
  const auto rows = static_cast<std::size_t>(frame.film.height);
  const Places places(rows * width);
  const std::span<const float> values = copies_.wait();
  std::vector<float>& pairs = frame.statistics.pixel_pairs;
  pairs.resize(rows * width);
  std::vector<double> sums(rows);
  const auto unpack_row = [&](std::size_t y) {
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      const std::span<const float> airlight = values.subspan(places.airlight + 4 * i, 4);
      for (std::size_t k = 0; k < 3; ++k) {
        frame.airlight[3 * i + k] = finite(airlight[k]);
        frame.transmittance[3 * i + k] = finite(airlight[3]);
      }
      for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
        frame.beauty[k] = finite(values[places.beauty + k]);
      }
      frame.depth[i] = depth_of(values[places.depth + i]);
      pairs[i] = values[places.pairs + i];
      sums[y] += static_cast<double>(pairs[i]);
    }
  };
  arena.execute([&] { Job().parallel_for(rows, unpack_row); });
  double sum = 0.0;
  for (const double row : sums) sum += row;
  frame.statistics.view_pairs += static_cast<std::uint64_t>(sum);
}

}  // namespace brume::gl
