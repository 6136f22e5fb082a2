#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "brume/error.h"
#include "brume/mesh_arrays.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/gaussians/other_format.h"
#include "core/io/import/imported_scene_file.h"
#include "core/io/scene/fields_json.h"
#include "core/io/scene/light_json.h"
#include "core/io/scene/scene_names.h"
#include "core/io/text_scanner.h"
#include "core/io/volume/volume_file.h"
#include "core/number_domain.h"
#include "core/scene/copies.h"
#include "core/scene/fields/camera_fields.h"
#include "core/scene/fields/environment_fields.h"
#include "core/scene/imported_scene.h"
#include "core/scene/mesh.h"
#include "core/transport/medium_summary.h"
#include "render/prepare/fog_extent.h"
#include "tools/brume/command.h"
#include "tools/brume/command_files.h"
#include "tools/brume/progress_line.h"

namespace brume {
namespace {

using Json = nlohmann::ordered_json;

Json bounds(const glm::dvec3& min_corner, const glm::dvec3& max_corner) {
  return Json::array({to_json(min_corner), to_json(max_corner)});
}

Json medium_json(const Medium& medium) {
  const MediumSummary summary = summarize(medium);
  Json json;
  json["gaussians"] = medium.size();
  json["homogeneous_density"] = medium.homogeneous_density();
  if (!medium.empty()) {
    json["center_bounds"] = bounds(summary.min_center, summary.max_center);
    json["bounds"] = bounds(summary.min_extent, summary.max_extent);
    json["radius_range"] = Json::array({summary.min_radius, summary.max_radius});
  }
  json["peak_density"] = summary.peak_density;
  json["greatest_optical_depth"] = summary.max_optical_depth;
  return json;
}

Json gaussians_json(const std::string& file) {
  const ProgressLine line("measuring " + file);
  std::vector<std::string> warnings;
  Medium medium;
  for (const Gaussian& gaussian : read_gaussians(file, nullptr, limits::gaussians, {}, &warnings)) {
    medium.append(gaussian);
  }
  print_warnings(warnings);
  return medium_json(medium);
}

Json scene_json(const SceneDocument& document) {
  const Scene& scene = document.scene;
  Json json;
  json["medium"] = medium_json(scene.medium);
  if (const auto& loaded = document.extras.medium_file) {
    json["medium"]["file"] = loaded->file.string();
  }
  if (scene.medium.homogeneous_density() > 0.0) {
    const FogExtent extent(scene);
    if (!extent.ball().is_endless()) {
      json["medium"]["fog_extent"] = extent.ball().radius;
    }
    json["medium"]["fog_extent_is"] = scene.optics.extent           ? "set"
                                      : !extent.ball().is_endless() ? "derived"
                                                                    : "endless";
  }
  if (const double transmittance = transmittance_of_fog(scene); transmittance < 1.0) {
    json["medium"]["far_light_transmittance"] = transmittance;
  }
  json["film"] = Json::array({scene.film.width, scene.film.height});
  if (!scene.cameras.empty()) {
    json["cameras"].push_back(scene.camera_name);
    for (const NamedCamera& camera : scene.cameras) json["cameras"].push_back(camera.name);
  }
  json["lights"] = Json::array();
  for (const Light& light : scene.lights) {
    json["lights"].push_back(light_to_json(light, [](const auto& file) { return file.string(); }));
  }
  if (const auto& environment = scene.environment) {
    if (const auto& sky = environment->sky) {
      write_fields(json["environment"]["sky"], *sky, sky->keys);
    } else {
      json["environment"] = environment->file.string();
    }
  }
  json["surfaces"] = Json::array();
  const std::vector<Surface> placed = with_placed_copies(scene.surfaces);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const Surface& surface = scene.surfaces[i];
    Json entry;
    if (!surface.name.empty()) entry["name"] = surface.name;
    if (const auto& primitive = surface.primitive) {
      entry["primitive"] = scene_names::primitives[static_cast<std::size_t>(primitive->shape)];
    } else {
      entry[surface.imported ? "file" : "mesh"] = surface.mesh_file.string();
      if (!surface.nodes.empty()) entry["nodes"] = surface.nodes;
    }
    entry["vertices"] = surface.mesh->n_vertices();
    entry["faces"] = surface.mesh->n_faces();
    if (placed[i].placed_copies) entry["copies"] = placed[i].placed_copies->size();
    if (!surface.visible) entry["visible"] = false;
    json["surfaces"].push_back(std::move(entry));
  }
  return json;
}

Json grids_json(const std::string& file) {
  Json json = Json::array();
  for (const VolumeGridInfo& grid : volume_grids(file)) {
    Json entry;
    entry["name"] = grid.name;
    entry["type"] = grid.type;
    entry["voxels"] = grid.voxels;
    if (grid.voxels > 0) entry["bounds"] = bounds(grid.min_corner, grid.max_corner);
    entry["voxel_size"] = to_json(grid.voxel_size);
    json.push_back(std::move(entry));
  }
  return json;
}

Json imported_json(const ImportedScene& scene) {
  Json json;
  const auto parts = chosen_parts(scene, {});
  if (const auto mesh = joined_mesh(parts)) {
    const MeshBox box = box_of(*mesh);
    json["bounds"] = bounds(box.low, box.high);
  }
  std::set<const Texture*> textures;
  std::vector<std::size_t> faces(scene.nodes.size(), 0);
  for (const ImportedPart* part : parts) {
    faces[part->node] += part->mesh->n_faces() * std::max<std::size_t>(part->placements.size(), 1);
    for (const TextureReference* texture : textures_of(part->material.metallic_roughness)) {
      if (texture->content) textures.insert(texture->content.get());
    }
  }
  json["textures"] = textures.size();
  json["nodes"] = Json::array();
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    Json& entry = json["nodes"].emplace_back();
    entry["name"] = scene.nodes[i].name;
    if (const auto parent = scene.nodes[i].parent) entry["parent"] = scene.nodes[*parent].name;
    if (faces[i] > 0) entry["faces"] = faces[i];
  }
  json["cameras"] = Json::array();
  for (const NamedCamera& camera : scene.cameras) {
    Json& entry = json["cameras"].emplace_back(Json{{"name", camera.name}});
    write_fields(entry, camera.camera, camera.keys);
  }
  json["lights"] = Json::array();
  for (const Light& light : scene.lights) {
    Json& entry = json["lights"].emplace_back(light_to_json(light, [](const auto&) { return ""; }));
    if (!light.name.empty()) entry["name"] = light.name;
  }
  return json;
}

