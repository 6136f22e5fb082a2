#include "app/frames/frame_service.h"

#include <QElapsedTimer>
#include <algorithm>
#include <exception>
#include <utility>

#include "render/gl/egl_context.h"
#include "render/samples/denoised_frame.h"

namespace brume {
namespace {

constexpr double motion_budget = 33.0;  // milliseconds: about 30 frames a second
// Pixels get at least this share of it: fewer would not save what takes longer than all of it.
constexpr double min_pixel_share = 0.5;
constexpr int first_divisor = 4;  // while the cost of a pixel is unknown
constexpr int max_divisor = 6;    // coarser than this shows nothing any more

Film divided(const Film& film, int divisor) {
  return {std::max(1, film.width / divisor), std::max(1, film.height / divisor)};
}

double milliseconds_of_any_resolution(const FrameStatistics& statistics) {
  static const StageSet stages{Stage::transfer,    Stage::prepare,     Stage::environment,
                               Stage::light_depth, Stage::light_table, Stage::scattering,
                               Stage::shadow_map};
  double sum = 0.0;
  for (const StageTime& time : statistics.stages) {
    if (stages.has(time.stage)) sum += time.milliseconds;
  }
  return sum;
}

// The chosen renderer, and the pictures that it leaves on the device.
class ChosenRenderer {
 public:
  ChosenRenderer() = default;
  ChosenRenderer(Backend backend, const std::shared_ptr<const TransferStore>& transfers,
                 const FrameService::MakeContext& make_context,
                 const std::shared_ptr<gl::PicturePool>& pictures) {
    auto sharing = sharing_renderer(backend, transfers, make_context, pictures);
    sharing_ = sharing.get();
    renderer_ = std::move(sharing);
    if (!renderer_) renderer_ = make_renderer(backend, transfers, problem_);
  }

  // Null if stopped.
  std::shared_ptr<RenderedFrame> render(const FrameRequest& request, const Film& film,
                                        const std::stop_token& stop) {
    auto rendered = std::make_shared<RenderedFrame>();
    auto options =
        sharing_ && request.moving ? display_options(request.display, request.mode) : std::nullopt;
    const Scene& scene = *request.scene;
    if (options) {
      options->depth = request.depth;
      auto shown = sharing_->show(scene, request.camera, film, request.settings, *options, stop,
                                  request.motion);
      if (!shown) return nullptr;
      rendered->frame = std::move(shown->frame);
      rendered->on_device = std::move(shown->picture);
    } else {
      auto frame = request.settings.airlight == AirlightMethod::path
                       ? trace(request, film, stop)
                       : renderer_->render(scene, request.camera, film, request.settings, stop, {},
                                           request.motion);
      if (!frame) return nullptr;
      rendered->frame = std::move(*frame);
    }
    if (!problem_.empty()) rendered->frame.statistics.on_cpu = {{Stage::frame, problem_}};
    if (!rendered->on_device) {
      rendered->picture = to_picture(rendered->frame, request.display, request.mode);
    }
    return rendered;
  }

 private:
  // Null where another is better: OpenGL in software is not taken unasked, and not where there is a
  // GPU that the views do not use.
  static std::unique_ptr<GlRenderer> sharing_renderer(
      Backend backend, const std::shared_ptr<const TransferStore>& transfers,
      const FrameService::MakeContext& make_context,
      const std::shared_ptr<gl::PicturePool>& pictures) {
    if (backend == Backend::cpu || !make_context) return nullptr;
    auto context = make_context();
    if (!context) return nullptr;
    std::string problem;
    auto renderer = GlRenderer::create(std::move(context), transfers, problem, pictures);
    if (!renderer || !renderer->is_software()) return renderer;
    const bool better =
        backend == Backend::auto_ || EglContext::create(nullptr, false, EglContext::Devices::gpu);
    return better ? nullptr : std::move(renderer);
  }

  // The picture by paths begins with the solved one, which a coarse one is alone.
  std::optional<Frame> trace(const FrameRequest& request, const Film& film,
                             const std::stop_token& stop) {
    const Scene& scene = *request.scene;
    const auto solve = [&] {
      Settings settings = solved_settings(solved_slices);
      settings.background_apart = request.settings.background_apart;
      return renderer_->render(scene, request.camera, film, settings, stop);
    };
    if (request.divisor != 1) return solve();
    const auto is_known = [&] {
      return traced_ && traced_->view == request.view && traced_->serial == request.serial &&
             2 * traced_->paths == request.settings.paths;
    };
    if (!is_known()) {
      traced_.reset();
      std::optional<Frame> solved = solve();
      if (!solved) return std::nullopt;
      traced_.emplace(Traced{request.view, request.serial, 0, DenoisedView(*solved)});
    }
    std::optional<Frame> frame =
        renderer_->render(scene, request.camera, film, request.settings, stop);
    if (!frame) return std::nullopt;
    traced_->paths = request.settings.paths;
    traced_->denoised.denoise(*frame, {stop, {}});
    if (!stop.stop_requested()) return frame;
    traced_.reset();
    return std::nullopt;
  }

