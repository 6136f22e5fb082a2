#include "render/gl/paper_stage.h"

#include <algorithm>
#include <cmath>

#include "render/geometry/ray_range.h"

namespace brume::gl {
std::size_t PaperStage::run(FrameStages& stages, FrameContext& work, StageClock& clock,
                            DeviceFrame& device) {
  const MediumIndex& medium = stages.prepared().medium();
  const PaperLights paper = device.arena.execute([&] { return stages.paper_lights(work, clock); });
  const EnvironmentLight* environment = stages.shading().environment();
  upload_lights(paper, medium.size(), work.rays.eye());
  if (environment) upload_inscattering(*environment);

  const Program& program =
      device.programs.get("paper", device.medium.defined() + ray_definitions(work.rays));
  set_noise(program, medium.noise(), work.rays.eye());
  program.set("light_count", static_cast<int>(paper.lights.size()));
  program.set("gaussian_count", static_cast<int>(medium.size()));
  set_fog(program, device.view.fog);
  program.set("anisotropy", static_cast<float>(medium.anisotropy()));
  program.set("at_mean", paper.at_mean ? 1 : 0);
  program.set("conserves", std::ranges::any_of(paper.lights, &PaperLight::conserve_energy) ? 1 : 0);
  program.set("has_inscattering", environment ? 1 : 0);
  return film_.run(
      device.programs, device.clock, program,
      [&] {
        program.bind("Lights", lights_);
        program.bind("Frozen", frozen_);
        program.bind("Inscattering", inscattering_);
      },
      device.lists, device.view, device.textures);
}

void PaperStage::upload_lights(const PaperLights& paper, std::size_t gaussians,
                               const glm::dvec3& eye) {
  std::vector<PaperLightData> data;
  std::vector<float> frozen;
  frozen.reserve((paper.lights.size() + 1) * gaussians);
  const auto append = [&](const std::vector<double>& depths) {
    for (const double depth : depths)
      frozen.push_back(static_cast<float>(std::min(depth, endless)));
  };
  for (const PaperLight& light : paper.lights) {
    PaperLightData& u = data.emplace_back();
    u.position = glm::vec3(light.position - eye);
    u.h_min = static_cast<float>(light.h_min);
    u.intensity = glm::vec3(light.intensity);
    u.transmittance = static_cast<float>(std::exp(-light.depth_to_eye));
    u.conserves_energy = light.conserve_energy ? 1 : 0;
    append(light.frozen);
  }
  append(paper.from_eye);
  lights_.upload(std::span<const PaperLightData>(data));
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
