#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "brume/limits.h"
#include "brume/methods.h"

namespace brume {

struct Scene;

// Resolution of the optical depth table of a light.
struct OpticalDepthTableSize {
  int directions = 128;  // cells of the direction map = directions^2
  int radii = 64;

  bool operator==(const OpticalDepthTableSize&) const = default;
};

// Shadow maps have at most so many cells along a side.
inline constexpr int max_shadow_cells = 1024;

// Resolution of the grid of environment light in the medium; see SourceGrid.
struct SourceGridSize {
  int nodes = 80'000;   // maximum, > 8
  int directions = 96;  // maximum

  bool operator==(const SourceGridSize&) const = default;
};

// Where the iteration for light scattered more than once ends; see solve_scattering().
struct ScatteringLimits {
  // The degree of the quadrature rules of the sweeps' directions: of all; of the first if a point
  // light is inside the medium, or surfaces are, which radiate along them.
  int degree = 9;
  int light_degree = 19;
  double tolerance = 1e-3;  // of Convergence::residual
  int sweeps = 40;          // maximum

  bool operator==(const ScatteringLimits&) const = default;
};

// Deviations of `paper` from the publication.
struct PaperOptions {
  // Evaluates light at the Gaussian's mean on the ray instead of the projection of its center:
  // right where a surface or the eye cuts it.
  bool at_mean = false;
  // Scales the airlight of the Gaussians on a ray to the absorbed fraction 1 - exp(-T(v, p)); not
  // where eye or light are inside a dense Gaussian.
  bool conserve_energy = false;

  bool operator==(const PaperOptions&) const = default;
};

// How bright a picture is all in all, over RGB: what errors of its parts are relative to.
struct Brightness {
  double airlight_rms = 0.0;
  double mean = 0.0;  // of the picture's radiance
  double rms = 0.0;   // the same

  bool operator==(const Brightness&) const = default;
};

// Parameters of rendering; the content is in Scene.
struct Settings {
  // A FrameRenderer measures nothing: it renders `auto_` as `sliced`, with what is given below.
  AirlightMethod airlight = AirlightMethod::auto_;
  // `auto_`: maximum relative RMSE of the airlight.
  double max_error = 0.02;

  // Samples of pixels that are not the same all over; 1: all pixels are what their centers see. See
  // render/samples. `path` and OpenGL sample all pixels as often.
  int samples = 1;

  // Worker threads; 0: all.
  int threads = 0;

  // Airlight is sampled at 1 / airlight_scale of the film's width and height: 1, 2 or 4; see
  // film_airlight().
  int airlight_scale = 1;
  double upsampling_tolerance = 0.01;

  // The brightness of the whole picture, see with_brightness(): all its regions are rendered alike.
  // Absent: that of what is rendered.
  std::optional<Brightness> brightness{};

  PaperOptions paper{};

  // `sliced`: slices per ray, and the optical depth tables of lights.
  int slices = 24;
  OpticalDepthTableSize optical_depth_table{};
  // `sliced`: cells of a light's shadow map = shadow_cells^2, or for far lights in a room more.
  int shadow_cells = 384;
  // `sliced`: environment light in the medium, and all that is scattered more than once.
  SourceGridSize source_grid{};
  // Frame::background is filled: for layers.
  bool background_apart = false;
  // `sliced`: light scattered and reflected more than once; the other methods are single.
  Scattering scattering = Scattering::single;
  ScatteringLimits scattering_limits{};

  // Uses the paper's single point spread function for light scattered onto surfaces and environment
  // inscattering, instead of one per optical depth.
  bool paper_spread = false;

  // `sliced`: smooth surfaces mirror what is around them, but in motion.
  bool mirrors = true;
  // `sliced` and `path`: what is seen sends nothing but what it mirrors, and nothing is seen behind
  // the fog: for layers. Lights that highlights show are not mirrored.
  bool mirrored_alone = false;

  // Maximum error of a ray's optical depth from culling far Gaussians; the reference has its own.
  double depth_error = 1e-3;

  // `sliced`: many small Gaussians that overlap are merged into fewer, up to this relative error of
  // optical depth; see merged_medium(). 0: never.
  double merge_error = 0.0;
  // The greatest share of them left with which merging makes up for its time.
  double merge_share = 0.8;

  // `path`: paths per pixel, 1 to max_paths. A frame that differs from the last in nothing but more
  // of them goes on where that stopped.
  int paths = 64;
  // `path`: of its random numbers.
  std::uint64_t path_seed = 0;

  // `reference`: relative tolerance of each ray's quadrature.
  double reference_tolerance = 1e-4;

  // `paper`: SIMD in single precision, or the scalar double path that tests compare with.
  enum class Precision { simd_float, plain_double };
  Precision precision = Precision::simd_float;

  bool operator==(const Settings&) const = default;
};

inline constexpr int max_paths = limits::paths;

// Samples a pixel where nothing else is asked for: more than one if there are surfaces or lights
// that are seen, whose edges need them.
inline constexpr int edge_samples = 16;
int chosen_samples(const Scene& scene);

// The method as on the command line, with its parameter: "sliced:24", "path:64", "paper+mean".
std::string airlight_name(const Settings& settings);

// Reduces the resolution of light tables and shadow maps so that all lights together fit
// max_light_map_bytes, down to a minimum.
inline constexpr std::size_t max_light_map_bytes = std::size_t{1} << 30;
Settings limit_light_map_memory(Settings settings, std::size_t lights, bool shadows);

// The settings that a FrameRenderer renders: `auto_` becomes `sliced`.
Settings without_auto(Settings settings);

// `sliced` with a number of slices and balanced table sizes and tolerances.
Settings sliced_settings(Settings settings, int slices);

}  // namespace brume
