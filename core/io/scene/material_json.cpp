#include "core/io/scene/material_json.h"

#include <set>

#include "brume/limits.h"
#include "core/io/scene/fields_json.h"
#include "core/io/scene/scene_names.h"
#include "core/scene/fields/material_fields.h"
#include "core/scene/imported_scene.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

// visit(key, reference, whether it holds colors)
template <class MaterialOrConst, class Visit>
void visit_texture_keys(MaterialOrConst& material, Visit visit) {
  visit("base_color_texture", material.base_color_texture, true);
  visit("metallic_roughness_texture", material.metallic_roughness_texture, false);
  visit("normal_texture", material.normal_texture, false);
  visit("emissive_texture", material.emissive_texture, true);
  visit("transmission_texture", material.transmission_texture, true);
}

class MaterialReader {
 public:
  MaterialReader(JsonContext& context, SceneReferences& references, SceneBudget& budget,
                 UnknownKeys& unknown_keys, ObjectId& surface, bool replaces_file)
      : context_(context),
        references_(references),
        budget_(budget),
        unknown_keys_(unknown_keys),
        surface_(surface),
        replaces_file_(replaces_file) {}

  // `place`: of the material, among the keys of its surface.
  void read(JsonObject& object, const std::string& place, Material& material) {
    place_ = place;
    material.type =
        static_cast<Material::Type>(object.choice("type", scene_names::materials, std::size_t{0}));
    switch (material.type) {
      case Material::Type::measured:
        read_measured(object, material);
        break;
      case Material::Type::phong:
      case Material::Type::diffuse:
        read_fields(object, material);
        break;
      case Material::Type::metallic_roughness:
        read_metallic_roughness(object, material.metallic_roughness);
        break;
    }
    unknown_keys_.add(surface_, place, object.unknown_keys());
  }

 private:
  void read_measured(JsonObject& object, Material& material) {
    const JsonPath file = object.path_of("file");
    material.file = references_.resolve(context_, file, object.text("file", {}));
    material.measured = references_.measured_brdf(context_, file, material.file);
    budget_.reserve(file, *material.measured);
  }

  void read_metallic_roughness(JsonObject& object, MetallicRoughness& material) {
    read_fields(object, material);
    material.alpha =
        static_cast<AlphaMode>(object.choice("alpha", scene_names::alpha_modes, std::size_t{0}));
    visit_texture_keys(material, [&](const char* key, TextureReference& texture, bool has_colors) {
      const Json* value = object.peek(key);
      const bool is_empty = value && value->is_object() && value->empty();
      auto reference = object.find_object(key);
      if (!reference) return;
      texture = {};
      if (replaces_file_ && is_empty) return;
      read_texture_reference(*reference, key, texture, has_colors);
    });
  }

  void read_texture_reference(JsonObject& object, const char* key, TextureReference& texture,
                              bool has_colors) {
    const JsonPath file = object.path_of("file");
    std::tie(texture.file, texture.content) =
        references_.texture(context_, file, object.text("file", {}), has_colors);
    if (texture.content) budget_.reserve(file, *texture.content);
    const auto wrap = [&](const char* name) {
      return static_cast<TextureWrap>(
          object.choice(name, scene_names::texture_wraps, std::size_t{0}));
    };
    texture.wrap_u = wrap("wrap_u");
    texture.wrap_v = wrap("wrap_v");
    unknown_keys_.add(surface_, place_ + "." + key, object.unknown_keys());
  }

  JsonContext& context_;
  SceneReferences& references_;
  SceneBudget& budget_;
  UnknownKeys& unknown_keys_;
  ObjectId& surface_;
  bool replaces_file_;  // a material of an imported scene, whose textures an empty object removes
  std::string place_;
};

// Unknown keys of a material, and the folder of the scene file.
struct MaterialPlace {
  const UnknownKeys& unknown_keys;
  ObjectId surface;
  std::string place;
  const fs::path& directory;

  [[nodiscard]] const std::string& unknown(const std::string& member) const {
    return unknown_keys.of(surface, place + member);
  }
};

// Textures to leave out, in the order of textures_of().
using LeftOut = std::array<bool, texture_has_colors.size()>;

