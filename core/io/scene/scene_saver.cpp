#include <algorithm>
#include <cmath>
#include <map>

#include "brume/error.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/gaussians/gaussian_columns.h"
#include "core/io/scene/cameras_and_output_json.h"
#include "core/io/scene/fields_json.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/keys_json.h"
#include "core/io/scene/light_json.h"
#include "core/io/scene/material_json.h"
#include "core/io/scene/medium_json.h"
#include "core/io/scene/scene_file.h"
#include "core/io/scene/scene_names.h"
#include "core/io/scene/scene_references.h"
#include "core/medium/written_radii.h"
#include "core/scene/animation/animation.h"
#include "core/scene/fields/copies_fields.h"
#include "core/scene/fields/surface_fields.h"
#include "core/scene/group_effects.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

// Whether the Gaussians that came from medium.file are still what they were, in groups that the
// numbers of the file still mean.
bool is_unchanged(const MediumFile& file, const Scene& scene) {
  const Medium& before = file.loaded;
  const Medium& now = scene.medium;
  const auto first = before.index_of(file.first_id);
  if (!first) return true;  // a file without any
  const auto is_in_place = [&scene](GroupId group) {
    return group == 0 || (group <= scene.groups.size() && scene.groups[group - 1].id == group);
  };
  for (std::size_t i = *first; i < before.size(); ++i) {
    const auto found = now.index_of(before.ids()[i]);
    if (!found || now.gaussian(*found) != before.gaussian(i)) return false;
    if (!is_in_place(before.group(i))) return false;
  }
  return true;
}

// The optics of a Gaussian or of a spline's.
void add_optics(Json& entry, const GaussianOptics& optics) {
  if (optics.albedo) entry["albedo"] = to_json(*optics.albedo);
  if (optics.emission != glm::dvec3(0.0)) entry["emission"] = to_json(optics.emission);
}

void add_radii(Json& entry, const Gaussian& gaussian) {
  if (gaussian.is_ball()) {
    entry["radius"] = gaussian.radius;
    return;
  }
  entry["radii"] = to_json(written_radii(gaussian));
  if (gaussian.shape.rotation != GaussianShape().rotation) {
    entry["rotate"] = to_json(gaussian.shape.rotation);
  }
}

void add_name(Json& object, const std::string& name) {
  if (!name.empty()) object["name"] = name;
}

Json emitter_to_json(const Emitter& emitter, const UnknownKeys& unknown_keys) {
  Json entry = Json::object();
  write_fields(entry, emitter, emitter.keys);
  // Absent, it is the emission at birth.
  if (emitter.emission_at_death == emitter.optics.emission) {
    entry.erase("emission_at_death");
  } else {
    entry["emission_at_death"] = to_json(emitter.emission_at_death);
  }
  add_name(entry, emitter.name);
  add_rest(entry, emitter.id, unknown_keys, [&](auto&& visit) { visit_keyed(emitter, visit); });
  return entry;
}

Json medium_to_json(const SceneDocument& document, const fs::path& directory) {
  const Scene& scene = document.scene;
  const UnknownKeys& unknown_keys = document.extras.unknown_keys;
  const Medium& medium = scene.medium;
  const MediumFile* file =
      refers_to_medium_file(document) ? document.extras.medium_file.get() : nullptr;

  Json object;
  object["density"] = medium.homogeneous_density();
  for (const Group& group : scene.groups) {
    Json entry = group_to_json(group, scene.groups);
    add_rest(entry, group.object_id, unknown_keys,
             [&](auto&& visit) { visit_keyed(group, visit); });
    object["groups"].push_back(std::move(entry));
  }
  for (const PaintedSpline& spline : scene.splines) {
    Json entry = spline_to_json(spline);
    add_optics(entry, spline.optics);
    add_unknown_keys(entry, unknown_keys.of(spline.object_id, ""));
    object["splines"].push_back(std::move(entry));
  }
  const std::map<GaussianId, const PaintedSpline*> splines = splines_of_gaussians(scene.splines);
  Json& gaussians = object["gaussians"] = Json::array();
  GaussianId next_id = 1;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const GaussianId id = medium.ids()[i];
    if (file != nullptr && file->contains(id)) continue;
    const Gaussian g = medium.gaussian(i);
    Json entry{{"center", to_json(g.center)}, {"density", g.density}};
    add_radii(entry, g);
    add_optics(entry, g.optics);
    if (const Group* group = find_group(scene.groups, g.group)) entry["group"] = group->name;
    if (const auto spline = splines.find(id); spline != splines.end()) {
      entry["spline"] = spline->second->name;
    }
    if (id != next_id && gaussian_columns::is_id(static_cast<double>(id))) entry["id"] = id;
    next_id = id + 1;
    add_unknown_keys(entry, unknown_keys.of_gaussian(id));
    gaussians.push_back(std::move(entry));
  }
  if (file != nullptr) object["file"] = SceneReferences::text_for(file->file, directory);

  const MediumOptics& optics = scene.optics;
  write_fields(object, optics, optics.keys);
  const Noise& noise = optics.noise;
  const std::string& noise_unknown = unknown_keys.of("medium.noise");
  const std::string& noise_keys_unknown = unknown_keys.of("medium.noise.keys");
  if (noise != Noise{} || !noise_unknown.empty() || !noise_keys_unknown.empty()) {
    Json& entry = object["noise"] = Json::object();
    write_fields(entry, noise, noise.keys);
    add_keys(entry, unknown_keys, noise_keys_unknown,
             [&noise](auto&& visit) { visit_keyed(noise, visit); });
    add_unknown_keys(entry, noise_unknown);
  }
  for (const Emitter& emitter : scene.emitters) {
    object["emitters"].push_back(emitter_to_json(emitter, unknown_keys));
  }
  for (const MediumSequence& sequence : scene.sequences) {
    Json entry{{"file", SceneReferences::text_for(sequence.file, directory)},
               {"first", sequence.first},
               {"last", sequence.last},
               {"frames_per_second", sequence.frames_per_second},
               {"start", sequence.start}};
    add_unknown_keys(entry, unknown_keys.of(sequence.id, ""));
    object["sequences"].push_back(std::move(entry));
  }
  add_keys(object, unknown_keys, unknown_keys.of("medium.keys"), [&](auto&& visit) {
    visit_keyed_density(medium, scene.density_keys, visit);
    visit_keyed(optics, visit);
  });
  add_unknown_keys(object, unknown_keys.of("medium"));
  return object;
}

