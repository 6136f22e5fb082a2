#include "render/gl/sliced_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "core/scene/lights/radiance_map.h"
#include "core/scene/ray_noise.h"
#include "render/geometry/ray_range.h"
#include "render/gl/grid_nodes.h"
#include "render/gl/shader_source.h"
#include "render/slices/slice_boundaries.h"

namespace brume::gl {

void set_noise(const Program& program, const RayNoise& noise, const glm::dvec3& eye) {
  const double amplitude = noise.on() ? noise.amplitude() / noise_lattice::rms : 0.0;
  program.set("noise_amplitude", static_cast<float>(amplitude));
  program.set("noise_frequency", static_cast<float>(std::min(noise.frequency(), endless)));
  program.set("noise_cell", glm::vec3(noise.cell(eye)));
  program.set("noise_key", noise.key());
}

std::size_t SlicedStage::run(FrameStages& stages, FrameContext& work, DeviceFrame& device) {
  const MediumIndex& medium = stages.prepared().medium();
  const glm::dvec3& eye = work.rays.eye();
  const std::vector<SlicedLight> lights = FrameStages::lights_of(work);
  const auto maps = lights_.lay_out(medium, lights, work.settings.optical_depth_table);
  if (work.plan.runs(Stage::light_table)) {
    work.frame.statistics.light_pairs += device.clock.time(
        Stage::light_table, [&] { return lights_.build(device.programs, device.medium); });
  }
  make_shadows(stages, work, lights, maps, device);
  const std::vector<SlicedLight> lit_from = stages.lit_from(work, lights);
  lights_.upload(lit_from, &shadows_, eye);

  slices_.choose(device.programs, device.clock, lights_, lit_from.size(), work.settings.slices,
                 device.lists, device.view, device.textures);
  const SourceFunction* const source = stages.source_function(work);
  const SliceScattering scattering = slice_scattering(medium.anisotropy(), source);
  std::string defined = device.medium.has_optics() ? "OPTICS" : "";
  const auto has_cone = [](const SlicedLight& light) { return light.falloff.has_cone(); };
  if (std::ranges::any_of(lights, has_cone)) defined += " CONES";
  if (scattering.anisotropy != 0.0f) defined += " ANISOTROPIC";
  defined.append(" ").append(device.medium.defined()).append(ray_definitions(work.rays));
  const Program& program = device.programs.get("sliced", defined);
  set_noise(program, medium.noise(), eye);
  program.set("light_count", static_cast<int>(lights.size()));
  set_fog(program, device.view.fog);
  program.set("negligible", static_cast<float>(medium.negligible_depth()));
  program.set("anisotropy", scattering.anisotropy);
  program.set("view_extinction", scattering.view_extinction);
  program.set("truncated_phase", scattering.truncated_phase);
  program.set("albedo", scattering.albedo);
  program.set("light_extinction", source ? static_cast<float>(source->light_extinction()) : 1.0f);
  const double from_eye = scattering.anisotropy < 0.0f ? 1.0 : -1.0;
  const auto along_ray = [&](double extinction) {
    return static_cast<float>(1.0 + from_eye * extinction);
  };
  program.set("ray_per_gaussians", along_ray(source ? source->light_extinction() : 1.0));
  program.set("ray_per_fog", along_ray(source ? source->lobe_fog_extinction() : 0.0));
  upload_source(source, eye, program);
  return film_.run(
      device.programs, device.clock, program,
      [&] {
        lights_.bind(program);
        device.medium.bind_optics(program);
        program.bind("Shadows", shadows_.values());
        program.bind("Source", source_);
        slices_.bind(program);
      },
      device.lists, device.view, device.textures);
}

void SlicedStage::make_shadows(const FrameStages& stages, const FrameContext& work,
                               std::span<const SlicedLight> lights,
                               std::span<const DirectionMap> tables, DeviceFrame& device) {
  if (!work.plan.runs(Stage::shadow_map)) {
    shadows_.clear();
    return;
  }
  std::vector<DirectionMap> directions;
  for (std::size_t l = 0; l < tables.size(); ++l) {
    directions.push_back(stages.shadow_directions(work, lights[l], tables[l]));
  }
  device.clock.time(Stage::shadow_map,
                    [&] { shadows_.make(device.programs, device.mesh, lights, directions); });
}

void SlicedStage::upload_source(const SourceFunction* source, const glm::dvec3& eye,
                                const Program& program) {
  program.set("source_levels", source ? static_cast<int>(source->grid().levels().size()) : 0);
  program.set("source_broadening_at", 0);
  program.set("eye_lobe_at", 0);
  program.set("source_map_size", glm::ivec2(0));
  program.set("source_lobe_on_rays", 0);
  if (!source) return;
  const EyeLobe& eye_lobe = source->eye_lobe();
  const SourceFunction::WeightParts parts = source->weight_parts(&eye_lobe);
  const bool is_new =
      source_revision_ != source->grid().revision() || eye_lobe_revision_ != eye_lobe.revision();
  // The layout is that of shaders/source.glsl; places are known without the values.
  std::vector<glm::vec4> values;
  std::size_t at = 0;
  bool has_surfaces = false;
  const NodeVisibility visibility(source->grid(), eye);
  const auto levels = source->grid().levels();
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const SourceGrid::Level& level = levels[k];
    set_level(program, "source", k, level, eye, visibility, at);
    at += level.values.size() / 4;
    if (is_new) append_nodes(level, level.values, values);
    has_surfaces |= level.surfaces && !level.surfaces->hidden().empty();
  }
  program.set("source_occlusion_bits", visibility.occlusion_bits);
  program.set("source_surfaces", has_surfaces ? 1 : 0);
  glm::vec4 factors(0.0f);
  for (std::size_t l = 0; l < parts.factors.size(); ++l) {
    factors[static_cast<int>(l)] = static_cast<float>(parts.factors[l]);
  }
  program.set("source_factors", factors);
  program.set("source_bands", static_cast<int>(parts.factors.size()));
  program.set("source_scale", static_cast<float>(parts.scale));
  program.set("source_lobe_scale", static_cast<float>(parts.lobe_scale));
  program.set("source_harmonics_scale", static_cast<float>(parts.harmonics_scale));
  program.set("source_map_at", static_cast<int>(at));
  int at_nodes = 0;
  for (std::size_t f = 0; f < parts.lobes.size(); ++f) at_nodes |= parts.at_nodes[f] ? 1 << f : 0;
  program.set("source_at_nodes", at_nodes);
  program.set("source_lobe_on_rays", source->has_lobe_on_rays() ? 1 : 0);
  if (!parts.lobes.empty()) {
    const RadianceMap& map = *parts.lobes[0];  // all have the same size
    const double angle = glm::radians(parts.rotation);
    program.set("source_map_size", glm::ivec2(map.width, map.height));
    program.set("source_rotation", glm::vec2(std::cos(angle), std::sin(angle)));
  }
  for (const auto& lobe : parts.lobes) {
    for (std::size_t i = 0; is_new && i < lobe->pixels.size(); ++i) {
      values.emplace_back(lobe->pixels[i], 0.0f);
    }
  }
  const std::vector<float>& broadening = source->lobe_broadening().values();
  for (const auto& lobe : parts.lobes) at += lobe->pixels.size();
  if (!broadening.empty()) {
    program.set("source_broadening_at", static_cast<int>(at));
    static_assert(LobeBroadening::depths % 4 == 0);
    for (std::size_t i = 0; is_new && i < broadening.size(); i += 4) {
      values.emplace_back(broadening[i], broadening[i + 1], broadening[i + 2], broadening[i + 3]);
    }
  }
  if (!eye_lobe.empty()) {
    program.set("eye_lobe_at", static_cast<int>(at + broadening.size() / 4));
    const EyeLobe::Places& places = eye_lobe.places();
    program.set("eye_lobe_size", glm::ivec4(EyeLobe::size, 0));
    program.set("eye_lobe_x", places.film[0]);
    program.set("eye_lobe_y", places.film[1]);
    program.set("eye_lobe_forward", places.forward);
    program.set("eye_lobe_start", places.start);
    program.set("eye_lobe_distance", places.distance);
    if (is_new) values.insert(values.end(), eye_lobe.values().begin(), eye_lobe.values().end());
  }
  if (!is_new) return;
  source_revision_ = 0;
  eye_lobe_revision_ = eye_lobe.revision();
  source_.upload(std::span<const glm::vec4>(values));
  source_revision_ = source->grid().revision();
}

