#pragma once

#include <memory>
#include <vector>

#include "render/frame_renderer.h"
#include "render/prepare/albedo.h"
#include "render/util/job.h"

namespace brume {

struct RenderPlan;
class TransferStore;

// The CPU renderer. Caches acceleration structures and optical depths of lights between frames, so
// a camera move is cheap; knows changes by their revisions.
class Renderer final : public FrameRenderer {
 public:
  Renderer();
  // Uses only transfer already in `transfers`; surfaces lacking it are lit without self-shadowing,
  // and the statistics say so. A default-constructed renderer computes transfer itself, which may
  // take longer than the frame.
  explicit Renderer(std::shared_ptr<const TransferStore> transfers);
  ~Renderer() override;
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  std::optional<Frame> render(const Scene& scene, const Camera& camera, const Film& film,
                              const Settings& settings, std::stop_token stop = {},
                              const std::function<void(double)>& progress = {},
                              const Motion& motion = {}) override;
  // The same by a plan of that scene and film that is already made.
  std::optional<Frame> render(const RenderPlan& plan, const Scene& scene, const Camera& camera,
                              const Film& film, const Job& job);

 private:
  struct Impl;
  std::shared_ptr<TransferStore> own_transfers_;  // null: transfers_ is shared
  std::shared_ptr<const TransferStore> transfers_;
  // One per albedo group; see albedo.h.
  std::vector<std::unique_ptr<Impl>> impls_;
  ExtinctionMedia media_;
};

}  // namespace brume
