#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "render/cpu/source_grid.h"
#include "render/cpu/source_look_up.h"
#include "render/distant_lights.h"
#include "render/job.h"
#include "render/settings.h"

namespace brume {

// The light of an environment that the medium scatters towards the eye: J of a SourceGrid, kept
// from frame to frame. A moved camera renews nothing; what the grid was made from is compared by
// value.
//
// The grid keeps few bands. What the peak of the phase function, see PhaseBands, makes of the map
// is known without the medium, for each of a few parts of it, the families. The medium dims it
//   - of a beam, light from so much the same direction as a sun's, like the mean of that light;
//   - of all others like what comes along the view ray, from behind where g > 0, from the eye where
//     g < 0, since little of what the peak sends on comes from elsewhere.
// So thin media are right for any phase function, and so are all media the narrower the peak is.
class EnvironmentSource {
 public:
  struct Input {
    const Environment& environment;
    const Medium& medium;  // of the extinction coefficient
    double anisotropy;
    double fog_depth;  // of the homogeneous part, from any point to where the fog ends
    std::optional<SourceGrid::Receivers> receivers;
    SourceGridSize size;
  };
  // False if the job was stopped: then this is empty.
  bool update(const Input& input, const Job& job);
  void clear() { grid_.reset(); }

  // From here on, of the last update().
  [[nodiscard]] const SourceGrid& grid() const { return *grid_; }
  // Another number whenever grid() is another.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] bool has_receivers() const { return grid_ && receivers_; }
  [[nodiscard]] bool has_peak() const { return !peaks_.empty(); }
  // What the peak scatters of the light that comes along a view ray, for each unit of
  // SliceShares::along_rays. `line_depth`: of the Gaussians from the eye on, all of them.
  [[nodiscard]] glm::vec3 peak(const SourceLookUp& from_eye, const SourceWeights& weights,
                               float line_depth) const;
  // For a view ray along the unit vector w.
  [[nodiscard]] SourceWeights weights(const glm::dvec3& w) const;
  // What they are made of, for who makes many at once.
  struct WeightParts {
    double scale;
    std::span<const double> factors;  // of the phase function's bands
    // What the peak makes of each family; empty: there is none.
    std::span<const std::shared_ptr<const RadianceMap>> peaks;
    std::span<const bool> is_beam;  // of the families
    double rotation;                // of these maps; see Environment
  };
  [[nodiscard]] WeightParts weight_parts() const;

 private:
  [[nodiscard]] bool has_same(const std::optional<SourceGrid::Receivers>& receivers) const;
  void read_map(const RadianceMap& map, double anisotropy, std::size_t directions, const Job& job);
  void find_peaks(std::span<const LightGroup> groups, double anisotropy, const Job& job);

  // What the grid and the lights were made from.
  Environment environment_;
  Medium medium_;
  double anisotropy_ = 0.0;
  std::optional<SourceGrid::Receivers> receivers_;
  SourceGridSize size_;

  std::vector<SourceLight> lights_;  // in the frame of the map
  double power_ = 0.0;               // of all the light
  double attenuation_ = 1.0;         // by the fog
  // For each family of lights the map that the peak of the phase function makes of it. Empty where
  // there is no peak.
  std::vector<std::shared_ptr<const RadianceMap>> peaks_;
  std::array<bool, source_families> is_beam_{};
  PhaseBands phase_{0.0};
  std::optional<SourceGrid> grid_;
  std::uint64_t revision_ = 0;
};

}  // namespace brume
