#pragma once

#include <QImage>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

#include "app/frames/view_mode.h"
#include "app/jobs/background_job.h"
#include "brume/frame.h"
#include "brume/scene.h"
#include "render/gl_renderer.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"

namespace brume {

struct FrameRequest {
  std::shared_ptr<const Scene> scene;
  Camera camera;
  Film film;  // full resolution
  Settings settings;
  Motion motion{};
  DisplayLook display;
  ViewMode mode = ViewMode::final;
  int view = 0;              // index of the view
  std::uint64_t serial = 0;  // identifies the state of scene, camera and film
  bool moving = false;       // interactive: may reduce resolution and omit layers
  int divisor = 1;           // at rest: of the resolution
  bool depth = true;         // request the depth layer nevertheless
  bool headlight = false;    // the scene has a light that the document lacks
  double time = 0.0;         // [s] of the scene
  // Counts what the view shows besides the time: frames of another do not go to the cache.
  std::uint64_t look = 0;
  bool refines_cache = false;  // at rest, during playback: to be shown when its time comes again
};

struct RenderedFrame {
  FrameRequest request;
  Frame frame;     // in motion at most the depth layer, and none without surfaces
  QImage picture;  // null if on the device
  std::shared_ptr<gl::DevicePicture> on_device;  // null: picture and frame are complete
  bool cached = false;                           // by PictureCache: a picture alone
  int divisor = 1;
  double milliseconds = 0.0;
};

// Renders for all views in a background thread: the latest request of each view, the active view
// first. A frame at rest is cancelled by newer requests of its view or the active one; a frame in
// motion is short and completes, to give feedback while dragging. Path-traced frames at full
// resolution take long, and come after all others.
class FrameService : public QObject {
  Q_OBJECT
 public:
  // Creates an OpenGL context that shares objects with the views, in the service's thread. May be
  // empty or return null.
  using MakeContext = std::function<std::unique_ptr<gl::Context>()>;

  // `transfers` as of Renderer.
  explicit FrameService(std::shared_ptr<const TransferStore> transfers,
                        MakeContext make_context = {}, QObject* parent = nullptr);
  ~FrameService() override;  // cancels the current frame

  void request(FrameRequest request);
  void forget(int view);  // drops its pending requests
  void set_active(int view);

  // Render device of the following frames; auto_ initially. Retries a failed device, even if
  // unchanged.
  void set_backend(Backend backend);
  [[nodiscard]] Backend backend() const { return backend_; }

 Q_SIGNALS:
  void backend_changed();
  void frame_ready(std::shared_ptr<const brume::RenderedFrame> frame);
  void failed(const QString& message);

 private:
  void work(const Job& job, const std::shared_ptr<const TransferStore>& transfers,
            const MakeContext& make_context);
  int motion_divisor(const Film& film) const;
  [[nodiscard]] int priority(const FrameRequest& request) const;

  std::mutex mutex_;
  std::condition_variable_any wake_;
  int active_ = 0;
  std::map<int, FrameRequest> pending_;  // by view
  std::optional<FrameRequest> running_;
  std::stop_source stop_frame_;
  // The last frame in motion took: for all that does not depend on the resolution, and the rest; 0
  // initially.
  double fixed_milliseconds_ = 0.0;
  double milliseconds_per_pixel_ = 0.0;
  Backend backend_ = Backend::auto_;
  std::uint64_t backend_choice_ = 1;  // counts set_backend()
  BackgroundJob job_{BackgroundJob::Policy::one_at_a_time};
};

}  // namespace brume
