#pragma once

#include <cstdint>

#include "render/albedo.h"
#include "render/gl/film_airlight.h"

namespace brume::gl {

// What a display shows of a frame.
struct DisplayOptions {
  enum class Layer { beauty, airlight };
  Layer layer = Layer::beauty;
  double exposure = 0.0;  // [stops]
  bool depth = false;     // wanted in memory as well, where there are surfaces
};

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
