#include "render/gl_renderer.h"

#include <tbb/task_arena.h>

#include <cassert>

#include "render/cpu/composite.h"
#include "render/gl/composite_stage.h"
#include "render/gl/device.h"
#include "render/gl/egl_context.h"
#include "render/gl/gl_plan.h"
#include "render/gl/paper_stage.h"
#include "render/gl/read_back.h"
#include "render/gl/sliced_stage.h"
#include "render/gl/surface_stage.h"
#include "render/prepare/albedo.h"
#include "render/prepare/frame_stages.h"
#include "render/prepare/sample_spacing.h"
#include "render/renderer.h"
#include "render/samples/mean_frame.h"

namespace brume {

using namespace gl;

namespace {

// The context is current in this thread while one lives.
class Current {
 public:
  explicit Current(Context& context) : context_(context) {
    if (!context.make_current()) throw Error("the context cannot be made current");
  }
  ~Current() { context_.done_current(); }
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;

 private:
  Context& context_;
};

}  // namespace

struct GlRenderer::Impl {
  // The state of one albedo among the colour channels; see albedo.h.
  struct Group {
    FrameStages stages;
    MediumBuffers medium;
    MeshBuffers mesh;
    TileLists lists;
    SlicedStage sliced;
    PaperStage paper;
    SurfaceStage surfaces;
  };

  std::unique_ptr<Context> context;
  Device device;
  std::shared_ptr<TransferStore> own_transfers;  // null: those of another
  std::shared_ptr<const TransferStore> transfers;
  std::shared_ptr<PicturePool> pictures;  // null: there is none
  std::string failure;                    // why nothing more is tried; empty: nothing failed

  // From here on objects of the context.
  Programs programs;
  DeviceClock clock;
  FilmTextures textures;
  ReadBack fetched;
  CompositeStage composite;
  DisplayStage display;
  std::vector<std::unique_ptr<Group>> groups;

  ExtinctionMedia media;
  std::unique_ptr<Renderer> cpu;  // made when it is needed

  ~Impl() { release(true); }
  // Gives all objects back; the shaders too if the context is not used any more.
  void release(bool all);

