// The nodes of a glTF file, and what hangs on them.

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/import/gltf_file.h"
#include "core/io/import/gltf_materials.h"
#include "core/io/import/node_transform.h"
#include "core/io/import/scene_readers.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

class GltfReader {
 public:
  explicit GltfReader(const std::filesystem::path& file) : file_(file, scene_.warnings) {}

  RawScene read() {
    read_nodes();
    scene_.images = read_gltf_images(file_);
    read_materials();
    for (const Node& node : nodes_) add_parts(node);
    center_ = center();
    for (const Node& node : nodes_) add_camera_and_light(node);
    file_.context().finish_warnings();
    scene_.files = file_.files();
    return std::move(scene_);
  }

 private:
  struct Node {
    std::size_t element;  // of the list `nodes`
    std::size_t index;    // of scene_.nodes
    glm::dmat4 to_world;
  };

  // Roots of the default scene; of all nodes, if the file has no scene.
  std::vector<std::size_t> roots() {
    const std::size_t count = file_.list("nodes").size();
    JsonObject root(file_.context(), file_.root(), file_.path());
    const Json::array_t& scenes = file_.list("scenes");
    if (!scenes.empty()) {
      const std::size_t index = file_.index(root, "scene", "scenes").value_or(0);
      const JsonPath list = file_.path().member("scenes");
      const JsonPath path = list.element(index);
      JsonObject scene(file_.context(), scenes[index], path);
      return node_indices(scene, "nodes");
    }
    std::vector<bool> is_child(count, false);
    const JsonPath list = file_.path().member("nodes");
    for (std::size_t i = 0; i < count; ++i) {
      const JsonPath path = list.element(i);
      JsonObject node(file_.context(), file_.list("nodes")[i], path);
      for (const std::size_t child : node_indices(node, "children")) is_child[child] = true;
    }
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_child[i]) result.push_back(i);
    }
    return result;
  }

  std::vector<std::size_t> node_indices(JsonObject& object, const char* key) {
    const std::size_t count = file_.list("nodes").size();
    std::vector<std::size_t> indices;
    for (const Json& value : object.array(key, count)) {
      if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= count) {
        object.fail(key, "found " + quoted_json(value) + "; allowed: one of the " +
                             std::to_string(count) + " nodes");
      }
      indices.push_back(value.get<std::size_t>());
    }
    return indices;
  }

  // Parents come before their children.
  void read_nodes() {
    struct Visit {
      std::size_t element;
      std::optional<std::size_t> parent;
    };
    std::vector<Visit> open;
    for (const std::size_t root : roots()) open.push_back({root, std::nullopt});
    std::ranges::reverse(open);
    std::vector<bool> is_known(file_.list("nodes").size(), false);
    const JsonPath list = file_.path().member("nodes");
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      const JsonPath path = list.element(visit.element);
      JsonObject object(file_.context(), file_.list("nodes")[visit.element], path);
      if (is_known[visit.element]) {
        file_.context().fail(path, "is the child of more than one node; allowed: a tree");
      }
      is_known[visit.element] = true;
      if (nodes_.size() >= max_imported_nodes) {
        file_.context().fail(list, "found more than " + std::to_string(max_imported_nodes) +
                                       " nodes; allowed: " + std::to_string(max_imported_nodes));
      }
      const std::size_t index = nodes_.size();
      scene_.nodes.push_back(
          {imported_name(object.text("name", ""), "node " + std::to_string(visit.element)),
           visit.parent});
      const glm::dmat4 parent = visit.parent ? nodes_[*visit.parent].to_world : glm::dmat4(1.0);
      nodes_.push_back({visit.element, index, parent * transform(object)});
      check_transform(path, nodes_.back().to_world);
      std::vector<std::size_t> children = node_indices(object, "children");
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        open.push_back({*child, index});
      }
    }
  }

  void check_transform(const JsonPath& path, const glm::dmat4& to_world) {
    for (int k = 0; k < 16; ++k) {
      const double value = to_world[k / 4][k % 4];
      if (domain::coordinate.contains(value)) continue;
      file_.context().fail(path,
                           "its transform in the scene: " + domain::coordinate.refusal(value));
    }
  }

  glm::dmat4 transform(JsonObject& node) {
    if (const Json* matrix = node.find("matrix")) {
      const std::vector<double> m =
          read_numbers(file_.context(), *matrix, node.path_of("matrix"), 16, domain::coordinate);
      glm::dmat4 result;
      for (int k = 0; k < 16; ++k) result[k / 4][k % 4] = m[static_cast<std::size_t>(k)];
      return result;
    }
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    if (const Json* value = node.find("rotation")) {
      const std::vector<double> q =
          read_numbers(file_.context(), *value, node.path_of("rotation"), 4, domain::coordinate);
      rotation = glm::dquat(q[3], q[0], q[1], q[2]);
      const double length = glm::length(rotation);
      if (!(length > 0.0)) node.fail("rotation", "found length 0; allowed: a unit quaternion");
      rotation /= length;
    }
    const glm::dvec3 scale = node.vector("scale", domain::coordinate, glm::dvec3(1.0));
    const glm::dvec3 translation = node.vector("translation", domain::coordinate, glm::dvec3(0.0));
    return glm::translate(glm::dmat4(1.0), translation) * glm::mat4_cast(rotation) *
           glm::scale(glm::dmat4(1.0), scale);
  }

  void read_materials() {
    const Json::array_t& list = file_.list("materials");
    const JsonPath path = file_.path().member("materials");
    for (std::size_t i = 0; i < list.size(); ++i) {
      materials_.push_back(read_gltf_material(file_, list[i], path.element(i)));
    }
    materials_.emplace_back();  // of what has none
    for (const GltfMaterial& material : materials_) scene_.materials.push_back(material.material);
  }

  void add_parts(const Node& node) {
    const JsonPath nodes = file_.path().member("nodes");
    const JsonPath node_path = nodes.element(node.element);
    JsonObject object(file_.context(), file_.list("nodes")[node.element], node_path);
    const auto index = file_.index(object, "mesh", "meshes");
    if (!index) return;
    if (object.find("skin")) {
      file_.context().warn(object.path_of("skin"), "the mesh is shown as it is without its skin");
    }
    const JsonPath meshes = file_.path().member("meshes");
    const JsonPath path = meshes.element(*index);
    JsonObject mesh(file_.context(), file_.list("meshes")[*index], path);
    const Json::array_t& primitives = mesh.array("primitives", limits::surfaces);
    const JsonPath primitives_path = path.member("primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      add_part(node, primitives[i], primitives_path.element(i));
    }
  }

  void add_part(const Node& node, const Json& value, const JsonPath& path) {
    JsonObject primitive(file_.context(), value, path);
    constexpr std::int64_t triangles = 4;
    const std::int64_t mode = primitive.integer("mode", 0, 6, triangles);
    if (mode < triangles) {
      file_.context().warn(path, "points and lines are left out");
      return;
    }
    if (scene_.parts.size() >= limits::surfaces) {
      file_.context().fail(path,
                           "found more than " + std::to_string(limits::surfaces) +
                               " meshes of nodes; allowed: " + std::to_string(limits::surfaces));
    }
    RawPart part;
    part.node = node.index;
    part.material = file_.index(primitive, "material", "materials").value_or(materials_.size() - 1);
    read_mesh(primitive, mode, materials_[part.material], part.mesh);
    if (part.mesh.triangles.empty()) return;
    bytes_ += part.mesh.points.size() * (sizeof(glm::vec3) * 2 + sizeof(glm::vec2)) +
              part.mesh.triangles.size() * sizeof(glm::uvec3);
    if (bytes_ > limits::scene_bytes / 4) {  // a mesh takes up to four times its arrays
      file_.context().fail(path, "the meshes up to here take more memory than the allowed " +
                                     std::to_string(limits::scene_bytes) + " bytes");
    }
    apply_transform(node.to_world, file_.context().file(), path.text(), part.mesh);
    scene_.parts.push_back(std::move(part));
  }

  void read_mesh(JsonObject& primitive, std::int64_t mode, const GltfMaterial& material,
                 MeshArrays& mesh) {
    const JsonPath path = primitive.path_of("attributes");
    JsonObject attributes(file_.context(), primitive.required("attributes"), path);
    static_cast<void>(attributes.required("POSITION"));
    mesh.points = vectors<glm::vec3>(attributes, "POSITION");
    mesh.normals = vectors<glm::vec3>(attributes, "NORMAL");
    if (attributes.find("COLOR_0")) {
      file_.context().warn(attributes.path_of("COLOR_0"), "colors of vertices are left out");
    }
    const std::string set = "TEXCOORD_" + std::to_string(material.texcoord_set);
    for (const glm::vec2& uv : vectors<glm::vec2>(attributes, set)) {
      const glm::dvec2 moved(material.texcoord_transform * glm::dvec3(uv, 1.0));
      mesh.texcoords.push_back(texcoord(moved));
    }
    for (const std::size_t count : {mesh.normals.size(), mesh.texcoords.size()}) {
      if (count == 0 || count == mesh.points.size()) continue;
      file_.context().fail(path, "found " + std::to_string(count) + " values for " +
                                     std::to_string(mesh.points.size()) + " vertices");
    }
    add_triangles(primitive, mode, mesh);
    if (mesh.normals.empty()) add_flat_normals(mesh);
  }

  // v up, as Brume has it.
  static glm::vec2 texcoord(const glm::dvec2& uv) {
    constexpr double longest = 1e6;
    const bool is_valid = std::abs(uv.x) <= longest && std::abs(uv.y) <= longest;
    return is_valid ? glm::vec2(uv.x, 1.0 - uv.y) : glm::vec2(0.0f);
  }

  template <class Vector>
  std::vector<Vector> vectors(JsonObject& attributes, const std::string& key) {
    const auto accessor = file_.index(attributes, key, "accessors");
    if (!accessor) return {};
    constexpr auto size = static_cast<std::size_t>(Vector::length());
    const std::vector<float> numbers = file_.numbers(attributes.path_of(key), *accessor, size);
    std::vector<Vector> result(numbers.size() / size);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      result[i / size][static_cast<int>(i % size)] = numbers[i];
    }
    return result;
  }

  void add_triangles(JsonObject& primitive, std::int64_t mode, MeshArrays& mesh) {
    const auto count = static_cast<unsigned>(mesh.points.size());
    std::vector<unsigned> corners;
    if (const auto accessor = file_.index(primitive, "indices", "accessors")) {
      corners = file_.indices(primitive.path_of("indices"), *accessor);
    } else {
      for (unsigned i = 0; i < count; ++i) corners.push_back(i);
    }
    for (const unsigned corner : corners) {
      if (corner < count) continue;
      primitive.fail("indices", "found vertex " + std::to_string(corner) + "; allowed: less than " +
                                    std::to_string(count));
    }
    const auto add = [&mesh](unsigned a, unsigned b, unsigned c) {
      if (a != b && b != c && c != a) mesh.triangles.emplace_back(a, b, c);
    };
    constexpr std::int64_t list = 4;
    constexpr std::int64_t strip = 5;
    for (std::size_t i = 0; i + 2 < corners.size(); i += mode == list ? 3 : 1) {
      if (mode == list || (mode == strip && i % 2 == 0)) {
        add(corners[i], corners[i + 1], corners[i + 2]);
      } else if (mode == strip) {
        add(corners[i + 1], corners[i], corners[i + 2]);
      } else {
        add(corners[0], corners[i + 1], corners[i + 2]);
      }
    }
  }

  void add_camera_and_light(const Node& node) {
    const JsonPath nodes = file_.path().member("nodes");
    const JsonPath path = nodes.element(node.element);
    JsonObject object(file_.context(), file_.list("nodes")[node.element], path);
    if (const auto camera = file_.index(object, "camera", "cameras")) add_camera(node, *camera);
    const Json* extensions = object.find("extensions");
    if (extensions == nullptr) return;
    const JsonPath extensions_path = object.path_of("extensions");
    JsonObject all(file_.context(), *extensions, extensions_path);
    if (const Json* use = all.find("KHR_lights_punctual")) {
      const JsonPath use_path = all.path_of("KHR_lights_punctual");
      JsonObject light(file_.context(), *use, use_path);
      add_light(node, light);
    }
  }

  // The middle of the scene's meshes.
  [[nodiscard]] glm::dvec3 center() const {
    glm::dvec3 low(limits::coordinate);
    glm::dvec3 high(-limits::coordinate);
    for (const RawPart& part : scene_.parts) {
      for (const glm::vec3& point : part.mesh.points) {
        low = glm::min(low, glm::dvec3(point));
        high = glm::max(high, glm::dvec3(point));
      }
    }
    return scene_.parts.empty() ? glm::dvec3(0.0) : 0.5 * (low + high);
  }

  void add_camera(const Node& node, std::size_t index) {
    if (scene_.cameras.size() >= limits::cameras) return;
    const JsonPath list = file_.path().member("cameras");
    const JsonPath path = list.element(index);
    JsonObject object(file_.context(), file_.list("cameras")[index], path);
    if (object.choice("type", {"perspective", "orthographic"}, {}) == 1) {
      file_.context().warn(path, "orthographic cameras are left out");
      return;
    }
    const JsonPath perspective_path = object.path_of("perspective");
    JsonObject perspective(file_.context(), object.required("perspective"), perspective_path);
    static constexpr NumberDomain half_turn{0.0, std::numbers::pi, "a number in (0, pi) radians",
                                            true};
    const double fov = perspective.number("yfov", half_turn, {}) * degrees_per_radian;
    scene_.cameras.push_back({scene_.nodes[node.index].name,
                              camera_of_node(node.to_world, center_, std::min(fov, 179.999)),
                              {}});
  }

  void add_light(const Node& node, JsonObject& use) {
    if (scene_.lights.size() >= limits::lights) return;
    JsonObject root(file_.context(), file_.root(), file_.path());
    const JsonPath extensions_path = root.path_of("extensions");
    JsonObject extensions(file_.context(), root.required("extensions"), extensions_path);
    const JsonPath punctual_path = extensions.path_of("KHR_lights_punctual");
    JsonObject punctual(file_.context(), extensions.required("KHR_lights_punctual"), punctual_path);
    const Json::array_t& lights = punctual.array("lights", limits::gaussians);
    if (lights.empty()) use.fail("light", "refers to lights; the file has none");
    static_cast<void>(use.required("light"));
    const auto index = static_cast<std::size_t>(
        use.integer("light", 0, static_cast<std::int64_t>(lights.size()) - 1, 0));
    const JsonPath lights_path = punctual.path_of("lights");
    const JsonPath path = lights_path.element(index);
    JsonObject object(file_.context(), lights[index], path);
    Light light;
    light.name = scene_.nodes[node.index].name;
    light.position = node.to_world[3];
    light.intensity = object.vector("color", domain::unit, glm::dvec3(1.0)) *
                      object.number("intensity", domain::intensity, 1.0) / lumens_per_watt;
    glm::dvec3 direction = -glm::dvec3(node.to_world[2]);
    if (const double length = glm::length(direction); length > 0.0) direction /= length;
    const std::size_t type = object.choice("type", {"point", "spot", "directional"}, {});
    if (type != 0 && direction == glm::dvec3(0.0)) {
      file_.context().fail(path, "has no direction: the scale of its node is 0");
    }
    if (type == 1) light.spot = read_cone(object, direction);
    if (type == 2) light.directional = Directional{direction};
    scene_.lights.push_back(std::move(light));
  }

  SpotCone read_cone(JsonObject& light, const glm::dvec3& direction) {
    SpotCone cone{direction};
    const Json* value = light.find("spot");
    if (value == nullptr) return cone;
    static constexpr NumberDomain quarter_turn{0.0, std::numbers::pi / 2 + 1e-6,
                                               "a number in [0, pi/2] radians"};
    const JsonPath path = light.path_of("spot");
    JsonObject spot(file_.context(), *value, path);
    cone.inner_angle = spot.number("innerConeAngle", quarter_turn, 0.0) * degrees_per_radian;
    cone.outer_angle =
        spot.number("outerConeAngle", quarter_turn, std::numbers::pi / 4) * degrees_per_radian;
    if (!(cone.inner_angle < cone.outer_angle)) {
      spot.fail("innerConeAngle", "allowed: less than outerConeAngle");
    }
    return cone;
  }

  RawScene scene_;
  GltfFile file_;
  std::vector<Node> nodes_;
  std::vector<GltfMaterial> materials_;
  glm::dvec3 center_{0.0};
  std::size_t bytes_ = 0;
};

}  // namespace

RawScene read_gltf(const std::filesystem::path& file) {
  return GltfReader(file).read();
}

}  // namespace brume
