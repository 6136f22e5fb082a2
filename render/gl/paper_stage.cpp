#include "render/gl/paper_stage.h"

#include <algorithm>
#include <cmath>

namespace brume::gl {
namespace {

// As `PaperLight` of shaders/paper.glsl.
struct LightUniforms {
  glm::vec4 position{0.0f};
  glm::vec4 intensity{0.0f};
  glm::ivec4 options{0};
};

}  // namespace

std::size_t PaperStage::run(FrameStages& stages, FrameContext& work, StageClock& clock,
                            DeviceFrame& device) {
  const MediumIndex& medium = stages.prepared().medium();
  const PaperLights paper = device.arena.execute([&] { return stages.paper_lights(work, clock); });
  const EnvironmentLight* environment = stages.shading().environment();
  upload_lights(paper, medium.size(), work.rays.eye());
  if (environment) upload_inscattering(*environment);

  const Program& program = device.programs["paper"];
  set_noise(program, medium.noise(), work.rays.eye());
  program.set("light_count", static_cast<int>(paper.lights.size()));
  program.set("gaussian_count", static_cast<int>(medium.size()));
  program.set("b0", static_cast<float>(medium.homogeneous_density()));
  program.set("anisotropy", static_cast<float>(medium.anisotropy()));
  program.set("at_mean", paper.at_mean ? 1 : 0);
  program.set("conserves", std::ranges::any_of(paper.lights, &PaperLight::conserve_energy) ? 1 : 0);
  program.set("has_inscattering", environment ? 1 : 0);
  return film_.run(
      device.programs, device.clock, program,
      [&] {
        lights_.bind(0);
        frozen_.bind(1);
        inscattering_.bind(7);
      },
      device.lists, device.view, device.textures);
}

void PaperStage::upload_lights(const PaperLights& paper, std::size_t gaussians,
                               const glm::dvec3& eye) {
  std::vector<LightUniforms> uniforms;
  std::vector<float> frozen;
  frozen.reserve((paper.lights.size() + 1) * gaussians);
  const auto append = [&](const std::vector<double>& depths) {
    for (const double depth : depths) frozen.push_back(static_cast<float>(std::min(depth, 1e30)));
  };
  for (const PaperLight& light : paper.lights) {
    LightUniforms& u = uniforms.emplace_back();
    u.position = glm::vec4(glm::vec3(light.position - eye), static_cast<float>(light.h_min));
    u.intensity =
        glm::vec4(glm::vec3(light.intensity), static_cast<float>(std::exp(-light.depth_to_eye)));
    u.options.x = light.conserve_energy ? 1 : 0;
    append(light.frozen);
  }
  append(paper.from_eye);
  lights_.upload(std::span<const LightUniforms>(uniforms));
  frozen_.upload(std::span<const float>(frozen));
}

void PaperStage::upload_inscattering(const EnvironmentLight& environment) {
  std::vector<float> values;
  for (const glm::vec3& c : environment.coefficients().values()) {
    values.insert(values.end(), {c.x, c.y, c.z, 0.0f});
  }
  for (const auto& polynomial : environment.scattering().polynomials()) {
    values.insert(values.end(), polynomial.begin(), polynomial.end());
  }
  inscattering_.upload(std::span<const float>(values));
}

}  // namespace brume::gl
