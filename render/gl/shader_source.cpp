#include "render/gl/shader_source.h"

#include <algorithm>
#include <bit>
#include <iomanip>
#include <limits>
#include <set>
#include <span>
#include <sstream>
#include <vector>

#include "brume/frame.h"
#include "core/math/spherical_harmonics.h"
#include "core/math/srgb.h"
#include "core/scene/camera_rays.h"
#include "core/scene/materials/brdf.h"
#include "core/scene/materials/ggx.h"
#include "core/scene/materials/ggx_sh.h"
#include "core/scene/materials/measured_brdf.h"
#include "core/scene/materials/texture.h"
#include "core/scene/ray_noise.h"
#include "render/display/dither.h"
#include "render/display/neutral_view.h"
#include "render/geometry/direction_map.h"
#include "render/geometry/edge_on.h"
#include "render/geometry/ray_range.h"
#include "render/geometry/tiles.h"
#include "render/gl/resources.h"
#include "render/gl/shader_structs.h"
#include "render/gl/surface_stage.h"
#include "render/optical_depth/increment_kernels.h"
#include "render/prepare/upsampling_limits.h"
#include "render/scattering/source_grid.h"
#include "render/simd/coefficients.h"
#include "render/simd/reflection_kernels.h"
#include "render/simd/scatter_table.h"
#include "render/slices/lobe_broadening.h"
#include "render/slices/slice_boundaries.h"
#include "render/slices/slice_kernels.h"
#include "render/visibility/surface_point.h"
#include "render/visibility/triangle_bvh.h"

namespace brume::gl {
namespace {

// The coefficients of one band as `before` names them, times the elements of a quarter turn, as
// `after` names them.
void write_quarter_turn(int band, bool is_inverse, char before, char after, std::ostream& out) {
  const auto first = sh_index(band, -band);
  const auto end = sh_index(band, band) + 1;
  for (std::size_t i = first; i < end; ++i) {
    out << "  vec3 " << after << i - first << " = vec3(0.0)";
    for (const ShElement& e : sh_quarter_turn()) {
      if ((is_inverse ? e.from : e.to) != i) continue;
      out << " + " << e.value << " * " << before << (is_inverse ? e.to : e.from) - first;
    }
    out << ";\n";
  }
}

void write_turn(int band, const char* angle, char name, std::ostream& out) {
  for (int m = 1; m <= band; ++m) {
    out << "  turn_back(" << angle << m << ", " << name << band + m << ", " << name << band - m
        << ");\n";
  }
}

void write_band(int band, std::ostream& out) {
  out << "vec3 reflected_band_" << band << "() {\n";
  for (int m = -band; m <= band; ++m) {
    out << "  vec3 a" << band + m << " = light_around(" << band << ", " << sh_index(band, m)
        << ");\n";
  }
  write_turn(band, "azimuth_", 'a', out);
  write_quarter_turn(band, false, 'a', 'b', out);
  write_turn(band, "polar_", 'b', out);
  write_quarter_turn(band, true, 'b', 'c', out);
  write_turn(band, "eye_", 'c', out);
  out << "  return vec3(0.0)";
  for (int m = 0; m <= band; ++m) {
    out << " + reflectance(" << band * (band + 1) / 2 + m << ") * c" << band + m;
  }
  out << ";\n}\n";
}

// The text of sh_turns.glsl, for reflection.glsl: reflected_light(), the sum over bands of the
// light from around (light_around()), turned into a SurfaceFrame by three angles about z and two
// quarter turns about x, times reflectance(). Every coefficient is a variable of its own.
std::string sh_turns() {
  std::ostringstream out;
  out << std::scientific << std::setprecision(std::numeric_limits<float>::max_digits10 - 1);
  for (const char* angle : {"azimuth_", "polar_", "eye_"}) {
    for (int m = 1; m < sh_max_bands; ++m) out << "vec2 " << angle << m << " = vec2(1.0, 0.0);\n";
  }
  for (int band = 0; band < sh_max_bands; ++band) write_band(band, out);
  out << "vec3 reflected_light(SurfaceFrame frame) {\n";
  for (const char* angle : {"azimuth", "polar", "eye"}) {
    out << "  " << angle << "_1 = frame." << angle << ";\n";
    for (int m = 2; m < sh_max_bands; ++m) {
      out << "  " << angle << '_' << m << " = turned_further(" << angle << '_' << m - 1
          << ", frame." << angle << ");\n";
    }
  }
  out << "  return vec3(0.0)";
  for (int band = 0; band < sh_max_bands; ++band) out << " + reflected_band_" << band << "()";
  out << ";\n}\n";
  return out.str();
}

void append_text(const std::string& text, std::set<std::string>& seen, std::ostream& out);

void append(const std::string& name, std::set<std::string>& seen, std::ostream& out) {
  if (!seen.insert(name).second) return;
  if (name == "constants.glsl") {
    append_text(shader_constants(), seen, out);
    return;
  }
  if (name == "structs.glsl") {
    out << shader_structs();
    return;
  }
  if (name == "sh_turns.glsl") {
    out << sh_turns();
    return;
  }
  const char* text = embedded_shader(name);
  if (!text) throw Error("there is no shader " + name);
  append_text(text, seen, out);
}

void append_text(const std::string& text, std::set<std::string>& seen, std::ostream& out) {
  constexpr std::string_view include = "#include \"";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(include)) {
      append(line.substr(include.size(), line.rfind('"') - include.size()), seen, out);
    } else {
      out << line << '\n';
    }
  }
}

}  // namespace

