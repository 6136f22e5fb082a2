#include "render/gl/display_stage.h"

#include "brume/frame.h"

namespace brume::gl {

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
