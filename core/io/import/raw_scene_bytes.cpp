#include "core/io/import/raw_scene_bytes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <type_traits>

#include "brume/limits.h"
#include "core/io/byte_reader.h"
#include "core/number_domain.h"
#include "core/scene/cameras.h"
#include "core/scene/fields/camera_fields.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/fields/material_fields.h"
#include "core/scene/light_rules.h"
#include "core/scene/mesh.h"

namespace brume {
namespace {

// Both directions visit the same members in the same order.

class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}

  template <class Value>
  void plain(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    out_.write(reinterpret_cast<const char*>(&value), sizeof(Value));
  }
  template <class Value>
  void plain_list(const std::vector<Value>& values) {
    plain(std::uint64_t{values.size()});
    out_.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(Value)));
  }
  void text(const std::string& value) {
    plain(std::uint64_t{value.size()});
    out_.write(value.data(), static_cast<std::streamsize>(value.size()));
  }
  void list(const auto& values, auto&& visit_element) {
    plain(std::uint64_t{values.size()});
    for (const auto& value : values) visit_element(value);
  }
  template <class Value>
  void maybe(const std::optional<Value>& value, auto&& visit_value) {
    plain(std::uint8_t{value.has_value()});
    if (value) visit_value(*value);
  }
  template <class Value>
  void shared(const std::shared_ptr<const Value>& value, auto&& visit_value) {
    plain(std::uint8_t{value != nullptr});
    if (value) visit_value(*value);
  }
  void kind(const Light::Kind& kind) { plain(static_cast<std::uint8_t>(kind.index())); }

 private:
  std::ostream& out_;
};

class Reader {
 public:
  Reader(const std::filesystem::path& file, std::string_view bytes) : bytes_(file, bytes) {}

  template <class Value>
  void plain(Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    std::memcpy(&value, bytes_.read_bytes(sizeof(Value)).data(), sizeof(Value));
  }
  template <class Value>
  void plain_list(std::vector<Value>& values) {
    const std::string_view bytes = bytes_.read_bytes(count(sizeof(Value)) * sizeof(Value));
    values.resize(bytes.size() / sizeof(Value));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  }
  void text(std::string& value) { value = bytes_.read_bytes(count(1)); }
  void list(auto& values, auto&& visit_element) {
    for (std::size_t left = count(1); left > 0; --left) visit_element(values.emplace_back());
  }
  template <class Value>
  void maybe(std::optional<Value>& value, auto&& visit_value) {
    if (bytes_.number<std::uint8_t>() != 0) visit_value(value.emplace());
  }
  template <class Value>
  void shared(std::shared_ptr<const Value>& value, auto&& visit_value) {
    if (bytes_.number<std::uint8_t>() == 0) return;
    auto read = std::make_shared<Value>();
    visit_value(*read);
    value = std::move(read);
  }
  void kind(Light::Kind& kind) {
    const auto index = bytes_.number<std::uint8_t>();
    check(index < light_kinds.size());
    kind = light_kind(index);
  }

  void check(bool is_valid) {
    if (!is_valid) bytes_.fail("is not what the program that reads scenes writes");
  }

 private:
  std::size_t count(std::size_t element_bytes) {
    const auto count = bytes_.number<std::uint64_t>();
    check(count <= limits::scene_bytes / element_bytes);
    return static_cast<std::size_t>(count);
  }

  ByteReader bytes_;
};

void visit_path(Writer& io, const std::filesystem::path& path) {
  io.text(path.native());
}

void visit_path(Reader& io, std::filesystem::path& path) {
  std::string text;
  io.text(text);
  path = text;
}

void visit_values(auto& io, auto& values) {
  io.plain(values.base_color);
  io.plain(values.metallic);
  io.plain(values.roughness);
  io.plain(values.emissive);
  io.plain(values.normal_scale);
  io.plain(values.alpha);
  io.plain(values.opacity);
  io.plain(values.alpha_cutoff);
  io.plain(values.transmission);
}

void visit_light(auto& io, auto& light) {
  io.text(light.name);
  io.plain(light.position);
  io.plain(light.intensity);
  io.plain_list(light.keys.position);
  io.plain_list(light.keys.direction);
  // The values of those kinds that other programs' scenes have.
  io.kind(light.kind);
  if (auto* spot = std::get_if<light::Spot>(&light.kind)) {
    io.plain(spot->direction);
    io.plain(spot->inner_angle);
    io.plain(spot->outer_angle);
  }
  if (auto* sun = std::get_if<light::Directional>(&light.kind)) io.plain(sun->direction);
}

void visit_mesh(auto& io, auto& mesh) {
  io.plain_list(mesh.points);
  visit_vertex_values(mesh, [&io](auto& values, auto&&) { io.plain_list(values); });
  io.plain_list(mesh.triangles);
}

