#pragma once

#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/medium/medium.h"
#include "core/scene/camera.h"
#include "core/scene/emitter.h"
#include "core/scene/group.h"
#include "core/scene/keys.h"
#include "core/scene/medium_sequence.h"
#include "core/scene/metallic_roughness.h"
#include "core/scene/object_id.h"
#include "core/scene/output.h"
#include "core/scene/painted_spline.h"
#include "core/scene/primitive.h"

namespace brume {

class MeasuredBrdf;
class PhotometricProfile;
struct ImportedScene;
struct RadianceMap;
struct TriangleMesh;

// ...Keys are the keyframes of an object's values; see core/scene/animation.h.
struct LightKeys {
  Keys<glm::dvec3> position;
  Keys<glm::dvec3> intensity;
  Keys<glm::dvec3> direction;  // of all but a point light and a sphere
  // Of a spot.
  Keys<double> inner_angle;
  Keys<double> outer_angle;
  Keys<double> profile_rotation;
  Keys<double> angular_diameter;  // of a directional light
  // Of an area light.
  Keys<glm::dvec3> up;
  Keys<double> width;
  Keys<double> height;
  Keys<double> radius;

  bool operator==(const LightKeys&) const = default;
};

// The cone of a spot light: full intensity within the inner angle, none beyond the outer one; see
// core/scene/light_falloff.h.
struct SpotCone {
  glm::dvec3 direction{0.0, -1.0, 0.0};  // the way it shines; any length but 0
  double inner_angle = 0.0;              // from the axis, >= 0, below outer_angle [degrees]
  double outer_angle = 45.0;             // at most 180 [degrees]

  bool operator==(const SpotCone&) const = default;
};

// How a luminaire spreads the light of a point light, whose axis is straight down, or of a spot,
// within its cone; see core/scene/light_falloff.h.
struct LightProfile {
  std::filesystem::path file;                         // IES LM-63
  std::shared_ptr<const PhotometricProfile> content;  // null: none
  double rotation = 0.0;  // about the axis, counterclockwise against it [degrees]

  bool operator==(const LightProfile&) const = default;
};

// How a directional light shines: the sun, or anything as far away. Methods evaluate it as
// core/scene/point_lights.h has it.
struct Directional {
  glm::dvec3 direction{0.0, -1.0, 0.0};  // the way it shines; any length but 0
  double angular_diameter = 0.0;         // of its disc, in [0, 90) [degrees]

  bool operator==(const Directional&) const = default;
};

// A surface that shines with the same radiance everywhere and in all directions of its front, or of
// both sides. It is not seen itself and keeps no light out, as point lights.
struct AreaLight {
  enum class Shape { rectangle, disk, sphere };
  Shape shape = Shape::rectangle;
  glm::dvec3 direction{0.0, -1.0, 0.0};  // normal of its front; any length but 0; not of a sphere
  glm::dvec3 up{0.0, 1.0, 0.0};          // along the height of a rectangle, but for the normal
  double width = 1.0, height = 1.0;      // of a rectangle, > 0 [u]
  double radius = 0.5;                   // of a disk or sphere, > 0 [u]
  bool two_sided = false;                // a sphere then shines inwards, too

  bool operator==(const AreaLight&) const = default;
};

// A point light, a spot (a point light with a cone), a directional or an area light. Intensity,
// RGB, >= 0: of a point light radiant intensity [W/sr], of a spot that on its axis, with a profile
// that in its brightest direction, of a directional light irradiance on what faces it, without any
// medium [W/u^2], of an area light radiance [W/(sr u^2)].
struct Light {
  glm::dvec3 position{0.0};  // an area light's center; of no meaning for a directional light
  glm::dvec3 intensity{1.0};
  std::optional<SpotCone> spot{};  // at most one of these
  std::optional<Directional> directional{};
  std::optional<AreaLight> area{};
  LightProfile profile{};  // of a point light or a spot
  LightKeys keys{};
  std::string name{};  // empty: none of its own
  bool on = true;
  bool locked = false;  // for editors: not to be changed in the view
  ObjectId id = 0;