// A value on one line: numbers bare, lists with spaces.
std::string as_words(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return quoted_text(value.get<double>());
  if (!value.is_array() && !value.is_object()) return value.dump();
  std::string text;
  for (const auto& [key, member] : value.items()) {
    const bool is_range = value.is_array() && member.is_array();
    if (!text.empty()) text += is_range ? " to " : ", ";
    if (value.is_object()) text += key + " ";
    text += member.is_array() ? "(" + as_words(member) + ")" : as_words(member);
  }
  return text;
}

void print_lines(std::ostream& out, const Json& json, const std::string& indent) {
  for (const auto& [key, value] : json.items()) {
    std::string name = key;
    std::replace(name.begin(), name.end(), '_', ' ');
    const bool is_list = value.is_array() && (value.empty() || value[0].is_object());
    if (value.is_object()) {
      out << indent << name << "\n";
      print_lines(out, value, indent + "  ");
    } else if (is_list) {
      out << indent << name << ": " << value.size() << "\n";
      for (const Json& element : value) out << indent << "  " << as_words(element) << "\n";
    } else {
      out << indent << name << ": " << as_words(value) << "\n";
    }
  }
}

class InfoCommand final : public Command {
 public:
  explicit InfoCommand(CLI::App& app) {
    app.add_option(
           "FILE", file_,
           "a scene (.brume, .gltf, .glb, .obj, .fbx), Gaussians (.ply, .csv, splats of .glb and "
           ".gltf) or a volume (.vdb)")
        ->type_name("FILE")
        ->required();
    app.add_flag("--json", as_json_, "print JSON");
    app.footer(
        "Peak density and maximum optical depth are found by search, so they are lower bounds. "
        "The\ndensity is evaluated at the centres of the Gaussians; the optical depth along lines "
        "through\nthem, the best of which are refined. If there are very many Gaussians, only the "
        "densest\nare tried, with fewer steps.");
  }

  ExitCode run() override {
    Json json;
    json["file"] = file_;
    const std::string extension = lower_case_extension(file_);
    if (extension == ".vdb") {
      const ProgressLine line("reading " + file_);
      print_warnings(volume_warnings(file_));
      json["grids"] = grids_json(file_);
    } else if (extension == ".ply" || extension == ".csv") {
      json["medium"] = gaussians_json(file_);
    } else if (is_imported_scene(file_)) {
      const bool is_gltf = extension == ".glb" || extension == ".gltf";
      if (is_gltf && has_splats(file_)) json["medium"] = gaussians_json(file_);
      const ProgressLine line("reading " + file_);
      std::vector<std::string> warnings;
      json.update(imported_json(*read_imported_scene(file_, warnings)));
      print_warnings(warnings);
    } else if (extension == ".brume") {
      CommandFiles files;
      const SceneDocument document = read_document(file_, files);
      const ProgressLine line("measuring " + file_);
      json.update(scene_json(document));
      if (const auto deep = deep_fog_text(document.scene)) print_warnings({*deep});
    } else {
      refuse_other_format(file_, read_first_bytes(file_, 64));
      throw InputError(file_, "",
                       "found the extension " + quoted_text(extension) +
                           "; allowed: .brume, .ply, .csv, .vdb, .gltf, "
                           ".glb, .obj, .fbx");
    }
    std::ostringstream text;
    if (as_json_) {
      text << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
    } else {
      print_lines(text, json, "");
    }
    print_result(text.str());
    return done;
  }

 private:
  std::string file_;
  bool as_json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_info_command(CLI::App& app) {
  return std::make_unique<InfoCommand>(app);
}

}  // namespace brume
