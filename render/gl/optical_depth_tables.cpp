#include "render/gl/optical_depth_tables.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/scene/lights/area_lights.h"
#include "render/gl/shader_source.h"
#include "render/gl/shadow_maps.h"
#include "render/simd/coefficients.h"
#include "render/slices/shadow_map.h"

namespace brume::gl {
namespace {

// Maximum words of a table, a fixed slot per light, so that moving a light leaves the others'
// tables in place: a DirectionMap has about size^2 cells and sides up to four times as long.
std::size_t max_words(const OpticalDepthTableSize& size) {
  const auto n = static_cast<std::size_t>(size.directions);
  return (n * n + 12 * n + 16) * static_cast<std::size_t>(size.radii);
}

// No ray meets more than this.
float max_depth(const MediumIndex& medium) {
  double sum = 0.0;
  for (const GaussianTerm<double>& g : medium.gaussians()) {
    sum += g.c / g.a * std::sqrt(std::numbers::pi);
  }
  return static_cast<float>(
      std::clamp(1.01 * sum, 1e-30, static_cast<double>(OpticalDepthTable::opaque)));
}

}  // namespace

MapData map_data(const DirectionMap& map, std::size_t first) {
  return {glm::vec4(map.right, map.scale.x), glm::vec4(map.up, map.scale.y),
          glm::vec4(map.axis, map.octahedral ? 1.0f : 0.0f), glm::vec4(map.offset, 0.0f, 0.0f),
          glm::ivec4(map.columns, map.rows, static_cast<int>(first), 0)};
}

void set_map(const Program& program, const MapData& map) {
  program.set("map.right", map.right);
  program.set("map.up", map.up);
  program.set("map.axis", map.axis);
  program.set("map.offset", map.offset);
  program.set("map.cells", map.cells);
}

void dispatch_bundles(const Program& program, const glm::ivec2& rays) {
  const glm::ivec2 groups = (rays + (bundle_side - 1)) / bundle_side;
  program.dispatch(static_cast<std::size_t>(groups.x), static_cast<std::size_t>(groups.y));
}

std::span<const DirectionMap> OpticalDepthTables::lay_out(const MediumIndex& medium,
                                                          std::span<const SlicedLight> lights,
                                                          const OpticalDepthTableSize& size) {
  assert(size.radii <= max_table_radii);
  const bool same = medium.revision() == revision_ && size == size_;
  if (!same) max_depth_ = max_depth(medium);
  tables_.resize(lights.size());
  maps_.resize(lights.size());
  for (std::size_t l = 0; l < lights.size(); ++l) {
    Table& table = tables_[l];
    if (!same || table.light != lights[l].position || table.layout.empty()) {
      table = {lights[l].position, OpticalDepthTableLayout(medium, lights[l].position, size),
               false};
    }
    maps_[l] = table.layout.map;
  }
  revision_ = medium.revision();
  size_ = size;
  return maps_;
}

std::uint64_t OpticalDepthTables::build(Programs& programs, MediumBuffers& medium) {
  const std::size_t bytes = tables_.size() * max_words(size_) * sizeof(std::uint32_t);
  if (bytes > values_.bytes()) {
    for (Table& table : tables_) table.made = false;
  }
  values_.reserve(bytes);
  bool any = false;
  for (std::size_t l = 0; l < tables_.size(); ++l) {
    Table& table = tables_[l];
    if (table.made || table.layout.empty()) continue;
    if (!any) {
      pairs_.reserve(sizeof(std::uint32_t));
      pairs_.clear();
    }
    any = true;
    const Program& program = programs.get("optical_depth_table", medium.defined());
    set_map(program, map_data(table.layout.map, l * max_words(size_)));
    program.set("count", static_cast<unsigned>(medium.count()));
    program.set("light", table.light);
    program.set("max_depth", max_depth_);
    program.set("radii", table.layout.radii.count);
    program.set("first_radius", static_cast<float>(table.layout.radii.first));
    program.set("radii_per_unit", static_cast<float>(table.layout.radii.per_unit));
    program.set("curvature", static_cast<float>(table.layout.radii.curvature));
    medium.bind(program);
    program.bind("Tables", values_);
    program.bind("Totals", pairs_);
    dispatch_bundles(program, {table.layout.map.columns + 2, table.layout.map.rows + 2});
    table.made = true;
  }
  if (!any) return 0;
  std::array<std::uint32_t, 1> pairs{};
  pairs_.download(std::span<std::uint32_t>(pairs));
  return pairs[0];
}

void OpticalDepthTables::upload(std::span<const SlicedLight> lights, const ShadowMaps* shadows,
                                const glm::dvec3& origin) {
  profiles_.upload(lights);
  std::vector<LightData> data(lights.size());
  for (std::size_t l = 0; l < lights.size(); ++l) {
    const SlicedLight& light = lights[l];
    LightData& u = data[l];
    u.position = glm::vec3(light.position - origin);
    u.h_min = static_cast<float>(light.h_min);
    u.intensity = glm::vec3(light.intensity);
    u.falloff_shape = static_cast<std::int32_t>(light.falloff.shape());
    u.falloff_axis = glm::vec3(light.falloff.axis());
    u.dark_versine = static_cast<float>(light.falloff.dark_versine());
    u.per_versine = static_cast<float>(light.falloff.per_versine());
    u.azimuth_0 = glm::vec3(light.falloff.azimuth_0());
    u.azimuth_90 = glm::vec3(light.falloff.azimuth_90());
    if (const auto& map = light.falloff.map()) {
      const glm::ivec2 place = profiles_.place(*map);
      u.map_column = place.x;
      u.map_row = place.y;
      u.map_side = map->side;
      u.cotangent = static_cast<float>(light.falloff.cotangent());
    }
    u.radius2 = static_cast<float>(light.radius * light.radius);
    u.index = light.index;
    if (light.area_points > 0) {
      const AreaOutline outline(*light.area, light.area_center,
                                static_cast<int>(coefficient::disk_corners));
      u.area_points = light.area_points;
      u.area_far2 = static_cast<float>(coefficient::far_areas * facing_area(*light.area));
      u.area_of_point = static_cast<float>(area_of_point(light));
      u.area_center = glm::vec3(outline.center - origin);
      u.area_u = glm::vec3(outline.u);
      u.area_v = glm::vec3(outline.v);
      u.area_corners = outline.corner_count;
      u.area_is_two_sided = is_two_sided(*light.area) ? 1 : 0;
      if (const auto* sphere = std::get_if<light::Sphere>(&*light.area)) {
        u.area_radius = static_cast<float>(sphere->radius);
      }
    }
    if (!light.fog.is_endless()) {
      u.fog_center = glm::vec3(light.fog.center - origin);
      u.fog_radius = static_cast<float>(light.fog.radius);
    }
    const glm::dvec3 from_light = origin - light.position;
    if (!light.is_far) u.map_origin = glm::vec4(u.position, 0.0f);
    if (l < tables_.size() && !tables_[l].layout.empty()) {
      const OpticalDepthTableLayout& layout = tables_[l].layout;
      u.has_table = 1;
      if (light.is_far) u.in_table = glm::vec4(layout.map.components(from_light), 0.0);
      u.table = map_data(layout.map, l * max_words(size_));
      u.first_radius = static_cast<float>(layout.radii.first);
      u.radii_per_unit = static_cast<float>(layout.radii.per_unit);
      u.curvature = static_cast<float>(layout.radii.curvature);
      u.radii = layout.radii.count;
      u.max_depth = max_depth_;
    }
    if (shadows && !shadows->empty()) {
      u.has_shadows = 1;
      const glm::dvec3 in_shadows =
          light.is_far ? shadows->map(l).components(from_light) : glm::dvec3(0.0);
      u.in_shadows = glm::vec4(in_shadows, in_shadows.z - shadows->start(l));
      u.shadows = map_data(shadows->map(l), shadows->first(l));
      u.shadow_bias = brume::shadow_bias(shadows->map(l));
    }
  }
  lights_.upload(std::span<const LightData>(data));
}

void OpticalDepthTables::bind(const Program& program) {
  program.bind("Lights", lights_);
  program.bind("Tables", values_);
  profiles_.bind(program);
}

namespace {

// Texels of a row of maps: as many rows of those of profiles hold one for each light that a scene
// may have.
constexpr int row_length = 8224;

}  // namespace

glm::ivec2 ProfileMaps::place_of(std::size_t index) const {
  const auto i = static_cast<int>(index);
  const int columns = row_length / side_;
  return {i % columns * side_, i / columns * side_};
}

void ProfileMaps::upload(std::span<const SlicedLight> lights) {
  std::vector<std::shared_ptr<const IntensityMap>> maps;
  for (const SlicedLight& light : lights) {
    const auto& map = light.falloff.map();
    if (map && std::ranges::find(maps, map) == maps.end()) maps.push_back(map);
  }
  if (maps == maps_) return;
  maps_ = maps;
  side_ = 0;
  if (maps_.empty()) {
    texture_.release();
    return;
  }
  for (const auto& map : maps_) side_ = std::max(side_, map->side);
  const int columns = std::min(static_cast<int>(maps_.size()), row_length / side_);
  const glm::ivec2 size(columns * side_, place_of(maps_.size() - 1).y + side_);
  if (size.y > row_length) {
    throw OutOfMemory("the pictures in the lights' beams do not fit into a texture");
  }
  std::vector<float> texels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    const IntensityMap& map = *maps_[i];
    const glm::ivec2 corner = place_of(i);
    for (int row = 0; row < map.side; ++row) {
      std::ranges::copy(
          std::span(map.values)
              .subspan(static_cast<std::size_t>(row) * static_cast<std::size_t>(map.side),
                       static_cast<std::size_t>(map.side)),
          texels.begin() + (corner.y + row) * std::ptrdiff_t{size.x} + corner.x);
    }
  }
  texture_.reserve(Texture::Format::r32f, size);
  texture_.upload(texels);
}

glm::ivec2 ProfileMaps::place(const IntensityMap& map) const {
  const auto found = std::ranges::find(maps_, &map, [](const auto& p) { return p.get(); });
  return place_of(static_cast<std::size_t>(found - maps_.begin()));
}

void ProfileMaps::bind(const Program& program) {
  if (texture_.size().x == 0) texture_.reserve(Texture::Format::r32f, {1, 1});
  program.bind("profiles", texture_);
}

}  // namespace brume::gl
