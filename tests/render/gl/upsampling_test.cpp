// The upsampling of airlight: what is promised of it, on both backends. Both are given the same
// airlight per pixel in place of a method's.

#include "render/cpu/upsampling.h"
#include "core/scene/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <limits>

#include "render/cpu/film_airlight.h"
#include "render/gl/film_airlight.h"
#include "render/gl/shader_source.h"
#include "render/prepare/light_pixels.h"
#include "tests/random.h"
#include "tests/render/gl/gl_frames.h"

namespace brume::gl {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// Airlight and optical depth per pixel, and the distance to the surface.
struct Given {
  Film film{100, 61};
  int scale = 4;
  double tolerance = 0.01;
  std::vector<glm::vec4> values;
  std::vector<float> distances;
  std::vector<Light> lights;

  [[nodiscard]] std::size_t pixels() const { return values.size(); }
};

Given film_of(const std::function<glm::vec4(int x, int y)>& value,
              const std::function<float(int x, int y)>& distance) {
  Given given;
  for (int y = 0; y < given.film.height; ++y) {
    for (int x = 0; x < given.film.width; ++x) {
      given.values.push_back(value(x, y));
      given.distances.push_back(distance(x, y));
    }
  }
  return given;
}

float open(int /*x*/, int /*y*/) {
  return infinite;
}

// The result of a backend.
struct Upsampled {
  std::vector<glm::vec3> airlight;
  std::vector<float> transmittance;
  std::vector<float> evaluations;  // by the method, per pixel
  std::size_t exact = 0;           // pixels that it says it has evaluated
};

CameraRays rays_of(const Given& given) {
  return {Camera{}, given.film};
}

// Fog in all tiles: how far off a surface may be depends on its mean free path.
constexpr double b0 = 1.0;

MediumIndex medium_of() {
  Medium medium;
  medium.append({{0, 0, 0}, 5.0, 0.1});
  medium.set_homogeneous_density(b0);
  return {medium, 1e-6};
}

Settings settings_of(const Given& given) {
  Settings settings;
  settings.airlight_scale = given.scale;
  settings.upsampling_tolerance = given.tolerance;
  return settings;
}

Upsampled upsample_on_cpu(const Given& given) {
  const CameraRays rays = rays_of(given);
  const auto width = static_cast<std::size_t>(given.film.width);
  AirlightIntegrator method;
  method.evaluate = [&](std::span<const std::uint32_t>, const TileRays& tile,
                        const TileAirlight& out) {
    for (std::size_t k = 0; k < tile.directions.size(); ++k) {
      const glm::dvec3 at = rays.project(tile.eye + tile.directions[k]);
      const glm::vec4& value =
          given.values[static_cast<std::size_t>(at.y) * width + static_cast<std::size_t>(at.x)];
      out.airlight[k] = glm::vec3(value);
      out.depths[k] = static_cast<double>(value.w);
    }
    return tile.directions.size();
  };
  Frame frame;
  frame.film = given.film;
  frame.depth = given.distances;
  frame.airlight.assign(3 * given.pixels(), -1.0f);
  frame.transmittance.assign(3 * given.pixels(), -1.0f);
  frame.statistics.pixel_pairs.assign(given.pixels(), 0.0f);
  Scene scene;
  scene.lights = given.lights;
  const Settings settings = settings_of(given);
  const brume::FilmAirlight result =
      film_airlight(medium_of(), point_lights(scene), rays, {given.film, settings}, settings,
                    std::nullopt, method, {}, {}, frame);
  Upsampled upsampled;
  for (std::size_t i = 0; i < given.pixels(); ++i) {
    upsampled.airlight.emplace_back(frame.airlight[3 * i], frame.airlight[3 * i + 1],
                                    frame.airlight[3 * i + 2]);
    upsampled.transmittance.push_back(frame.transmittance[3 * i]);
  }
  upsampled.evaluations = frame.statistics.pixel_pairs;
  upsampled.exact = result.exact_pixels;
  return upsampled;
}

// In place of an airlight method: what is given for each pixel.
constexpr const char* given_airlight = R"(
#include "tile_list.glsl"
#include "film.glsl"

layout(std430, binding = 6) readonly buffer Given { vec4 given[]; };

void main() {
  const PixelOfGroup pixel = pixel_of_group();
  const vec4 value = given[pixel.position.y * film.x + pixel.position.x];
  store_pixel(pixel, value.rgb, value.w, 1u);
}
)";