void SliceTexture::choose(Programs& programs, DeviceClock& clock, OpticalDepthTables& lights,
                          std::size_t light_count, int slices, TileLists& lists,
                          const FilmView& view, const FilmTextures& textures) {
  const glm::ivec2 tiles = lists.tiles();
  tiles_ = tiles;
  const auto tile_count = static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y);
  const auto node_count =
      static_cast<std::size_t>(2 * tiles.x + 1) * static_cast<std::size_t>(2 * tiles.y + 1);
  stride_ = static_cast<int>(max_boundaries(slices, light_count, view.fog.density > 0.0f));
  const auto record = static_cast<std::size_t>(stride_) + 1;
  chosen_.reserve(tile_count * record * sizeof(float));
  const std::size_t rows = node_count * record / node_texture_width + 1;
  if (rows > node_texture_width) throw OutOfMemory("the slices do not fit into device memory");
  nodes_.reserve(Texture::Format::r32f, glm::ivec2(node_texture_width, static_cast<int>(rows)));

  clock.time(view.plan.medium_stage(), [&] {
    const Program& choose =
        programs.get("choose_slices", lists.defined() + ray_definitions(view.rays));
    set_rays(choose, view.rays);
    choose.set("film", glm::ivec2(view.film.width, view.film.height));
    choose.set("tiles", tiles);
    choose.set("scale", view.plan.settings.airlight_scale);
    choose.set("ray_end", static_cast<float>(std::min(view.ray_end, endless)));
    choose.set("light_count", static_cast<int>(light_count));
    choose.set("slices", slices);
    choose.set("per_light", slices_per_light(slices, light_count));
    set_fog(choose, view.fog);
    choose.set("stride", stride_);
    lights.bind(choose);
    lists.bind(choose);
    choose.bind("Chosen", chosen_);
    choose.bind("depths", textures.depth);
    choose.dispatch_linear(tile_count);

    const Program& merge = programs["merge_slices"];
    merge.set("tiles", tiles);
    merge.set("stride", stride_);
    merge.bind("Chosen", chosen_);
    merge.bind("slice_nodes", nodes_);
    merge.dispatch_linear(node_count);
  });
}

void SliceTexture::bind(const Program& program) const {
  program.set("stride", stride_);
  program.bind("slice_nodes", nodes_);
}

std::vector<std::vector<float>> SliceTexture::download_tiles() const {
  const std::size_t record = stride() + 1;
  std::vector<std::vector<float>> tiles(static_cast<std::size_t>(tiles_.x * tiles_.y));
  std::vector<float> values(tiles.size() * record);
  chosen_.download(std::span(values));
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * record);
    tiles[i].assign(first + 1, first + 1 + static_cast<std::ptrdiff_t>(*first));
  }
  return tiles;
}

std::vector<std::vector<float>> SliceTexture::download_nodes() const {
  const std::size_t record = stride() + 1;
  std::vector<std::vector<float>> nodes(
      static_cast<std::size_t>((2 * tiles_.x + 1) * (2 * tiles_.y + 1)));
  std::vector<float> values(static_cast<std::size_t>(nodes_.size().x) *
                            static_cast<std::size_t>(nodes_.size().y));
  nodes_.download(std::span(values));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * record);
    if (*first > 0.0f) {
      nodes[i].assign(first + 1, first + static_cast<std::ptrdiff_t>(record));
    }
  }
  return nodes;
}

}  // namespace brume::gl
