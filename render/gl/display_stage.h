#pragma once

#include <cstdint>
#include <vector>

#include "render/albedo.h"
#include "render/gl/display_options.h"
#include "render/gl/film_airlight.h"

namespace brume::gl {

// to_display() on the device.
class DisplayStage {
 public:
  // The channels of group number `which`; the last group's run shows all. `picture`: rgba8.
  void run(Programs& programs, const FilmTextures& film, const DisplayOptions& options,
           const std::vector<AlbedoGroup>& groups, std::size_t which, const Texture& picture);
  // Of Gaussian and ray, of all pixels. Waits for the device.
  std::uint64_t sum_pairs(Programs& programs, const FilmTextures& film);

 private:
  Texture channels_;  // of the groups so far
  Buffer rows_;
};

}  // namespace brume::gl
