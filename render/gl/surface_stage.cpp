#include "render/gl/surface_stage.h"

#include <algorithm>
#include <cstring>

#include "core/scene/materials/ggx_sh.h"
#include "core/scene/materials/measured_brdf.h"
#include "render/gl/grid_nodes.h"
#include "render/shading/vertex_lighting.h"
#include "render/simd/reflection_kernels.h"

namespace brume::gl {
namespace {

void append(std::vector<float>& values, const glm::vec3& v, float w) {
  values.insert(values.end(), {v.x, v.y, v.z, w});
}

void append(std::vector<float>& values, const ScatterTable& table) {
  for (const auto& polynomial : table.polynomials()) {
    values.insert(values.end(), polynomial.begin(), polynomial.end());
  }
}

bool has_same_light(const SurfaceShading& a, const SurfaceShading& b) {
  return a.transferred == b.transferred && a.average_depth == b.average_depth;
}

// Appends the light at a surface's vertices, front and back, and the average depths around it;
// where they begin.
std::array<int, 4> append_light(const SurfaceShading& shading, std::vector<glm::vec4>& values) {
  std::array<int, 4> begins{-1, -1, -1, -1};
  for (const MeshSide which : {MeshSide::front, MeshSide::back}) {
    if (!shading.transferred || shading.transferred->side(which).radiance.empty()) continue;
    const VertexLighting::Side& side = shading.transferred->side(which);
    begins[static_cast<std::size_t>(which)] = static_cast<int>(values.size());
    const std::size_t functions = side.incident.size() / side.radiance.size();
    for (std::size_t v = 0; v < side.radiance.size(); ++v) {
      values.emplace_back(side.radiance[v], 0.0f);
      for (std::size_t i = 0; i < functions; ++i) {
        values.emplace_back(side.incident[v * functions + i], 0.0f);
      }
    }
  }
  if (!shading.average_depth) return begins;
  begins[2] = static_cast<int>(values.size());
  const std::span<const float> depths = shading.average_depth->depths();
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (i % 4 == 0) values.emplace_back(0.0f);
    values.back()[static_cast<int>(i % 4)] = depths[i];
  }
  return begins;
}

// The tables of measured materials, each once; where they begin.
void append_tables(std::span<const std::shared_ptr<const MeasuredBrdf>> measured,
                   std::vector<glm::vec4>& values, std::span<std::array<int, 4>> begins) {
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (!measured[i]) continue;
    const auto known =
        static_cast<std::size_t>(std::ranges::find(measured, measured[i]) - measured.begin());
    if (known < i) {
      begins[i][3] = begins[known][3];
      continue;
    }
    begins[i][3] = static_cast<int>(values.size());
    for (const glm::vec3& value : measured[i]->values()) values.emplace_back(value, 0.0f);
  }
}

}  // namespace

std::uint64_t SurfaceStage::run(const FrameStages& stages, const FrameContext& work,
                                OpticalDepthTables& tables, DeviceFrame& device) {
  const MediumIndex& medium = stages.prepared().medium();
  const SurfaceLighting lighting = stages.surface_lighting(work);
  using SurfaceDepths = RenderPlan::SurfaceDepths;
  const bool sums = work.plan.surface_depths == SurfaceDepths::exact;
  const std::uint64_t pairs = sums ? sum_depths(lighting, device) : 0;

  OpticalDepthTables& lights = work.plan.surface_depths == SurfaceDepths::tables ? tables : lights_;
  lights.upload(FrameStages::lights_of(work), nullptr, device.mesh.center());
  const bool is_glossy = std::ranges::any_of(
      stages.shading().surfaces(),
      [](const SurfaceShading& s) { return s.material && !s.material->is_diffuse(); });
  if (work.plan.has_metallic_roughness) materials_.run(work, device);
  if (!lighting.lights.empty()) find_shadows(work, lights, lighting.lights.size(), device);
  const Program& program =
      device.programs.get(work.plan.has_metallic_roughness ? "metallic_surfaces"
                          : is_glossy                      ? "glossy_surfaces"
                                                           : "surfaces",
                          ray_definitions(work.rays));
  set_rays(program, work.rays);
  program.set("light_count", static_cast<int>(lighting.lights.size()));
  set_fog(program, BatchFog(medium, device.mesh.center()));
  program.set("albedo", static_cast<float>(lighting.albedo));
  program.set("eye", work.rays.eye() - device.mesh.center());
  program.set("film", glm::ivec2(work.frame.film.width, work.frame.film.height));
  program.set("has_depths", sums ? 1 : 0);
  upload_light(stages, work, lighting, device.mesh.center(), program);
  upload_values(stages, work, lighting, device.mesh.center(), program);
  device.mesh.bind(program);
  lights.bind(program);
  if (sums) program.bind("Tables", depths_);
  program.bind("Hits", device.mesh.hits());
  program.bind("Behind", device.textures.behind);
  program.bind("Arriving", light_);
  program.bind("Lit", lit_);
  program.bind("Values", values_);
  program.dispatch_over({work.frame.film.width, work.frame.film.height});
  return pairs;
}

