#pragma once

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "brume/at_time.h"
#include "brume/frame.h"
#include "brume/scene.h"
#include "core/scene/camera_rays.h"
#include "render/lights/paper_lights.h"
#include "render/prepare/albedo.h"
#include "render/prepare/film_window.h"
#include "render/prepare/fog_extent.h"
#include "render/prepare/point_sources.h"
#include "render/prepare/prepared_scene.h"
#include "render/prepare/ray_ends.h"
#include "render/render_plan.h"
#include "render/scattering/source_function.h"
#include "render/settings.h"
#include "render/shading/film_surfaces.h"
#include "render/shading/prepared_shading.h"
#include "render/shading/surface_shading.h"
#include "render/slices/sliced_light.h"
#include "render/transfer/transfer_store.h"
#include "render/util/job.h"
#include "render/visibility/light_shapes.h"

namespace brume {

// Measures the wall time of consecutive stages.
class StageClock {
 public:
  explicit StageClock(std::vector<StageTime>& stages) : stages_(stages) {}
  void finish(Stage stage) {
    const auto now = std::chrono::steady_clock::now();
    add_time(stages_, stage, std::chrono::duration<double, std::milli>(now - last_).count());
    last_ = now;
  }

 private:
  std::vector<StageTime>& stages_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// State of one frame of one albedo group while it is rendered.
struct FrameContext {
  const RenderPlan& plan;
  const Settings& settings;  // the plan's
  const Scene& scene;        // the group's
  const Camera& camera;
  const TransferStore& transfers;
  TransferStore* own_transfers;  // where missing transfer is computed; null: it is not
  Job job;
  AlbedoGroup group;
  FogExtent fog_extent;
  FilmWindow window;
  LightShapes light_shapes;
  CameraRays rays;
  Frame frame;            // of the window
  MirroredWays mirrored;  // with mirrors, before surfaces are shaded

  FrameContext(const RenderPlan& frame_plan, const Scene& group_scene, const Camera& frame_camera,
               const FilmWindow& film_window, const TransferStore& known_transfers,
               TransferStore* new_transfers, Job frame_job, AlbedoGroup albedo_group,
               const FogExtent& extent)
      : plan(frame_plan),
        settings(frame_plan.settings),
        scene(group_scene),
        camera(frame_camera),
        transfers(known_transfers),
        own_transfers(new_transfers),
        job(std::move(frame_job)),
        group(std::move(albedo_group)),
        fog_extent(extent),
        window(film_window),
        light_shapes(group_scene.lights),
        rays(frame_camera, film_window.film()) {
    frame.film = window.film();
    frame.camera = frame_camera;
    frame.time = scene.time;
    frame.frames_per_second = frame_rate(scene);
    frame.statistics.skipped = plan.skipped;
    frame.statistics.on_cpu = plan.on_cpu;
    frame.statistics.gaussians_total = scene.medium.size();
  }
  // Allocates all layers of the frame.
  void make_layers();
  // Mirrored rays need it before surfaces are shaded. An empty function: there is no medium, or the
  // method has none.
  void set_mirrored_ways(AirlightAlong airlight_along) {
    mirrored.airlight_along = std::move(airlight_along);
    mirrored.open_length = [this](const glm::dvec3& origin) {
      return fog_extent.ray_distance(origin);
    };
  }
  // Brightness::airlight_rms, if it is known: of the group, whose airlight is still to be
  // multiplied by its albedo.
  [[nodiscard]] std::optional<double> airlight_rms() const {
    if (!settings.brightness) return std::nullopt;
    return settings.brightness->airlight_rms / group.albedo;
  }
  // The plan's lights.
  [[nodiscard]] std::vector<PointSource> sources() const {
    return point_sources(plan.lights, rays, camera, fog_extent);
  }
};

// The stages before and after the airlight, shared by both backends, and their caches. Each does
// nothing where the plan does without it.
class FrameStages {
 public:
  // The stages before the airlight, in this order. First the view-independent ones; false if the
  // job was stopped.
  bool begin(FrameContext& work, StageClock& clock);
  // First hits of the view rays; fills the depth layer.
  void find_hits(FrameContext& work, StageClock& clock);
  // In-scattered light on a grid. False if the job was stopped.
  bool prepare_source(FrameContext& work, StageClock& clock);

