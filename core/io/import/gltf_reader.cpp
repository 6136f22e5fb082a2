// Reads what hangs on the nodes of a glTF file.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/import/gltf_animation.h"
#include "core/io/import/gltf_file.h"
#include "core/io/import/gltf_materials.h"
#include "core/io/import/gltf_mesh.h"
#include "core/io/import/gltf_nodes.h"
#include "core/io/import/node_keys.h"
#include "core/io/import/node_motion.h"
#include "core/io/import/node_transform.h"
#include "core/io/import/poses.h"
#include "core/io/import/scene_readers.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "core/scene/mesh.h"

namespace brume {
namespace {

// Nodes may share meshes: nothing in the file bounds how many primitives that are.
constexpr std::size_t max_primitives = 1 << 20;

class GltfReader {
 public:
  explicit GltfReader(const std::filesystem::path& file) : file_(file, scene_.warnings) {}

  RawScene read() {
    nodes_ = read_gltf_nodes(file_);
    read_animation();
    for (const GltfNode& node : nodes_) add_node(node);
    count_uses();
    read_materials();
    for (std::size_t i = 0; i < nodes_.size(); ++i) add_parts(i);
    center_ = center();
    for (std::size_t i = 0; i < nodes_.size(); ++i) add_camera_and_light(i);
    file_.context().finish_warnings();
    scene_.files = file_.files();
    return std::move(scene_);
  }

 private:
  void read_animation() {
    try {
      animation_ = read_gltf_animation(file_, nodes_);
    } catch (const InputError& error) {
      scene_.warnings.push_back(std::string(error.what()) + "; the animation is left out");
      animation_.tracks.resize(nodes_.size());
      animation_.weights.resize(nodes_.size());
    }
    std::vector<MovingNode> moving;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      moving.push_back(
          {nodes_[i].parent, nodes_[i].to_parent, nodes_[i].transform, animation_.tracks[i]});
    }
    motion_.emplace(file_.context().file(), std::move(moving));
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (motion_->moves(i)) nodes_[i].to_world = motion_->to_world(i, 0.0);
    }
  }

  void add_node(const GltfNode& node) {
    JsonObject object = file_.object("nodes", node.element);
    const std::string name = imported_name(object.text("name", ""), "");
    ImportedNode& result = scene_.nodes.emplace_back();
    result.name = name.empty() ? "node " + std::to_string(node.element) : name;
    result.parent = node.parent;
    const auto index = file_.index(object, "mesh", "meshes");
    if (!name.empty() || !index) return;
    result.mesh_name = imported_name(file_.object("meshes", *index).text("name", ""), "");
  }

  void read_materials() {
    GltfImages images(file_);
    for (std::size_t i = 0; i < file_.list("materials").size(); ++i) {
      materials_.push_back(read_gltf_material(file_, images, i));
    }
    materials_.emplace_back();  // of what has none
    for (const GltfMaterial& material : materials_) scene_.materials.push_back(material.material);
    scene_.images = images.all();
  }

  void count_uses() {
    uses_.resize(file_.list("meshes").size());
    for (const GltfNode& node : nodes_) {
      JsonObject object = file_.object("nodes", node.element);
      if (const auto index = file_.index(object, "mesh", "meshes")) ++uses_[*index];
    }
  }