void SurfaceStage::find_shadows(const FrameContext& work, OpticalDepthTables& lights,
                                std::size_t light_count, DeviceFrame& device) {
  const Film& film = work.frame.film;
  const std::size_t pixels =
      static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  const std::size_t words = (light_count + light_bits - 1) / light_bits;
  lit_.reserve(words * pixels * sizeof(std::uint32_t));
  const char* materials = work.plan.has_metallic_roughness ? " METALLIC" : "";
  const Program& program =
      device.programs.get("surface_shadows", materials + ray_definitions(work.rays));
  set_rays(program, work.rays);
  program.set("light_count", static_cast<int>(light_count));
  program.set("eye", work.rays.eye() - device.mesh.center());
  program.set("film", glm::ivec2(film.width, film.height));
  device.mesh.bind(program);
  lights.bind(program);
  program.bind("Hits", device.mesh.hits());
  program.bind("Behind", device.textures.behind);
  program.bind("Lit", lit_);
  program.dispatch_over({film.width, film.height});
}

std::uint64_t SurfaceStage::sum_depths(const SurfaceLighting& lighting, DeviceFrame& device) {
  const Film& film = device.view.film;
  const std::size_t pixels =
      static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  depths_.reserve(lighting.lights.size() * pixels * sizeof(float));
  totals_.reserve(sizeof(std::uint32_t));
  totals_.clear();
  const Program& program = device.programs.get(
      "surface_depths", device.medium.defined() + ray_definitions(device.view.rays));
  program.set("count", static_cast<unsigned>(device.medium.count()));
  program.set("film", glm::ivec2(film.width, film.height));
  for (std::size_t l = 0; l < lighting.lights.size(); ++l) {
    const glm::dvec3& light = lighting.lights[l].source.position;
    set_rays(program, device.view.rays);
    program.set("eye", device.view.rays.eye() - device.mesh.center());
    program.set("light", light);
    program.set("light_at", glm::vec3(light - device.mesh.center()));
    program.set("first", static_cast<int>(l * pixels));
    device.mesh.bind(program);
    device.medium.bind(program);
    program.bind("Hits", device.mesh.hits());
    program.bind("Depths", depths_);
    program.bind("Totals", totals_);
    dispatch_bundles(program, {film.width, film.height});
  }
  std::array<std::uint32_t, 1> pairs{};
  totals_.download(std::span<std::uint32_t>(pairs));
  return pairs[0];
}

