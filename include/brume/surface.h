#pragma once

#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brume/copies.h"
#include "brume/keys.h"
#include "brume/metallic_roughness.h"
#include "brume/object_id.h"
#include "brume/primitive.h"

namespace brume {

class MeasuredBrdf;
struct ImportedScene;
struct TriangleMesh;

// Reflection of a surface; evaluated by core/scene/materials/brdf.h.
struct Material {
  enum class Type { diffuse, phong, measured, metallic_roughness };
  Type type = Type::diffuse;
  glm::dvec3 reflectance{0.5};   // diffuse albedo, RGB in [0, 1]; the diffuse BRDF is this / pi
  glm::dvec3 specular{0.0};      // phong only, RGB in [0, 1]
  double exponent = 1.0;         // phong only, >= 0
  std::filesystem::path file{};  // measured only: a MERL .binary
  std::shared_ptr<const MeasuredBrdf> measured{};  // its content; never null in a loaded scene
  MetallicRoughness metallic_roughness{};          // metallic_roughness only
  std::string name{};  // an imported material has that of its file; empty: none

  bool operator==(const Material&) const = default;
};

// Keyframes of its placement, and of a material that is not measured.
struct SurfaceKeys {
  Keys<glm::dvec3> translate;
  Keys<glm::dquat> rotate;
  Keys<double> scale;
  Keys<glm::dvec3> reflectance;
  // Phong only:
  Keys<glm::dvec3> specular;
  Keys<double> exponent;

  bool operator==(const SurfaceKeys&) const = default;
};

// A mesh placed in the scene: world = translate + rotate * (scale * mesh). Or nodes of another
// program's scene, placed in the same way: frames show them with the meshes of that file and its
// materials (shown_surfaces()), or those of `materials` with the same names; `mesh` is all of them
// as one, and `material` counts for nothing.
struct Surface {
  enum class Transfer { none, shadow, interreflection };
  std::string name{};                    // empty: none of its own
  std::filesystem::path mesh_file{};     // of `mesh` or `imported`; empty for a primitive
  std::optional<Primitive> primitive{};  // what the mesh is made of instead of a file
  std::shared_ptr<const ImportedScene> imported{};  // null: a mesh alone
  std::vector<std::string> nodes{};                 // chosen of `imported`; empty: all
  std::shared_ptr<const TriangleMesh> mesh{};       // never null in a loaded scene
  glm::dvec3 translate{0.0};
  glm::dquat rotate{1.0, 0.0, 0.0, 0.0};  // unit
  double scale = 1.0;                     // > 0
  Material material{};
  std::vector<Material> materials{};  // in place of those of `imported` that have their names
  SurfaceKeys keys{};
  Transfer transfer = Transfer::none;
  std::optional<Copies> copies{};
  // Its copies' meshes in the world, of surfaces that frames show: see evaluate_at().
  std::shared_ptr<const CopyPlacements> placed_copies{};
  bool visible = true;  // else no frame has it: evaluate_at() leaves it out
  bool locked = false;  // for editors: not to be changed in the view
  // The eye does not see it, but what is behind the picture in its place; all else does.
  bool holdout = false;
  ObjectId id = 0;

  bool operator==(const Surface&) const = default;
};

}  // namespace brume