Json copies_to_json(const Surface& surface, const UnknownKeys& unknown_keys,
                    const fs::path& directory) {
  const Copies& copies = *surface.copies;
  Json object;
  if (copies.placements) {
    object["file"] = SceneReferences::text_for(copies.file, directory);
  } else {
    object["over"] = copies.scatter.over;
    write_fields(object, copies.scatter, NoKeys());
  }
  add_unknown_keys(object, unknown_keys.of(surface.id, "copies"));
  return object;
}

Json surface_to_json(const Surface& surface, const UnknownKeys& unknown_keys,
                     const fs::path& directory) {
  Json object;
  add_name(object, surface.name);
  if (const auto& primitive = surface.primitive) {
    Json& entry = object["primitive"] =
        Json{{"type", scene_names::primitives[static_cast<std::size_t>(primitive->shape)]},
             {"size", to_json(primitive->size)}};
    add_unknown_keys(entry, unknown_keys.of(surface.id, "primitive"));
  } else {
    object[surface.imported ? "file" : "mesh"] =
        SceneReferences::text_for(surface.mesh_file, directory);
    if (!surface.nodes.empty()) object["nodes"] = surface.nodes;
  }
  object["translate"] = to_json(surface.translate);
  object["rotate"] = to_json(surface.rotate);
  object["scale"] = surface.scale;
  if (!surface.imported) {
    object["material"] = material_to_json(surface, unknown_keys, directory);
  } else if (!surface.materials.empty()) {
    object["materials"] = materials_to_json(surface, unknown_keys, directory);
  }
  if (surface.transfer != Surface::Transfer::none) {
    object["transfer"] = scene_names::transfers[static_cast<std::size_t>(surface.transfer)];
  }
  if (surface.copies) object["copies"] = copies_to_json(surface, unknown_keys, directory);
  write_fields(object, surface, NoKeys());
  add_rest(object, surface.id, unknown_keys,
           [&](auto&& visit) { visit_keyed_surface(surface, visit); });
  return object;
}

Json sky_to_json(const Sky& sky, ObjectId environment, const UnknownKeys& unknown_keys) {
  Json object = Json::object();
  write_fields(object, sky, sky.keys);
  add_rest(
      object, environment, unknown_keys, [&](auto&& visit) { visit_keyed(sky, visit); }, "sky");
  return object;
}

