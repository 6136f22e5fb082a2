#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brume/camera.h"
#include "brume/emitter.h"
#include "brume/export.h"
#include "brume/group.h"
#include "brume/keys.h"
#include "brume/lights.h"
#include "brume/medium.h"
#include "brume/medium_sequence.h"
#include "brume/object_id.h"
#include "brume/output.h"
#include "brume/painted_spline.h"
#include "brume/surface.h"

namespace brume {

struct NoiseKeys {
  Keys<double> amplitude;
  Keys<double> frequency;
  Keys<glm::dvec3> velocity;

  bool operator==(const NoiseKeys&) const = default;
};

// Noise that displaces view rays; see core/scene/ray_noise.h.
struct Noise {
  double amplitude = 0.0;    // rms displacement relative to the radius, >= 0; 0: off
  double frequency = 1.0;    // lattice cells per u, >= 0
  glm::dvec3 velocity{0.0};  // of the pattern [u/s]
  std::int64_t seed = 0;
  NoiseKeys keys{};

  bool operator==(const Noise&) const = default;
};

// Keys of the homogeneous density are in Scene::density_keys.
struct MediumKeys {
  Keys<glm::dvec3> albedo;
  Keys<double> anisotropy;
  Keys<double> extent;

  bool operator==(const MediumKeys&) const = default;
};

// Optical properties of the medium besides density.
struct MediumOptics {
  glm::dvec3 albedo{
      1.0};  // single-scattering albedo, RGB in (0, 1]; extinction = scattering / albedo
  double anisotropy = 0.0;  // g of Henyey-Greenstein, in [-0.95, 0.95]
  // How far homogeneous fog reaches from the middle of the scene: it is in this ball alone [u].
  // Absent: see FogExtent.
  std::optional<double> extent{};
  Noise noise;
  MediumKeys keys{};

  bool operator==(const MediumOptics&) const = default;
};

// A camera that is not in use. Each camera of a scene has another name, never an empty one.
struct NamedCamera {
  std::string name;
  Camera camera;
  CameraKeys keys;
  ObjectId id = 0;

  bool operator==(const NamedCamera&) const = default;
};
inline constexpr const char* default_camera_name = "Camera";

inline constexpr double default_frame_rate = 30.0;

// The frames of a scene that are played, from time 0 on.
struct Playback {
  int first = 0;  // 0 <= first <= last <= limits::frame
  int last = 0;
  bool loops = true;
  double frames_per_second = default_frame_rate;  // of domain::frame_rate

  bool operator==(const Playback&) const = default;
};

// Everything a frame needs except the way it is rendered. A value: copying shares the meshes.
// Paths are absolute.
struct Scene {
  Camera camera;  // the one in use
  CameraKeys camera_keys;
  std::string camera_name = default_camera_name;
  ObjectId camera_id = 0;
  std::vector<NamedCamera> cameras;  // the others
  Film film;
  Output output;
  Medium medium;
  Keys<double> density_keys;  // of the medium's homogeneous density
  MediumOptics optics;
  std::vector<Group> groups;              // of the medium's Gaussians
  std::vector<PaintedSpline> splines;     // that some of them were painted along
  std::vector<Emitter> emitters;          // their particles are not in `medium`, see evaluate_at()
  std::vector<MediumSequence> sequences;  // not in `medium` either
  std::vector<Light> lights;
  std::optional<Environment> environment;
  std::vector<Surface> surfaces;
  std::optional<Playback> playback;  // absent: all that moves, again and again
  double time = 0.0;                 // that it shows [s], see evaluate_at(); not saved

  bool operator==(const Scene&) const = default;
};

// Checks what a program made: every value is in its domain, references are to what there is, ids
// and names are unique where they must be. Throws DomainError. Loaded scenes are checked already.
BRUME_EXPORT void check(const Scene& scene);
// The values of Gaussians alone: a pass over the columns.
BRUME_EXPORT void check(const Medium& medium);
BRUME_EXPORT void check(const Camera& camera);

}  // namespace brume
