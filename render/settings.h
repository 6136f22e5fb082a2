#pragma once

#include <cstddef>
#include <string>

namespace brume {

enum class AirlightMethod {
  paper,      // the paper's approximation, as published
  sliced,     // exact optical depths per slice of the ray, light from a table
  march,      // the midpoint rule with exact optical depths: what the others are measured against
  reference,  // the integral itself, converged
};

// How fine the table of a light's optical depths is.
struct LightTableSize {
  int directions = 128;  // its square is the number of cells of the map of directions
  int radii = 64;

  bool operator==(const LightTableSize&) const = default;
};

// How fine the grid of an environment's light in the medium is; see SourceGrid.
struct SourceGridSize {
  int nodes = 80'000;   // at most, > 8
  int directions = 96;  // that light comes from, at most

  bool operator==(const SourceGridSize&) const = default;
};

// Departures of `paper` from what was published.
struct PaperOptions {
  // The light of a Gaussian is taken at its mean on the ray, not at the projection of its centre:
  // right where a surface or the eye cuts it.
  bool at_mean = false;
  // The airlight of the Gaussians on a ray is scaled so that they scatter as much as they take
  // away, 1 - exp(-T(v, p)); not where the eye or the light stands in a dense Gaussian.
  bool conserve_energy = false;

  bool operator==(const PaperOptions&) const = default;
};

// How a frame is rendered; what is rendered is the Scene's.
struct Settings {
  AirlightMethod airlight = AirlightMethod::paper;

  // The time that is shown [s]: noise goes with the wind.
  double time = 0.0;

  // Worker threads; 0 takes all.
  int threads = 0;

  // Airlight at 1 / airlight_scale of the film's width and height: 1, 2 or 4; see film_airlight().
  int airlight_scale = 1;
  double upsampling_tolerance = 0.01;

  PaperOptions paper;

  // `sliced`: slices per ray, and how fine the table of each light is.
  int slices = 24;
  LightTableSize light_table;
  // `sliced`: its square is the number of cells of the map of surfaces around a light.
  int shadow_cells = 384;
  // `sliced` and `march`: the light of an environment in the medium.
  SourceGridSize source_grid;

  // Light that the medium scatters onto surfaces, and the glow of an environment: by the paper's
  // one point spread function for all lights and depths, not by that of each.
  bool paper_spread = false;

  // How far the optical depth of a ray may be off because Gaussians far from it are left out; the
  // reference has its own.
  double depth_error = 1e-3;

  // `march`: steps per ray through the medium, >= 1.
  int march_steps = 64;

  // `reference`: the relative tolerance of each ray's quadrature.
  double reference_tolerance = 1e-4;

  // `paper`: SIMD in float, or the plain double path that the tests hold it against.
  enum class Arithmetic { simd_float, plain_double };
  Arithmetic arithmetic = Arithmetic::simd_float;

  // Where few Gaussians have changed since the frame before, only the parts of the lights' tables
  // that they are seen in are made again. Faster while one edits, but a pixel then depends on the
  // edits before it, by the steps in which tables store optical depths. Not for frames that are
  // kept.
  bool patch_light_tables = false;

  bool operator==(const Settings&) const = default;
};

const char* to_string(AirlightMethod method);

// The method as the command line takes it, with the number that belongs to it: "march:64".
std::string airlight_name(const Settings& settings);

// The same with the tables and shadow maps of lights as fine as fit into memory where there are so
// many: all of them take at most max_light_map_bytes, or are as small as `sliced` ever has them.
inline constexpr std::size_t max_light_map_bytes = std::size_t{1} << 30;
Settings with_fitting_light_maps(Settings settings, std::size_t lights, bool shadows);

// `sliced` with a number of slices, and tables and tolerances that go with it, so that no error
// dominates.
Settings sliced_settings(Settings settings, int slices);

}  // namespace brume