void visit_deformation(auto& io, auto& deformation) {
  visit_mesh(io, deformation.rest);
  io.list(deformation.targets, [&io](auto& target) {
    io.plain_list(target.points);
    io.plain_list(target.normals);
  });
  io.plain_list(deformation.influences);
  io.plain_list(deformation.ends);
  io.list(deformation.poses, [&io](auto& pose) {
    io.plain(pose.time);
    io.plain(pose.is_held);
    io.plain_list(pose.weights);
    io.plain_list(pose.joints);
  });
}

void visit_scene(auto& io, auto& scene) {
  io.list(scene.nodes, [&io](auto& node) {
    io.text(node.name);
    io.maybe(node.parent, [&io](auto& parent) { io.plain(parent); });
  });
  io.list(scene.parts, [&io](auto& part) {
    io.plain(part.node);
    io.plain(part.material);
    visit_mesh(io, part.mesh);
    io.plain_list(part.keys.translate);
    io.plain_list(part.keys.rotate);
    io.plain_list(part.keys.scale);
    io.shared(part.deformation, [&io](auto& deformation) { visit_deformation(io, deformation); });
  });
  io.list(scene.materials, [&io](auto& material) {
    io.text(material.name);
    visit_values(io, material.values);
    for (auto& texture : material.textures) {
      io.maybe(texture, [&io](auto& use) {
        io.plain(use.image);
        io.plain(use.wrap_u);
        io.plain(use.wrap_v);
        io.plain(use.uses_second_texcoords);
      });
    }
    io.maybe(material.opacity_image, [&io](auto& image) { io.plain(image); });
    io.plain(material.is_transmission_tinted);
  });
  io.list(scene.images, [&io](auto& image) {
    visit_path(io, image.file);
    io.text(image.bytes);
    io.text(image.name);
    io.text(image.error);
    io.plain(image.is_absolute);
  });
  io.list(scene.cameras, [&io](auto& camera) {
    io.text(camera.name);
    io.plain(camera.camera);
    io.plain_list(camera.keys.eye);
    io.plain_list(camera.keys.target);
    io.plain_list(camera.keys.roll);
  });
  io.list(scene.lights, [&io](auto& light) { visit_light(io, light); });
  io.list(scene.files, [&io](auto& file) { visit_path(io, file); });
  io.list(scene.warnings, [&io](auto& warning) { io.text(warning); });
}

bool is_in(const glm::dvec3& v, const NumberDomain& domain) {
  return domain.contains(v.x) && domain.contains(v.y) && domain.contains(v.z);
}

bool is_valid(const MeshArrays& mesh) {
  const std::size_t count = mesh.points.size();
  if (mesh.normals.size() != count) return false;
  bool are_as_many = true;
  visit_vertex_values(mesh, [&](const auto& values, auto&&) {
    are_as_many = are_as_many && (values.empty() || values.size() == count);
  });
  if (!are_as_many || mesh.second_texcoords.size() > mesh.texcoords.size()) return false;
  for (const glm::vec3& point : mesh.points) {
    if (!is_in(point, domain::coordinate)) return false;
  }
  for (const glm::vec3& normal : mesh.normals) {
    if (normal != glm::vec3(0.0f) && !(std::abs(glm::length(normal) - 1.0f) < 1e-3f)) return false;
  }
  for (const auto* texcoords : {&mesh.texcoords, &mesh.second_texcoords}) {
    for (const glm::vec2& uv : *texcoords) {
      if (!(std::abs(uv.x) <= 1e7f && std::abs(uv.y) <= 1e7f)) return false;
    }
  }
  for (const glm::vec4& color : mesh.colors) {
    for (int k = 0; k < 4; ++k) {
      if (!domain::unit.contains(static_cast<double>(color[k]))) return false;
    }
  }
  for (const glm::uvec3& t : mesh.triangles) {
    if (t.x >= count || t.y >= count || t.z >= count) return false;
  }
  return true;
}

bool is_finite(const std::vector<glm::vec3>& vectors) {
  return std::ranges::all_of(vectors, [](const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  });
}

