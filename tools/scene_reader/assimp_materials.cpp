#include "tools/scene_reader/assimp_materials.h"

#include <assimp/material.h>

#include <algorithm>
#include <cmath>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/import/scene_readers.h"
#include "core/number_domain.h"
#include "tools/scene_reader/limited_files.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

std::optional<double> number(const aiMaterial& material, const char* key, unsigned type,
                             unsigned index) {
  ai_real value = 0;
  if (material.Get(key, type, index, value) != aiReturn_SUCCESS || !std::isfinite(value)) {
    return std::nullopt;
  }
  return static_cast<double>(value);
}

std::optional<glm::dvec3> color(const aiMaterial& material, const char* key, unsigned type,
                                unsigned index, double brightest) {
  aiColor3D value;
  if (material.Get(key, type, index, value) != aiReturn_SUCCESS) return std::nullopt;
  const auto clamped = [brightest](float x) {
    return std::isfinite(x) ? std::clamp(static_cast<double>(x), 0.0, brightest) : 0.0;
  };
  return glm::dvec3(clamped(value.r), clamped(value.g), clamped(value.b));
}

// A value of a physical material of 3ds Max, which assimp leaves as it is: what the file has
// besides for readers of Phong are pi times its emission and an exponent that is not its roughness.
std::string max_key(const char* name) {
  return std::string("$raw.3dsMax|main|") + name;
}

TextureWrap wrap_of(aiTextureMapMode mode) {
  return mode == aiTextureMapMode_Mirror  ? TextureWrap::mirror
         : mode == aiTextureMapMode_Clamp ? TextureWrap::clamp
                                          : TextureWrap::repeat;
}

class Materials {
 public:
  Materials(const aiScene& from, const fs::path& file, RawScene& to)
      : from_(from), file_(file), to_(to) {}

  std::vector<TexcoordChannels> add_all() {
    std::vector<TexcoordChannels> channels;
    for (unsigned i = 0; i < from_.mNumMaterials; ++i) {
      channels_.clear();
      add(*from_.mMaterials[i]);
      channels.push_back(channels_);
    }
    return channels;
  }

