#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "brume/camera.h"
#include "brume/export.h"
#include "brume/frame.h"
#include "brume/methods.h"
#include "brume/output.h"
#include "brume/scene.h"

namespace brume {

// What is asked of a frame; the content is in a Scene. Defaults are those of `brume render`.
struct RenderRequest {
  std::optional<Film> film{};      // absent: the scene's
  std::optional<Camera> camera{};  // absent: the scene's
  double time = 0.0;               // of the animation [s]

  AirlightMethod airlight = AirlightMethod::auto_;
  double max_error = 0.02;  // `auto_`: relative RMSE of the airlight, in [1e-4, 10]
  // `sliced` and `auto_`: which orders of scattering.
  Scattering scattering = Scattering::multiple;
  int slices = 24;       // `sliced`: of a view ray, 4 to 256
  int march_steps = 64;  // `march`: of a view ray, 1 to 65,536
  int paths = 64;        // `path`: per pixel, 1 to limits::paths
  // `path`: each seed gives another, independent picture.
  std::uint32_t seed = 0;

  // Of pixels that need them, 1 to limits::samples; absent: the scene's, else chosen.
  std::optional<int> samples{};
  std::optional<Shutter> shutter{};  // absent: the scene's
  OutputLayers layers{};             // those besides the Frame's own go to Frame::layers

  // Measures the error of a frame whose method does not: of all but `auto_`, which always does, and
  // `reference` and `path`, which have none. Takes seconds, with area lights up to a minute.
  bool measure_error = false;

  Backend backend = Backend::auto_;
  int threads = 0;  // at most; 0: all
};

// Renders frames of scenes, one at a time, and keeps between them what did not change: of a camera
// or a light that moves, only what depends on it is computed again. A frame does not depend on what
// was rendered before.
class BRUME_EXPORT SceneRenderer {
 public:
  SceneRenderer();
  ~SceneRenderer();
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) noexcept;

  // nullopt if `stop` was requested. `progress` gets the completed fraction in [0, 1], from
  // the rendering threads, one call at a time. Throws DomainError for what is asked,
  // std::bad_alloc.
  std::optional<Frame> render(const Scene& scene, const RenderRequest& request = {},
                              const std::stop_token& stop = {},
                              const std::function<void(double)>& progress = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The same of one frame.
BRUME_EXPORT std::optional<Frame> render(const Scene& scene, const RenderRequest& request = {},
                                         const std::stop_token& stop = {},
                                         const std::function<void(double)>& progress = {});

}  // namespace brume
