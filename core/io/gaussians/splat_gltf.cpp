// Reading splats of glTF.

#include "core/io/gaussians/splat_gltf.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <map>
#include <string_view>
#include <utility>

#include "brume/error.h"
#include "core/io/gaussians/dropped_splats.h"
#include "core/io/gaussians/gaussian_columns.h"
#include "core/io/import/gltf_file.h"
#include "core/io/import/gltf_nodes.h"
#include "core/medium/splat.h"

namespace brume {
namespace {

constexpr const char* splat_extension = "KHR_gaussian_splatting";
constexpr std::string_view scale_name = "KHR_gaussian_splatting:SCALE";
constexpr std::string_view opacity_name = "KHR_gaussian_splatting:OPACITY";
constexpr std::string_view color_name = "KHR_gaussian_splatting:SH_DEGREE_0_COEF_0";

// An empty medium has no primitive.
bool uses_splats(GltfFile& file) {
  const Json::array_t& used = file.root().array("extensionsUsed", limits::keys);
  return std::ranges::count(used, Json(splat_extension)) > 0;
}

// The member of what may be no object; null where there is none.
const Json* member(const Json& value, const char* name) {
  if (!value.is_object()) return nullptr;
  const auto found = value.find(name);
  return found == value.end() ? nullptr : &*found;
}

class GltfSplatReader {
 public:
  explicit GltfSplatReader(const std::filesystem::path& file)
      : file_(file, warnings_),
        nodes_(read_gltf_nodes(file_)),
        meshes_(file_.list("meshes").size()) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) add_node(i);
    for (std::size_t i = 0; i < meshes_.size(); ++i) count_mesh(i);
  }

  // Refuses a file that is of something else.
  void expect_splats(const std::filesystem::path& file) {
    const auto has_splats = [](const Mesh& mesh) { return !mesh.primitives.empty(); };
    if (std::ranges::none_of(meshes_, has_splats) && !uses_splats(file_)) {
      throw InputError(file, "meshes",
                       "has no Gaussian splats; allowed: a primitive with the extension " +
                           std::string(splat_extension));
    }
  }

  // Over all nodes.
  [[nodiscard]] std::size_t count() const {
    std::size_t sum = 0;
    for (const Mesh& mesh : meshes_) sum += mesh.nodes.size() * mesh.count;
    return sum;
  }