std::string shader_source(const std::string& name) {
  std::istringstream words(name);
  std::string file;
  words >> file;
  std::string text;
  for (std::string defined; words >> defined;) text += "#define " + defined + "\n";
  return complete_shader(text + "#include \"" + file + "\"\n");
}

std::string complete_shader(const std::string& text) {
  std::ostringstream out;
  out << "#version 450 core\n";
  std::set<std::string> seen;
  append_text(text, seen, out);
  return out.str();
}

namespace {

class Constants {
 public:
  Constants() {
    out_ << "#define CONSTANT const float\n#include \"constants.inl\"\n" << std::scientific;
  }
  void add(const char* name, float value) { add(name, "float", value, ""); }
  void add(const char* name, int value) { add(name, "int", value, ""); }
  void add(const char* name, unsigned value) { add(name, "uint", value, "u"); }
  // Single precision, unless add_double().
  void add(const char* name, double value) { add(name, static_cast<float>(value)); }
  void add_double(const char* name, double value) { add(name, "double", value, "LF"); }
  void add(const char* name, std::span<const float> values) { add(name, "float", values, ""); }
  void add(const char* name, std::span<const int> values) { add(name, "int", values, ""); }
  void add(const char* name, std::span<const unsigned> values) { add(name, "uint", values, "u"); }
  // The names are the C++ ones, one after a comma; `a::b` is a_b in shaders.
  template <class... T>
  void add_all(std::string_view names, const T&... values) {
    const auto next_name = [&names] {
      std::string name(names.substr(0, names.find(',')));
      names.remove_prefix(std::min(names.size(), name.size() + 2));
      if (const std::size_t colons = name.find("::"); colons != name.npos) {
        name.erase(colons, 1);
        name[colons] = '_';
      }
      return name;
    };
    (add(next_name().c_str(), values), ...);
  }
  [[nodiscard]] std::string text() const { return out_.str(); }