  // State of the frame after begin().
  [[nodiscard]] const PreparedScene& prepared() const { return prepared_; }
  [[nodiscard]] const PreparedShading& shading() const { return shading_; }
  // The environment that is seen behind all; null: nothing.
  [[nodiscard]] const EnvironmentLight* background(const FrameContext& work) const {
    return work.settings.mirrored_alone ? nullptr : shading_.environment();
  }
  // After find_hits().
  [[nodiscard]] RayEnds ray_ends(const FrameContext& work) const {
    return {work.fog_extent.ray_distance(work.rays), distances_};
  }
  // Path-traced frames have layers of what is behind panes, see PaneLayers. The panes that pixels
  // see first, after find_hits(); opaque ones where they see none.
  [[nodiscard]] std::vector<SeenPane> seen_panes(const FrameContext& work) const;
  // Replaces hits on panes by those behind them.
  void find_hits_behind_panes(FrameContext& work);
  // First hit of a pixel's ray, after find_hits().
  [[nodiscard]] SurfaceHit hit(std::size_t pixel) const;
  // Null: there is none.
  [[nodiscard]] const SourceFunction* source_function(const FrameContext& work) const {
    return work.plan.has_source_function() ? &source_ : nullptr;
  }
  // Optical depth of b0 from any point to the end of the fog.
  [[nodiscard]] double fog_depth(const FrameContext& work) const {
    return work.fog_extent.surface_optical_depth(prepared_.medium().homogeneous_density());
  }
  // The same of view rays that hit nothing, from the eye; 0 if they have no end, or fog is a ball.
  [[nodiscard]] double view_fog_depth(const FrameContext& work) const {
    const double b0 = prepared_.medium().homogeneous_density();
    return work.fog_extent.ball().is_endless() || !work.fog_extent.fog().is_endless() || !(b0 > 0.0)
               ? 0.0
               : b0 * work.fog_extent.ray_distance(work.rays);
  }
  // The lights as `paper` and `sliced` need them; pairs are added to the frame's statistics.
  PaperLights paper_lights(FrameContext& work, StageClock& clock);
  std::vector<SlicedLight> sliced_lights(FrameContext& work, StageClock& clock);
  // The lights that slices are chosen for, after prepare_source(): the scene's, then in fog what
  // Gaussians emit.
  [[nodiscard]] std::vector<SlicedLight> lit_from(const FrameContext& work,
                                                  std::vector<SlicedLight> lights) const;
  // Parts of sliced_lights(): the lights without tables, and the directions of a light's shadow
  // map; `table` is the map of its table.
  static std::vector<SlicedLight> lights_of(const FrameContext& work);
  [[nodiscard]] int far_shadow_cells(const FrameContext& work) const;
  [[nodiscard]] DirectionMap shadow_directions(const FrameContext& work, const PointSource& light,
                                               const DirectionMap& table) const;

  // Lighting of surfaces, without optical depth tables.
  [[nodiscard]] SurfaceLighting surface_lighting(const FrameContext& work) const;
  // Updates the vertex lighting of surfaces with radiance transfer; see PreparedShading.
  void update_vertex_lighting(FrameContext& work);
  // Outgoing radiance of surfaces, RGB per pixel; empty if none is lit.
  std::span<const glm::vec3> shade_surfaces(FrameContext& work, StageClock& clock);
  // The wide highlights at the pixels of that frame, if anything mirrors.
  [[nodiscard]] const SharedHighlights& highlights() const { return highlights_; }
  // The same of further hits, those that are seen last through panes; they are shaded for it.
  const SharedHighlights& find_highlights_behind(FrameContext& work,
                                                 std::span<const RasterPixel> hits,
                                                 std::span<const std::uint32_t> copies);
  // Shades more points of surfaces, after shade_surfaces(), until the next frame.
  [[nodiscard]] FilmSurfaces film_surfaces(const FrameContext& work) const {
    return {work.scene.surfaces,
            prepared_.medium(),
            prepared_.ray_caster(),
            shading_,
            lighting_,
            work.rays,
            work.frame.film,
            work.window.shaded(),
            work.plan.precision,
            work.light_shapes,
            work.plan.has_mirrors ? &work.mirrored : nullptr,
            work.settings.mirrored_alone};
  }

 private:
  static bool make_transfers(FrameContext& work);
  [[nodiscard]] bool has_surfaces() const { return !prepared_.ray_caster().empty(); }
  void meet_lights(FrameContext& work);
  // The table towards a light; its pairs are added to the frame's statistics.
  const OpticalDepthTable& table_of(FrameContext& work, const glm::dvec3& light);
  SurfaceLighting tabled_lighting(FrameContext& work);
  [[nodiscard]] LitSpace lit_space(const FrameContext& work) const;
  [[nodiscard]] IncidentOptics incident_optics(const FrameContext& work) const;
  SourceFunction::Multiple multiple_scattering(FrameContext& work, StageClock& clock);
  void set_hit(std::size_t pixel, const SurfaceHit& hit);

  PreparedScene prepared_;
  PreparedShading shading_;
  SharedHighlights highlights_, highlights_behind_;
  EmissionLights emission_lights_;
  SourceFunction source_;
  SurfaceLighting lighting_;  // of the frame
  // Members to reuse their memory.
  std::vector<RasterPixel> hits_;
  std::vector<double> distances_;      // of hits_ in double, where float is too coarse; else empty
  std::vector<std::uint32_t> copies_;  // of hits_; empty: nothing has copies
  std::vector<glm::vec3> surface_radiance_;
};

}  // namespace brume