bool is_valid(const Deformation& deformation) {
  const std::size_t vertices = deformation.rest.points.size();
  MeshArrays rest = deformation.rest;
  if (rest.normals.empty()) rest.normals.resize(vertices);
  if (!is_valid(rest) || deformation.poses.empty()) return false;
  for (const MorphTarget& target : deformation.targets) {
    for (const auto* offsets : {&target.points, &target.normals}) {
      const bool are_as_many = offsets->empty() || offsets->size() == vertices;
      if (!are_as_many || !is_finite(*offsets)) return false;
    }
  }
  const std::size_t joints = deformation.poses.front().joints.size();
  const std::size_t weights = deformation.poses.front().weights.size();
  const bool is_skinned = !deformation.influences.empty();
  if (joints == 0 || deformation.ends.size() != (is_skinned ? vertices : 0)) return false;
  for (const Influence& influence : deformation.influences) {
    if (influence.joint >= joints || !(influence.weight >= 0.0f && influence.weight <= 1.0001f)) {
      return false;
    }
  }
  std::uint32_t begin = 0;
  for (const std::uint32_t end : deformation.ends) {
    if (end <= begin || end > deformation.influences.size()) return false;
    begin = end;
  }
  double last = -std::numeric_limits<double>::infinity();
  for (const Pose& pose : deformation.poses) {
    if (!domain::seconds.contains(pose.time) || !(pose.time > last) ||
        pose.joints.size() != joints || pose.weights.size() != weights) {
      return false;
    }
    for (const double weight : pose.weights) {
      if (!std::isfinite(weight)) return false;
    }
    last = pose.time;
    for (const glm::dmat4& joint : pose.joints) {
      for (int k = 0; k < 16; ++k) {
        if (!std::isfinite(joint[k / 4][k % 4])) return false;
      }
    }
  }
  return true;
}

bool is_valid(double value, const NumberDomain& domain) {
  return domain.contains(value);
}
bool is_valid(const glm::dvec3& value, const NumberDomain& domain) {
  return is_in(value, domain);
}
bool is_valid(const glm::dquat& value, const NumberDomain&) {
  return std::abs(glm::length(value) - 1.0) < 1e-3;
}

template <class T>
bool is_valid(const Keys<T>& keys, const NumberDomain& domain) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Key<T>& key = keys[i];
    if (!domain::seconds.contains(key.time) || !is_valid(key.value, domain) || key.in || key.out ||
        (i > 0 && !(key.time - keys[i - 1].time >= min_key_distance)) ||
        (key.interpolation != Interpolation::linear &&
         key.interpolation != Interpolation::constant)) {
      return false;
    }
  }
  return true;
}

bool is_valid(const PlacementKeys& keys) {
  return keys.rotate.empty() == keys.empty() && keys.scale.empty() == keys.empty() &&
         is_valid(keys.translate, domain::coordinate) &&
         is_valid(keys.rotate, domain::coordinate) && is_valid(keys.scale, domain::length);
}

bool is_valid(TextureWrap wrap) {
  return wrap == TextureWrap::repeat || wrap == TextureWrap::clamp || wrap == TextureWrap::mirror;
}

bool is_valid(const RawMaterial& material, std::size_t images) {
  for (const auto& texture : material.textures) {
    if (texture &&
        (texture->image >= images || !is_valid(texture->wrap_u) || !is_valid(texture->wrap_v))) {
      return false;
    }
  }
  if (material.opacity_image && *material.opacity_image >= images) return false;
  const AlphaMode alpha = material.values.alpha;
  return is_in_domain(material.values) &&
         (alpha == AlphaMode::opaque || alpha == AlphaMode::cutout || alpha == AlphaMode::blend);
}

bool is_valid(const Light& light) {
  return is_in(light.position, domain::coordinate) && is_in_domain(light) && !refusal(light) &&
         is_valid(light.keys.position, domain::coordinate) &&
         is_valid(light.keys.direction, domain::coordinate);
}

}  // namespace

void write_raw_scene(std::ostream& out, const RawScene& scene) {
  Writer writer(out);
  visit_scene(writer, scene);
}

RawScene read_raw_scene(const std::filesystem::path& file, std::string_view bytes) {
  Reader reader(file, bytes);
  RawScene scene;
  visit_scene(reader, scene);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    reader.check(!scene.nodes[i].parent || *scene.nodes[i].parent < i);
  }
  reader.check(scene.nodes.size() <= max_imported_nodes && scene.parts.size() <= limits::surfaces &&
               scene.lights.size() <= limits::lights && scene.cameras.size() <= limits::cameras);
  for (const RawPart& part : scene.parts) {
    reader.check(part.node < scene.nodes.size() && part.material < scene.materials.size() &&
                 is_valid(part.mesh) && is_valid(part.keys) &&
                 (!part.deformation || is_valid(*part.deformation)));
  }
  for (const RawMaterial& material : scene.materials) {
    reader.check(is_valid(material, scene.images.size()));
  }
  for (const NamedCamera& camera : scene.cameras) {
    reader.check(is_in_domain(camera.camera) && !refusal(camera.camera) &&
                 is_valid(camera.keys.eye, domain::coordinate) &&
                 is_valid(camera.keys.target, domain::coordinate) &&
                 is_valid(camera.keys.roll, domain::degrees));
  }
  for (const Light& light : scene.lights) reader.check(is_valid(light));
  return scene;
}

}  // namespace brume