 private:
  template <class T>
  void add(const char* name, const char* type, T value, const char* suffix) {
    set_precision<T>();
    out_ << "const " << type << " " << name << " = " << value << suffix << ";\n";
  }
  template <class T>
  void add(const char* name, const char* type, std::span<const T> values, const char* suffix) {
    set_precision<T>();
    out_ << "const " << type << " " << name << "[" << values.size() << "] = " << type << "[](";
    for (std::size_t i = 0; i < values.size(); ++i) {
      out_ << (i > 0 ? ", " : "") << values[i] << suffix;
    }
    out_ << ");\n";
  }
  // Digits that tell all values apart.
  template <class T>
  void set_precision() {
    out_ << std::setprecision(std::max(std::numeric_limits<T>::max_digits10 - 1, 0));
  }

  std::ostringstream out_;
};

// Constants that shaders call as C++ does.
#define NAMED(...) #__VA_ARGS__, __VA_ARGS__

// Rows one after another.
std::vector<float> floats(std::span<const ShRecurrence::Row> rows) {
  std::vector<float> values;
  for (const ShRecurrence::Row& row : rows) {
    for (const double x : row) values.push_back(static_cast<float>(x));
  }
  return values;
}

// Constants of the kernels of render/simd and render/slices.
void add_kernels(Constants& constants) {
  constants.add_all(NAMED(exact_above));
  constants.add("float_epsilon", std::numeric_limits<float>::epsilon());
  constants.add("fog_nodes", coefficient::fog_rule.nodes);
  constants.add("fog_weights", coefficient::fog_rule.weights);
  constants.add("broadening_angles", LobeBroadening::angles);
  constants.add("broadening_depths", LobeBroadening::depths);
  constants.add("broadening_depth_scale", LobeBroadening::depth_scale);
  constants.add("min_map_cosine", DirectionMap::min_cosine);
  constants.add("map_border_share", DirectionMap::border_share);
  constants.add("noise_last_node", static_cast<unsigned>(RayNoise::period - 1));
  constants.add("noise_axis_bits", std::countr_zero(unsigned{RayNoise::period}));
  constants.add("hash_factors", noise_lattice::hash_factors);
  constants.add("hash_shifts", noise_lattice::hash_shifts);
}

// Constants of light given as spherical harmonics, and of materials.
void add_reflection(Constants& constants) {
  constants.add_all(NAMED(source_clusters, grid_bands, light_bits));
  constants.add("max_grid_levels", static_cast<int>(SourceGrid::max_levels));
  constants.add("enclosed_bit", GridOcclusion::enclosed_bit);
  constants.add("sh_bands", sh_max_bands);
  constants.add("sh_count", sh_max_bands * sh_max_bands);
  const ShRecurrence recurrence;
  constants.add("sh_start", floats(std::span(&recurrence.start, 1)));
  constants.add("sh_up", floats(recurrence.up));
  constants.add("sh_down", floats(recurrence.down));
  constants.add("grid_functions", static_cast<int>(sh_size(grid_bands)));
  constants.add("cosine_factors", clamped_cosine_factors());
  constants.add("theta_h_cells", MeasuredBrdf::theta_h_cells);
  constants.add("theta_d_cells", MeasuredBrdf::theta_d_cells);
  constants.add("phi_d_cells", MeasuredBrdf::phi_d_cells);
  constants.add("reflection_intervals", ReflectionTable::intervals);
  constants.add("reflection_row", static_cast<int>(ReflectionTable::row_size));
  constants.add("scatter_terms", ScatterTable::degree + 1);
  constants.add("scatter_opaque", ScatterTable::opaque);
}

// Constants of metallic-roughness materials and textures.
void add_materials(Constants& constants) {
  constants.add_all(NAMED(min_ggx_cosine, min_grazing_cosine, min_normal_height, ggx_vectors));
  const auto encoding = [](brume::Texture::Encoding value) { return static_cast<unsigned>(value); };
  constants.add("texture_linear", encoding(brume::Texture::Encoding::linear));
  constants.add("texture_shared_exponent", encoding(brume::Texture::Encoding::shared_exponent));
  constants.add("wrap_repeat", static_cast<unsigned>(TextureWrap::repeat));
  constants.add("wrap_clamp", static_cast<unsigned>(TextureWrap::clamp));
  constants.add("dielectric_f0", GgxReflection::dielectric_f0);
  constants.add("min_alpha", GgxReflection::min_alpha);
  constants.add("ggx_row", static_cast<int>(GgxSh::row_size));
  constants.add("ggx_angles", GgxSh::angle_intervals);
  constants.add("ggx_roughnesses", GgxSh::roughness_intervals);
}

void add_slices(Constants& constants) {
  constants.add_all(NAMED(gauss_3_place, falloff_panel, profile_panel, picture_panel, phase_panel,
                          wide_falloff, wide_phase, gauss_3_end, gauss_3_middle, bin_room,
                          slice_opaque, opaque_fog_depth, points_per_demand, near_light_share,
                          light_slice_share, light_distances, min_gap_of_range, min_gap_of_distance,
                          node_texture_width, slice_chunk, optics_width, max_table_radii));
  const auto add_shape = [&](const char* name, LightFalloff::Shape shape) {
    constants.add(name, static_cast<int>(shape));
  };
  add_shape("falloff_isotropic", LightFalloff::Shape::isotropic);
  add_shape("falloff_cone", LightFalloff::Shape::cone);
  add_shape("falloff_cosine", LightFalloff::Shape::cosine);
  add_shape("falloff_two_cosines", LightFalloff::Shape::two_cosines);
  constants.add("bins_per_slice", slice_demand::bins_per_slice);
  constants.add("box_radii", slice_demand::box_radii);
  constants.add("box_share", slice_demand::box_share);
  constants.add("tail_step", slice_demand::tail_step);
  constants.add("inverse_tail_depth", 1.0 / slice_demand::tail_depth);
  constants.add("core_radii_of_thin", slice_demand::core_radii);
  constants.add("max_demanding", static_cast<unsigned>(slice_demand::max_gaussians));
  constants.add("outstanding_demand", slice_demand::outstanding);
  constants.add("max_front_depth", slice_demand::max_front_depth);
  constants.add("uniform_share", slice_demand::uniform_share);
  constants.add("max_bins", slice_demand::bins_per_slice * max_slices);
  constants.add("max_boundaries", static_cast<int>(max_slice_boundaries));
}

// Constants of rays, tiles and upsampling.
void add_film(Constants& constants) {
  constants.add_all(NAMED(endless, max_radiance, bundle_side, coarse_entries,
                          invocations_per_gaussian, max_relative_step, middle_per_second_difference,
                          unknown_curvature, halving_samples, max_local_fit_curvature,
                          min_surface_weight, radii_per_tolerance, free_paths_per_tolerance));
  constants.add("tile_width", Tiles::width);
  constants.add("tile_height", Tiles::height);
  constants.add("group_size", Tiles::pixels);
  constants.add("bundle_size", bundle_side * bundle_side);
  constants.add_double("pixel_rounding", CameraRays::pixel_rounding);
  constants.add("max_levels", TriangleBvh::max_levels);
  constants.add_double("near_radii", RayCaster::near_radii);
  constants.add_double("start_radii", RayCaster::start_radii);
  constants.add_double("position_rounding", position_rounding);
  constants.add_double("edge_on_rounding", edge_on_rounding);
  constants.add_double("edge_on_share", edge_on_share);
  constants.add("light_margin", RayCaster::light_margin);
}

void add_display(Constants& constants) {
  constants.add_all(NAMED(highlight::start, highlight::desaturation, highlight::offset,
                          highlight::knee, highlight::slope, srgb::knee, srgb::slope, srgb::gain,
                          srgb::offset, srgb::exponent, brightest_shown, dither::column_step,
                          dither::row_step, dither::threshold_bits, dither::threshold_unit));
}

}  // namespace

std::string shader_constants() {
  Constants constants;
  add_kernels(constants);
  add_reflection(constants);
  add_materials(constants);
  add_slices(constants);
  add_film(constants);
  add_display(constants);
  return constants.text();
}

}  // namespace brume::gl
