#include "core/scene/lights/beam_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <glm/trigonometric.hpp>
#include <mutex>

#include "core/math/max_component.h"
#include "core/scene/lights/photometric_profile.h"
#include "core/scene/materials/texture.h"

namespace brume {
namespace {

constexpr int map_side = 513;
constexpr std::size_t texel_count = std::size_t{map_side} * map_side;

using Channel = std::vector<float>;

// From -1 to 1.
double coordinate(int i) {
  return 2.0 * i / (map_side - 1) - 1.0;
}

// Means over 2 * reach + 1 values of `count` in steps of `stride`, 0 beyond the ends.
void blur_row(float* values, std::size_t stride, int reach) {
  std::array<float, map_side> before{};
  for (int i = 0; i < map_side; ++i) before[static_cast<std::size_t>(i)] = values[stride * i];
  double sum = 0.0;
  const auto value = [&](int i) {
    return i < 0 || i >= map_side ? 0.0 : static_cast<double>(before[static_cast<std::size_t>(i)]);
  };
  for (int i = 0; i < reach; ++i) sum += value(i);
  for (int i = 0; i < map_side; ++i) {
    sum += value(i + reach) - value(i - reach - 1);
    values[stride * i] = static_cast<float>(std::max(sum, 0.0) / (2 * reach + 1));
  }
}

void blur(Channel& channel, double focus) {
  constexpr int times = 3;
  const auto reach = static_cast<int>(std::lround((1.0 - focus) * 0.5 * (map_side - 1) / times));
  if (reach == 0) return;
  for (int time = 0; time < times; ++time) {
    for (int i = 0; i < map_side; ++i) {
      blur_row(channel.data() + static_cast<std::ptrdiff_t>(map_side) * i, 1, reach);
      blur_row(channel.data() + i, map_side, reach);
    }
  }
}

// What the profile of a spot lets through of a place in the square.
class ProfileShare {
 public:
  explicit ProfileShare(const light::Spot& spot)
      : profile_(spot.profile.content.get()),
        tangent_(beam_tangent(spot)),
        turn_(glm::radians(spot.profile.rotation - spot.texture.rotation)) {}

  [[nodiscard]] double at(double x, double y) const {
    if (!profile_) return 1.0;
    const double cosine = std::cos(turn_);
    const double sine = std::sin(turn_);
    return profile_->at(
        {tangent_ * (cosine * x + sine * y), tangent_ * (cosine * y - sine * x), 1.0});
  }

 private:
  const PhotometricProfile* profile_;
  double tangent_, turn_;
};

std::vector<BeamPattern> make_patterns(const light::Spot& spot) {
  std::array<Channel, 3> channels;
  for (Channel& channel : channels) channel.resize(texel_count);
  const ProfileShare share(spot);
  const Texture& picture = *spot.texture.content;
  bool is_gray = true;
  for (int row = 0; row < map_side; ++row) {
    for (int column = 0; column < map_side; ++column) {
      const double x = coordinate(column);
      const double y = coordinate(row);
      const glm::dvec3 color(picture.lookup({0.5 * (x + 1.0), 0.5 * (y + 1.0)},
                                            1.0 / (map_side - 1), TextureWrap::clamp,
                                            TextureWrap::clamp));
      constexpr double alike = 2.0 / 255.0;
      is_gray = is_gray && max_component(glm::abs(color - glm::dvec3(color.g))) <=
                               alike * max_component(color);
      const std::size_t texel =
          static_cast<std::size_t>(row) * map_side + static_cast<unsigned>(column);
      for (int c = 0; c < 3; ++c) {
        channels[static_cast<std::size_t>(c)][texel] =
            static_cast<float>(share.at(x, y) * color[c]);
      }
    }
  }
  std::vector<BeamPattern> patterns;
  for (int c = 0; c < 3; ++c) {
    if (is_gray && c != 1) continue;
    Channel& channel = channels[static_cast<std::size_t>(c)];
    blur(channel, spot.texture.focus);
    const float brightest = std::ranges::max(channel);
    if (!(brightest > 0.0f)) continue;
    for (float& value : channel) value /= brightest;
    BeamPattern& pattern = patterns.emplace_back();
    pattern.factor = glm::dvec3(is_gray ? static_cast<double>(brightest) : 0.0);
    pattern.factor[c] = static_cast<double>(brightest);
    pattern.map =
        std::make_shared<const IntensityMap>(IntensityMap{map_side, std::move(channel), true});
  }
  return patterns;
}

// What patterns depend on.
struct Made {
  std::weak_ptr<const Texture> picture;
  std::weak_ptr<const PhotometricProfile> profile;
  double focus, outer_angle, turn;  // the last two 0 without a profile
  std::vector<BeamPattern> patterns;
};

}  // namespace

double beam_tangent(const light::Spot& spot) {
  constexpr double greatest = 89.9;  // [degrees]
  return std::tan(glm::radians(std::clamp(spot.outer_angle, 1e-6, greatest)));
}

std::vector<BeamPattern> beam_patterns(const light::Spot& spot) {
  static std::mutex mutex;
  static std::deque<Made> kept;  // the last used one first
  constexpr std::size_t max_kept = 256;
  const bool has_profile = spot.profile.content != nullptr;
  Made wanted{spot.texture.content,
              spot.profile.content,
              spot.texture.focus,
              has_profile ? spot.outer_angle : 0.0,
              has_profile ? spot.profile.rotation - spot.texture.rotation : 0.0,
              {}};
  const std::scoped_lock lock(mutex);
  std::erase_if(kept, [](const Made& made) { return made.picture.expired(); });
  const auto known = std::ranges::find_if(kept, [&](const Made& made) {
    return made.picture.lock() == spot.texture.content &&
           made.profile.lock() == spot.profile.content && made.focus == wanted.focus &&
           made.outer_angle == wanted.outer_angle && made.turn == wanted.turn;
  });
  if (known != kept.end()) {
    std::rotate(kept.begin(), known, known + 1);
    return kept.front().patterns;
  }
  wanted.patterns = make_patterns(spot);
  if (kept.size() == max_kept) kept.pop_back();
  kept.push_front(std::move(wanted));
  return kept.front().patterns;
}

}  // namespace brume
