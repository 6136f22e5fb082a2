#pragma once

#include <memory>
#include <string>

#include "render/frame_renderer.h"
#include "render/gl/context.h"
#include "render/gl/display_options.h"
#include "render/gl/picture_pool.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// What renders: auto_ takes gl where a GPU answers. OpenGL in software is never taken unasked: cpu
// is faster.
enum class Backend { auto_, cpu, gl };

// A renderer of that backend, or of the CPU where there is no such; `problem` then says why (auto_
// has none). `transfers` as of Renderer.
std::unique_ptr<FrameRenderer> make_renderer(Backend backend,
                                             const std::shared_ptr<const TransferStore>& transfers,
                                             std::string& problem);

// Renders frames with OpenGL: the pictures of Renderer, which it leaves to that where it cannot
// make them itself. Every frame's statistics say what ran where and why. What is kept from frame to
// frame is as there.
//
// May be called from any thread, from one at a time; the context is current during calls only.
class GlRenderer final : public FrameRenderer {
 public:
  // With a context of its own. `transfers` as of Renderer. Null where there is none that runs the
  // passes; `problem` then says why. `debug` as of EglContext.
  static std::unique_ptr<GlRenderer> create(std::shared_ptr<const TransferStore> transfers,
                                            std::string& problem, bool debug = false);
  // With a context that nobody else makes current. `pictures`: for show(), of contexts that share
  // their objects with it; null: there are none.
  static std::unique_ptr<GlRenderer> create(std::unique_ptr<gl::Context> context,
                                            std::shared_ptr<const TransferStore> transfers,
                                            std::string& problem,
                                            std::shared_ptr<gl::PicturePool> pictures = nullptr);
  ~GlRenderer() override;

  std::optional<Frame> render(const Scene& scene, const Camera& camera, const Film& film,
                              const Settings& settings, std::stop_token stop = {},
                              const std::function<void(double)>& progress = {}) override;

  // A frame whose picture stays on the device. It has no layers then, but for the depth where that
  // is asked for and there are surfaces. Without a picture it is what render() makes: it was not
  // made on the device, or there is no pool.
  struct Shown {
    Frame frame;
    std::shared_ptr<gl::DevicePicture> picture;
  };
  std::optional<Shown> show(const Scene& scene, const Camera& camera, const Film& film,
                            const Settings& settings, const gl::DisplayOptions& options,
                            std::stop_token stop = {});

  [[nodiscard]] const std::string& device_name() const;
  // Whether the device is the CPU in disguise, slower than Renderer.
  [[nodiscard]] bool is_software() const;
  [[nodiscard]] gl::Context& context();

 private:
  struct Impl;
  explicit GlRenderer(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace brume
