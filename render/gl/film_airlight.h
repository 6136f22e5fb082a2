#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "render/gl/device_clock.h"
#include "render/gl/programs.h"
#include "render/gl/tile_lists.h"
#include "render/settings.h"

namespace brume::gl {

// The layers of a frame on the device.
struct FilmTextures {
  Texture depth;     // to the surface [u]; < 0: none
  Texture airlight;  // RGB, transmittance
  Texture pairs;     // Gaussians evaluated
  Buffer behind;     // RGB and a gap per pixel that surfaces send
  Texture beauty;    // RGBA

  void reserve(const Film& film);
};

// What shaders/film.glsl needs to know of a frame.
struct FilmView {
  Film film;
  const CameraRays& rays;
  double ray_end;  // of rays that hit nothing [u]; may be +inf
  double b0;
  const Settings& settings;
  std::span<const PointLight> lights;  // that nothing is interpolated beside
};

// An airlight method over the pixels of a film: film_airlight() of render/film_airlight.h.
class FilmAirlight {
 public:
  // The program runs once for each tile's pixels, and for those that upsampling asks for again;
  // `bind` sets storage blocks 0, 1, 6 and 7 for it. Its other uniforms are set. Fills the airlight
  // and the pairs. Returns the number of pixels where the method itself was asked; waits for the
  // device where airlight is upsampled.
  std::size_t run(Programs& programs, DeviceClock& clock, const Program& method,
                  const std::function<void()>& bind, TileLists& lists, const FilmView& view,
                  FilmTextures& textures);

 private:
  Texture samples_;
  Buffer asked_, totals_;
  Buffer light_offsets_, light_pixels_;
};

// Sets the uniforms of shaders/rays.glsl.
void set_rays(const Program& program, const CameraRays& rays);

}  // namespace brume::gl
