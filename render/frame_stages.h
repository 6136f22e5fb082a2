#pragma once

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "core/scene/scene.h"
#include "render/cpu/paper_airlight.h"
#include "render/cpu/sliced_airlight.h"
#include "render/cpu/surfaces.h"
#include "render/environment_source.h"
#include "render/film_airlight.h"
#include "render/fog_end.h"
#include "render/frame.h"
#include "render/job.h"
#include "render/prepared_scene.h"
#include "render/prepared_shading.h"
#include "render/render_plan.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// Tells how long stages took, one after the other.
class StageClock {
 public:
  explicit StageClock(std::vector<StageTime>& stages) : stages_(stages) {}
  void finish(const char* name) {
    const auto now = std::chrono::steady_clock::now();
    stages_.push_back({name, std::chrono::duration<double, std::milli>(now - last_).count()});
    last_ = now;
  }

 private:
  std::vector<StageTime>& stages_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// One frame of one medium while it is made.
struct FrameWork {
  const Scene& scene;
  const Camera& camera;
  const TransferStore& transfers;
  TransferStore* own_transfers;  // to make what is missing in; null: nothing is made
  Job job;
  double albedo;  // of the channels that count
  FogEnd fog_end;
  RenderPlan plan;
  Settings settings;  // those asked for, with light maps that fit into memory
  CameraRays rays;
  Frame frame;

  FrameWork(const Scene& of, const Camera& from, const Film& film, const Settings& by,
            const TransferStore& with, TransferStore* own, Job part, double of_albedo,
            const FogEnd& end)
      : scene(of),
        camera(from),
        transfers(with),
        own_transfers(own),
        job(std::move(part)),
        albedo(of_albedo),
        fog_end(end),
        plan(of, by.airlight),
        settings(with_fitting_light_maps(by, plan.lights.size(), plan.surfaces)),
        rays(from, film) {
    frame.film = film;
    frame.time = by.time;
  }
  // For every pixel of all of them.
  void make_layers();
};

// The stages of a frame that come before and after its airlight, and what they keep from frame to
// frame.
class FrameStages {
 public:
  // What comes before the airlight, in this order. First what does not depend on the view; false if
  // the job was stopped.
  bool begin(FrameWork& work, StageClock& clock);
  // What view rays meet; fills the depth layer.
  void find_hits(FrameWork& work, StageClock& clock);
  // The light of an environment in the medium. False if the job was stopped.
  bool prepare_source(const FrameWork& work, StageClock& clock);

  // From here on, of the frame that has begun.
  [[nodiscard]] const PreparedScene& prepared() const { return prepared_; }
  [[nodiscard]] const PreparedShading& shading() const { return shading_; }
  // After find_hits().
  [[nodiscard]] RayEnds ray_ends(const FrameWork& work) const {
    return {work.fog_end.of_rays(work.rays.eye()), distances_};
  }
  // What the medium scatters of an environment's light; null: there is none.
  [[nodiscard]] const EnvironmentSource* scattered_environment(const FrameWork& work) const {
    return work.plan.environment ? &source_ : nullptr;
  }
  // The depth of b0 from any point to where the fog ends.
  [[nodiscard]] double fog_depth(const FrameWork& work) const {
    return work.fog_end.depth_of_surfaces(prepared_.medium().homogeneous_density());
  }
  // What `paper` and `sliced` need of the lights; pairs go to the frame's statistics.
  PaperLights paper_lights(FrameWork& work, StageClock& clock);
  std::vector<SlicedLight> sliced_lights(FrameWork& work, StageClock& clock);
  // The latter's parts: the lights as such, and the directions of the shadows of surfaces around
  // one; `table` is the map of its table.
  static std::vector<SlicedLight> lights_of(const FrameWork& work);
  static DirectionMap shadow_directions(const FrameWork& work, const DirectionMap& table);

  // What surfaces are lit by; no light has a table.
  [[nodiscard]] SurfaceLighting surface_lighting(const FrameWork& work) const;
  // Another number whenever the grid of SurfaceLighting::arriving is another.
  [[nodiscard]] std::uint64_t source_revision() const { return source_.revision(); }
  // Takes the light of surfaces with radiance transfer: see PreparedShading.
  void take_light(FrameWork& work);
  // RGB per pixel that surfaces send to the eye; empty where none is lit.
  std::span<const glm::vec3> shade_surfaces(FrameWork& work, StageClock& clock);

 private:
  static bool find_transfers(FrameWork& work);
  SurfaceLighting tabled_lighting(FrameWork& work);
  [[nodiscard]] ArrivalOptics arrival_optics(const FrameWork& work) const;

  PreparedScene prepared_;
  PreparedShading shading_;
  EnvironmentSource source_;
  // Kept for their memory only.
  std::vector<RasterPixel> hits_;
  std::vector<double> distances_;  // of hits_, where float lacks digits; else empty
  std::vector<glm::vec3> surface_radiance_;
};

}  // namespace brume
