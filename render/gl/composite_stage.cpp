#include "render/gl/composite_stage.h"

#include <cmath>
#include <glm/trigonometric.hpp>

#include "brume/frame.h"
#include "core/scene/lights/radiance_map.h"
#include "render/visibility/holdout.h"

namespace brume::gl {

void CompositeStage::run(Programs& programs, const FrameContext& work, MeshBuffers& mesh,
                         FilmTextures& textures) {
  const bool holds_out = work.plan.runs(Stage::visibility) && has_holdouts(work.scene.surfaces);
  const Program& program =
      programs.get("composite", (holds_out ? " HOLDOUTS" : "") + ray_definitions(work.rays));
  if (holds_out) {
    std::vector<std::uint32_t> held_out;
    for (const Surface& surface : work.scene.surfaces) held_out.push_back(surface.holdout ? 1 : 0);
    held_out_.upload(std::span<const std::uint32_t>(held_out));
    program.bind("HeldOut", held_out_);
    program.bind("Hits", mesh.hits());
    mesh.bind(program);
  }
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

void DisplayStage::run(Programs& programs, const FilmTextures& film, const DisplayOptions& options,
                       const glm::ivec2& first_pixel, const AlbedoGroup& group, bool is_first,
                       bool is_last, const Texture& picture) {
  glm::vec3 channels(0.0f);
  for (const std::size_t c : group.channels) channels[static_cast<int>(c)] = 1.0f;
  if (!is_first || !is_last) channels_.reserve(Texture::Format::rgba32f, picture.size());
  const Program& program = programs["display"];
  program.set("albedo", static_cast<float>(group.albedo));
  program.set("channels", channels);
  program.set("airlight_only", options.layer == DisplayOptions::Layer::airlight ? 1 : 0);
  program.set("is_first", is_first ? 1 : 0);
  program.set("is_last", is_last ? 1 : 0);
  program.set("gain", exposure_gain(options.exposure));
  program.set("first_pixel", first_pixel);
  program.bind("airlight", film.airlight);
  program.bind("beauty", film.beauty);
  program.bind("channels_so_far", channels_);
  program.bind("picture", picture);
  program.dispatch_over(picture.size());
}

std::uint64_t DisplayStage::sum_pairs(Programs& programs, const FilmTextures& film) {
  std::vector<float> rows(static_cast<std::size_t>(film.pairs.size().y));
  rows_.reserve(rows.size() * sizeof(float));
  const Program& program = programs["sum_pairs"];
  program.set("width", film.pairs.size().x);
  program.bind("pairs", film.pairs);
  program.bind("Rows", rows_);
  program.dispatch(rows.size());
  rows_.download(std::span<float>(rows));
  double sum = 0.0;
  for (const float row : rows) sum += static_cast<double>(row);
  return static_cast<std::uint64_t>(sum);
}

}  // namespace brume::gl