Json scene_to_json(const SceneDocument& document, const fs::path& directory) {
  const Scene& scene = document.scene;
  const UnknownKeys& unknown_keys = document.extras.unknown_keys;
  Json root{{"format", scene_names::format}, {"version", scene_names::version}};
  root["camera"] = camera_to_json(scene, unknown_keys);
  for (const NamedCamera& camera : scene.cameras) {
    root["cameras"].push_back(camera_to_json(camera, unknown_keys));
  }
  root["film"] = Json{{"width", scene.film.width}, {"height", scene.film.height}};
  add_unknown_keys(root["film"], unknown_keys.of("film"));
  if (Json output = output_to_json(scene.output, unknown_keys, directory); !output.empty()) {
    root["output"] = std::move(output);
  }
  root["medium"] = medium_to_json(document, directory);
  Json& lights = root["lights"] = Json::array();
  for (const Light& light : scene.lights) {
    Json entry = light_to_json(light, [&directory](const std::filesystem::path& file) {
      return SceneReferences::text_for(file, directory);
    });
    if (entry.contains("texture")) {
      add_unknown_keys(entry["texture"], unknown_keys.of(light.id, "texture"));
    }
    add_name(entry, light.name);
    add_rest(entry, light.id, unknown_keys, [&](auto&& visit) { visit_keyed(light, visit); });
    lights.push_back(std::move(entry));
  }
  if (const auto& environment = scene.environment) {
    Json& entry = root["environment"] = Json::object();
    if (const auto& sky = environment->sky) {
      entry["sky"] = sky_to_json(*sky, environment->id, unknown_keys);
    } else {
      entry["file"] = SceneReferences::text_for(environment->file, directory);
    }
    write_fields(entry, *environment, environment->keys);
    add_rest(entry, environment->id, unknown_keys,
             [&](auto&& visit) { visit_keyed(*environment, visit); });
  }
  Json& surfaces = root["surfaces"] = Json::array();
  for (const Surface& surface : scene.surfaces) {
    surfaces.push_back(surface_to_json(surface, unknown_keys, directory));
  }
  if (const auto& playback = scene.playback) {
    Json& entry = root["timeline"] =
        Json{{"first", playback->first}, {"last", playback->last}, {"loop", playback->loops}};
    if (playback->frames_per_second != default_frame_rate) {
      entry["frames_per_second"] = playback->frames_per_second;
    }
    add_unknown_keys(entry, unknown_keys.of("timeline"));
  }
  add_unknown_keys(root, unknown_keys.of(""));
  return root;
}

// JSON as people write it: an array or object that fits on a line stands on one.
class Layout {
 public:
  explicit Layout(const fs::path& directory) : directory_(directory) {}

  std::string text(const Json& root) {
    append(root, 0);
    return std::move(text_) + "\n";
  }

 private:
  static constexpr std::size_t longest_line = 100;
  static constexpr std::size_t max_on_a_line = 16;

  void append(const Json& value, std::size_t indent) {
    if (value.is_structured() && !value.empty()) {
      const std::size_t begin = text_.size();
      if (indent > 0 && append_line(value, begin + longest_line - std::min(indent, longest_line))) {
        return;
      }
      text_.resize(begin);
      append_broken(value, indent);
    } else {
      append_scalar(value);
    }
  }

  void append_scalar(const Json& value) {
    if (value.is_number_float() && !std::isfinite(value.get<double>())) {
      throw InputError(directory_, "", "a scene with a value that is not finite cannot be saved");
    }
    text_ += value.dump();
  }

  void append_broken(const Json& value, std::size_t indent) {
    const std::string line = std::string(1, '\n').append(indent + 2, ' ');
    text_ += value.is_object() ? '{' : '[';
    const char* separator = "";
    for (const auto& [key, member] : value.items()) {
      text_ += separator + line;
      if (value.is_object()) text_ += Json(key).dump() + ": ";
      append(member, indent + 2);
      separator = ",";
    }
    (text_ += '\n').append(indent, ' ');
    text_ += value.is_object() ? '}' : ']';
  }

  // False, with some of it written, if the text would become longer than `end`.
  bool append_line(const Json& value, std::size_t end) {
    if (!value.is_structured() || value.empty()) {
      append_scalar(value);
      return text_.size() <= end;
    }
    if (value.size() > max_on_a_line) return false;
    text_ += value.is_object() ? "{ " : "[";
    const char* separator = "";
    for (const auto& [key, member] : value.items()) {
      text_ += separator;
      if (value.is_object()) text_ += Json(key).dump() + ": ";
      if (!append_line(member, end)) return false;
      separator = ", ";
    }
    text_ += value.is_object() ? " }" : "]";
    return text_.size() <= end;
  }

  const fs::path& directory_;
  std::string text_;
};

}  // namespace

bool refers_to_medium_file(const SceneDocument& document) {
  const std::shared_ptr<const MediumFile>& loaded = document.extras.medium_file;
  return loaded != nullptr && is_unchanged(*loaded, document.scene);
}

std::string document_to_json(const SceneDocument& document, const fs::path& directory) {
  try {
    return Layout(directory).text(scene_to_json(document, directory));
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw InputError(directory, "", "the scene does not fit into memory");
  } catch (const std::exception& error) {  // a name that is not UTF-8, or of the file system
    throw InputError(directory, "", std::string("the scene cannot be saved: ") + error.what());
  }
}

void save_document(const SceneDocument& document, const fs::path& file) {
  write_atomically(file, document_to_json(document, file.parent_path()));
}

}  // namespace brume
