#pragma once

#include <memory>
#include <string>

#include "brume/methods.h"
#include "render/frame_renderer.h"
#include "render/gl/context.h"
#include "render/gl/display_options.h"
#include "render/gl/picture_pool.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// Creates a renderer; falls back to the CPU with the reason in `problem` (not with auto_).
// `transfers`: see Renderer.
std::unique_ptr<FrameRenderer> make_renderer(Backend backend,
                                             const std::shared_ptr<const TransferStore>& transfers,
                                             std::string& problem);

// Renders frames with OpenGL, matching Renderer, to which it falls back for unsupported frames.
// Statistics say what ran where and why. Caches like Renderer.
//
// May be called from any thread, one at a time; the context is current during calls only.
class GlRenderer final : public FrameRenderer {
 public:
  // Creates its own context. Null if no suitable device, with the reason in `problem`. `transfers`:
  // see Renderer; `debug`: see EglContext.
  static std::unique_ptr<GlRenderer> create(std::shared_ptr<const TransferStore> transfers,
                                            std::string& problem, bool debug = false);
  // Uses a context that is not used elsewhere. `pictures`: for show(), of contexts that share
  // objects with it; may be null.
  static std::unique_ptr<GlRenderer> create(std::unique_ptr<gl::Context> context,
                                            std::shared_ptr<const TransferStore> transfers,
                                            std::string& problem,
                                            std::shared_ptr<gl::PicturePool> pictures = nullptr);
  ~GlRenderer() override;

  std::optional<Frame> render(const Scene& scene, const Camera& camera, const Film& film,
                              const Settings& settings, std::stop_token stop = {},
                              const std::function<void(double)>& progress = {},
                              const Motion& motion = {}) override;

  // A frame of a whole film whose picture stays on the device. It has no layers except, on request,
  // the depth.
  // Without a picture (fallback, or no pool) it equals the result of render().
  struct DisplayFrame {
    Frame frame;
    std::shared_ptr<gl::DevicePicture> picture;
  };
  std::optional<DisplayFrame> show(const Scene& scene, const Camera& camera, const Film& film,
                                   const Settings& settings, const gl::DisplayOptions& options,
                                   std::stop_token stop = {}, const Motion& motion = {});

  [[nodiscard]] const std::string& device_name() const;
  // Whether the device is a software renderer, slower than Renderer.
  [[nodiscard]] bool is_software() const;
  [[nodiscard]] gl::Context& context();

 private:
  struct Impl;
  explicit GlRenderer(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace brume
