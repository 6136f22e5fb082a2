#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "brume/scene.h"
#include "core/scene/camera_rays.h"
#include "render/gl/device_clock.h"
#include "render/gl/programs.h"
#include "render/gl/tile_lists.h"
#include "render/render_plan.h"
#include "render/simd/gaussian_kernels.h"

namespace brume::gl {

// The layers of a frame as textures.
struct FilmTextures {
  Texture depth;     // distance to the surface [u]; < 0: none
  Texture airlight;  // RGB, transmittance
  Texture pairs;     // Gaussians evaluated per pixel
  Buffer behind;     // outgoing radiance of surfaces, RGB and padding per pixel
  Texture beauty;    // RGBA

  void reserve(const Film& film);
};

// Inputs of shaders/film.glsl.
struct FilmView {
  Film film;
  const CameraRays& rays;
  double ray_end;  // length of rays that hit nothing [u]; may be +inf
  BatchFog fog;
  const RenderPlan& plan;
  std::optional<double> airlight_rms;  // absent: that of the samples
};

// Runs an airlight method over the pixels of a film; device counterpart of film_airlight()
// (render/cpu/film_airlight.h).
class FilmAirlight {
 public:
  // Dispatches `method` for all tiles, and again for pixels that upsampling requests; `bind` binds
  // what film.glsl and tile_list.glsl do not have. Its other uniforms must be set. Fills airlight
  // and pairs. Returns the number of pixels evaluated exactly; waits for the device if airlight is
  // upsampled.
  std::size_t run(Programs& programs, DeviceClock& clock, const Program& method,
                  const std::function<void()>& bind, TileLists& lists, const FilmView& view,
                  FilmTextures& textures);

 private:
  Texture samples_;
  Buffer requests_, totals_, curved_cells_;
  Buffer light_offsets_, light_pixels_;
};

// Programs that include shaders/rays.glsl are defined PARALLEL for an orthographic camera.
std::string ray_definitions(const CameraRays& rays);
// Sets the uniforms of shaders/rays.glsl.
void set_rays(const Program& program, const CameraRays& rays);
// The uniforms of fog: of shaders/view_fog.glsl, or of surfaces.
void set_fog(const Program& program, const BatchFog& fog);

}  // namespace brume::gl
