#include "core/io/scene/surface_json.h"

#include <algorithm>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/scene/fields_json.h"
#include "core/io/scene/keys_json.h"
#include "core/io/scene/material_json.h"
#include "core/io/scene/scene_names.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "core/scene/animation/animation.h"
#include "core/scene/copies.h"
#include "core/scene/fields/copies_fields.h"
#include "core/scene/fields/surface_fields.h"
#include "core/scene/imported_scene.h"

namespace brume {

Surface SurfaceReader::read(JsonObject& object) {
  Surface surface;
  surface.name = object.name("");
  read_mesh(object, surface);
  surface.translate = object.vector("translate", domain::coordinate, surface.translate);
  if (const Json* rotate = object.find("rotate")) {
    surface.rotate = read_unit_quaternion(context_, *rotate, object.path_of("rotate"));
  }
  surface.scale = object.number("scale", domain::length, surface.scale);
  if (surface.imported) {
    read_materials(context_, object, references_, budget_, unknown_keys_, surface);
  } else {
    auto material = object.find_object("material");
    if (material) read_material(context_, *material, references_, budget_, unknown_keys_, surface);
  }
  surface.transfer = static_cast<Surface::Transfer>(
      object.choice("transfer", scene_names::transfers, std::size_t{0}));
  if (auto copies = object.find_object("copies")) read_copies(*copies, surface);
  read_fields(object, surface);
  read_rest(context_, object, surface.id, unknown_keys_,
            [&](auto&& visit) { visit_keyed_surface(surface, visit); });
  return surface;
}

void SurfaceReader::read_copies(JsonObject& object, Surface& surface) {
  Copies& copies = surface.copies.emplace();
  if (object.find("file") != nullptr) {
    const auto is_alone = [&object](const std::string& name) {
      if (object.find(name) != nullptr) object.fail(name, found_beside("file"));
    };
    is_alone("over");
    visit_fields<Scatter>([&](const auto& field) { is_alone(field.info.name); });
    const JsonPath path = object.path_of("file");
    copies.file = references_.resolve(context_, path, object.text("file", {}));
    copies.placements = references_.copies(context_, path, copies.file, budget_.copies_left());
    budget_.reserve_copies(path, static_cast<double>(copies.placements->size()), surface);
  } else {
    copies.scatter.over = object.text("over", {});
    read_fields(object, copies.scatter);
  }
  unknown_keys_.add(surface.id, "copies", object.unknown_keys());
}

void SurfaceReader::reserve_scattered(const JsonPath& path, const std::vector<Surface>& surfaces) {
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!surfaces[i].copies || surfaces[i].copies->placements) continue;
    const Scatter& scatter = surfaces[i].copies->scatter;
    const JsonPath element = path.element(i);
    const JsonPath copies = element.member("copies");
    const Surface* const over = find_scattered_over(scatter, surfaces);
    if (over == nullptr) {
      context_.warn(copies.member("over"), "there is no surface " + quoted_text(scatter.over) +
                                               "; nothing is scattered over it");
    } else {
      budget_.reserve_copies(copies.member("density"), scattered_count(scatter, *over),
                             surfaces[i]);
    }
  }
}

std::shared_ptr<const TriangleMesh> SurfaceReader::primitive_mesh(const Primitive& primitive) {
  for (const auto& [known, mesh] : primitive_meshes_) {
    if (known == primitive) return mesh;
  }
  return primitive_meshes_.emplace_back(primitive, mesh_of(primitive)).second;
}

void SurfaceReader::read_mesh(JsonObject& object, Surface& surface) {
  const bool has_primitive = object.find("primitive") != nullptr;
  const char* key = has_primitive ? "primitive" : object.find("file") ? "file" : "mesh";
  for (const char* other : {"file", "mesh"}) {
    if (std::string_view(key) == other || !object.find(other)) continue;
    object.fail(other, std::string("found besides ") + key + "; allowed: one of both");
  }
  const JsonPath path = object.path_of(key);
  if (has_primitive) {
    JsonObject primitive = object.object("primitive");
    surface.primitive = read_primitive(primitive, surface);
    surface.mesh = primitive_mesh(*surface.primitive);
    budget_.reserve(path, *surface.mesh);
    return;
  }
  surface.mesh_file = references_.resolve(context_, path, object.text(key, {}));
  if (path.key == "file") {
    read_imported(object, path, surface);
    return;
  }
  surface.mesh = references_.mesh(context_, path, surface.mesh_file);
  budget_.reserve(path, *surface.mesh);
}

void SurfaceReader::read_imported(JsonObject& object, const JsonPath& path, Surface& surface) {
  surface.imported = references_.imported(context_, path, surface.mesh_file);
  const ImportedScene& scene = *surface.imported;
  const bool is_missing = references_.is_missing(surface.mesh_file);  // then so are its nodes
  const Json::array_t& nodes = object.array("nodes", limits::surfaces);
  const JsonPath nodes_path = object.path_of("nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].is_string() || nodes[i].get_ref<const std::string&>().empty()) {
      context_.fail(nodes_path.element(i), "found " + quoted_json(nodes[i]) + "; allowed: a name");
    }
    surface.nodes.push_back(nodes[i].get<std::string>());
    if (!is_missing) check_node(scene, nodes_path.element(i), surface.nodes.back());
  }
  if (object.find("nodes") && nodes.empty()) {
    object.fail("nodes", "found no names; allowed: at least one");
  }
  const std::vector<const ImportedPart*> parts =
      chosen_parts(scene, is_missing ? std::vector<std::string>() : surface.nodes);
  if (parts.empty()) {
    const bool are_all = surface.nodes.empty();
    const std::string why = !are_all ? "these nodes have no triangles"
                            : scene.left_out.empty()
                                ? "has no triangles"
                                : scene.left_out + ", and no triangles anywhere";
    context_.fail(are_all ? path : nodes_path, InputError(surface.mesh_file, "", why).what());
  }
  surface.mesh = joined_mesh(parts);
  budget_.reserve(path, *surface.mesh);
  budget_.reserve(path, parts);
}

void SurfaceReader::check_node(const ImportedScene& scene, const JsonPath& path,
                               const std::string& name) {
  if (std::ranges::count(scene.nodes, name, &ImportedNode::name) > 0) return;
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(scene.nodes.size(), 10); ++i) {
    names += (i > 0 ? ", " : "") + quoted_text(scene.nodes[i].name);
  }
  if (scene.nodes.size() > 10) names += " ...";
  context_.fail(path, "found " + quoted_text(name) + "; allowed: a node of " +
                          quoted_text(scene.files.front().string()) + ": " + names);
}

Primitive SurfaceReader::read_primitive(JsonObject& object, Surface& surface) {
  Primitive primitive;
  primitive.shape =
      static_cast<Primitive::Shape>(object.choice("type", scene_names::primitives, {}));
  primitive.size = object.vector("size", domain::length, primitive.size);
  unknown_keys_.add(surface.id, "primitive", object.unknown_keys());
  return primitive;
}

}  // namespace brume
