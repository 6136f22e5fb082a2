#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "brume/revision.h"
#include "brume/scene.h"
#include "render/lights/distant_lights.h"
#include "render/lights/emission_lights.h"
#include "render/motion.h"
#include "render/scattering/lobe/eye_lobe.h"
#include "render/scattering/multiple_scattering.h"
#include "render/scattering/source_grid.h"
#include "render/scattering/source_lookup.h"
#include "render/settings.h"
#include "render/slices/slice_kernels.h"
#include "render/util/job.h"

namespace brume {

// The source function of the medium towards the eye, as far as a grid holds it: light of the
// environment that was scattered once, and all light that was scattered more often. Cached between
// frames; made anew only when its inputs change, never for a camera move.
//
// The grid stores few bands. The forward lobe of the phase function (see PhaseBands) is convolved
// with the map without medium, once per cluster of directions. The medium attenuates it
//   - for a narrow cluster, such as a sun's, and beside surfaces that occlude light by the mean
//   transmittance towards it, which nodes hold (unless an EyeLobe knows what the eye sees);
//   - for the others by the transmittance along the view ray: from behind where g > 0, from the eye
//   where g < 0.
// This is exact for thin media, and converges for narrow lobes.
class SourceFunction {
 public:
  // For light that is scattered more than once.
  struct Multiple {
    std::vector<MultipleScattering::Light> lights;
    const EmissionLights* emission;  // of the medium
    double albedo;
    const RayCaster* ray_caster;  // of the surfaces; null: there are none
    std::span<const Surface> surfaces;
    ScatteringLimits limits;
    bool through_windows = false;      // most of what is around the eye are surfaces
    const CameraRays* view = nullptr;  // that sees the medium; not null with surfaces
  };
  struct Input {
    const Environment* environment;  // null: none
    const Medium& medium;            // densities are extinction coefficients
    double anisotropy;
    // Optical depth of b0 from any point to the end of the fog; not counted with `multiple`: then,
    // and where it is 0, nodes hold how much passes the ball.
    double fog_depth;
    FogBall fog_ball;
    LitSpace lit;
    std::optional<SourceGrid::Receivers> receivers;
    SourceGridSize size;
    std::optional<Multiple> multiple;
    Revision scene_medium = 0;  // of what `medium` stands for, see MergedMedium
    Motion motion{};
    double view_fog_depth = 0.0;  // of view rays that hit nothing, with `multiple`
  };
  // The grid with the environment's part, then what was scattered more often; `grid_is_made` is
  // called in between. False, and empty, if the job was stopped.
  bool update(const Input& input, const Job& job, const std::function<void()>& grid_is_made = {});
  void clear();

  // The results of the last update().
  [[nodiscard]] const SourceGrid& grid() const { return *grid_; }
  // Extinction of light on its way to where it is scattered to the eye, and of what a SourceGrid's
  // bands scatter on the way to the eye, relative to the medium's: with more than one scattering,
  // what the forward lobe scatters goes on. See TruncatedScattering.
  [[nodiscard]] double light_extinction() const { return extinction_; }
  // The light of surfaces, and of the sky beside them, that this lobe scatters to the eye.
  [[nodiscard]] const EyeLobe& eye_lobe() const { return eye_lobe_; }
  [[nodiscard]] const PhaseBands& phase() const { return phase_; }
  // Of light that is scattered more than once; empty if there is none.
  [[nodiscard]] const LobeBroadening& lobe_broadening() const { return lobe_broadening_; }
  [[nodiscard]] double albedo() const { return albedo_; }
  // Of light that is scattered more than once; of no sweeps if there is none.
  [[nodiscard]] Convergence convergence() const { return multiple_.convergence(); }
  // Memory of the light on the grid.
  [[nodiscard]] std::size_t bytes() const { return grid_->bytes() + multiple_.bytes(); }
  [[nodiscard]] bool has_forward_lobe() const { return !light_.lobes.empty(); }
  // Whether some of its light is attenuated along view rays; see lobe().
  [[nodiscard]] bool has_lobe_on_rays() const { return has_lobe_on_rays_; }
  // Extinction of homogeneous fog for that light, relative to the fog's; 0: the fog attenuates it
  // evenly, by the scale of its weights.
  [[nodiscard]] double lobe_fog_extinction() const {
    return keeps_transmitted_ || !fog_ball_.is_endless() ? extinction_ : 0.0;
  }
  // Look-ups relative to the eye. `lobe`, here and below: that of the eye, null for other eyes; it
  // holds the light of clusters that are not narrow.
  [[nodiscard]] SourceLookup from_eye(const glm::dvec3& eye, const EyeLobe* lobe = nullptr) const;
  // Forward-lobe scattering of the light along a view ray, per unit of SliceWeights::along_rays.
  // `line_depth`: optical depth of the Gaussians from the eye to infinity.
  [[nodiscard]] glm::vec3 lobe(const SourceLookup& source, const SourceWeights& weights,
                               float line_depth) const;
  // The same for ray k of a tile, with the look-ups of its eye.
  [[nodiscard]] glm::vec3 lobe_on_ray(const SourceLookup& source, const SourceWeights& weights,
                                      float line_depth, const TileRays& rays, std::size_t k) const;
  // Whether weights() depend on the view ray.
  [[nodiscard]] bool is_anisotropic() const { return phase_.count() > 1; }
  // Weights for a view ray along the unit vector w.
  [[nodiscard]] SourceWeights weights(const glm::dvec3& w, const EyeLobe* lobe = nullptr) const;
  // The inputs of weights(), for computing many at once on a device.
  struct WeightParts {
    double scale;                     // of the environment's light at nodes
    double lobe_scale;                // of its light along view rays
    double harmonics_scale;           // of what the grid holds
    std::span<const double> factors;  // of the phase function's bands
    // The map convolved with the forward lobe, per cluster; empty without lobe.
    std::span<const std::shared_ptr<const RadianceMap>> lobes;
    std::span<const bool> at_nodes;  // of the clusters: attenuated as nodes hold it
    double rotation;                 // of the maps about +y; see Environment
  };
  [[nodiscard]] WeightParts weight_parts(const EyeLobe* lobe) const;