  // Where a frame goes.
  struct Target {
    const DisplayOptions* options = nullptr;  // null: to memory
    std::shared_ptr<DevicePicture> picture;   // null: not to a display
  };
  std::optional<Frame> render(const Scene& scene, const Camera& camera, const Film& film,
                              const Settings& settings, const Motion& motion, const Job& job,
                              Target& target);
  std::optional<Frame> try_render(const RenderPlan& plan, const Scene& scene, const Camera& camera,
                                  const Film& film, const Job& job, Target& target);
  std::optional<Frame> render(FrameContext& work, tbb::task_arena& arena, std::size_t which,
                              const Target& target);
  // The stages of a frame, in this order. Those that may take long are false if the job was
  // stopped.
  void find_hits(FrameContext& work, Group& group);
  void integrate_medium(FrameContext& work, Group& group, StageClock& clock, DeviceFrame& frame);
  bool shade_surfaces(FrameContext& work, Group& group, StageClock& clock, DeviceFrame& frame);
  void show(FrameContext& work, std::size_t which, const Target& target, StageClock& clock);
  void read_back(FrameContext& work, tbb::task_arena& arena, StageClock& clock);
};

std::unique_ptr<FrameRenderer> make_renderer(Backend backend,
                                             const std::shared_ptr<const TransferStore>& transfers,
                                             std::string& problem) {
  std::unique_ptr<GlRenderer> renderer;
  if (backend == Backend::gl) {
    renderer = GlRenderer::create(transfers, problem);
  } else if (backend == Backend::auto_) {
    std::string none;
    auto context = EglContext::create(&none, false, EglContext::Devices::gpu);
    if (context) renderer = GlRenderer::create(std::move(context), transfers, none);
    if (renderer && renderer->is_software()) renderer.reset();
  }
  if (renderer) return renderer;
  return transfers ? std::make_unique<Renderer>(transfers) : std::make_unique<Renderer>();
}

std::unique_ptr<GlRenderer> GlRenderer::create(std::shared_ptr<const TransferStore> transfers,
                                               std::string& problem, bool debug) {
  auto context = EglContext::create(&problem, debug);
  if (!context) return nullptr;
  return create(std::move(context), std::move(transfers), problem);
}

std::unique_ptr<GlRenderer> GlRenderer::create(std::unique_ptr<Context> context,
                                               std::shared_ptr<const TransferStore> transfers,
                                               std::string& problem,
                                               std::shared_ptr<PicturePool> pictures) {
  auto impl = std::make_unique<Impl>();
  impl->context = std::move(context);
  if (!impl->context->make_current()) {
    problem = "the context cannot be made current";
    return nullptr;
  }
  impl->device = current_device();
  impl->context->done_current();
  problem = missing_feature(impl->device);
  if (!problem.empty()) return nullptr;
  if (!transfers) transfers = impl->own_transfers = std::make_shared<TransferStore>();
  impl->transfers = std::move(transfers);
  impl->pictures = std::move(pictures);
  return std::unique_ptr<GlRenderer>(new GlRenderer(std::move(impl)));
}

GlRenderer::GlRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
GlRenderer::~GlRenderer() = default;

const std::string& GlRenderer::device_name() const {
  return impl_->device.name;
}

bool GlRenderer::is_software() const {
  return impl_->device.is_software;
}

Context& GlRenderer::context() {
  return *impl_->context;
}

void GlRenderer::Impl::release(bool all) {
  if (!context || !context->make_current()) return;
  groups.clear();
  textures = {};
  fetched = {};
  composite = {};
  display = {};
  clock = {};
  if (pictures) pictures->trim();
  if (all) programs = {};
  context->done_current();
}

std::optional<Frame> GlRenderer::render(const Scene& scene, const Camera& camera, const Film& film,
                                        const Settings& settings, std::stop_token stop,
                                        const std::function<void(double)>& progress,
                                        const Motion& motion) {
  Impl::Target memory;
  return impl_->render(scene, camera, film, settings, motion, {std::move(stop), progress}, memory);
}

std::optional<GlRenderer::DisplayFrame> GlRenderer::show(const Scene& scene, const Camera& camera,
                                                         const Film& film, const Settings& settings,
                                                         const DisplayOptions& options,
                                                         std::stop_token stop,
                                                         const Motion& motion) {
  assert(!film.region);
  Impl::Target target;
  if (impl_->pictures) target.options = &options;
  auto frame = impl_->render(scene, camera, film, settings, motion, {std::move(stop), {}}, target);
  if (!frame) return std::nullopt;
  return DisplayFrame{std::move(*frame), std::move(target.picture)};
}

std::optional<Frame> GlRenderer::Impl::render(const Scene& scene, const Camera& camera,
                                              const Film& film, const Settings& settings,
                                              const Motion& motion, const Job& job,
                                              Target& target) {
  RenderPlan plan(scene, film, with_useful_spacing(scene, camera, film, settings),
                  own_transfers ? nullptr : transfers.get(), motion);
  std::string why = failure;
  if (const std::optional<Reason> reason = refusal(plan); why.empty() && reason) {
    why = to_string(*reason);
  }
  if (why.empty() && camera.clip != Camera().clip) why = to_string(Reason::clipped_on_cpu);
  if (why.empty() && settings.samples > 1) {
    // All pixels as often: whole frames are quick here, and few are read back in between.
    const auto render_film = [&](const Film& shifted, const Settings& single, const Job& part) {
      Target memory;
      return render(scene, camera, shifted, single, motion, part, memory);
    };
    return render_shifted(film, settings, job, render_film);
  }
  if (why.empty()) {
    try {
      return try_render(device_plan(plan, target.options), scene, camera, film, job, target);
    } catch (const OutOfMemory& error) {
      why = error.what();
      target.picture.reset();
      release(false);
    } catch (const Error& error) {
      why = failure = error.what();
      target.picture.reset();
      release(true);
    }
  }
  if (!cpu) {
    cpu = own_transfers ? std::make_unique<Renderer>() : std::make_unique<Renderer>(transfers);
  }
  plan.on_cpu = {{Stage::frame, why}};
  return cpu->render(plan, scene, camera, film, job);
}

std::optional<Frame> GlRenderer::Impl::try_render(const RenderPlan& plan, const Scene& scene,
                                                  const Camera& camera, const Film& film,
                                                  const Job& job, Target& target) {
  const int threads = plan.settings.threads;
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  const FogExtent fog_extent(scene);
  const std::vector<AlbedoGroup> all = albedo_groups(scene, plan.has_own_optics);
  const Current current(*context);
  while (groups.size() < all.size()) groups.push_back(std::make_unique<Group>());
  groups.resize(all.size());
  if (target.options) target.picture = pictures->acquire({film.width, film.height});
  const FilmWindow window(film, plan.settings);
  return render_groups(scene, all, media, job,
                       [&](const Scene& group_scene, std::size_t which, const AlbedoGroup& group,
                           const Job& group_job) -> std::optional<Frame> {
                         FrameContext work(plan, group_scene, camera, window, *transfers,
                                           own_transfers.get(), group_job, group, fog_extent);
                         work.frame.statistics.backend = "gl";
                         work.frame.statistics.device = device.name;
                         std::optional<Frame> frame = render(work, arena, which, target);
                         if (!frame) return std::nullopt;
                         return window.cut(std::move(*frame));
                       });
}

// Where view rays end: the depth texture, and the hits of the mesh.
void GlRenderer::Impl::find_hits(FrameContext& work, Group& group) {
  if (!work.plan.runs(Stage::visibility)) {
    textures.depth.fill(-1.0f);
    return;
  }
  const PreparedScene& prepared = group.stages.prepared();
  group.mesh.update(prepared.ray_caster());
  clock.time(Stage::visibility,
             [&] { group.mesh.find_hits(programs, work.rays, work.frame.film, textures.depth); });
}

// Airlight and transmittance of the view rays.
void GlRenderer::Impl::integrate_medium(FrameContext& work, Group& group, StageClock& cpu_clock,
                                        DeviceFrame& frame) {
  if (!work.plan.has_medium()) {
    const glm::ivec2& size = textures.airlight.size();
    const std::vector<glm::vec4> clear(
        static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y),
        {0.0f, 0.0f, 0.0f, 1.0f});
    textures.airlight.upload({&clear[0].x, 4 * clear.size()});
    textures.pairs.fill(0.0f);
    return;
  }
  const PreparedScene& prepared = group.stages.prepared();
  group.medium.update(prepared.medium());
  clock.time(Stage::lists, [&] {
    group.lists.build(programs, group.medium, prepared.medium(), work.rays, work.frame.film,
                      work.settings.airlight_scale, device.storage_bytes);
  });
  FrameStatistics& statistics = work.frame.statistics;
  statistics.exact_pixels = work.settings.airlight == AirlightMethod::paper
                                ? group.paper.run(group.stages, work, cpu_clock, frame)
                                : group.sliced.run(group.stages, work, frame);
  statistics.gaussians_used = group.lists.used();
  if (prepared.is_merged()) statistics.gaussians_merged = prepared.medium().size();
  cpu_clock.finish(Stage::submit);
}