  bool operator==(const Light&) const = default;
};

struct EnvironmentKeys {
  Keys<double> intensity;
  Keys<double> rotation;

  bool operator==(const EnvironmentKeys&) const = default;
};

// An environment map; rotation about +y in degrees. Evaluated by core/scene/environment.h.
struct Environment {
  std::filesystem::path file;
  std::shared_ptr<const RadianceMap> map;  // never null in a loaded scene
  double intensity = 1.0;
  double rotation = 0.0;
  EnvironmentKeys keys{};
  ObjectId id = 0;

  bool operator==(const Environment&) const = default;
};

// Reflection of a surface; evaluated by core/scene/brdf.h.
struct Material {
  enum class Type { diffuse, phong, measured, metallic_roughness };
  Type type = Type::diffuse;
  glm::dvec3 reflectance{0.5};  // diffuse albedo, RGB in [0, 1]; the diffuse BRDF is this / pi
  glm::dvec3 specular{0.0};     // phong only, RGB in [0, 1]
  double exponent = 1.0;        // phong only, >= 0
  std::filesystem::path file;   // measured only: a MERL .binary
  std::shared_ptr<const MeasuredBrdf> measured;  // its content; never null in a loaded scene
  MetallicRoughness metallic_roughness{};        // metallic_roughness only

  bool operator==(const Material&) const = default;
};

// Of its placement, and of a material that is not measured.
struct SurfaceKeys {
  Keys<glm::dvec3> translate;
  Keys<glm::dquat> rotate;
  Keys<double> scale;
  Keys<glm::dvec3> reflectance;
  // Of phong.
  Keys<glm::dvec3> specular;
  Keys<double> exponent;

  bool operator==(const SurfaceKeys&) const = default;
};

// A mesh placed in the scene: world = translate + rotate * (scale * mesh). Or nodes of another
// program's scene, placed in the same way: frames show them with the meshes and materials of that
// file (shown_surfaces()); `mesh` is all of them as one, and `material` counts for nothing.
struct Surface {
  enum class Transfer { none, shadow, interreflection };
  std::string name;                               // empty: none of its own
  std::filesystem::path mesh_file;                // of `mesh` or `imported`; empty for a primitive
  std::optional<Primitive> primitive;             // what the mesh is made of instead of a file
  std::shared_ptr<const ImportedScene> imported;  // null: a mesh alone
  std::vector<std::string> nodes;                 // chosen of `imported`; empty: all
  std::shared_ptr<const TriangleMesh> mesh;       // never null in a loaded scene
  glm::dvec3 translate{0.0};
  glm::dquat rotate{1.0, 0.0, 0.0, 0.0};  // unit
  double scale = 1.0;                     // > 0
  Material material;
  SurfaceKeys keys{};
  Transfer transfer = Transfer::none;
  bool visible = true;  // else no frame has it: evaluate_at() leaves it out
  bool locked = false;  // for editors: not to be changed in the view
  ObjectId id = 0;

  bool operator==(const Surface&) const = default;
};

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

  bool operator==(const MediumKeys&) const = default;
};

// Optical properties of the medium besides density.
struct MediumOptics {
  glm::dvec3 albedo{
      1.0};  // single-scattering albedo, RGB in (0, 1]; extinction = scattering / albedo
  double anisotropy = 0.0;  // g of Henyey-Greenstein, in [-0.95, 0.95]
  Noise noise;
  MediumKeys keys{};

  bool operator==(const MediumOptics&) const = default;
};

struct CameraKeys {
  Keys<glm::dvec3> eye;
  Keys<glm::dvec3> target;
  Keys<double> vertical_fov;
  Keys<double> aperture;
  Keys<double> focus_distance;  // of a camera that has one

  bool operator==(const CameraKeys&) const = default;
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

// What is played of a scene: frames from time 0 on.
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

}  // namespace brume