// The layout is that of shaders/shade_surfaces.glsl.
void SurfaceStage::upload_values(const FrameStages& stages, const FrameContext& work,
                                 const SurfaceLighting& lighting, const glm::dvec3& center,
                                 const Program& program) {
  std::vector<float> values;
  const auto begin = [&](const char* place) {
    program.set(place, static_cast<int>(values.size()));
  };
  const auto& shadings = stages.shading().surfaces();
  std::vector<SurfaceRecord> records(shadings.size());
  values.resize(records.size() * sizeof(SurfaceRecord) / sizeof(float));
  for (std::size_t i = 0; i < shadings.size(); ++i) {
    SurfaceRecord& record = records[i];
    const PointLightShading reflected = point_light_shading(work.scene.surfaces[i].material, {});
    record.diffuse = reflected.diffuse;
    record.exponent = reflected.exponent;
    record.highlight = reflected.highlight;
    const bool is_glossy = shadings[i].material && !shadings[i].material->is_diffuse();
    if (const VertexLighting* transferred = shadings[i].transferred) {
      record.has_transfer = 1.0f;
      record.transferred_functions =
          is_glossy ? static_cast<float>(sh_size(transferred->order())) : 0.0f;
    }
    record.front_at = static_cast<float>(begins_[i][0]);
    record.back_at = static_cast<float>(begins_[i][1]);
    record.average_depths_at = static_cast<float>(begins_[i][2]);
    record.measured_at = static_cast<float>(begins_[i][3]);
    if (const AverageDepthGrid* grid = shadings[i].average_depth) {
      record.grid_corner = glm::vec3(grid->low() - center);
      record.cells_per_unit = glm::vec3(grid->cells_per_unit());
      record.grid_nodes = glm::vec3(grid->nodes());
    }
    if (!is_glossy) continue;
    record.reflection_at = static_cast<float>(values.size());
    const float* rows = shadings[i].material->table().rows();
    values.insert(values.end(), rows,
                  rows + (ReflectionTable::intervals + 1) * ReflectionTable::row_size);
  }
  if (!records.empty()) {
    std::memcpy(values.data(), records.data(), std::span(records).size_bytes());
  }
  begin("ggx_at");
  if (work.plan.has_metallic_roughness) {
    const GgxSh& table = GgxSh::table();
    for (const std::span<const float> rows : {table.diffuse(), table.scaled(), table.added()}) {
      values.insert(values.end(), rows.begin(), rows.end());
    }
  }
  program.set("scatters", lighting.point ? 1 : 0);
  begin("scatter_at");
  if (lighting.point) {
    append(values, *lighting.point);
    append(values, *lighting.distant);
  }
  program.set("has_environment", lighting.environment ? 1 : 0);
  program.set("extinction", static_cast<float>(lighting.extinction));
  program.set("incident_is_all", lighting.incident_is_all ? 1 : 0);
  program.set("incident_scale", static_cast<float>(lighting.incident_scale));
  begin("environment_at");
  if (lighting.environment) {
    for (const glm::vec3& c : lighting.environment->coefficients().values()) {
      append(values, c, 0.0f);
    }
    append(values, lighting.environment->scattering());
    program.set("fog_depth", static_cast<float>(lighting.fog_depth));
  }
  begin("densities_at");
  for (const SurfaceLight& light : lighting.lights) {
    values.push_back(static_cast<float>(light.density));
  }
  values_.upload(std::span<const float>(values));
}

void SurfaceStage::upload_light(const FrameStages& stages, const FrameContext& work,
                                const SurfaceLighting& lighting, const glm::dvec3& center,
                                const Program& program) {
  const Revision source = lighting.incident ? lighting.incident->revision() : 0;
  const Revision vertices = stages.shading().light_revision();
  const std::vector<SurfaceShading>& shadings = stages.shading().surfaces();
  std::vector<std::shared_ptr<const MeasuredBrdf>> measured;
  for (const Surface& surface : work.scene.surfaces) {
    const bool is_measured = surface.material.type == Material::Type::measured;
    measured.push_back(is_measured ? surface.material.measured : nullptr);
  }
  const bool is_new = source != source_revision_ || vertices != vertex_revision_ ||
                      measured != measured_ ||
                      !std::ranges::equal(shadings, shadings_, has_same_light) || begins_.empty();
  std::vector<glm::vec4> values;
  program.set("incident_levels",
              lighting.incident ? static_cast<int>(lighting.incident->levels().size()) : 0);
  program.set("incident_occlusion_bits", lighting.visibility.occlusion_bits);
  std::size_t at = 0;
  for (std::size_t k = 0; lighting.incident && k < lighting.incident->levels().size(); ++k) {
    const SourceGrid::Level& level = lighting.incident->levels()[k];
    set_level(program, "incident", k, level, center, lighting.visibility, at);
    at += level.incident.size() / 4;
    if (is_new) append_nodes(level, level.incident, values);
  }
  if (!is_new) return;
  source_revision_ = vertex_revision_ = 0;
  begins_.clear();
  for (const SurfaceShading& shading : shadings) begins_.push_back(append_light(shading, values));
  append_tables(measured, values, begins_);
  // Shaders are told in floats where things begin.
  if (values.size() > std::size_t{1} << 24) {
    throw OutOfMemory("the lighting of the surfaces does not fit into device memory");
  }
  light_.upload(std::span<const glm::vec4>(values));
  source_revision_ = source;
  vertex_revision_ = vertices;
  shadings_ = shadings;
  measured_ = std::move(measured);
}

}  // namespace brume::gl
