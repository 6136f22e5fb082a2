#include "app/viewport/frame_service.h"

#include <QElapsedTimer>
#include <algorithm>
#include <exception>

namespace brume {
namespace {

constexpr double motion_budget = 33.0;  // milliseconds: about 30 frames a second
constexpr int first_divisor = 4;        // while the cost of a pixel is unknown
constexpr int max_divisor = 6;          // coarser than this shows nothing any more

Film divided(const Film& film, int divisor) {
  return {std::max(1, film.width / divisor), std::max(1, film.height / divisor)};
}

}  // namespace

FrameService::FrameService(std::shared_ptr<const TransferStore> transfers, QObject* parent)
    : QObject(parent),
      thread_([this, transfers = std::move(transfers)](const std::stop_token& quit) {
        work(quit, transfers);
      }) {}

FrameService::~FrameService() {
  thread_.request_stop();
  {
    const std::scoped_lock lock(mutex_);
    stop_frame_.request_stop();
  }
  thread_.join();
}

void FrameService::request(FrameRequest request) {
  const std::scoped_lock lock(mutex_);
  const int view = request.view;
  if (running_) {
    const FrameRequest& now = running_->request;
    // The same state at full quality is already on its way.
    if (now.view == view && now.serial == request.serial && running_->divisor == 1 &&
        now.settings == request.settings && !stop_frame_.stop_requested()) {
      pending_.erase(view);
      return;
    }
    if (!now.moving && (now.view == view || view == active_)) {
      if (now.view != view) pending_.try_emplace(now.view, now);
      stop_frame_.request_stop();
    }
  }
  pending_.insert_or_assign(view, std::move(request));
  wake_.notify_one();
}

void FrameService::forget(int view) {
  const std::scoped_lock lock(mutex_);
  pending_.erase(view);
  if (running_ && running_->request.view == view) stop_frame_.request_stop();
}

void FrameService::set_active(int view) {
  const std::scoped_lock lock(mutex_);
  active_ = view;
}

void FrameService::set_backend(Backend backend) {
  {
    const std::scoped_lock lock(mutex_);
    backend_ = backend;
    ++backend_choice_;
  }
  Q_EMIT backend_changed();
}

int FrameService::motion_divisor(const Film& film) const {
  if (milliseconds_per_pixel_ == 0.0) return first_divisor;
  for (int divisor = 1; divisor < max_divisor; ++divisor) {
    const Film part = divided(film, divisor);
    if (milliseconds_per_pixel_ * part.width * part.height <= motion_budget) return divisor;
  }
  return max_divisor;
}

void FrameService::work(const std::stop_token& quit,
                        const std::shared_ptr<const TransferStore>& transfers) {
  std::unique_ptr<FrameRenderer> renderer;
  std::string problem;  // why it is not what was asked for
  std::uint64_t made_for = 0;
  while (true) {
    FrameRequest request;
    int divisor = 1;
    Backend backend = Backend::auto_;
    std::uint64_t choice = 0;
    std::stop_token stop;
    {
      std::unique_lock lock(mutex_);
      running_.reset();
      if (!wake_.wait(lock, quit, [this] { return !pending_.empty(); })) return;
      auto next = pending_.find(active_);
      if (next == pending_.end()) next = pending_.begin();
      request = std::move(next->second);
      pending_.erase(next);
      if (request.moving) divisor = motion_divisor(request.film);
      running_ = Running{request, divisor};
      stop_frame_ = std::stop_source();
      if (quit.stop_requested()) return;
      stop = stop_frame_.get_token();
      backend = backend_;
      choice = backend_choice_;
    }
    try {
      if (made_for != choice) {
        renderer.reset();
        problem.clear();
        renderer = make_renderer(backend, transfers, problem);
        made_for = choice;
        milliseconds_per_pixel_ = 0.0;
      }
      QElapsedTimer timer;
      timer.start();
      const Film film = divided(request.film, divisor);
      auto frame = renderer->render(*request.scene, request.camera, film, request.settings, stop);
      if (!frame) continue;
      if (!problem.empty()) frame->statistics.on_cpu = {{"frame", problem}};
      auto rendered = std::make_shared<RenderedFrame>();
      rendered->picture = to_picture(*frame, request.exposure, request.mode);
      rendered->milliseconds = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
      rendered->divisor = divisor;
      rendered->frame = std::move(*frame);
      rendered->request = std::move(request);
      if (rendered->request.moving) {  // at rest pixels may cost more
        milliseconds_per_pixel_ = rendered->milliseconds / (film.width * film.height);
      }
      QMetaObject::invokeMethod(
          this, [this, rendered] { Q_EMIT frame_ready(rendered); }, Qt::QueuedConnection);
    } catch (const std::exception& error) {
      const QString message = QString::fromUtf8(error.what());
      QMetaObject::invokeMethod(
          this, [this, message] { Q_EMIT failed(message); }, Qt::QueuedConnection);
    }
  }
}

}  // namespace brume
