#include "core/io/scene/material_json.h"

#include "core/io/scene/fields_json.h"
#include "core/io/scene/scene_names.h"
#include "core/scene/fields/material_fields.h"

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
                 UnknownKeys& unknown_keys, Surface& surface)
      : context_(context),
        references_(references),
        budget_(budget),
        unknown_keys_(unknown_keys),
        surface_(surface) {}

  void read(JsonObject& object) {
    Material& material = surface_.material;
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
    unknown_keys_.add(surface_.id, "material", object.unknown_keys());
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
      auto reference = object.find_object(key);
      if (reference) read_texture_reference(*reference, key, texture, has_colors);
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
    unknown_keys_.add(surface_.id, std::string("material.") + key, object.unknown_keys());
  }

  JsonContext& context_;
  SceneReferences& references_;
  SceneBudget& budget_;
  UnknownKeys& unknown_keys_;
  Surface& surface_;
};

void add_metallic_roughness(Json& object, const Surface& surface, const UnknownKeys& unknown_keys,
                            const fs::path& directory) {
  const MetallicRoughness& material = surface.material.metallic_roughness;
  write_fields(object, material, NoKeys());
  if (material.alpha != AlphaMode::opaque) {
    object["alpha"] = scene_names::alpha_modes[static_cast<std::size_t>(material.alpha)];
  }
  visit_texture_keys(material, [&](const char* key, const TextureReference& texture, bool) {
    if (texture.file.empty()) return;
    Json& entry = object[key] = Json{{"file", SceneReferences::text_for(texture.file, directory)}};
    const auto add_wrap = [&](const char* name, TextureWrap wrap) {
      if (wrap == TextureWrap::repeat) return;
      entry[name] = scene_names::texture_wraps[static_cast<std::size_t>(wrap)];
    };
    add_wrap("wrap_u", texture.wrap_u);
    add_wrap("wrap_v", texture.wrap_v);
    add_unknown_keys(entry, unknown_keys.of(surface.id, std::string("material.") + key));
  });
}

}  // namespace

void read_material(JsonContext& context, JsonObject& object, SceneReferences& references,
                   SceneBudget& budget, UnknownKeys& unknown_keys, Surface& surface) {
  MaterialReader(context, references, budget, unknown_keys, surface).read(object);
}

Json material_to_json(const Surface& surface, const UnknownKeys& unknown_keys,
                      const fs::path& directory) {
  const Material& material = surface.material;
  Json object;
  object["type"] = scene_names::materials[static_cast<std::size_t>(material.type)];
  switch (material.type) {
    case Material::Type::measured:
      object["file"] = SceneReferences::text_for(material.file, directory);
      break;
    case Material::Type::diffuse:
    case Material::Type::phong:
      write_fields(object, material, surface.keys);
      break;
    case Material::Type::metallic_roughness:
      add_metallic_roughness(object, surface, unknown_keys, directory);
      break;
  }
  add_unknown_keys(object, unknown_keys.of(surface.id, "material"));
  return object;
}

}  // namespace brume
