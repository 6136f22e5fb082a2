#include "core/io/scene/usd_material.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/image/image_file.h"
#include "core/scene/materials/mixed_texture.h"
#include "core/scene/materials/texture.h"

namespace brume {
namespace {

using Frames = std::span<const UsdFrame>;

bool is_image_file(const std::filesystem::path& file) {
  const std::string extension = lower_case_extension(file);
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg" ||
         extension == ".exr" || extension == ".hdr";
}

void write_image(const std::filesystem::path& file, const Texture& texture) {
  const Texture::Level& level = texture.levels().front();
  const auto count = static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
  const unsigned bits = has_alpha(texture) ? 32 : 24;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(bits / 8 * count);
  for (const std::uint32_t texel : texture.texels().subspan(level.first, count)) {
    for (unsigned shift = 0; shift < bits; shift += 8) {
      bytes.push_back(static_cast<std::uint8_t>(texel >> shift));
    }
  }
  if (bits == 32) {
    write_png_with_alpha(file, level.width, level.height, bytes);
  } else {
    write_png(file, level.width, level.height, bytes, {});
  }
}

const char* wrap_name(TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::clamp:
      return "\"clamp\"";
    case TextureWrap::mirror:
      return "\"mirror\"";
    case TextureWrap::repeat:
      break;
  }
  return "\"repeat\"";
}

// A Phong lobe's exponent as the roughness of a GGX lobe that is as wide: alpha^2 = 2 / (n + 2)
// (Walter et al., "Microfacet Models for Refraction", 2007).
double phong_roughness(double exponent) {
  return std::pow(2.0 / (exponent + 2.0), 0.25);
}

// The mean is white where there are none.
glm::dvec4 mean_color(const std::vector<glm::vec4>& colors) {
  if (colors.empty()) return glm::dvec4(1.0);
  glm::dvec4 sum(0.0);
  for (const glm::vec4& color : colors) sum += glm::dvec4(color);
  return sum / static_cast<double>(colors.size());
}

class PreviewSurface {
 public:
  PreviewSurface(UsdText& out, Frames frames, std::size_t i, std::string path,
                 UsdTextures& textures)
      : out_(out), frames_(frames), i_(i), path_(std::move(path)), textures_(textures) {}

  void write() {
    out_.constant("token outputs:surface.connect", "<" + path_ + "/Shader.outputs:surface>");
    out_.open("Shader", "Shader");
    out_.constant("uniform token info:id", "\"UsdPreviewSurface\"");
    const Material::Type type = first().type;
    if (type == Material::Type::metallic_roughness) {
      write_metallic_roughness();
    } else {
      each("color3f inputs:diffuseColor", [](const Material& m) { return m.reflectance; });
      out_.constant("float inputs:metallic", usd_value(0.0));
      write_lobe(type == Material::Type::phong);
    }
    out_.declare("token outputs:surface");
    out_.close();
    for (const Use& use : uses_) write_texture(use);
    for (const Reader& reader : readers_) write_reader(reader);
  }

 private:
  struct Use {
    const char* name;
    const TextureReference* texture;
    glm::dvec4 scale;
    glm::dvec4 bias;
    const char* color_space;
    const char* channel;  // that the shader takes
  };

  // A prim that reads values of vertices.
  struct Reader {
    const char* name;
    const char* type;
    const char* values;
    bool operator==(const Reader&) const = default;
  };

  [[nodiscard]] const Material& material(std::size_t k) const {
    return frames_[k].scene.surfaces[i_].material;
  }
  [[nodiscard]] const Material& first() const { return material(0); }

  template <class ValueOf>
  void each(std::string_view declaration, ValueOf value_of) {
    out_.each_frame(declaration, [&](std::size_t k) { return value_of(material(k)); });
  }

  void write_lobe(bool is_phong) {
    if (!is_phong) {
      out_.constant("float inputs:roughness", usd_value(1.0));
      return;
    }
    out_.constant("int inputs:useSpecularWorkflow", "1");
    each("color3f inputs:specularColor", [](const Material& m) { return m.specular; });
    each("float inputs:roughness", [](const Material& m) { return phong_roughness(m.exponent); });
  }

  void write_metallic_roughness() {
    const MetallicRoughness& m = first().metallic_roughness;
    const auto value = [&](const char* declaration, const char* name, auto constant,
                           const TextureReference& texture, const glm::dvec4& scale,
                           const char* space, const char* channel) {
      if (!texture.content) {
        out_.constant(declaration, usd_value(constant));
        return;
      }
      connect(declaration, {name, &texture, scale, glm::dvec4(0.0), space, channel});
    };
    const double opacity = usd_opacity(m);
    const Surface& surface = frames_[0].scene.surfaces[i_];
    const std::vector<glm::vec4>& colors = to_arrays(*surface.mesh).colors;
    if (!m.base_color_texture.content && !colors.empty()) {
      connect_reader("color3f inputs:diffuseColor", {"Colors", "float3", "displayColor"});
    } else {
      value("color3f inputs:diffuseColor", "BaseColor", m.base_color, m.base_color_texture,
            glm::dvec4(m.base_color, opacity) * mean_color(colors), "\"sRGB\"", "rgb");
    }
    if (m.alpha != AlphaMode::opaque && m.base_color_texture.content) {
      out_.constant("float inputs:opacity.connect", "<" + path_ + "/BaseColor.outputs:a>");
    } else if (usd_colors_have_opacity(surface)) {
      connect_reader("float inputs:opacity", {"Opacities", "float", "displayOpacity"});
    } else if (opacity < 1.0) {
      out_.constant("float inputs:opacity", usd_value(opacity));
    }
    if (m.alpha == AlphaMode::cutout) {
      out_.constant("float inputs:opacityThreshold", usd_value(m.alpha_cutoff));
    }
    value("color3f inputs:emissiveColor", "Emissive", m.emissive, m.emissive_texture,
          {m.emissive, 1.0}, "\"sRGB\"", "rgb");
    const TextureReference& pair = m.metallic_roughness_texture;
    const glm::dvec4 scale(1.0, m.roughness, m.metallic, 1.0);
    value("float inputs:roughness", "MetallicRoughness", m.roughness, pair, scale, "\"raw\"", "g");
    value("float inputs:metallic", "MetallicRoughness", m.metallic, pair, scale, "\"raw\"", "b");
    if (m.normal_texture.content) {
      const double slope = m.normal_scale;
      connect("normal3f inputs:normal", {"Normal",
                                         &m.normal_texture,
                                         {2 * slope, 2 * slope, 2, 1},
                                         {-slope, -slope, -1, 0},
                                         "\"raw\"",
                                         "rgb"});
    }
  }

