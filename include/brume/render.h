#pragma once

#include <cstdint>
#include <filesystem>
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

// Whether the error of a frame's airlight is measured: for at most what the picture cost, or until
// its interval is narrow, which may take many times as long. Such work is counted, not timed: what
// is chosen and measured is the same everywhere. `reference` and `path` have no error.
enum class ErrorMeasurement { none, quick, full };

// Opens at a frame's time only: no motion blur.
inline constexpr Shutter no_shutter{0.0, 0.0};

// A request for a frame; the content is in a Scene. request_options() (brume/request_options.h)
// say what each value does and may be. Defaults are those of `brume render`.
struct RenderRequest {
  // Absent: the scene's. A region's pixels have the bits that they have in the whole picture.
  std::optional<Film> film{};
  std::optional<Camera> camera{};  // absent: the scene's
  double time = 0.0;               // of the animation [s]

  AirlightMethod airlight = AirlightMethod::auto_;
  double max_error = 0.02;                  // of `auto_`: relative RMSE of the airlight
  std::optional<ErrorMeasurement> error{};  // absent: quick of `auto_`, else none
  Scattering scattering = Scattering::multiple;
  int slices = 24;
  int paths = 64;  // per pixel, 1 to limits::paths
  std::uint32_t seed = 0;
  Denoising denoise = Denoising::none;  // of `path`
  std::optional<int> airlight_scale{};  // absent: 4 of `auto_`, else 1
  bool paper_mean = false;
  bool paper_energy = false;
  bool paper_spread = false;
  double tolerance = 1e-4;

  std::optional<int> samples{};        // absent: the scene's, else chosen
  std::optional<Shutter> shutter{};    // absent: the scene's
  OutputLayers layers{};               // those besides the Frame's own go to Frame::layers
  std::optional<double> deep_error{};  // of a deep frame, see write_deep(); absent: it is none

  Backend backend = Backend::auto_;
  std::optional<int> threads{};  // at most; absent: all
};

struct DeepFileStatistics;
struct FrameInfo;

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

  // For all frames of a shot: the request with what `auto_` chooses at the request's time, and no
  // error measured if it says nothing of it; other methods stay. `progress`, throws: see render().
  std::optional<RenderRequest> choose(const Scene& scene, const RenderRequest& request,
                                      const std::stop_token& stop = {},
                                      const std::function<void(double)>& progress = {});

  // Writes the deep file of a frame that render() returned for a request with a deep_error, of the
  // same scene. nullopt, and the file as it was, if stopped. Throws InputError. Of programs in
  // Brume's tree, which know the types.
  std::optional<DeepFileStatistics> write_deep(const std::filesystem::path& file,
                                               const Scene& scene, const Frame& frame,
                                               const FrameInfo& info,
                                               const std::stop_token& stop = {},
                                               const std::function<void(double)>& progress = {});

 private:
  struct Impl;
  struct Moment;
  std::unique_ptr<Impl> impl_;
};

// The same of one frame.
BRUME_EXPORT std::optional<Frame> render(const Scene& scene, const RenderRequest& request = {},
                                         const std::stop_token& stop = {},
                                         const std::function<void(double)>& progress = {});

}  // namespace brume