  // A mesh is read once, however many nodes have it.
  std::vector<Gaussian> read(const std::filesystem::path& file, const SplatInput& input,
                             std::vector<std::string>* warnings) {
    std::vector<Gaussian> gaussians;
    gaussians.reserve(count());
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      MeshSplats splats;
      for (const std::size_t primitive : meshes_[i].primitives) {
        read_primitive(i, primitive, input.has_albedos, splats);
      }
      for (const std::size_t node : meshes_[i].nodes)
        place(splats, nodes_[node], input.along, gaussians);
    }
    dropped_.report(file, count(), warnings);
    return gaussians;
  }

 private:
  // A mesh that nodes have.
  struct Mesh {
    std::vector<std::size_t> nodes;
    std::vector<std::size_t> primitives;  // those with splats
    std::size_t count = 0;                // of splats
  };

  struct MeshSplats {
    std::vector<Splat> splats;
    std::map<std::size_t, std::string> faults;  // of those that are none
  };

  void add_node(std::size_t index) {
    JsonObject object = file_.object("nodes", nodes_[index].element);
    const auto mesh = file_.index(object, "mesh", "meshes");
    if (mesh) meshes_[*mesh].nodes.push_back(index);
  }

  void count_mesh(std::size_t index) {
    if (meshes_[index].nodes.empty()) return;
    JsonObject mesh = file_.object("meshes", index);
    const Json::array_t& primitives = mesh.array("primitives", limits::surfaces);
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      JsonObject primitive(file_.context(), primitives[i], mesh.path_of("primitives").element(i));
      if (!are_splats(primitive)) continue;
      JsonObject attributes = primitive.object("attributes");
      meshes_[index].primitives.push_back(i);
      meshes_[index].count += file_.count(accessor(attributes, "POSITION"));
    }
  }

  // Whether a primitive has splats; throws if they cannot be read.
  bool are_splats(JsonObject& primitive) {
    auto extensions = primitive.find_object("extensions");
    if (!extensions) return false;
    auto splats = extensions->find_object(splat_extension);
    if (!splats) return false;
    splats->choice("kernel", {"ellipse"}, 0);
    if (const Json* inner = splats->find("extensions"); inner != nullptr && !inner->empty()) {
      splats->fail("extensions", "found " + quoted_json(*inner) +
                                     "; allowed: splats that are not compressed or extended");
    }
    if (primitive.integer("mode", 0, 6, 4) != 0) {
      primitive.fail("mode", "allowed for splats: 0, points");
    }
    return true;
  }

  std::size_t accessor(JsonObject& attributes, std::string_view name) {
    static_cast<void>(attributes.required(name));
    return *file_.index(attributes, name, "accessors");
  }

  void read_primitive(std::size_t mesh, std::size_t index, bool has_albedos, MeshSplats& read) {
    JsonObject owner = file_.object("meshes", mesh);
    JsonObject primitive(file_.context(), owner.required("primitives")[index],
                         owner.path_of("primitives").element(index));
    JsonObject attributes = primitive.object("attributes");
    const auto values = [&](std::string_view name, std::size_t components) {
      return file_.numbers(attributes.path_of(name), accessor(attributes, name), components);
    };
    const std::vector<float> positions = values("POSITION", 3);
    const std::vector<float> rotations = values("KHR_gaussian_splatting:ROTATION", 4);
    const std::vector<float> scales = values(scale_name, 3);
    const std::vector<float> opacities = values(opacity_name, 1);
    const bool has_colors = has_albedos && attributes.find(color_name) != nullptr;
    const std::vector<float> colors =
        has_colors ? values(color_name, 3) : std::vector<float>(positions.size());
    const bool is_linear = has_colors && has_linear_colors(primitive);
    const std::size_t count = positions.size() / 3;
    for (const std::size_t found :
         {rotations.size() / 4, scales.size() / 3, opacities.size(), colors.size() / 3}) {
      if (found == count) continue;
      file_.context().fail(attributes.path(), "found " + std::to_string(found) + " values for " +
                                                  std::to_string(count) + " splats");
    }
    const auto check = [&](std::string_view name, const NumberDomain& domain, double value) {
      if (domain.contains(value)) return;
      std::string fault(name);
      fault.append(": ").append(domain.refusal(value));
      read.faults.emplace(read.splats.size(), std::move(fault));
    };
    for (std::size_t i = 0; i < count; ++i) {
      const float* p = &positions[3 * i];
      const float* q = &rotations[4 * i];
      const float* s = &scales[3 * i];
      for (int k = 0; k < 3; ++k) check(scale_name, domain::not_negative, s[k]);
      check(opacity_name, domain::unit, opacities[i]);
      Splat& splat = read.splats.emplace_back();
      splat = {{p[0], p[1], p[2]},
               {s[0], s[1], s[2]},
               unit_rotation({q[3], q[0], q[1], q[2]}),
               depth_of_opacity(opacities[i])};
      if (has_colors) {
        const float* c = &colors[3 * i];
        splat.albedo = albedo_of_sh({c[0], c[1], c[2]}, is_linear);
      }
    }
  }

  bool has_linear_colors(JsonObject& primitive) {
    JsonObject extensions = primitive.object("extensions");
    JsonObject splats = extensions.object(splat_extension);
    return splats.choice("colorSpace", {"srgb_rec709_display", "lin_rec709_display"}, 0) == 1;
  }

  static double depth_of_opacity(double opacity) {
    constexpr double most_opaque = 1.0 - 0x1p-25;
    return -std::log1p(-std::min(opacity, most_opaque));
  }

  // They are as deep wherever the node places them.
  void place(const MeshSplats& read, const GltfNode& node, OpacityAlong along,
             std::vector<Gaussian>& gaussians) {
    constexpr SplatNames attribute_names{{"POSITION", "POSITION", "POSITION"},
                                         {scale_name, scale_name, scale_name},
                                         opacity_name,
                                         {color_name, color_name, color_name}};
    const JsonPath path = file_.path().member("nodes").element(node.element);
    for (std::size_t i = 0; i < read.splats.size(); ++i) {
      const Splat& splat = read.splats[i];
      Gaussian g = gaussian_of(splat, along);
      if (node.to_world != glm::dmat4(1.0)) {
        g.center = glm::dvec3(node.to_world * glm::dvec4(g.center, 1.0));
        transform(g, glm::dmat3(node.to_world));
        set_depth_along(g, splat.depth, along);
      }
      const auto found = read.faults.find(i);
      const std::string fault =
          found == read.faults.end() ? splat_fault(g, attribute_names) : found->second;
      if (fault.empty()) {
        gaussians.push_back(g);
      } else {
        dropped_.add(path.text() + ", splat " + std::to_string(i), fault);
      }
    }
  }

  std::vector<std::string> warnings_;  // of what else the file has
  GltfFile file_;
  std::vector<GltfNode> nodes_;
  std::vector<Mesh> meshes_;
  DroppedSplats dropped_;
};

}  // namespace

std::vector<Gaussian> read_splats_gltf(const std::filesystem::path& file, std::size_t max_count,
                                       const SplatInput& input,
                                       std::vector<std::string>* warnings) {
  GltfSplatReader reader(file);
  reader.expect_splats(file);
  if (reader.count() > max_count) {
    throw InputError(file, "meshes",
                     "found " + std::to_string(reader.count()) +
                         " splats; allowed: " + gaussian_columns::allowed_count(max_count));
  }
  return reader.read(file, input, warnings);
}

bool has_splats_gltf(const std::filesystem::path& file) {
  std::vector<std::string> warnings;
  GltfFile gltf(file, warnings);
  if (uses_splats(gltf)) return true;
  return std::ranges::any_of(gltf.list("meshes"), [](const Json& mesh) {
    const Json* primitives = member(mesh, "primitives");
    return primitives != nullptr && primitives->is_array() &&
           std::ranges::any_of(*primitives, [](const Json& primitive) {
             const Json* extensions = member(primitive, "extensions");
             return extensions != nullptr && member(*extensions, splat_extension) != nullptr;
           });
  });
}

std::size_t splat_count_gltf(const std::filesystem::path& file) {
  return GltfSplatReader(file).count();
}

}  // namespace brume