  void connect(std::string declaration, const Use& use) {
    out_.constant(declaration + ".connect",
                  "<" + path_ + "/" + use.name + ".outputs:" + use.channel + ">");
    uses_.push_back(use);
  }

  void connect_reader(std::string declaration, const Reader& reader) {
    out_.constant(declaration + ".connect", "<" + path_ + "/" + reader.name + ".outputs:result>");
    readers_.push_back(reader);
  }

  // Both values of one texture are outputs of one prim.
  void write_texture(const Use& use) {
    if (use.channel == std::string_view("b")) return;
    out_.open("Shader", use.name);
    out_.constant("uniform token info:id", "\"UsdUVTexture\"");
    out_.constant("asset inputs:file", textures_.asset(*use.texture));
    const bool is_linear = use.texture->content->encoding() == Texture::Encoding::shared_exponent;
    out_.constant("token inputs:sourceColorSpace", is_linear ? "\"raw\"" : use.color_space);
    const bool is_second = use.texture->uses_second_texcoords && has_second_texcoords();
    const Reader reader = is_second ? Reader{"SecondCoordinates", "float2", "st1"}
                                    : Reader{"Coordinates", "float2", "st"};
    if (std::ranges::count(readers_, reader) == 0) readers_.push_back(reader);
    out_.constant("float2 inputs:st.connect", "<" + path_ + "/" + reader.name + ".outputs:result>");
    out_.constant("token inputs:wrapS", wrap_name(use.texture->wrap_u));
    out_.constant("token inputs:wrapT", wrap_name(use.texture->wrap_v));
    out_.constant("float4 inputs:scale", usd_value(use.scale));
    out_.constant("float4 inputs:bias", usd_value(use.bias));
    out_.declare("float outputs:g");
    out_.declare("float outputs:b");
    out_.declare("float outputs:a");
    out_.declare("float3 outputs:rgb");
    out_.close();
  }

  [[nodiscard]] bool has_second_texcoords() const {
    return !to_arrays(*frames_[0].scene.surfaces[i_].mesh).second_texcoords.empty();
  }

  void write_reader(const Reader& reader) {
    const std::string type = reader.type;
    out_.open("Shader", reader.name);
    out_.constant("uniform token info:id", "\"UsdPrimvarReader_" + type + "\"");
    out_.constant("string inputs:varname", std::string("\"") + reader.values + "\"");
    out_.declare(type + " outputs:result");
    out_.close();
  }

  UsdText& out_;
  Frames frames_;
  std::size_t i_;
  std::string path_;
  UsdTextures& textures_;
  std::vector<Use> uses_;
  std::vector<Reader> readers_;
};

}  // namespace

double usd_opacity(const MetallicRoughness& material) {
  const glm::dvec3& t = material.transmission;
  const double crossing = (t.x + t.y + t.z) / 3.0;
  return (material.alpha == AlphaMode::opaque ? 1.0 : material.opacity) * (1.0 - crossing);
}

bool usd_colors_have_opacity(const Surface& surface) {
  const Material& material = surface.material;
  return material.type == Material::Type::metallic_roughness &&
         material.metallic_roughness.alpha != AlphaMode::opaque &&
         !material.metallic_roughness.base_color_texture.content &&
         std::ranges::any_of(to_arrays(*surface.mesh).colors,
                             [](const glm::vec4& color) { return color.a < 1.0f; });
}

std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& file) {
  return usd_asset(file.lexically_proximate(folder).generic_string());
}

UsdTextures::UsdTextures(const std::filesystem::path& stage, AddOutput add_output)
    : folder_(std::filesystem::absolute(stage).parent_path()),
      stem_(stage.stem().string()),
      add_output_(std::move(add_output)) {}

std::string UsdTextures::asset(const TextureReference& texture) {
  const bool is_linear = texture.content->encoding() == Texture::Encoding::shared_exponent;
  if (is_image_file(texture.file) || is_linear) return named_from(folder_, texture.file);
  auto [at, is_new] = written_.try_emplace(texture.content.get());
  if (is_new) {
    at->second = folder_ / (stem_ + "_texture_" + std::to_string(written_.size()) + ".png");
    if (add_output_) add_output_(at->second);
    write_image(at->second, *texture.content);
  }
  return named_from(folder_, at->second);
}

void write_usd_material(UsdText& out, Frames frames, std::size_t i, const std::string& path,
                        UsdTextures& textures) {
  const std::string material = path + "/Material";
  out.constant("rel material:binding", "<" + material + ">");
  out.open("Material", "Material");
  PreviewSurface(out, frames, i, material, textures).write();
  out.close();
}

}  // namespace brume