void add_metallic_roughness(Json& object, const MetallicRoughness& material,
                            const LeftOut& left_out, const MaterialPlace& place) {
  write_fields(object, material, NoKeys());
  if (material.alpha != AlphaMode::opaque) {
    object["alpha"] = scene_names::alpha_modes[static_cast<std::size_t>(material.alpha)];
  }
  visit_texture_keys(material,
                     [&, k = 0u](const char* key, const TextureReference& texture, bool) mutable {
                       if (left_out[k++]) return;
                       Json& entry = object[key] = Json::object();
                       if (texture.file.empty()) return;
                       entry["file"] = SceneReferences::text_for(texture.file, place.directory);
                       const auto add_wrap = [&](const char* name, TextureWrap wrap) {
                         if (wrap == TextureWrap::repeat) return;
                         entry[name] = scene_names::texture_wraps[static_cast<std::size_t>(wrap)];
                       };
                       add_wrap("wrap_u", texture.wrap_u);
                       add_wrap("wrap_v", texture.wrap_v);
                       add_unknown_keys(entry, place.unknown(std::string(".") + key));
                     });
}

Json material_to_json(const Material& material, const SurfaceKeys& keys, const LeftOut& left_out,
                      const MaterialPlace& place) {
  Json object;
  if (!material.name.empty()) object["name"] = material.name;
  object["type"] = scene_names::materials[static_cast<std::size_t>(material.type)];
  switch (material.type) {
    case Material::Type::measured:
      object["file"] = SceneReferences::text_for(material.file, place.directory);
      break;
    case Material::Type::diffuse:
    case Material::Type::phong:
      write_fields(object, material, keys);
      break;
    case Material::Type::metallic_roughness:
      add_metallic_roughness(object, material.metallic_roughness, left_out, place);
      break;
  }
  add_unknown_keys(object, place.unknown(""));
  return object;
}

std::string place_of(const Material& material) {
  return "materials." + material.name;
}

}  // namespace

void read_material(JsonContext& context, JsonObject& object, SceneReferences& references,
                   SceneBudget& budget, UnknownKeys& unknown_keys, Surface& surface) {
  MaterialReader(context, references, budget, unknown_keys, surface.id, false)
      .read(object, "material", surface.material);
}

void read_materials(JsonContext& context, JsonObject& object, SceneReferences& references,
                    SceneBudget& budget, UnknownKeys& unknown_keys, Surface& surface) {
  MaterialReader reader(context, references, budget, unknown_keys, surface.id, true);
  const Json::array_t& materials = object.array("materials", limits::surfaces);
  const JsonPath path = object.path_of("materials");
  std::set<std::string> names;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    JsonObject entry(context, materials[i], path.element(i));
    Material material;
    material.name = entry.name({});
    if (!names.insert(material.name).second) {
      entry.fail("name", "found " + quoted_text(material.name) + " twice; allowed: once");
    }
    if (const Material* of_file = material_of_file(*surface.imported, material.name)) {
      const auto textures_of_file = textures_of(of_file->metallic_roughness);
      const auto textures = textures_of(material.metallic_roughness);
      for (std::size_t k = 0; k < textures.size(); ++k) *textures[k] = *textures_of_file[k];
    } else if (!references.is_missing(surface.mesh_file)) {
      context.warn(entry.path_of("name"),
                   "there is no material " + quoted_text(material.name) + " in " +
                       quoted_text(surface.mesh_file.filename().string()) + "; it changes nothing");
    }
    reader.read(entry, place_of(material), material);
    surface.materials.push_back(std::move(material));
  }
}

Json material_to_json(const Surface& surface, const UnknownKeys& unknown_keys,
                      const fs::path& directory) {
  LeftOut none{};
  const auto textures = textures_of(surface.material.metallic_roughness);
  for (std::size_t k = 0; k < none.size(); ++k) none[k] = textures[k]->file.empty();
  return material_to_json(surface.material, surface.keys, none,
                          {unknown_keys, surface.id, "material", directory});
}

Json materials_to_json(const Surface& surface, const UnknownKeys& unknown_keys,
                       const fs::path& directory) {
  Json list = Json::array();
  for (const Material& material : surface.materials) {
    list.push_back(material_to_json(material, {}, are_of_file(*surface.imported, material),
                                    {unknown_keys, surface.id, place_of(material), directory}));
  }
  return list;
}

}  // namespace brume
