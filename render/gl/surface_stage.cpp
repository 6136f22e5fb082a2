#include "render/gl/surface_stage.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace brume::gl {
namespace {

std::size_t blocks(int pixels) {
  return static_cast<std::size_t>((pixels + 7) / 8);
}

void append(std::vector<float>& values, const glm::vec3& v, float w) {
  values.insert(values.end(), {v.x, v.y, v.z, w});
}

void append(std::vector<float>& values, const ScatterTable& table) {
  for (const auto& polynomial : table.polynomials()) {
    values.insert(values.end(), polynomial.begin(), polynomial.end());
  }
}

}  // namespace

std::uint64_t SurfaceStage::run(const FrameStages& stages, const FrameWork& work,
                                LightTables* tables, DeviceFrame& device) {
  const MediumIndex& medium = stages.prepared().medium();
  const SurfaceLighting lighting = stages.surface_lighting(work);
  const bool sums = !tables && work.plan.gaussians && !lighting.lights.empty();
  const std::uint64_t pairs = sums ? sum_depths(lighting, device) : 0;

  LightTables& lights = tables ? *tables : lights_;
  lights.upload(FrameStages::lights_of(work), nullptr, device.mesh.middle());
  const Program& program = device.programs["surfaces"];
  set_rays(program, work.rays);
  program.set("light_count", static_cast<int>(lighting.lights.size()));
  program.set("b0", static_cast<float>(medium.homogeneous_density()));
  program.set("albedo", static_cast<float>(lighting.albedo));
  program.set("margin", static_cast<float>(Visibility::self_hit_margin));
  program.set("film", glm::ivec2(work.frame.film.width, work.frame.film.height));
  program.set("has_depths", sums ? 1 : 0);
  upload_values(work, lighting, program);
  upload_arriving(stages, lighting, device.mesh.middle(), program);
  device.mesh.bind(program);
  lights.bind();
  if (sums) depths_.bind(1);
  device.mesh.hits().bind(2);
  device.textures.behind.bind(3);
  arriving_.bind(6);
  values_.bind(7);
  program.dispatch(blocks(work.frame.film.width), blocks(work.frame.film.height));
  return pairs;
}

std::uint64_t SurfaceStage::sum_depths(const SurfaceLighting& lighting, DeviceFrame& device) {
  const Film& film = device.view.film;
  const std::size_t pixels =
      static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  depths_.reserve(lighting.lights.size() * pixels * sizeof(float));
  totals_.reserve(sizeof(std::uint32_t));
  totals_.clear();
  const Program& program = device.programs["surface_depths"];
  program.set("count", static_cast<unsigned>(device.medium.count()));
  program.set("film", glm::ivec2(film.width, film.height));
  for (std::size_t l = 0; l < lighting.lights.size(); ++l) {
    const glm::dvec3& light = lighting.lights[l].light.position;
    program.set("light", light);
    program.set("light_at", glm::vec3(light - device.mesh.middle()));
    program.set("first", static_cast<int>(l * pixels));
    device.mesh.bind(program);
    device.medium.bind();
    device.mesh.hits().bind(2);
    depths_.bind(3);
    totals_.bind(6);
    program.dispatch(blocks(film.width), blocks(film.height));
  }
  std::array<std::uint32_t, 1> pairs{};
  totals_.download(std::span<std::uint32_t>(pairs));
  return pairs[0];
}

// As shaders/surfaces.glsl has them.
void SurfaceStage::upload_values(const FrameWork& work, const SurfaceLighting& lighting,
                                 const Program& program) {
  std::vector<float> values;
  const auto begin = [&](const char* place) {
    program.set(place, static_cast<int>(values.size()));
  };
  for (const Surface& surface : work.scene.surfaces) {
    const PointLightShading reflected = point_light_shading(surface.material, {});
    append(values, reflected.diffuse, reflected.exponent);
    append(values, reflected.highlight, 0.0f);
  }
  program.set("scatters", lighting.point ? 1 : 0);
  begin("scatter_at");
  if (lighting.point) {
    append(values, *lighting.point);
    append(values, *lighting.distant);
  }
  program.set("has_environment", lighting.environment ? 1 : 0);
  begin("environment_at");
  if (lighting.environment) {
    for (const glm::vec3& c : lighting.environment->coefficients().values())
      append(values, c, 0.0f);
    const auto fog = static_cast<float>(lighting.fog_depth);
    program.set("environment_shares", lighting.environment->arriving(fog, lighting.albedo));
    program.set("environment_intensity", static_cast<float>(work.scene.environment->intensity));
  }
  begin("densities_at");
  for (const SurfaceLight& light : lighting.lights) {
    values.push_back(static_cast<float>(light.density));
  }
  values_.upload(std::span<const float>(values));
}

void SurfaceStage::upload_arriving(const FrameStages& stages, const SurfaceLighting& lighting,
                                   const glm::dvec3& middle, const Program& program) {
  program.set("arriving_levels",
              lighting.arriving ? static_cast<int>(lighting.arriving->levels().size()) : 0);
  if (!lighting.arriving) return;
  const bool is_new = arriving_revision_ != stages.source_revision();
  std::vector<float> values;
  std::size_t at = 0;
  const auto levels = lighting.arriving->levels();
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const SourceGrid::Level& level = levels[k];
    program.set(k == 0 ? "arriving_first[0]" : "arriving_first[1]",
                glm::vec4(glm::vec3(level.first - middle), 1.0f / level.nodes.spacing));
    program.set(k == 0 ? "arriving_count[0]" : "arriving_count[1]",
                glm::ivec4(level.nodes.count, static_cast<int>(at)));
    at += level.arriving.size() / 4;
    if (is_new) values.insert(values.end(), level.arriving.begin(), level.arriving.end());
  }
  if (!is_new) return;
  arriving_revision_ = 0;
  arriving_.upload(std::span<const float>(values));
  arriving_revision_ = stages.source_revision();
}

}  // namespace brume::gl
