#include "tools/bench/measure/cache_gains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "brume/edits.h"
#include "render/prepare/merged_medium.h"
#include "render/renderer.h"
#include "tools/bench/measure/plan_decisions.h"

namespace brume {
namespace {

// A frame and what it took.
struct TimedFrame {
  Frame frame;
  double milliseconds = 0.0;
  double cpu_milliseconds = 0.0;

  [[nodiscard]] double stage(Stage stage) const {
    double sum = 0.0;
    for (const StageTime& time : frame.statistics.stages) {
      if (time.stage == stage) sum += time.milliseconds;
    }
    return sum;
  }
};

TimedFrame timed_frame(Renderer& renderer, const Scene& scene, const Camera& camera,
                       const Settings& settings, const Motion& motion) {
  TimedFrame timed;
  const Stopwatch watch;
  timed.frame = *renderer.render(scene, camera, scene.film, settings, {}, {}, motion);
  timed.milliseconds = watch.milliseconds();
  timed.cpu_milliseconds = watch.cpu_milliseconds();
  return timed;
}

// Half a degree around the target per step.
Camera orbited(const Camera& camera, int steps) {
  return moved(camera, {.turn = 0.5}, steps);
}

// Collects pairs of frames.
class CachePairs {
 public:
  explicit CachePairs(Stage stage) : stage_(stage) {}

  void add(const TimedFrame& with, const TimedFrame& without) {
    const double saved = without.stage(stage_) - with.stage(stage_);
    with_ms_.push_back(with.milliseconds);
    with_cpu_ms_.push_back(with.cpu_milliseconds);
    without_ms_.push_back(with.milliseconds + saved);
    gains_.push_back(saved / with.milliseconds);
    change_ = std::max(change_, max_change(with.frame, without.frame, without.frame));
  }

  [[nodiscard]] CacheGain gain(std::string cache, std::string scene, CacheCode code) const {
    return {std::move(cache),          std::move(scene),
            std::move(code),           quartiles_of(with_ms_),
            quartiles_of(without_ms_), spread_of(with_cpu_ms_),
            quartiles_of(gains_),      change_};
  }