  void add_parts(std::size_t index_of_node) {
    const GltfNode& node = nodes_[index_of_node];
    JsonObject object = file_.object("nodes", node.element);
    const auto index = file_.index(object, "mesh", "meshes");
    if (!index) return;
    Use use{index_of_node, *index, nullptr, {}, {}};
    file_.context().try_read(object.path_of("skin"), [&] { use.joints = skins_.joints(object); });
    use.transforms = gltf_instances(file_, object);
    use.weights = gltf_weights(file_, object);
    use.track = animation_.weights[index_of_node];
    const bool has_own_weights = use.weights.size() > 0 || use.track;
    // The keys are of primitives without joints.
    const glm::dmat4 outer =
        motion_->moves(index_of_node) ? add_motion(use, object) : node.to_world;
    for (glm::dmat4& transform : use.transforms) transform = outer * transform;
    if (!use.joints && !has_own_weights && (use.transforms.size() > 1 || uses_[*index] > 1)) {
      use.placements = placements_of(use.transforms);
    }
    JsonObject mesh = file_.object("meshes", *index);
    if (use.weights.size() == 0) use.weights = gltf_weights(file_, mesh);
    const Json::array_t& primitives = mesh.array("primitives", limits::surfaces);
    primitives_ += primitives.size();
    if (primitives_ > max_primitives) {
      file_.context().fail(object.path(),
                           "found more than " + std::to_string(max_primitives) +
                               " primitives of nodes; allowed: " + std::to_string(max_primitives));
    }
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      add_part(use, i, primitives[i], mesh.path_of("primitives").element(i));
    }
  }

  // A mesh at a node.
  struct Use {
    std::size_t node;
    std::size_t mesh;
    const std::vector<Joint>* joints;    // as of GltfSkins
    std::vector<glm::dmat4> transforms;  // to the world, or to what the keys place
    CopyPlacements placements;           // the same, of a mesh that is shared; else empty
    PlacementKeys keys{};                // to the world
    MorphWeights weights{};              // of its morph targets
    std::shared_ptr<const Track<MorphWeights>> track{};  // of these
  };

  // Adds the keys of a node. Returns its transform to the placements that they are of.
  glm::dmat4 add_motion(Use& use, JsonObject& object) {
    NodeKeys found = placement_keys(*motion_, use.node);
    if (found.is_stretched) {
      file_.context().warn(object.path(),
                           "its animation stretches it along one axis: it keeps its proportions");
    }
    use.keys = std::move(found.keys);
    return found.to_placed;
  }

  void add_part(const Use& use, std::size_t index, const Json& value, const JsonPath& path) {
    const auto shared = shared_parts_.find({use.mesh, index});
    if (!use.placements.empty() && shared != shared_parts_.end()) {
      scene_.parts.push_back({use.node,
                              scene_.parts[shared->second].material,
                              {},
                              use.placements,
                              shared->second,
                              use.keys});
      return;
    }
    JsonObject primitive(file_.context(), value, path);
    constexpr std::int64_t triangles = 4;
    const std::int64_t mode = primitive.integer("mode", 0, 6, triangles);
    if (mode < triangles) {
      const Json* extensions = primitive.find("extensions");
      const bool are_splats = extensions != nullptr && extensions->is_object() &&
                              extensions->contains("KHR_gaussian_splatting");
      file_.context().warn(path, are_splats
                                     ? "Gaussian splats are no surfaces: they are read as Gaussians"
                                     : "points and lines are left out");
      note_left_out(path, are_splats ? "Gaussian splats" : mode == 0 ? "points" : "lines");
      return;
    }
    if (meshes_ + use.transforms.size() > limits::surfaces && use.placements.empty()) {
      file_.context().fail(path,
                           "found more than " + std::to_string(limits::surfaces) +
                               " meshes of nodes; allowed: " + std::to_string(limits::surfaces));
    }
    RawPart part;
    part.node = use.node;
    part.material = file_.index(primitive, "material", "materials").value_or(materials_.size() - 1);
    Deformation mesh = read_mesh(primitive, mode, use, part);
    if (mesh.rest.triangles.empty()) return;
    const auto add = [&](RawPart added, const glm::dmat4& to_world) {
      bytes_ += mesh_bytes(added.mesh) + added.keys.bytes();
      if (added.deformation) bytes_ += added.deformation->bytes();
      if (bytes_ > limits::scene_bytes / 4) {
        file_.context().fail(path, "the meshes up to here take more memory than the allowed " +
                                       std::to_string(limits::scene_bytes / 4) + " bytes");
      }
      ++meshes_;
      apply_transform(to_world, file_.context().file(), path.text(), added.mesh);
      scene_.parts.push_back(std::move(added));
    };
    const bool is_skinned = !mesh.influences.empty();
    const bool is_shared = !is_skinned && !use.placements.empty();
    if (is_shared) {
      shared_parts_[{use.mesh, index}] = scene_.parts.size();
      part.placements = use.placements;
    }
    if (!is_skinned) part.keys = use.keys;
    const std::vector<glm::dmat4> here{glm::dmat4(1.0)};
    const std::vector<glm::dmat4>& transforms = is_skinned || is_shared ? here : use.transforms;
    for (const glm::dmat4& to_world : transforms) {
      RawPart added = part;
      if (!is_skinned && mesh.targets.empty()) {
        added.mesh = &to_world == &transforms.back() ? std::move(mesh.rest) : mesh.rest;
        if (added.mesh.normals.empty()) add_flat_normals(added.mesh);
        add(std::move(added), to_world);
      } else {
        DeformationMotion motion{{}, use.weights, use.track};
        motion.joints = is_skinned ? *use.joints : std::vector<Joint>{{std::nullopt, to_world}};
        added.mesh = deformed(mesh, pose_at(motion, *motion_, 0.0));
        file_.context().try_read(
            path, [&] { added.deformation = moving_deformation(mesh, motion, *motion_); });
        add(std::move(added), glm::dmat4(1.0));
      }
    }
  }

  void note_left_out(const JsonPath& path, const std::string& what) {
    if (scene_.left_out.empty()) scene_.left_out = path.text() + ": found " + what;
  }

  // Reads the mesh of a part whose node and material are set, with the influences of the joints of
  // its skin.
  Deformation read_mesh(JsonObject& primitive, std::int64_t mode, const Use& use,
                        const RawPart& part) {
    JsonObject attributes = primitive.object("attributes");
    const JsonPath& path = attributes.path();
    static_cast<void>(attributes.required("POSITION"));
    if (const std::string name = compression(primitive, attributes); !name.empty()) {
      const ImportedNode& node = scene_.nodes[part.node];
      const std::string data = "data compressed by " + quoted_text(name);
      file_.context().warn(path, "a mesh of the node " +
                                     (node.mesh_name.empty() ? node.name : node.mesh_name) +
                                     " is missing: it has only " + data +
                                     "; export it again without " + compression_kind(name));
      note_left_out(path, data);
      return {};
    }
    Deformation mesh = read_gltf_mesh(file_, primitive, mode, materials_[part.material].texcoords);
    if (use.joints) {
      file_.context().try_read(
          path, [&] { read_gltf_influences(file_, attributes, use.joints->size(), mesh); });
    }
    return mesh;
  }

  // The extension that compresses points or triangles where nothing else has them; else empty.
  std::string compression(JsonObject& primitive, JsonObject& attributes) {
    const auto points = file_.index(attributes, "POSITION", "accessors");
    const auto indices = file_.index(primitive, "indices", "accessors");
    const Json* const extensions = primitive.find("extensions");
    std::string found = file_.compression(extensions, *points);
    return found.empty() && indices ? file_.compression(extensions, *indices) : found;
  }

  void add_camera_and_light(std::size_t index_of_node) {
    const GltfNode& node = nodes_[index_of_node];
    JsonObject object = file_.object("nodes", node.element);
    if (const auto camera = file_.index(object, "camera", "cameras"))
      add_camera(index_of_node, *camera);
    auto extensions = object.find_object("extensions");
    if (!extensions) return;
    if (auto light = extensions->find_object("KHR_lights_punctual")) {
      add_light(index_of_node, *light);
    }
  }

  // The middle of the scene's meshes.
  [[nodiscard]] glm::dvec3 center() const {
    glm::dvec3 low(limits::coordinate);
    glm::dvec3 high(-limits::coordinate);
    const auto add = [&](const glm::dvec3& point) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    };
    for (const RawPart& part : scene_.parts) {
      for (const Key<glm::dvec3>& key : part.keys.translate) add(key.value);
      for (const CopyPlacement& placement : part.placements) {
        if (part.keys.empty()) add(placement.translate);
      }
      if (!part.placements.empty() || !part.keys.empty()) continue;
      for (const glm::vec3& point : part.mesh.points) add(glm::dvec3(point));
    }
    return scene_.parts.empty() ? glm::dvec3(0.0) : 0.5 * (low + high);
  }

  void add_camera(std::size_t node, std::size_t index) {
    if (scene_.cameras.size() >= limits::cameras) return;
    JsonObject object = file_.object("cameras", index);
    if (object.choice("type", {"perspective", "orthographic"}, {}) == 1) {
      JsonObject orthographic = object.object("orthographic");
      // Turned over if negative, which should not be.
      const double height = 2.0 * std::abs(orthographic.number("ymag", domain::coordinate, {}));
      if (!domain::length.contains(height)) {
        file_.context().warn(orthographic.path(), "the camera sees nothing, and is left out");
        return;
      }
      Camera camera = camera_of_node(nodes_[node].to_world, center_, Camera().vertical_fov);
      camera.height = height;
      add_camera(node, camera);
      return;
    }
    JsonObject perspective = object.object("perspective");
    static constexpr NumberDomain half_turn{0.0, std::numbers::pi, "a number in (0, pi) radians",
                                            true};
    const double fov = glm::degrees(perspective.number("yfov", half_turn, {}));
    add_camera(node, camera_of_node(nodes_[node].to_world, center_, std::min(fov, 179.999)));
  }

  void add_camera(std::size_t node, const Camera& camera) {
    NamedCamera& added = scene_.cameras.emplace_back();
    added.name = scene_.nodes[node].name;
    added.camera = camera;
    if (motion_->moves(node)) add_keys(*motion_, node, center_, added);
  }

  void add_light(std::size_t node, JsonObject& use) {
    if (scene_.lights.size() >= limits::lights) return;
    JsonObject root = file_.root();
    JsonObject extensions = root.object("extensions");
    JsonObject punctual = extensions.object("KHR_lights_punctual");
    const Json::array_t& lights = punctual.array("lights", limits::gaussians);
    if (lights.empty()) use.fail("light", "refers to lights; the file has none");
    static_cast<void>(use.required("light"));
    const auto index = static_cast<std::size_t>(
        use.integer("light", 0, static_cast<std::int64_t>(lights.size()) - 1, 0));
    JsonObject object(file_.context(), lights[index], punctual.path_of("lights").element(index));
    Light light;
    light.name = scene_.nodes[node].name;
    light.position = nodes_[node].to_world[3];
    light.intensity = nearest_vector(file_, object, "color", domain::unit, glm::dvec3(1.0)) *
                      nearest_number(file_, object, "intensity", domain::intensity, 1.0) /
                      lumens_per_watt;
    glm::dvec3 direction = -glm::dvec3(nodes_[node].to_world[2]);
    if (const double length = glm::length(direction); length > 0.0) direction /= length;
    const std::size_t type = object.choice("type", {"point", "spot", "directional"}, {});
    if (type != 0 && direction == glm::dvec3(0.0)) {
      file_.context().fail(object.path(), "has no direction: the scale of its node is 0");
    }
    if (type == 1) light.kind = read_cone(object, direction);
    if (type == 2) light.kind = light::Directional{direction};
    if (motion_->moves(node)) add_keys(*motion_, node, light);
    scene_.lights.push_back(std::move(light));
  }

  light::Spot read_cone(JsonObject& light, const glm::dvec3& direction) {
    light::Spot cone{direction};
    auto spot = light.find_object("spot");
    if (!spot) return cone;
    static constexpr double quarter_turn = std::numbers::pi / 2 + 1e-6;
    static constexpr NumberDomain outer_angles{1e-6, quarter_turn, "a number in (0, pi/2] radians"};
    const double outer =
        nearest_number(file_, *spot, "outerConeAngle", outer_angles, std::numbers::pi / 4);
    const NumberDomain inner_angles{0.0, outer, "a number from 0 to outerConeAngle"};
    cone.inner_angle =
        glm::degrees(nearest_number(file_, *spot, "innerConeAngle", inner_angles, 0.0));
    cone.outer_angle = glm::degrees(outer);
    return cone;
  }

  RawScene scene_;
  GltfFile file_;
  std::vector<GltfNode> nodes_;
  GltfAnimation animation_;
  std::optional<NodeMotion> motion_;
  GltfSkins skins_{file_, nodes_};
  std::vector<GltfMaterial> materials_;
  glm::dvec3 center_{0.0};
  std::size_t bytes_ = 0;
  std::vector<std::size_t> uses_;  // of each mesh, by nodes
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> shared_parts_;  // by mesh, primitive
  std::size_t meshes_ = 0;                                                   // of parts
  std::size_t primitives_ = 0;
};

}  // namespace

RawScene read_gltf(const std::filesystem::path& file) {
  return GltfReader(file).read();
}

}  // namespace brume