 private:
  [[nodiscard]] bool has_same(const std::optional<SourceGrid::Receivers>& receivers) const;
  // Sets light_; nothing is left of it if stopped.
  void read_map(const std::shared_ptr<const RadianceMap>& map, double anisotropy,
                std::size_t directions, const Job& job);
  // False if stopped.
  bool make_grid(const Input& input, const Job& job);
  bool add_multiple(const Input& input, const Job& job);
  [[nodiscard]] LobedSky lobed_sky() const;
  void find_eye_lobe(const Input& input, bool is_same_light, const Job& job);
  [[nodiscard]] std::vector<SourceLight> lights_in_world() const;
  // Whether the grid holds light that was scattered more than once, and all in its own scale.
  [[nodiscard]] bool has_multiple() const { return added_ != 0; }
  void find_forward_lobes(std::span<const LightGroup> groups, const Job& job);

  // Inputs of the cached grid and lights.
  std::optional<Environment> environment_;
  Revision medium_ = 0;
  Revision scene_medium_ = 0;
  FogBall fog_ball_;
  bool through_windows_ = false;
  LitSpace lit_;
  double extinction_ = 1.0;
  double albedo_ = 1.0;
  LobeBroadening lobe_broadening_;
  bool keeps_transmitted_ = false;
  Revision emission_ = 0;
  Revision surfaces_revision_ = 0;
  double anisotropy_ = 0.0;
  std::optional<SourceGrid::Receivers> receivers_;
  SourceGridSize size_;

  // The light of a map, in its frame.
  struct MapLight {
    // What it is made from.
    std::shared_ptr<const RadianceMap> map;
    double anisotropy = 0.0;
    std::size_t directions = 0;

    std::vector<SourceLight> lights{};
    double power = 0.0;  // of all of them
    // Per cluster, the map convolved with the forward lobe; empty without lobe.
    std::vector<std::shared_ptr<const RadianceMap>> lobes{};
    std::array<bool, source_clusters> is_narrow{};
    RadianceMap wide{};  // the light of the other clusters
  };
  // In use, and the one before: frames in motion and at rest take turns.
  MapLight light_, last_light_;
  double attenuation_ = 1.0;       // by the fog
  double lobe_attenuation_ = 1.0;  // by the fog on view rays, up to their ends
  std::array<bool, source_clusters> at_nodes_{};
  bool has_lobe_on_rays_ = false;
  PhaseBands phase_{0.0};
  std::optional<SourceGrid> grid_;
  LevelOcclusion occlusion_;
  MultipleScattering multiple_;
  // What the grid holds of it.
  Revision added_ = 0;
  double added_scale_ = 0.0;
  EyeLobe eye_lobe_;
  // The camera that eye_lobe_ is of.
  struct View {
    glm::dvec3 eye{0.0};
    CameraRays::FilmPlane plane{};
    glm::ivec2 film{0};

    bool operator==(const View& other) const {
      return eye == other.eye && film == other.film && plane.corner == other.plane.corner &&
             plane.per_x == other.plane.per_x && plane.per_y == other.plane.per_y;
    }
  };
  View view_;
};

// How slices scatter light to the eye, with a source function or without (null).
SliceScattering slice_scattering(double anisotropy, const SourceFunction* source);

}  // namespace brume