// Objects of a context, which it must outlive.
struct DeviceState {
  Programs programs;
  Program method{"given airlight", complete_shader(given_airlight)};
  DeviceClock clock;
  MediumBuffers medium;
  TileLists lists;
  FilmTextures textures;
  FilmAirlight film;
  Buffer given;
};

Upsampled upsample_on_device(DeviceState& device, const Given& given) {
  const CameraRays rays = rays_of(given);
  const MediumIndex medium = medium_of();
  const Settings settings = settings_of(given);
  device.textures.reserve(given.film);
  std::vector<float> distances = given.distances;
  // Shaders know no infinity.
  for (float& t : distances) t = std::isfinite(t) ? t : -1.0f;
  device.textures.depth.upload(std::span<const float>(distances));
  device.textures.airlight.fill(-1.0f);
  device.medium.update(medium);
  device.lists.build(device.programs, device.medium, medium, rays, given.film, given.scale,
                     1 << 28);
  device.given.upload(std::span<const glm::vec4>(given.values));
  Scene scene;
  scene.lights = given.lights;
  scene.medium.set_homogeneous_density(b0);
  const RenderPlan plan(scene, given.film, settings);
  const FilmView view{given.film,
                      rays,
                      std::numeric_limits<double>::infinity(),
                      BatchFog(static_cast<float>(b0)),
                      plan,
                      std::nullopt};
  Upsampled upsampled;
  upsampled.exact = device.film.run(
      device.programs, device.clock, device.method,
      [&] { device.method.bind("Given", device.given); }, device.lists, view, device.textures);
  std::vector<float> airlight(4 * given.pixels());
  device.textures.airlight.download(std::span(airlight));
  for (std::size_t i = 0; i < given.pixels(); ++i) {
    upsampled.airlight.emplace_back(airlight[4 * i], airlight[4 * i + 1], airlight[4 * i + 2]);
    upsampled.transmittance.push_back(airlight[4 * i + 3]);
  }
  upsampled.evaluations.resize(given.pixels());
  device.textures.pairs.download(std::span(upsampled.evaluations));
  return upsampled;
}

float rms(const Given& given, const Upsampled& upsampled) {
  // Over the samples; those of a smooth film are like all pixels.
  double sum = 0.0;
  for (const glm::vec3& v : upsampled.airlight) sum += static_cast<double>(glm::dot(v, v));
  return static_cast<float>(std::sqrt(sum / (3.0 * static_cast<double>(given.pixels()))));
}

// A smooth film: waves of at least `length` pixels.
std::function<glm::vec4(int, int)> waves(unsigned seed, double length) {
  Random random(seed);
  std::vector<glm::dvec4> directions;
  for (int i = 0; i < 12; ++i) {
    const double angle = random.uniform(0.0, 6.28);
    const double frequency = 6.28 / (length * random.uniform(1.0, 3.0));
    directions.emplace_back(frequency * std::cos(angle), frequency * std::sin(angle),
                            random.uniform(0.0, 6.28), random.uniform(0.05, 0.2));
  }
  return [directions](int x, int y) {
    glm::vec4 value(1.0f, 0.8f, 0.6f, 0.7f);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const glm::dvec4& d = directions[i];
      const double wave = d.w * std::sin(d.x * x + d.y * y + d.z);
      value[static_cast<int>(i % 4)] += static_cast<float>(wave);
    }
    return value;
  };
}

// Nothing but noise: nothing can be interpolated.
std::function<glm::vec4(int, int)> noise(unsigned seed) {
  return [random = std::make_shared<Random>(seed)](int, int) {
    const glm::dvec3 color = random->point(0.5) + 0.5;
    return glm::vec4(glm::vec3(color), static_cast<float>(random->uniform(0.0, 3.0)));
  };
}

// Balls before the background and before each other, with edges in any place.
std::function<float(int, int)> balls(unsigned seed) {
  Random random(seed);
  std::vector<glm::dvec4> places;
  for (int i = 0; i < 12; ++i) {
    places.emplace_back(random.uniform(0, 100), random.uniform(0, 61), random.uniform(1, 18),
                        random.uniform(2, 9));
  }
  return [places](int x, int y) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::dvec4& p : places) {
      const double square = p.z * p.z - (x - p.x) * (x - p.x) - (y - p.y) * (y - p.y);
      if (square >= 0.0) nearest = std::min(nearest, p.w - 0.03 * std::sqrt(square));
    }
    return static_cast<float>(nearest);
  };
}

class Upsampling : public BothBackends<DeviceState>,
                   public testing::WithParamInterface<std::tuple<TestedBackend, int /*scale*/>> {
 protected:
  Upsampled upsample(Given given) {
    given.scale = scale();
    return std::get<0>(GetParam()) == TestedBackend::cpu ? upsample_on_cpu(given)
                                                         : upsample_on_device(device(), given);
  }
  [[nodiscard]] static int scale() { return std::get<1>(GetParam()); }
};

