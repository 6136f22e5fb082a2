#include "render/gl/composite_stage.h"

#include <cmath>
#include <glm/trigonometric.hpp>

#include "core/scene/lights/radiance_map.h"

namespace brume::gl {

void CompositeStage::run(Programs& programs, const FrameContext& work, FilmTextures& textures) {
  const Program& program = programs.get("composite", ray_definitions(work.rays));
  set_rays(program, work.rays);
  program.set("film", textures.beauty.size());
  program.set("sky_size", glm::ivec2(0));
  if (work.plan.has_environment) {
    const Environment& environment = *work.scene.environment;
    const RadianceMap& map = *environment.map;
    if (map_ != environment.map) {
      map_.reset();
      std::vector<glm::vec4> texels;
      texels.reserve(map.pixels.size());
      for (const glm::vec3& pixel : map.pixels) texels.emplace_back(pixel, 0.0f);
      sky_.upload(std::span<const glm::vec4>(texels));
      map_ = environment.map;
    }
    const double angle = glm::radians(environment.rotation);
    program.set("sky_size", glm::ivec2(map.width, map.height));
    program.set("sky_rotation", glm::vec2(std::cos(angle), std::sin(angle)));
    program.set("sky_intensity", static_cast<float>(environment.intensity));
  }
  program.bind("Sky", sky_);
  program.bind("Behind", textures.behind);
  program.bind("airlight", textures.airlight);
  program.bind("beauty", textures.beauty);
  program.bind("depths", textures.depth);
  program.dispatch_over({work.frame.film.width, work.frame.film.height});
}

}  // namespace brume::gl
