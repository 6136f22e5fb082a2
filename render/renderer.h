#pragma once

#include <memory>
#include <vector>

#include "render/frame_renderer.h"

namespace brume {

class TransferStore;

// Renders frames of scenes on the CPU. Keeps between frames what has not changed (ray-tracing and
// culling structures, optical depths from lights), so rendering again after a camera move is
// cheap; what changed is found by comparing values.
class Renderer final : public FrameRenderer {
 public:
  Renderer();
  // Takes the radiance transfer that surfaces ask for from there and makes none: where it is
  // missing, surfaces are lit without, and the statistics say so. A renderer without makes its own,
  // which may take longer than the frame.
  explicit Renderer(std::shared_ptr<const TransferStore> transfers);
  ~Renderer() override;
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  std::optional<Frame> render(const Scene& scene, const Camera& camera, const Film& film,
                              const Settings& settings, std::stop_token stop = {},
                              const std::function<void(double)>& progress = {}) override;

 private:
  struct Impl;
  std::shared_ptr<TransferStore> own_transfers_;  // null: those of another
  std::shared_ptr<const TransferStore> transfers_;
  // One for each albedo among the colour channels; see albedo.h.
  std::vector<std::unique_ptr<Impl>> impls_;
};

}  // namespace brume