TEST_P(Upsampling, PreservesAConstant) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const glm::vec4 value(0.3f, 2.0f, 1e-3f, 0.5f);
    const Given given = film_of([&](int, int) { return value; }, balls(seed));
    const Upsampled upsampled = upsample(given);
    for (std::size_t i = 0; i < given.pixels(); ++i) {
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(upsampled.airlight[i][c], value[c], 1e-6f * value[c]);
      ASSERT_NEAR(upsampled.transmittance[i], std::exp(-0.5f), 1e-6f);
    }
  }
}

// No pixel of a plane need be evaluated: on the background, or on a wall that faces the eye.
TEST_P(Upsampling, PreservesALinearFilm) {
  for (const float distance : {infinite, 4.0f}) {
    const Given given = film_of(
        [](int x, int y) {
          const auto u = static_cast<float>(x);
          const auto v = static_cast<float>(y);
          const float transmittance = 0.2f + 0.003f * u + 0.002f * v;
          return glm::vec4(1.0f + 0.01f * u, 0.5f + 0.02f * v, 3.0f - 0.01f * u - 0.01f * v,
                           -std::log(transmittance));
        },
        [&](int, int) { return distance; });
    const Upsampled upsampled = upsample(given);
    const Film& film = given.film;
    EXPECT_EQ(upsampled.exact,
              static_cast<std::size_t>(((film.width + scale() - 2) / scale() + 1) *
                                       ((film.height + scale() - 2) / scale() + 1)));
    for (std::size_t i = 0; i < given.pixels(); ++i) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(upsampled.airlight[i][c], given.values[i][c], 3e-6f) << i;
      }
      ASSERT_NEAR(upsampled.transmittance[i], std::exp(-given.values[i].w), 3e-6f) << i;
    }
  }
}

// Where there are no edges, pixels are mixed from those of their cell that were evaluated: none of
// more or less.
TEST_P(Upsampling, StaysWithinItsNeighbours) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Given given = film_of(waves(seed, 25.0), open);
    const Upsampled upsampled = upsample(given);
    for (int y = 0; y < given.film.height; ++y) {
      for (int x = 0; x < given.film.width; ++x) {
        const auto i = static_cast<std::size_t>(y * given.film.width + x);
        if (upsampled.evaluations[i] > 0.0f) continue;
        glm::vec3 low(infinite);
        glm::vec3 high(-infinite);
        const glm::ivec2 first(x / scale() * scale(), y / scale() * scale());
        for (int row = first.y; row <= std::min(first.y + scale(), given.film.height - 1); ++row) {
          for (int column = first.x; column <= std::min(first.x + scale(), given.film.width - 1);
               ++column) {
            const auto at = static_cast<std::size_t>(row * given.film.width + column);
            if (upsampled.evaluations[at] == 0.0f) continue;
            low = glm::min(low, glm::vec3(given.values[at]));
            high = glm::max(high, glm::vec3(given.values[at]));
          }
        }
        for (int c = 0; c < 3; ++c) {
          ASSERT_GE(upsampled.airlight[i][c], low[c] - 1e-6f) << x << ' ' << y;
          ASSERT_LE(upsampled.airlight[i][c], high[c] + 1e-6f) << x << ' ' << y;
        }
      }
    }
  }
}

// Airlight that grows with the distance: of another surface, it would be wrong by the distance
// between the two, at least a third; a pixel may stand off its surface by the depth that does not
// matter.
TEST_P(Upsampling, DoesNotBleedOverEdges) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto distance = balls(seed);
    const auto wall = [&](int x, int y) {
      const float t = distance(x, y);
      return std::isfinite(t) ? std::pow(1.3f, std::floor(t)) : t;
    };
    const Given given = film_of(
        [&](int x, int y) {
          const float t = wall(x, y);
          return std::isfinite(t) ? glm::vec4(t, 1.0f, 15.0f - t, -std::log(1.0f - 0.05f * t))
                                  : glm::vec4(20.0f, 0.0f, 0.5f, 4.0f);
        },
        wall);
    const auto room =
        static_cast<float>(double{free_paths_per_tolerance} * given.tolerance / b0) + 1e-5f;
    const Upsampled upsampled = upsample(given);
    for (std::size_t i = 0; i < given.pixels(); ++i) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(upsampled.airlight[i][c], given.values[i][c], room) << i;
      }
      ASSERT_NEAR(upsampled.transmittance[i], std::exp(-given.values[i].w), 0.05f * room) << i;
    }
  }
}

