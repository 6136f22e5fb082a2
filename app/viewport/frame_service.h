#pragma once

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "app/viewport/view_mode.h"
#include "core/scene/scene.h"
#include "render/frame.h"
#include "render/gl/gl_renderer.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"

namespace brume {

struct FrameRequest {
  std::shared_ptr<const Scene> scene;
  Camera camera;
  Film film;  // the full resolution
  Settings settings;
  double exposure = 0.0;  // stops
  ViewMode mode = ViewMode::final;
  int view = 0;              // whose it is
  std::uint64_t serial = 0;  // names the state of scene, camera and film that this shows
  bool moving = false;       // may take a lower resolution to stay fluid, and leave out layers
  bool depth = true;         // a layer that is wanted even so
};

struct RenderedFrame {
  FrameRequest request;
  Frame frame;  // of one in motion only the depth may be there, and not even that without surfaces
  QImage picture;  // as the mode wants it; null where it is on the device
  std::shared_ptr<gl::DevicePicture> on_device;  // null: picture is there, and all of the frame
  int divisor = 1;
  double milliseconds = 0.0;
};

// Renders for all views, in a thread of its own: of each view the newest request counts, the ones
// between are never rendered, and the active view comes first. A frame at rest is given up as soon
// as something newer is asked for that view or anything for the active one; one in motion is short
// and is let finish, or else nothing would be seen until the mouse stands still.
class FrameService : public QObject {
  Q_OBJECT
 public:
  // Makes a context that shares its objects with those of the views, in the service's thread. May
  // be null, and may say so.
  using MakeContext = std::function<std::unique_ptr<gl::Context>()>;

  // `transfers` as of Renderer.
  explicit FrameService(std::shared_ptr<const TransferStore> transfers,
                        MakeContext make_context = {}, QObject* parent = nullptr);
  ~FrameService() override;  // gives up the frame in flight

  void request(FrameRequest request);
  void forget(int view);  // what was asked for it and is not there yet
  void set_active(int view);

  // What renders from the next frame on; auto_ at first. Gives a device that has failed another
  // chance, even if it is the same as before.
  void set_backend(Backend backend);
  [[nodiscard]] Backend backend() const { return backend_; }

 Q_SIGNALS:
  void backend_changed();
  void frame_ready(std::shared_ptr<const brume::RenderedFrame> frame);
  void failed(const QString& message);

 private:
  void work(const std::stop_token& quit, const std::shared_ptr<const TransferStore>& transfers,
            const MakeContext& make_context);
  int motion_divisor(const Film& film) const;

  std::mutex mutex_;
  std::condition_variable_any wake_;
  int active_ = 0;
  std::map<int, FrameRequest> pending_;  // by view
  std::optional<FrameRequest> running_;
  std::stop_source stop_frame_;
  double milliseconds_per_pixel_ = 0.0;  // of the last frame in motion; 0 before the first
  Backend backend_ = Backend::auto_;
  std::uint64_t backend_choice_ = 1;  // counts set_backend()
  std::jthread thread_;
};

}  // namespace brume
