#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/scene/scene.h"
#include "render/frame.h"
#include "render/settings.h"

namespace brume {

class TransferStore;

// Renders frames of scenes on the CPU. Keeps between frames what has not changed (ray-tracing and
// culling structures, optical depths from lights), so rendering again after a camera move is
// cheap; what changed is found by comparing values. Not thread-safe: one frame at a time.
class Renderer {
 public:
  Renderer();
  // Takes the radiance transfer that surfaces ask for from there and makes none: where it is
  // missing, surfaces are lit without, and the statistics say so. A renderer without makes its own,
  // which may take longer than the frame.
  explicit Renderer(std::shared_ptr<const TransferStore> transfers);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  // The frame that `camera` sees on `film` (the scene's own are not used). Every value of the
  // frame is finite except the depth where nothing is hit. nullopt if `stop` was requested.
  // `progress` hears the share that is done, in [0, 1], from the rendering threads, one at a time.
  std::optional<Frame> render(const Scene& scene, const Camera& camera, const Film& film,
                              const Settings& settings, std::stop_token stop = {},
                              const std::function<void(double)>& progress = {});

 private:
  struct Impl;
  std::shared_ptr<TransferStore> own_transfers_;  // null: those of another
  std::shared_ptr<const TransferStore> transfers_;
  // One for each albedo among the colour channels; see albedo.h.
  std::vector<std::unique_ptr<Impl>> impls_;
};

}  // namespace brume