 private:
  void add(const aiMaterial& material) {
    RawMaterial result;
    aiString name;
    if (material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) {
      result.name = imported_name(name.C_Str(), "");
    }
    MetallicRoughness& values = result.values;
    values.base_color =
        color(material, AI_MATKEY_BASE_COLOR, 1.0)
            .value_or(color(material, AI_MATKEY_COLOR_DIFFUSE, 1.0).value_or(glm::dvec3(0.8)));
    values.metallic =
        std::clamp(number(material, max_key("metalness").c_str(), 0, 0)
                       .value_or(number(material, AI_MATKEY_METALLIC_FACTOR).value_or(0.0)),
                   0.0, 1.0);
    values.roughness = roughness(material);
    values.emissive = color(material, max_key("emit_color").c_str(), 0, 0, limits::intensity)
                          .value_or(color(material, AI_MATKEY_COLOR_EMISSIVE, limits::intensity)
                                        .value_or(glm::dvec3(0.0)));
    auto& [base, metallic_roughness, normal, emissive, transmission] = result.textures;
    base = texture(material, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE});
    if (base) values.base_color = glm::dvec3(1.0);
    emissive = texture(material, {aiTextureType_EMISSION_COLOR, aiTextureType_EMISSIVE});
    if (emissive && values.emissive == glm::dvec3(0.0)) values.emissive = glm::dvec3(1.0);
    normal = texture(material, {aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA});
    const auto metal = texture(material, {aiTextureType_METALNESS});
    const auto rough = texture(material, {aiTextureType_DIFFUSE_ROUGHNESS});
    if (metal && rough && metal->image == rough->image) {
      metallic_roughness = metal;
      values.metallic = values.roughness = 1.0;
    } else if (metal || rough) {
      warn("textures of metalness and roughness that are not one image are left out");
    }
    set_opacity(material, result);
    to_.materials.push_back(result);
  }

  // MTL's d, Tr and map_d, and FBX's transparency, are the share that a surface covers.
  void set_opacity(const aiMaterial& material, RawMaterial& result) {
    const auto mask = texture(material, {aiTextureType_OPACITY});
    if (mask) result.opacity_image = mask->image;
    const double opacity = std::clamp(number(material, AI_MATKEY_OPACITY).value_or(1.0), 0.0, 1.0);
    // FBX files may have a mask beside a factor that assimp takes for wholly transparent.
    result.values.opacity = mask && opacity == 0.0 ? 1.0 : opacity;
    if (mask || opacity < 1.0) result.values.alpha = AlphaMode::blend;
  }

  static double roughness(const aiMaterial& material) {
    if (const auto given = number(material, max_key("roughness").c_str(), 0, 0)) {
      return std::clamp(*given, 0.0, 1.0);
    }
    if (const auto glossiness = number(material, max_key("glossiness").c_str(), 0, 0)) {
      return std::clamp(1.0 - *glossiness, 0.0, 1.0);
    }
    if (const auto given = number(material, AI_MATKEY_ROUGHNESS_FACTOR)) {
      return std::clamp(*given, 0.0, 1.0);
    }
    const auto specular = color(material, AI_MATKEY_COLOR_SPECULAR, 1.0);
    const double exponent = number(material, AI_MATKEY_SHININESS).value_or(0.0);
    if (!(exponent > 0.0) || specular == glm::dvec3(0.0)) return 1.0;
    return std::pow(2.0 / (exponent + 2.0), 0.25);
  }

  // The first texture of one of the types.
  std::optional<RawTexture> texture(const aiMaterial& material,
                                    std::initializer_list<aiTextureType> types) {
    for (const aiTextureType type : types) {
      aiString name;
      if (material.GetTexture(type, 0, &name) != aiReturn_SUCCESS || name.length == 0) continue;
      const auto image = image_of(name);
      if (!image) continue;
      int u = aiTextureMapMode_Wrap;
      int v = aiTextureMapMode_Wrap;
      material.Get(AI_MATKEY_MAPPINGMODE_U(type, 0), u);
      material.Get(AI_MATKEY_MAPPINGMODE_V(type, 0), v);
      int channel = 0;
      material.Get(AI_MATKEY_UVWSRC(type, 0), channel);
      return RawTexture{*image, wrap_of(static_cast<aiTextureMapMode>(u)),
                        wrap_of(static_cast<aiTextureMapMode>(v)), is_second(channel)};
    }
    return std::nullopt;
  }

  // Whether texture coordinates are not those of the material's first texture.
  bool is_second(int channel) {
    const auto wanted = static_cast<unsigned>(std::max(channel, 0));
    const auto known = std::ranges::find(channels_, wanted);
    if (known != channels_.end()) return known != channels_.begin();
    if (channels_.size() == 2) {
      warn("a material's third texture coordinates: those of its first texture are used");
      return false;
    }
    channels_.push_back(wanted);
    return channels_.size() == 2;
  }

  std::optional<std::size_t> image_of(const aiString& name) {
    const std::string text = name.C_Str();
    const auto known = std::ranges::find(names_, text);
    if (known != names_.end()) return static_cast<std::size_t>(known - names_.begin());
    RawImage image;
    if (const aiTexture* embedded = from_.GetEmbeddedTexture(text.c_str())) {
      image.file = file_;
      image.name = embedded->mFilename.length > 0 ? embedded->mFilename.C_Str() : text;
      if (embedded->mHeight == 0) {
        image.bytes.assign(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
      } else {
        image.error = image.name + ": found pixels without a format; allowed: an image's file";
      }
    } else {
      std::string path = text;
      std::ranges::replace(path, '\\', '/');
      const fs::path folder = file_.parent_path();
      image.is_absolute = fs::path(path).is_absolute();
      image.file = place_of((folder / path).lexically_normal(), folder);
    }
    names_.push_back(text);
    to_.images.push_back(std::move(image));
    return to_.images.size() - 1;
  }

  void warn(const std::string& message) {
    const std::string warning = InputError(file_, "", message).what();
    if (std::ranges::count(to_.warnings, warning) == 0) to_.warnings.push_back(warning);
  }

  const aiScene& from_;
  const fs::path& file_;
  RawScene& to_;
  std::vector<std::string> names_;  // of to_.images
  TexcoordChannels channels_;       // of the material that is read
};

}  // namespace

std::vector<TexcoordChannels> add_materials(const aiScene& from, const fs::path& file,
                                            RawScene& to) {
  return Materials(from, file, to).add_all();
}

}  // namespace brume
