#include "core/io/import/gltf_mesh.h"

#include <cmath>

#include "brume/limits.h"
#include "core/number_domain.h"
#include "core/scene/mesh.h"

namespace brume {
namespace {

constexpr std::size_t max_morph_targets = 1 << 16;

// v up, as Brume has it.
glm::vec2 texcoord(const glm::dvec3& uv) {
  constexpr double longest = 1e6;
  const bool is_valid = std::abs(uv.x) <= longest && std::abs(uv.y) <= longest;
  return is_valid ? glm::vec2(uv.x, 1.0 - uv.y) : glm::vec2(0.0f);
}

// The values of an attribute that the mesh can do without, as `read` has them; else none.
template <class Read>
auto optional_values(GltfFile& file, JsonObject& attributes, const std::string& key,
                     std::size_t vertices, Read read) {
  decltype(read(file, attributes, key)) values;
  const bool is_read = file.context().try_read(attributes.path_of(key), [&] {
    values = read(file, attributes, key);
    check_value_count(attributes, key, values.size(), vertices);
  });
  if (!is_read) values.clear();
  return values;
}

std::vector<glm::vec4> colors(GltfFile& file, JsonObject& attributes, const std::string& key) {
  const auto accessor = file.index(attributes, key, "accessors");
  if (!accessor) return {};
  return file.colors(attributes.path_of(key), *accessor);
}

// Those that a material's textures use; TEXCOORD_0, if it has none.
void read_texcoords(GltfFile& file, JsonObject& attributes, std::span<const GltfTexcoords> uses,
                    MeshArrays& mesh) {
  constexpr GltfTexcoords first;
  const auto read = [&](const GltfTexcoords& use) {
    const std::string key = "TEXCOORD_" + std::to_string(use.set);
    const bool is_missing = attributes.find(key) == nullptr;
    auto texcoords =
        optional_values(file, attributes, key, mesh.points.size(), gltf_vectors<glm::vec2>);
    if (texcoords.empty() && !uses.empty()) {
      if (is_missing) file.context().warn(attributes.path_of(key), "missing: a texture uses it");
      texcoords.resize(mesh.points.size());
    }
    for (glm::vec2& uv : texcoords) uv = texcoord(use.transform * glm::dvec3(uv, 1.0));
    return texcoords;
  };
  mesh.texcoords = read(uses.empty() ? first : uses.front());
  if (uses.size() > 1) mesh.second_texcoords = read(uses[1]);
}

std::vector<MorphTarget> read_morph_targets(GltfFile& file, JsonObject& primitive,
                                            std::size_t vertices) {
  std::vector<MorphTarget> targets;
  std::size_t bytes = 0;  // which nothing in the file bounds: targets may share what they have
  for (const Json& value : primitive.array("targets", max_morph_targets)) {
    JsonObject target(file.context(), value, primitive.path_of("targets").element(targets.size()));
    const auto offsets = [&](const char* key) {
      return optional_values(file, target, key, vertices, gltf_vectors<glm::vec3>);
    };
    const MorphTarget& added = targets.emplace_back(offsets("POSITION"), offsets("NORMAL"));
    bytes += std::span(added.points).size_bytes() + std::span(added.normals).size_bytes();
    if (bytes > limits::scene_bytes / 4) {
      target.fail("POSITION", "the morph targets up to here take more memory than the allowed " +
                                  std::to_string(limits::scene_bytes / 4) + " bytes");
    }
  }
  return targets;
}

void add_triangles(GltfFile& file, JsonObject& primitive, std::int64_t mode, MeshArrays& mesh) {
  const auto count = static_cast<unsigned>(mesh.points.size());
  std::vector<unsigned> corners;
  if (const auto accessor = file.index(primitive, "indices", "accessors")) {
    corners = file.indices(primitive.path_of("indices"), *accessor);
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

}  // namespace

void check_value_count(JsonObject& attributes, const std::string& key, std::size_t values,
                       std::size_t vertices) {
  if (values == 0 || values == vertices) return;
  attributes.fail(key, "found " + std::to_string(values) + " values; allowed: " +
                           std::to_string(vertices) + ", one for each vertex");
}

Deformation read_gltf_mesh(GltfFile& file, JsonObject& primitive, std::int64_t mode,
                           std::span<const GltfTexcoords> texcoords) {
  JsonObject attributes = primitive.object("attributes");
  Deformation result;
  MeshArrays& mesh = result.rest;
  mesh.points = gltf_vectors<glm::vec3>(file, attributes, "POSITION");
  const std::size_t vertices = mesh.points.size();
  mesh.normals = optional_values(file, attributes, "NORMAL", vertices, gltf_vectors<glm::vec3>);
  mesh.colors = optional_values(file, attributes, "COLOR_0", vertices, colors);
  read_texcoords(file, attributes, texcoords, mesh);
  result.targets = read_morph_targets(file, primitive, vertices);
  add_triangles(file, primitive, mode, mesh);
  return result;
}

MorphWeights gltf_weights(GltfFile& file, JsonObject& object) {
  const Json* const value = object.find("weights");
  if (value == nullptr) return {};
  const std::size_t count = object.array("weights", max_morph_targets).size();
  const std::vector<double> weights =
      read_numbers(file.context(), *value, object.path_of("weights"), count, domain::coordinate);
  return {weights.data(), weights.size()};
}

}  // namespace brume
