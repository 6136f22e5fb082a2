#include "core/io/import/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include "brume/error.h"
#include "core/io/import/gltf_nodes.h"
#include "core/io/import/scene_readers.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "core/printable_text.h"

namespace brume {
namespace {

// A texture as a material refers to it.
struct TextureUse {
  RawTexture texture;
  GltfTexcoords texcoords;
};

constexpr std::int64_t max_set = 15;

TextureWrap wrap_of(JsonObject& sampler, const char* key) {
  constexpr std::int64_t clamp = 33071;
  constexpr std::int64_t mirror = 33648;
  constexpr std::int64_t repeat = 10497;
  const std::int64_t wrap = sampler.integer(key, INT32_MIN, INT32_MAX, repeat);
  return wrap == clamp    ? TextureWrap::clamp
         : wrap == mirror ? TextureWrap::mirror
                          : TextureWrap::repeat;
}

// KHR_texture_transform: scaled, rotated counterclockwise (with v down), moved.
void read_transform(JsonObject& object, TextureUse& use) {
  const glm::dvec2 offset = object.pair("offset", domain::coordinate, glm::dvec2(0.0));
  const glm::dvec2 scale = object.pair("scale", domain::coordinate, glm::dvec2(1.0));
  const double angle = object.number("rotation", domain::coordinate, 0.0);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  auto& [set, transform] = use.texcoords;
  transform = glm::dmat3(c * scale.x, -s * scale.x, 0.0, s * scale.y, c * scale.y, 0.0, offset.x,
                         offset.y, 1.0);
  set = static_cast<std::size_t>(
      object.integer("texCoord", 0, max_set, static_cast<std::int64_t>(set)));
}

// Reads an extension of an object, if it has that. Returns whether it has.
bool read_extension(JsonObject& object, std::string_view name, auto&& read) {
  auto extensions = object.find_object("extensions");
  auto extension = extensions ? extensions->find_object(name) : std::nullopt;
  if (extension) read(*extension);
  return extension.has_value();
}

// The image of a texture; the one of an extension for another format, if it is the only one.
std::optional<std::size_t> source_of(GltfFile& file, JsonObject& texture) {
  if (const auto source = file.index(texture, "source", "images")) return source;
  const Json* const extensions = texture.find("extensions");
  if (extensions == nullptr || !extensions->is_object()) return std::nullopt;
  auto object = texture.object("extensions");
  for (const auto& [name, value] : extensions->items()) {
    if (!value.is_object()) continue;
    JsonObject extension = object.object(name);
    if (const auto source = file.index(extension, "source", "images")) return source;
  }
  return std::nullopt;
}

// Nullopt for a texture without an image.
std::optional<TextureUse> read_texture_use(GltfFile& file, GltfImages& images, JsonObject& object) {
  if (object.find("index") == nullptr) object.fail("index", "missing");
  const std::size_t index = *file.index(object, "index", "textures");
  TextureUse use;
  use.texcoords.set = static_cast<std::size_t>(object.integer("texCoord", 0, max_set, 0));
  read_extension(object, "KHR_texture_transform",
                 [&](JsonObject& transform) { read_transform(transform, use); });
  JsonObject texture = file.object("textures", index);
  if (const auto sampler_index = file.index(texture, "sampler", "samplers")) {
    JsonObject sampler = file.object("samplers", *sampler_index);
    use.texture.wrap_u = wrap_of(sampler, "wrapS");
    use.texture.wrap_v = wrap_of(sampler, "wrapT");
  }
  const auto image = source_of(file, texture);
  if (!image) {
    file.context().warn(texture.path_of("source"), "missing: the texture is left out");
    return std::nullopt;
  }
  images.use(*image);
  use.texture.image = *image;
  return use;
}

// Collects the textures of a material. A mesh has two sets of texture coordinates: those of the
// first textures.
class Textures {
 public:
  Textures(GltfFile& file, GltfImages& images, GltfMaterial& material)
      : file_(file), images_(images), material_(material) {}

  // The texture `key` of an object, the `slot`th of textures_of(); the object of its reference
  // is handed to `read` for what else it has.
  void read(JsonObject& owner, const char* key, std::size_t slot, auto&& read_more) {
    auto object = owner.find_object(key);
    if (!object) return;
    read_more(*object);
    std::optional<TextureUse> use = read_texture_use(file_, images_, *object);
    if (!use) return;
    use->texture.uses_second_texcoords = index_of(use->texcoords, object->path()) == 1;
    material_.material.textures[slot] = use->texture;
  }

 private:
  std::size_t index_of(const GltfTexcoords& texcoords, const JsonPath& user) {
    std::vector<GltfTexcoords>& known = material_.texcoords;
    const auto found = std::ranges::find(known, texcoords);
    if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
    if (known.size() == 2) {
      file_.context().warn(user,
                           "has texture coordinates of its own, the material's third: those of the "
                           "material's first texture are used");
      return 0;
    }
    known.push_back(texcoords);
    return known.size() - 1;
  }