// Their outgoing radiance.
bool GlRenderer::Impl::shade_surfaces(FrameContext& work, Group& group, StageClock& cpu_clock,
                                      DeviceFrame& frame) {
  if (!work.plan.runs(Stage::surfaces)) {
    textures.behind.clear();
    return !work.job.stop.stop_requested();
  }
  if (work.plan.runs(Stage::vertex_light)) {
    frame.arena.execute([&] { group.stages.update_vertex_lighting(work); });
    if (work.job.stop.stop_requested()) return false;
    cpu_clock.finish(Stage::vertex_light);
  }
  work.frame.statistics.light_pairs += clock.time(Stage::surfaces, [&] {
    return group.surfaces.run(group.stages, work, group.sliced.tables(), frame);
  });
  return !work.job.stop.stop_requested();
}

// After the last group the picture is complete on return, for all contexts.
void GlRenderer::Impl::show(FrameContext& work, std::size_t which, const Target& target,
                            StageClock& cpu_clock) {
  const FilmRegion region = work.frame.film.region.value_or(FilmRegion{});
  clock.time(Stage::display, [&] {
    display.run(programs, textures, *target.options, {region.x, region.y}, work.group, which == 0,
                which + 1 == groups.size(), target.picture->texture());
  });
  cpu_clock.finish(Stage::submit);
  work.frame.statistics.view_pairs += display.sum_pairs(programs, textures);
  finish();
  cpu_clock.finish(Stage::wait);
  if (which == 0 && work.plan.runs(Stage::read_depth)) {
    read_depth(textures, work.frame);
    cpu_clock.finish(Stage::read_depth);
  }
}

void GlRenderer::Impl::read_back(FrameContext& work, tbb::task_arena& arena,
                                 StageClock& cpu_clock) {
  fetched.start(textures);
  cpu_clock.finish(Stage::submit);
  arena.execute([&] { work.make_layers(); });
  fetched.finish(work, arena);
  if (work.settings.background_apart) set_background_apart(work.frame);
  cpu_clock.finish(Stage::read_back);
}

std::optional<Frame> GlRenderer::Impl::render(FrameContext& work, tbb::task_arena& arena,
                                              std::size_t which, const Target& target) {
  Group& group = *groups[which];
  const auto start = std::chrono::steady_clock::now();
  StageClock cpu_clock(work.frame.statistics.stages);
  clock.restart();
  if (!arena.execute([&] { return group.stages.begin(work, cpu_clock); })) return std::nullopt;
  textures.reserve(work.frame.film);
  find_hits(work, group);
  if (!arena.execute([&] { return group.stages.prepare_source(work, cpu_clock); })) {
    return std::nullopt;
  }
  DeviceFrame frame{
      programs,
      clock,
      group.medium,
      group.mesh,
      group.lists,
      textures,
      {work.frame.film, work.rays, work.fog_extent.ray_distance(work.rays),
       BatchFog(group.stages.prepared().medium(), work.rays.eye()), work.plan, work.airlight_rms()},
      arena};
  integrate_medium(work, group, cpu_clock, frame);
  if (!shade_surfaces(work, group, cpu_clock, frame)) return std::nullopt;
  clock.time(Stage::composite, [&] { composite.run(programs, work, group.mesh, textures); });
  if (target.picture) {
    show(work, which, target, cpu_clock);
  } else {
    read_back(work, arena, cpu_clock);
  }
  check("finishing a frame");
  clock.collect(work.frame.statistics.stages);
  if (work.job.progress) work.job.progress(1.0);
  work.frame.statistics.frame_milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return std::move(work.frame);
}

}  // namespace brume
