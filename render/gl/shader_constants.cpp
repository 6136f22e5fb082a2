#include "render/gl/shader_constants.h"

#include <iomanip>
#include <limits>
#include <numbers>
#include <span>
#include <sstream>
#include <vector>

#include "core/math/spherical_harmonics.h"
#include "core/medium/noise.h"
#include "core/scene/measured_brdf.h"
#include "render/geometry/ray_range.h"
#include "render/geometry/tiles.h"
#include "render/gl/arithmetic_peak.h"
#include "render/lighting/environment_light.h"
#include "render/lighting/slice_boundaries.h"
#include "render/lighting/slice_kernels.h"
#include "render/lighting/source_grid.h"
#include "render/prepare/upsampling_limits.h"
#include "render/simd/coefficients.h"
#include "render/simd/reflection_kernels.h"
#include "render/simd/scatter_table.h"
#include "render/view_transform.h"
#include "render/visibility/triangle_bvh.h"

namespace brume::gl {
namespace {

class Constants {
 public:
  Constants() {
    out_ << std::scientific << std::setprecision(std::numeric_limits<float>::max_digits10 - 1);
  }
  void add(const char* name, float value) {
    out_ << "const float " << name << " = " << value << ";\n";
  }
  void add(const char* name, int value) { out_ << "const int " << name << " = " << value << ";\n"; }
  void add(const char* name, std::span<const float> values) {
    out_ << "const float " << name << "[" << values.size() << "] = float[](";
    for (std::size_t i = 0; i < values.size(); ++i) out_ << (i > 0 ? ", " : "") << values[i];
    out_ << ");\n";
  }
  [[nodiscard]] std::string text() const { return out_.str(); }

 private:
  std::ostringstream out_;
};

// Rows one after another.
std::vector<float> floats(std::span<const ShRecurrence::Row> rows) {
  std::vector<float> values;
  for (const ShRecurrence::Row& row : rows) {
    for (const double x : row) values.push_back(static_cast<float>(x));
  }
  return values;
}

}  // namespace

std::string shader_constants() {
  Constants constants;
  constants.add("erfcx_coefficients", coefficient::erfcx);
  constants.add("erf_small_coefficients", coefficient::erf_small);
  constants.add("erf_fast_coefficients", coefficient::erf_fast);
  constants.add("erf_fast_end", coefficient::erf_fast_end);
  constants.add("atan_small_coefficients", coefficient::atan_small);
  constants.add("exact_above", exact_above);
  constants.add("gauss_nodes", coefficient::gauss_nodes);
  constants.add("gauss_weights", coefficient::gauss_weights);
  constants.add("fog_nodes", coefficient::fog_rule.nodes);
  constants.add("fog_weights", coefficient::fog_rule.weights);
  constants.add("source_clusters", source_clusters);
  constants.add("sh_bands", sh_max_bands);
  constants.add("sh_count", sh_max_bands * sh_max_bands);
  const ShRecurrence recurrence;
  constants.add("sh_start", floats(std::span(&recurrence.start, 1)));
  constants.add("sh_up", floats(recurrence.up));
  constants.add("sh_down", floats(recurrence.down));
  constants.add("grid_functions", static_cast<int>(sh_size(grid_bands)));
  constants.add("cosine_factors", EnvironmentLight::cosine_factors());
  constants.add("theta_h_cells", MeasuredBrdf::theta_h_cells);
  constants.add("theta_d_cells", MeasuredBrdf::theta_d_cells);
  constants.add("phi_d_cells", MeasuredBrdf::phi_d_cells);
  constants.add("reflection_intervals", ReflectionTable::intervals);
  constants.add("reflection_row", static_cast<int>(ReflectionTable::row_size));
  constants.add("scatter_terms", ScatterTable::degree + 1);
  constants.add("scatter_opaque", ScatterTable::opaque);
  constants.add("scatter_scale", ScatterTable::scale);
  constants.add("bin_room", static_cast<float>(bin_room));
  constants.add("slice_opaque", static_cast<float>(slice_opaque));
  constants.add("opaque_fog_depth", static_cast<float>(opaque_fog_depth));
  constants.add("phase", static_cast<float>(0.25 * std::numbers::inv_pi));
  constants.add("noise_period", RayNoise::period);
  constants.add("tile_width", Tiles::width);
  constants.add("tile_height", Tiles::height);
  constants.add("group_size", Tiles::pixels);
  constants.add("chunk", slice_chunk);
  constants.add("max_bins", 4 * max_slices);
  constants.add("max_boundaries", static_cast<int>(max_slice_boundaries));
  constants.add("node_texture_width", node_texture_width);
  constants.add("max_curvature_of_surroundings", max_curvature_of_surroundings);
  constants.add("min_surface_share", min_surface_share);
  constants.add("radii_per_tolerance", radii_per_tolerance);
  constants.add("free_paths_per_tolerance", free_paths_per_tolerance);
  constants.add("max_levels", TriangleBvh::max_levels);
  constants.add("peak_slices", peak_slices);
  constants.add("highlight_start", highlight::start);
  constants.add("highlight_desaturation", highlight::desaturation);
  constants.add("highlight_offset", highlight::offset);
  constants.add("highlight_knee", highlight::knee);
  constants.add("highlight_slope", highlight::slope);
  constants.add("brightest_shown", brightest_shown);
  return constants.text();
}

}  // namespace brume::gl