  static constexpr int solved_slices = 24;

  // The view that was traced last.
  struct Traced {
    int view;
    std::uint64_t serial;
    int paths;  // per pixel
    DenoisedView denoised;
  };

  std::optional<Traced> traced_;
  std::unique_ptr<FrameRenderer> renderer_;
  GlRenderer* sharing_ = nullptr;  // the same, where its pictures are for the views
  std::string problem_;            // why it is not what was asked for
};

}  // namespace

FrameService::FrameService(std::shared_ptr<const TransferStore> transfers, MakeContext make_context,
                           QObject* parent)
    : QObject(parent) {
  job_.start([this, transfers = std::move(transfers),
              make_context = std::move(make_context)](const Job& job) -> BackgroundJob::Apply {
    work(job, transfers, make_context);
    return {};
  });
}

FrameService::~FrameService() {
  job_.cancel();
  const std::scoped_lock lock(mutex_);
  stop_frame_.request_stop();
}

void FrameService::request(FrameRequest request) {
  const std::scoped_lock lock(mutex_);
  const int view = request.view;
  if (running_) {
    const FrameRequest& now = *running_;
    // The same state at full quality is already on its way.
    if (now.view == view && now.serial == request.serial && !now.moving &&
        now.settings == request.settings && now.motion == request.motion &&
        now.divisor == request.divisor && !stop_frame_.stop_requested()) {
      pending_.erase(view);
      return;
    }
    if (!now.moving && (now.view == view || priority(request) > priority(now))) {
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
  if (running_ && running_->view == view) stop_frame_.request_stop();
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

int FrameService::priority(const FrameRequest& request) const {
  const bool refines = request.settings.airlight == AirlightMethod::path && request.divisor == 1;
  return (refines ? 0 : 2) + (request.view == active_ ? 1 : 0);
}

int FrameService::motion_divisor(const Film& film) const {
  if (milliseconds_per_pixel_ == 0.0) return first_divisor;
  const double budget =
      std::max(motion_budget - fixed_milliseconds_, min_pixel_share * motion_budget);
  for (int divisor = 1; divisor < max_divisor; ++divisor) {
    const Film part = divided(film, divisor);
    if (milliseconds_per_pixel_ * part.width * part.height <= budget) return divisor;
  }
  return max_divisor;
}

void FrameService::work(const Job& job, const std::shared_ptr<const TransferStore>& transfers,
                        const MakeContext& make_context) {
  const auto pictures = gl::PicturePool::create();
  ChosenRenderer renderer;
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
      if (!wake_.wait(lock, job.stop, [this] { return !pending_.empty(); })) return;
      const auto next = std::ranges::max_element(
          pending_, {}, [this](const auto& pending) { return priority(pending.second); });
      request = std::move(next->second);
      pending_.erase(next);
      divisor = request.moving ? motion_divisor(request.film) : request.divisor;
      running_ = request;
      stop_frame_ = std::stop_source();
      if (job.stop.stop_requested()) return;
      stop = stop_frame_.get_token();
      backend = backend_;
      choice = backend_choice_;
    }
    try {
      if (made_for != choice) {
        renderer = {};  // first, or there would be two of them
        renderer = ChosenRenderer(backend, transfers, make_context, pictures);
        made_for = choice;
        milliseconds_per_pixel_ = 0.0;
      }
      QElapsedTimer timer;
      timer.start();
      const Film film = divided(request.film, divisor);
      const std::shared_ptr<RenderedFrame> rendered = renderer.render(request, film, stop);
      if (!rendered) continue;
      rendered->milliseconds = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
      rendered->divisor = divisor;
      rendered->request = std::move(request);
      if (rendered->request.moving) {  // at rest pixels may cost more
        fixed_milliseconds_ = milliseconds_of_any_resolution(rendered->frame.statistics);
        const double of_pixels = std::max(rendered->milliseconds - fixed_milliseconds_, 0.0);
        milliseconds_per_pixel_ = of_pixels / (film.width * film.height);
      }
      job_.deliver(job, [this, rendered] { Q_EMIT frame_ready(rendered); });
    } catch (const std::exception& error) {
      const QString message = QString::fromUtf8(error.what());
      job_.deliver(job, [this, message] { Q_EMIT failed(message); });
    }
  }
}

}  // namespace brume
