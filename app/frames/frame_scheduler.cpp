#include "app/frames/frame_scheduler.h"

#include <QWidget>
#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "app/frames/frame_services.h"
#include "app/frames/headlight.h"
#include "render/prepare/merged_medium.h"

namespace brume {
namespace {

constexpr int rest_after = 150;  // milliseconds without a change
constexpr int motion_slices = 8;
// It leaves a fiftieth of a bank's million Gaussians.
constexpr double motion_merge_error = 0.05;
// Each picture of a sequence has other Gaussians: merging that leaves more takes longer than they.
constexpr double motion_merge_share = 0.4;
// All orders of scattering, while the scene changes: from the last solution on, which is nearly
// right. The frame at rest goes on to convergence.
constexpr int motion_sweeps = 1;
// Against 20,000 nodes of 64 directions and the degrees of rest it takes a half to a quarter of the
// time, and pictures differ from those at rest by as much; on 4,000 nodes by up to three times as
// much (benchmark_gestures).
constexpr SourceGridSize motion_grid{6'000, 32};
constexpr int motion_degree = 7;
constexpr int motion_light_degree = 9;
constexpr int max_view_paths = 4096;  // per pixel
constexpr int preview_divisor = 4;

bool is_path_traced(const RenderedFrame& frame) {
  return frame.request.settings.airlight == AirlightMethod::path;
}

}  // namespace

FrameScheduler::FrameScheduler(const Document& document, FrameServices& services, const View& view,
                               const QWidget& pane)
    : document_(document), services_(services), view_(view), pane_(pane) {
  rest_timer_.setSingleShot(true);
  connect(&rest_timer_, &QTimer::timeout, this, [this] { pace(FramePacing::Event::quiet); });
  connect(&services.service, &FrameService::frame_ready, this, &FrameScheduler::use_frame);
  // Even if they are again those of the frame shown: another one may be on its way.
  connect(&quality_, &FrameQuality::settings_changed, this, [this] {
    if (pane_.isHidden() || mode_ == ViewMode::path_traced) return;
    send(frame_request(false));
  });
  connect(&quality_, &FrameQuality::failed, this, &FrameScheduler::failed);
  connect(&quality_, &FrameQuality::error_changed, this, &FrameScheduler::map_error);
  connect(&services.error_mapper, &ErrorMapper::grown, this,
          [this](const auto& frame, const auto& map) {
            if (frame != shown_ || mode_ != ViewMode::error) return;
            error_map_ = map;
            Q_EMIT picture_changed();
          });
  connect(&services.error_mapper, &ErrorMapper::failed, this, [this](const QString& message) {
    if (active_) Q_EMIT failed(message);
  });
  connect(&services.service, &FrameService::failed, this, [this] { refines_cache_ = false; });
  connect(&services.color, &ColorManagement::view_changed, this, &FrameScheduler::picture_changed);
  connect(&services.transfer_job, &TransferJob::made, this, &FrameScheduler::change_look);
  connect(&services.service, &FrameService::backend_changed, this, &FrameScheduler::change_look);
  on_change(document, Change::scene, this, [this] {
    quality_.scene_replaced();
    oldest_serial_ = serial_ + 1;
    forget_cached();
  });
  on_change(document, Change::medium | Change::part | Change::hidden_or_locked, this,
            &FrameScheduler::change_look);
}

void FrameScheduler::set_active(bool active) {
  if (active == active_) return;
  active_ = active;
  if (active) {
    services_.service.set_active(index());
    if (is_settled()) measure();
    refine();
  } else {
    quality_.stop_measuring();
    if (mode_ == ViewMode::error) services_.error_mapper.cancel();
  }
}

void FrameScheduler::set_exposure(double stops) {
  exposure_ = stops;
  Q_EMIT picture_changed();
}

DisplayLook FrameScheduler::display() const {
  return {exposure_, services_.color.view(), plate_};
}

void FrameScheduler::set_plate(const std::shared_ptr<const PlateBehind>& plate) {
  const bool other_frames = (plate == nullptr) != (plate_ == nullptr);
  plate_ = plate;
  Q_EMIT picture_changed();
  if (other_frames) change_look();
}

void FrameScheduler::set_mode(ViewMode mode) {
  if (mode == mode_) return;
  const bool other_frames = (mode == ViewMode::path_traced) != (mode_ == ViewMode::path_traced);
  mode_ = mode;
  forget_error_map();
  Q_EMIT picture_changed();
  if (other_frames) {
    services_.service.forget(index());
    quality_.stop_measuring();
    request_at_rest();
    if (is_settled()) measure();  // again, if there is no other frame yet
    refine();
  }
  map_error();
  Q_EMIT mode_changed();
}

bool FrameScheduler::is_settled() const {
  if (mode_ == ViewMode::path_traced) return shows_paths() && shown_->divisor == 1;
  return shown_ && shown_->request.serial == serial_ && is_full(*shown_);
}

// One in motion may be, where that saves nothing.
bool FrameScheduler::is_full(const RenderedFrame& frame) const {
  return frame.divisor == 1 && !frame.on_device && !frame.cached &&
         frame.request.settings == rest_settings(*frame.request.scene) &&
         frame.request.motion == Motion{};
}

bool FrameScheduler::shows_paths() const {
  return shown_ && shown_->request.serial == serial_ && is_path_traced(*shown_);
}

bool FrameScheduler::is_measured() const {
  if (!is_settled()) return false;
  return mode_ == ViewMode::path_traced ? shown_->request.settings.paths > 1
                                        : quality_.is_measured();
}

bool FrameScheduler::has_all_paths() const {
  if (mode_ != ViewMode::path_traced || !is_settled()) return false;
  const int paths = shown_->request.settings.paths;
  // Two paths without noise: there is nothing that more of them would change.
  const bool is_exact = paths > 1 && !shown_->frame.statistics.path_noise;
  return is_exact || paths >= max_view_paths;
}

// A coarse picture soon, without paths, unless there is a fine one; then all pixels with 1 path, 2,
// 4, 8 ...
void FrameScheduler::ask_for_paths(FrameRequest& request) const {
  request.settings = {};
  request.settings.airlight = AirlightMethod::path;
  request.settings.paths = 1;
  if (!shown_ || shown_->request.serial != serial_) {
    request.divisor = preview_divisor;
  } else if (shows_paths() && shown_->divisor == 1) {
    request.settings.paths = std::min(2 * shown_->request.settings.paths, max_view_paths);
  }
}

// The samples are those that are chosen, or fewer if the output has fewer.
Settings FrameScheduler::rest_settings(const Scene& scene) const {
  Settings settings = quality_.settings();
  const int most = chosen_samples(scene);
  settings.samples = std::min(document_.scene().output.samples.value_or(most), most);
  settings.background_apart = plate_ != nullptr;
  return settings;
}

void FrameScheduler::ask_in_motion(FrameRequest& request) const {
  const Scene& scene = *request.scene;
  const Settings rest = quality_.settings();
  Settings& settings = request.settings = sliced_settings(rest, motion_slices);
  Motion& motion = request.motion;
  settings.airlight = rest.airlight;
  settings.merge_error = motion_merge_error;
  settings.merge_share = motion_merge_share;
  motion.has_own_medium = MergedMedium::may_merge(scene.medium);
  if (settings.scattering == Scattering::multiple) {
    settings.scattering_limits.sweeps = motion_sweeps;
    motion.warm_start = true;
    settings.scattering_limits.degree = motion_degree;
    settings.scattering_limits.light_degree = motion_light_degree;
    settings.source_grid = motion_grid;
  }
  if (request.scene == rested_scene_) {
    // Keeps prepared data: alternating between two would rebuild it each time.
    settings.shadow_cells = rest.shadow_cells;
    if (!motion.has_own_medium) {
      settings.optical_depth_table = rest.optical_depth_table;
      settings.depth_error = rest.depth_error;
    }
    motion.any_source_precision = true;
    motion.warm_start = false;
    settings.source_grid = rest.source_grid;
    settings.scattering_limits = rest.scattering_limits;
  }
}

std::shared_ptr<const Scene> FrameScheduler::lit_scene() const {
  auto scene = view_.shown_scene();
  const bool is_paper = quality_.settings().airlight == AirlightMethod::paper;
  if (is_paper || !is_unlit(document_.scene())) return scene;  // it has no directional lights
  if (headlit_from_ != scene || headlit_camera_ != view_.camera()) {
    auto headlit = std::make_shared<Scene>(*scene);
    headlit->lights.push_back(headlight(view_.camera()));
    headlit_ = std::move(headlit);
    headlit_from_ = std::move(scene);
    headlit_camera_ = view_.camera();
  }
  return headlit_;
}

FrameRequest FrameScheduler::frame_request(bool moving) {
  check_look();
  const auto scene = lit_scene();
  FrameRequest request{.scene = scene,
                       .camera = view_.shown_camera(),
                       .film = look_.film,
                       .settings = rest_settings(*scene),
                       .display = display(),
                       .mode = mode_,
                       .view = index(),
                       .serial = serial_,
                       .moving = moving,
                       .depth = view_.shown_handles().use_depth(),
                       .headlight = scene == headlit_,
                       .time = view_.time(),
                       .look = look_count_};
  if (moving) {
    ask_in_motion(request);
  } else if (mode_ == ViewMode::path_traced) {
    ask_for_paths(request);
  }
  request.settings.background_apart = plate_ != nullptr;
  return request;
}

void FrameScheduler::send(FrameRequest request) {
  refines_cache_ = request.refines_cache;
  services_.service.request(std::move(request));
}

void FrameScheduler::request() {
  if (hold_ != Hold::none) {
    hold_ = Hold::changed;
    return;
  }
  ++serial_;
  forget_error_map();
  if (!pane_.isHidden()) pace(FramePacing::Event::change);
}

void FrameScheduler::pace(FramePacing::Event event) {
  switch (pacing_.on(event)) {
    case FramePacing::Action::none:
      return;
    case FramePacing::Action::render_in_motion:
      return render_in_motion();
    case FramePacing::Action::wait_no_longer:
      return rest_timer_.start(0);
    case FramePacing::Action::render_at_rest:
      return request_at_rest();
  }
}

void FrameScheduler::render_in_motion() {
  quality_.picture_changes(*lit_scene(), view_.shown_camera());
  services_.transfer_job.follow(document_.scene(), quality_.settings());
  if (!show_cached()) send(frame_request(true));
  rest_timer_.start(rest_after);
}

void FrameScheduler::end_gesture() {
  pace(FramePacing::Event::gesture_end);
}

void FrameScheduler::change_look() {
  if (hold_ == Hold::none) forget_cached();
  request();
}

void FrameScheduler::release() {
  if (std::exchange(hold_, Hold::none) == Hold::changed) request();
}

bool FrameScheduler::uses_cache() const {
  return mode_ == ViewMode::final || mode_ == ViewMode::airlight || mode_ == ViewMode::outlines;
}

void FrameScheduler::forget_cached() {
  ++look_count_;
  services_.cache.forget(index());
}

void FrameScheduler::check_look() {
  const QSize pixels = (QSizeF(pane_.size()) * pane_.devicePixelRatioF()).toSize();
  const Look look{.film = {std::max(1, pixels.width()), std::max(1, pixels.height())},
                  .display = display(),
                  .mode = mode_,
                  .airlight = quality_.airlight(),
                  .slices = quality_.slices(),
                  .scattering = quality_.scattering(),
                  .max_error = quality_.max_error()};
  if (look == look_) return;
  look_ = look;
  forget_cached();
}

bool FrameScheduler::show_cached() {
  check_look();
  if (!uses_cache()) return false;
  const PictureCache::Picture* kept =
      services_.cache.find(index(), view_.time(), view_.shown_camera());
  if (!kept) return false;
  const bool is_draft = !kept->full;
  auto frame = std::make_shared<RenderedFrame>(*kept->frame);
  frame->request.scene = lit_scene();
  frame->request.serial = serial_;
  frame->request.moving = true;  // the one at rest has layers, and follows
  frame->cached = true;
  shown_ = std::move(frame);
  pace(FramePacing::Event::picture);
  if (is_draft) refine_cached();
  Q_EMIT frame_shown();
  return true;
}

void FrameScheduler::refine_cached() {
  if (refines_cache_) return;
  FrameRequest request = frame_request(false);
  request.refines_cache = true;
  send(std::move(request));
}

void FrameScheduler::request_at_rest() {
  if (!is_settled() && !pane_.isHidden()) send(frame_request(false));
}

void FrameScheduler::forget() {
  refines_cache_ = false;
  services_.service.forget(index());
}

void FrameScheduler::resume() {
  if (is_settled()) {
    refine();
  } else {
    request();
  }
}

void FrameScheduler::use_frame(const std::shared_ptr<const RenderedFrame>& frame) {
  if (frame->request.view != index() || frame->request.serial < oldest_serial_) return;
  const bool at_rest = !frame->request.moving;
  // One that came too late for the mode it was made for.
  if (at_rest && is_path_traced(*frame) != (mode_ == ViewMode::path_traced)) return;
  if (frame->request.refines_cache) refines_cache_ = false;
  check_look();
  if (uses_cache() && frame->request.look == look_count_) {
    services_.cache.insert(*frame, is_full(*frame) || (at_rest && frame->divisor == 1));
  }
  // A later one may have come from the cache.
  const bool is_late = shown_ && frame->request.serial < shown_->request.serial;
  if (is_late || (frame->request.refines_cache && frame->request.serial != serial_)) return;
  shown_ = frame;
  forget_error_map();
  // Paths prepare nothing that a frame in motion could keep.
  if (at_rest && !is_path_traced(*frame)) rested_scene_ = shown_->request.scene;
  if (is_settled()) measure();
  refine();
  if (shown_->request.serial == serial_) pace(FramePacing::Event::picture);
  Q_EMIT frame_shown();
}

// One view at a time: the renderer keeps the paths of one picture.
void FrameScheduler::refine() {
  if (mode_ != ViewMode::path_traced || !active_ || pane_.isHidden() || !shows_paths()) return;
  if (!has_all_paths()) send(frame_request(false));
}

// One view at a time: each measurement takes all cores.
void FrameScheduler::measure() {
  if (active_ && mode_ != ViewMode::path_traced) quality_.frame_shown(shown_);
}

// Once the frame is measured, auto will not choose another.
void FrameScheduler::map_error() {
  if (mode_ == ViewMode::error && active_ && is_measured()) services_.error_mapper.start(shown_);
}

void FrameScheduler::forget_error_map() {
  if (active_) services_.error_mapper.cancel();
  error_map_.reset();
}

}  // namespace brume