  GltfFile& file_;
  GltfImages& images_;
  GltfMaterial& material_;
};

AlphaMode alpha_mode(JsonObject& material) {
  const std::string mode = material.text("alphaMode", "OPAQUE");
  return mode == "MASK"    ? AlphaMode::cutout
         : mode == "BLEND" ? AlphaMode::blend
                           : AlphaMode::opaque;
}

double emissive_strength(GltfFile& file, JsonObject& material) {
  double strength = 1.0;
  read_extension(material, "KHR_materials_emissive_strength", [&](JsonObject& extension) {
    strength = nearest_number(file, extension, "emissiveStrength", domain::not_negative, 1.0);
  });
  return strength;
}

// KHR_materials_transmission: as much of what is not reflected crosses, in the base color.
void read_transmission(GltfFile& file, JsonObject& extension, RawMaterial& material,
                       Textures& textures) {
  MetallicRoughness& values = material.values;
  values.transmission = nearest_number(file, extension, "transmissionFactor", domain::unit, 0.0) *
                        (1.0 - values.metallic) * values.base_color;
  textures.read(extension, "transmissionTexture", 4, [](JsonObject&) {});
  material.is_transmission_tinted = true;
}

void set_color(MetallicRoughness& values, const std::vector<double>& rgba) {
  values.base_color = {rgba[0], rgba[1], rgba[2]};
  values.opacity = rgba[3];
}

// KHR_materials_pbrSpecularGlossiness, which takes the place of metallic-roughness, as a
// dielectric.
void read_glossiness(GltfFile& file, JsonObject& extension, MetallicRoughness& values,
                     Textures& textures) {
  set_color(values,
            nearest_numbers(file, extension, "diffuseFactor", domain::unit, {1.0, 1.0, 1.0, 1.0}));
  values.metallic = 0.0;
  values.roughness = 1.0 - nearest_number(file, extension, "glossinessFactor", domain::unit, 1.0);
  textures.read(extension, "diffuseTexture", 0, [](JsonObject&) {});
  file.context().warn(extension.path(), "specular colors and textures of glossiness are left out");
}

}  // namespace

GltfMaterial read_gltf_material(GltfFile& file, GltfImages& images, std::size_t index) {
  JsonObject object = file.object("materials", index);
  GltfMaterial result;
  result.material.name = imported_name(object.text("name", ""), "");
  MetallicRoughness& values = result.material.values;
  Textures textures(file, images, result);
  const auto nothing = [](JsonObject&) {};
  const bool has_glossiness =
      read_extension(object, "KHR_materials_pbrSpecularGlossiness",
                     [&](JsonObject& gloss) { read_glossiness(file, gloss, values, textures); });
  if (auto pbr = object.find_object("pbrMetallicRoughness"); pbr && !has_glossiness) {
    set_color(values,
              nearest_numbers(file, *pbr, "baseColorFactor", domain::unit, {1.0, 1.0, 1.0, 1.0}));
    values.metallic = nearest_number(file, *pbr, "metallicFactor", domain::unit, 1.0);
    values.roughness = nearest_number(file, *pbr, "roughnessFactor", domain::unit, 1.0);
    textures.read(*pbr, "baseColorTexture", 0, nothing);
    textures.read(*pbr, "metallicRoughnessTexture", 1, nothing);
  }
  textures.read(object, "normalTexture", 2, [&](JsonObject& normal) {
    static constexpr NumberDomain scales{-1000.0, 1000.0, "a number from -1000 to 1000"};
    values.normal_scale = std::abs(nearest_number(file, normal, "scale", scales, 1.0));
  });
  textures.read(object, "emissiveTexture", 3, nothing);
  values.emissive = nearest_vector(file, object, "emissiveFactor", domain::unit, glm::dvec3(0.0)) *
                    emissive_strength(file, object);
  values.alpha = alpha_mode(object);
  if (values.alpha == AlphaMode::opaque) values.opacity = 1.0;
  if (values.alpha == AlphaMode::cutout) {
    values.alpha_cutoff = nearest_number(file, object, "alphaCutoff", domain::unit, 0.5);
  }
  read_extension(object, "KHR_materials_transmission", [&](JsonObject& extension) {
    read_transmission(file, extension, result.material, textures);
  });
  return result;
}

void GltfImages::use(std::size_t index) {
  RawImage& image = images_[index];
  if (!image.file.empty()) return;
  JsonObject object = file_.object("images", index);
  image = {file_.context().file(), {}, object.path().text()};
  if (const std::string name = object.text("name", ""); !name.empty()) {
    image.name += " (" + quoted_text(name) + ")";
  }
  try {
    if (const auto view = file_.index(object, "bufferView", "bufferViews")) {
      image.bytes = file_.buffer_view(*view);
      return;
    }
  } catch (const InputError& error) {  // which begins with the file's name
    image.error = error.what();
    image.error.erase(0, printable(file_.context().file().string()).size() + 2);
    return;
  }
  GltfFile::Resource found = file_.resource(object.text("uri", ""));
  if (!found.refusal.empty()) image.error = object.path_of("uri").text() + ": " + found.refusal;
  image.bytes = std::move(found.bytes);
  if (!found.file.empty()) image.file = std::move(found.file);
}

}  // namespace brume
