#include "render/gl/material_stage.h"

#include <cstring>
#include <map>

#include "brume/mesh_arrays.h"
#include "core/scene/materials/mesh_values.h"
#include "core/scene/materials/texture.h"
#include "render/gl/shader_structs.h"

namespace brume::gl {
namespace {

bool is_metallic_roughness(const Surface& surface) {
  return surface.material.type == Material::Type::metallic_roughness;
}

// Texels of textures, each once, and what materials.glsl needs to know of their uses.
class TextureRecords {
 public:
  std::vector<std::uint32_t> texels;
  std::vector<std::uint32_t> words;

  // The place of a use among `words`; 0: no texture.
  std::uint32_t add(const TextureReference& reference) {
    if (!reference.content) return 0;
    const brume::Texture& texture = *reference.content;
    const std::uint32_t first = first_texel(texture);
    const auto place = static_cast<std::uint32_t>(words.size());
    words.insert(words.end(), {static_cast<std::uint32_t>(texture.encoding()),
                               static_cast<std::uint32_t>(reference.wrap_u),
                               static_cast<std::uint32_t>(reference.wrap_v),
                               static_cast<std::uint32_t>(texture.levels().size()),
                               std::uint32_t{reference.uses_second_texcoords}});
    for (const brume::Texture::Level& level : texture.levels()) {
      words.insert(words.end(), {static_cast<std::uint32_t>(level.width),
                                 static_cast<std::uint32_t>(level.height),
                                 first + static_cast<std::uint32_t>(level.first)});
    }
    return place;
  }

 private:
  std::uint32_t first_texel(const brume::Texture& texture) {
    const auto [known, is_new] =
        first_.try_emplace(&texture, static_cast<std::uint32_t>(texels.size()));
    if (is_new) {
      if (texels.size() + texture.texels().size() > UINT32_MAX) {
        throw OutOfMemory("the textures do not fit into device memory");
      }
      texels.insert(texels.end(), texture.texels().begin(), texture.texels().end());
    }
    return known->second;
  }

  std::map<const brume::Texture*, std::uint32_t> first_;
};

}  // namespace

void MaterialStage::run(const FrameContext& work, DeviceFrame& device) {
  upload_materials(work.scene);
  upload_mesh_values(work.scene, device.mesh);
  const Film& film = work.frame.film;
  const std::size_t pixels =
      static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  device.textures.behind.reserve((1 + ggx_vectors) * pixels * sizeof(glm::vec4));
  const Program& program = device.programs.get("materials", ray_definitions(work.rays));
  set_rays(program, work.rays);
  program.set("eye", work.rays.eye() - device.mesh.center());
  program.set("film", glm::ivec2(film.width, film.height));
  program.set("pixel_angle", static_cast<float>(2.0 * work.rays.pixel_half_angle()));
  program.set("pixel_width", static_cast<float>(work.rays.pixel_width()));
  device.mesh.bind(program);
  program.bind("Hits", device.mesh.hits());
  program.bind("Behind", device.textures.behind);
  program.bind("Texels", texels_);
  program.bind("MeshValues", mesh_values_);
  program.set("second_texcoords_at", static_cast<int>(second_texcoords_at_));
  program.set("colors_at", static_cast<int>(colors_at_));
  program.bind("Records", records_);
  program.dispatch_over({film.width, film.height});
}

void MaterialStage::upload_materials(const Scene& scene) {
  std::vector<Material> materials;
  for (const Surface& surface : scene.surfaces) materials.push_back(surface.material);
  if (materials_ == materials) return;
  materials_.reset();
  std::vector<MaterialRecord> records(materials.size());
  TextureRecords textures;
  textures.words.resize(records.size() * sizeof(MaterialRecord) / sizeof(std::uint32_t));
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!is_metallic_roughness(scene.surfaces[i])) continue;
    const MetallicRoughness& material = materials[i].metallic_roughness;
    records[i] = {.base_color = glm::vec3(material.base_color),
                  .metallic = static_cast<float>(material.metallic),
                  .emissive = glm::vec3(material.emissive),
                  .roughness = static_cast<float>(material.roughness),
                  .normal_scale = static_cast<float>(material.normal_scale),
                  .is_metallic_roughness = 1,
                  .base_color_texture = textures.add(material.base_color_texture),
                  .metallic_roughness_texture = textures.add(material.metallic_roughness_texture),
                  .normal_texture = textures.add(material.normal_texture),
                  .emissive_texture = textures.add(material.emissive_texture)};
  }
  if (!records.empty()) {
    std::memcpy(textures.words.data(), records.data(), std::span(records).size_bytes());
  }
  records_.upload(std::span<const std::uint32_t>(textures.words));
  texels_.upload(std::span<const std::uint32_t>(textures.texels));
  materials_ = std::move(materials);
}

void MaterialStage::upload_mesh_values(const Scene& scene, const MeshBuffers& mesh) {
  if (mesh_ == mesh.revision()) return;
  mesh_ = 0;
  bool has_second = false;
  bool has_colors = false;
  for (const Surface& surface : scene.surfaces) {
    const MeshArrays& arrays = to_arrays(*surface.mesh);
    has_second = has_second || !arrays.second_texcoords.empty();
    has_colors = has_colors || !arrays.colors.empty();
  }
  std::vector<float> values;
  const auto append = [&](auto&& add) {
    for (const MeshBuffers::Place& place : mesh.places()) {
      const MeshArrays& arrays = to_arrays(*scene.surfaces[place.surface].mesh);
      for (const MeshValues& corner : corner_values(arrays, place.index)) add(corner);
    }
  };
  const auto append_texcoords = [&](std::size_t set) {
    append([&](const MeshValues& corner) {
      const glm::vec2 uv(corner.texcoords[set].uv);
      values.insert(values.end(), {uv.x, uv.y});
    });
  };
  const std::size_t corners = 3 * mesh.places().size();
  values.reserve(corners * (2 + (has_second ? 2 : 0) + (has_colors ? 3 : 0)));
  append_texcoords(0);
  second_texcoords_at_ = has_second ? values.size() : 0;
  if (has_second) append_texcoords(1);
  colors_at_ = has_colors ? values.size() : 0;
  if (has_colors) {
    append([&](const MeshValues& corner) {
      const glm::vec3 color(corner.color);
      values.insert(values.end(), {color.r, color.g, color.b});
    });
  }
  if (values.size() > INT32_MAX) throw OutOfMemory("the meshes do not fit into device memory");
  mesh_values_.upload(std::span<const float>(values));
  mesh_ = mesh.revision();
}

}  // namespace brume::gl