// A pixel is either evaluated once, and then is what was given, or interpolated; as many are
// evaluated as reported; no pixel is left out.
TEST_P(Upsampling, EvaluatesEachRequestedPixelOnce) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    for (const bool is_smooth : {false, true}) {
      const Given given = film_of(is_smooth ? waves(seed, 12.0) : noise(seed), balls(seed));
      const Upsampled upsampled = upsample(given);
      std::size_t exact = 0;
      for (std::size_t i = 0; i < given.pixels(); ++i) {
        ASSERT_GE(upsampled.transmittance[i], 0.0f) << i;
        if (upsampled.evaluations[i] == 0.0f) continue;
        ++exact;
        ASSERT_EQ(upsampled.evaluations[i], 1.0f) << i;
        // The CPU mixes samples of the last row and column from themselves, with a weight of 1.
        for (int c = 0; c < 3; ++c) {
          ASSERT_NEAR(upsampled.airlight[i][c], given.values[i][c], 3e-7f) << i;
        }
        ASSERT_NEAR(upsampled.transmittance[i], std::exp(-given.values[i].w), 1e-6f) << i;
      }
      EXPECT_EQ(exact, upsampled.exact);
      if (is_smooth) {
        EXPECT_LT(exact, given.pixels());
      } else {
        // A cell of noise here and there looks smooth.
        EXPECT_GT(exact, 0.99 * static_cast<double>(given.pixels()));
      }
    }
  }
}

// The estimate is of one axis and at the samples: with both axes, and a curvature that changes from
// a sample to the next, interpolated pixels are wrong by up to 2.5 times the tolerance; in the mean
// by less than it.
TEST_P(Upsampling, MeetsTheTolerance) {
  double square = 0.0;
  std::size_t interpolated = 0;
  std::size_t evaluated = 0;
  for (const double length : {8.0, 12.0, 20.0}) {
    for (const double tolerance : {0.03, 0.01, 0.003}) {
      for (unsigned seed = 1; seed <= 3; ++seed) {
        Given given = film_of(waves(seed, length * scale()), open);
        given.tolerance = tolerance;
        const Upsampled upsampled = upsample(given);
        const double unit = static_cast<double>(rms(given, upsampled)) * tolerance;
        for (std::size_t i = 0; i < given.pixels(); ++i) {
          if (upsampled.evaluations[i] > 0.0f) {
            ++evaluated;
            continue;
          }
          ++interpolated;
          for (int c = 0; c < 3; ++c) {
            const double error =
                static_cast<double>(std::abs(upsampled.airlight[i][c] - given.values[i][c])) / unit;
            ASSERT_LT(error, 2.5) << i;
            square += error * error / 3.0;
          }
          ASSERT_LT(std::abs(upsampled.transmittance[i] - std::exp(-given.values[i].w)),
                    2.5 * tolerance);
        }
      }
    }
  }
  // Enough of both, or nothing is tested.
  EXPECT_GT(interpolated, evaluated / 4);
  // With halved cells a sixth: enough to see that it is not all.
  EXPECT_GT(evaluated, interpolated / 8);
  EXPECT_LT(std::sqrt(square / static_cast<double>(interpolated)), 1.0);
}

TEST_P(Upsampling, EvaluatesPixelsNearLights) {
  Given given = film_of(waves(1, 60.0), open);
  given.tolerance = 1.0;  // nothing else is worth it
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    Light light;
    light.position = random.point(2.0);
    given.lights.push_back(light);
  }
  const Upsampled upsampled = upsample(given);
  Scene scene;
  scene.lights = given.lights;
  const auto pixels = light_pixels(point_lights(scene), rays_of(given), given.film, light_block);
  ASSERT_GT(pixels.size(), 100U);
  for (const glm::ivec2& pixel : pixels) {
    EXPECT_EQ(upsampled.evaluations[static_cast<std::size_t>(pixel.y * given.film.width + pixel.x)],
              1.0f)
        << pixel.x << ' ' << pixel.y;
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, Upsampling,
                         testing::Combine(testing::Values(TestedBackend::cpu,
                                                          TestedBackend::device),
                                          testing::Values(2, 4)),
                         [](const auto& it) {
                           const bool is_on_cpu = std::get<0>(it.param) == TestedBackend::cpu;
                           return (is_on_cpu ? "Cpu" : "Device") +
                                  std::to_string(std::get<1>(it.param));
                         });

}  // namespace
}  // namespace brume::gl