 private:
  Stage stage_;
  std::vector<double> with_ms_, with_cpu_ms_, without_ms_, gains_;
  double change_ = 0.0;
};

CacheGain measure_cache(const FrameCache& cache, const MovingView& view, Renderer& renderer,
                        int pairs) {
  Scene scene = view.scene;
  const Settings settings = view.settings_of(cache.method);
  const auto render = [&](const Scene& shown, const Settings& wanted, const Camera& camera) {
    return timed_frame(renderer, shown, camera, wanted, view.motion);
  };
  static_cast<void>(render(scene, settings, scene.camera));
  CachePairs all(cache.stage);
  for (int i = 1; i <= pairs; ++i) {
    if (cache.edit) cache.edit(scene);
    Scene other_scene = scene;
    Settings other_settings = settings;
    cache.displace(other_scene, other_settings);
    const Camera camera = orbited(scene.camera, i);
    const TimedFrame cached = render(scene, settings, camera);
    static_cast<void>(render(other_scene, other_settings, camera));
    all.add(cached, render(scene, settings, camera));
  }
  return all.gain(std::string(cache.name), view.name, cache.code);
}

bool merges(const RenderPlan& plan, const Scene& scene) {
  return plan.merge_error > 0.0 && MergedMedium::may_merge(scene.medium);
}

template <Stage stage>
bool runs(const RenderPlan& plan, const Scene&) {
  return plan.runs(stage);
}

constexpr std::array caches{
    FrameCache{
        .name = "index of the medium",
        .code = {12, "prepared_scene"},
        .is_used = [](const RenderPlan& plan, const Scene&) { return plan.has_medium(); },
        .displace = [](Scene&, Settings& settings) { settings.depth_error *= 2.0; },
    },
    FrameCache{
        .name = "merged medium",
        .code = {10, "prepared_scene"},
        .is_used =
            [](const RenderPlan& plan, const Scene& scene) {
              return merges(plan, scene) && !plan.motion.has_own_medium;
            },
        .displace = [](Scene&, Settings& settings) { settings.merge_error *= 0.9; },
    },
    FrameCache{
        .name = "merged medium, where edits are followed",
        .code = {180, "merged_medium"},
        .is_used =
            [](const RenderPlan& plan, const Scene& scene) {
              return merges(plan, scene) && plan.motion.has_own_medium;
            },
        .displace = [](Scene&, Settings& settings) { settings.merge_error *= 0.9; },
        .edit =
            [](Scene& scene) {
              const auto ids = scene.medium.ids().first(scene.medium.size() / 100);
              std::vector<Gaussian> thinned;
              for (std::size_t i = 0; i < ids.size(); ++i) {
                thinned.push_back(scene.medium.gaussian(i));
                thinned.back().density *= 0.9;
              }
              MediumEdit::change(scene.medium, ids, thinned).apply(scene.medium);
            },
    },
    FrameCache{
        .name = "ray caster",
        .code = {20, "prepared_scene, ray_caster"},
        .is_used = runs<Stage::visibility>,
        .displace =
            [](Scene& scene, Settings&) {
              for (Surface& surface : scene.surfaces) surface.translate.x += 1e-3;
            },
    },
    FrameCache{
        .name = "optical depth tables",
        .code = {12, "prepared_scene"},
        .stage = Stage::light_table,
        .is_used = runs<Stage::light_table>,
        .displace =
            [](Scene&, Settings& settings) {
              settings.optical_depth_table = {32, 16};
            },
    },
    FrameCache{
        .name = "shadow maps",
        .code = {8, "prepared_scene, shadow_map"},
        .stage = Stage::shadow_map,
        .is_used = runs<Stage::shadow_map>,
        .displace = [](Scene&, Settings& settings) { settings.shadow_cells = 32; },
    },
    FrameCache{
        .name = "grid of environment light",
        .code = {25, "source_function"},
        .stage = Stage::environment,
        .is_used = runs<Stage::environment>,
        .displace =
            [](Scene&, Settings& settings) {
              settings.source_grid = {1000, 24};
            },
    },
    FrameCache{
        .name = "spherical harmonics of the environment",
        .code = {5, "prepared_shading, environment_light"},
        .is_used = [](const RenderPlan& plan, const Scene&) { return plan.has_environment; },
        .displace = [](Scene&,
                       Settings& settings) { settings.paper_spread = !settings.paper_spread; },
    },
    FrameCache{
        .name = "spherical harmonics of glossy materials",
        .code = {11, "prepared_shading"},
        .is_used =
            [](const RenderPlan& plan, const Scene& scene) {
              return plan.has_indirect_light &&
                     std::ranges::any_of(scene.surfaces, [](const Surface& surface) {
                       return surface.material.type != Material::Type::diffuse;
                     });
            },
        .displace =
            [](Scene& scene, Settings&) {
              for (Surface& surface : scene.surfaces) surface.material.reflectance *= 0.5;
            },
    },
    FrameCache{
        .name = "vertex lighting",
        .code = {67, "prepared_shading, vertex_lighting"},
        .stage = Stage::surfaces,
        .is_used = runs<Stage::vertex_light>,
        .displace =
            [](Scene&, Settings& settings) {
              settings.precision = Settings::Precision::plain_double;
            },
    },
    FrameCache{
        .name = "`paper`: optical depths from the lights to Gaussian centers",
        .code = {11, "prepared_scene"},
        .method = AirlightMethod::paper,
        .stage = Stage::light_depth,
        .is_used = runs<Stage::light_depth>,
        .displace =
            [](Scene& scene, Settings&) {
              for (Light& light : scene.lights) light.position.x += 1e-3;
            },
    },
    FrameCache{
        .name = "`paper`: grids of average optical depths",
        .code = {22, "prepared_shading"},
        .method = AirlightMethod::paper,
        .is_used = runs<Stage::average_depth>,
        // Which has none.
        .displace =
            [](Scene&, Settings& settings) {
              settings.airlight = AirlightMethod::sliced;
              settings.optical_depth_table = {32, 16};
              settings.source_grid = {1000, 24};
            },
    }};

}  // namespace

Quartiles quartiles_of(std::vector<double> values) {
  std::ranges::sort(values);
  const auto quantile = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - std::floor(place));
  };
  return {quantile(0.5), quantile(0.25), quantile(0.75)};
}

Settings MovingView::settings_of(AirlightMethod method) const {
  Settings result = settings;
  result.airlight = method;
  return result;
}

std::span<const FrameCache> frame_caches() {
  return caches;
}

std::vector<CacheGain> measure_caches(const MovingView& view, int pairs) {
  const auto plan = [&](AirlightMethod method) {
    return RenderPlan(view.scene, view.scene.film, view.settings_of(method), view.transfers.get(),
                      view.motion);
  };
  Renderer renderer(view.transfers);
  std::vector<CacheGain> gains;
  for (const FrameCache& cache : frame_caches()) {
    if (!cache.is_used(plan(cache.method), view.scene)) continue;
    gains.push_back(measure_cache(cache, view, renderer, pairs));
  }
  return gains;
}

}  // namespace brume
