#pragma once

#include <QTimer>

#include "app/frames/error_map.h"
#include "app/frames/frame_pacing.h"
#include "app/frames/frame_quality.h"
#include "app/frames/frame_service.h"
#include "app/view/view.h"

namespace brume {

struct FrameServices;

inline constexpr double max_exposure = 20.0;  // of a view, stops either way

// The frames of one view: when to request which, and what is displayed of them.
class FrameScheduler : public QObject {
  Q_OBJECT
 public:
  // `pane`: the widget that displays them.
  FrameScheduler(const Document& document, FrameServices& services, const View& view,
                 const QWidget& pane);

  // Something that changes the picture: requests a frame soon, the full one once the view rests.
  // None for a hidden pane.
  void request();
  // The gesture has ended: the full frame follows the last picture of it at once.
  void end_gesture();
  void change_look();  // the same, for what is not due to the time
  void forget();       // drops what is pending
  void resume();       // after forget(): requests what is missing
  // Changes of time: until release(), all that changes is due to the time, and requested at once
  // then.
  void hold() {
    if (hold_ == Hold::none) hold_ = Hold::held;
  }
  void release();
  // Whether it is the view that keys, panels and the error meter are about.
  void set_active(bool active);

  [[nodiscard]] double exposure() const { return exposure_; }
  void set_exposure(double stops);
  [[nodiscard]] DisplayLook display() const;  // with the view that all share, and the plate
  // Behind the fog; null: none.
  void set_plate(const std::shared_ptr<const PlateBehind>& plate);
  [[nodiscard]] ViewMode mode() const { return mode_; }
  void set_mode(ViewMode mode);

  // Render settings and error.
  [[nodiscard]] FrameQuality& quality() { return quality_; }
  [[nodiscard]] const FrameQuality& quality() const { return quality_; }

  // The displayed frame; nullptr initially. May have no layers in motion.
  [[nodiscard]] const RenderedFrame* shown() const { return shown_.get(); }
  // Whether it is up to date at full resolution; path-traced, with any number of paths.
  [[nodiscard]] bool is_settled() const;
  // Whether its error is known too, so auto has settled; of a path-traced one, its noise.
  [[nodiscard]] bool is_measured() const;
  // Whether it is path-traced, and gets no more paths.
  [[nodiscard]] bool has_all_paths() const;
  // Error map of the displayed frame; may be incomplete; nullptr if not shown.
  [[nodiscard]] const ErrorMap* error_map() const { return error_map_.get(); }

 Q_SIGNALS:
  void frame_shown();      // another frame is to be displayed
  void picture_changed();  // the same frame, in another way
  void mode_changed();
  void failed(const QString& message);

 private:
  [[nodiscard]] bool shows_paths() const;  // of the present state
  // At full resolution with the settings for rest, and all its layers.
  [[nodiscard]] bool is_full(const RenderedFrame& frame) const;
  void ask_for_paths(FrameRequest& request) const;
  // With samples of edges, which frames in motion do without.
  [[nodiscard]] Settings rest_settings(const Scene& scene) const;
  void ask_in_motion(FrameRequest& request) const;
  [[nodiscard]] FrameRequest frame_request(bool moving);
  void send(FrameRequest request);
  // The cache is for what keeps its look while it plays, and needs no layers.
  [[nodiscard]] bool uses_cache() const;
  void forget_cached();
  void check_look();     // forgets what is cached if the pane looks otherwise now
  bool show_cached();    // of the present state; false: there is none
  void refine_cached();  // renders it at rest, one at a time
  [[nodiscard]] std::shared_ptr<const Scene> lit_scene() const;  // by a headlight if unlit
  [[nodiscard]] int index() const { return static_cast<int>(view_.projection()); }
  void pace(FramePacing::Event event);
  void render_in_motion();
  void request_at_rest();
  void use_frame(const std::shared_ptr<const RenderedFrame>& frame);
  void refine();  // more paths, where they are shown
  void measure();
  void map_error();  // if visible and idle
  void forget_error_map();

  const Document& document_;
  FrameServices& services_;
  const View& view_;
  const QWidget& pane_;
  bool active_ = false;
  double exposure_ = 0.0;
  std::shared_ptr<const PlateBehind> plate_;
  ViewMode mode_ = ViewMode::final;
  std::uint64_t serial_ = 0;         // of the current state
  std::uint64_t oldest_serial_ = 0;  // older frames belong to another scene
  std::shared_ptr<const RenderedFrame> shown_;
  // Cached pictures were made for this.
  struct Look {
    Film film;
    DisplayLook display;
    ViewMode mode = ViewMode::final;
    AirlightMethod airlight = AirlightMethod::auto_;
    int slices = 0;
    Scattering scattering = Scattering::multiple;
    double max_error = 0.0;
    bool operator==(const Look&) const = default;
  };
  Look look_;
  std::uint64_t look_count_ = 0;                               // see FrameRequest
  enum class Hold { none, held, changed } hold_ = Hold::none;  // see hold()
  FramePacing pacing_;
  bool refines_cache_ = false;                 // one for the cache is on its way
  std::shared_ptr<const ErrorMap> error_map_;  // of the displayed frame
  std::shared_ptr<const Scene> rested_scene_;  // of the last frame at rest
  // Cache of lit_scene(), and what it was made from.
  mutable std::shared_ptr<const Scene> headlit_;
  mutable std::shared_ptr<const Scene> headlit_from_;
  mutable Camera headlit_camera_;
  QTimer rest_timer_;
  FrameQuality quality_;
};

}  // namespace brume
