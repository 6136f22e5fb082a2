#include "core/io/import/imported_scene_file.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/image/texture_file.h"
#include "core/io/import/reader_program.h"
#include "core/io/import/scene_readers.h"
#include "core/io/text_scanner.h"
#include "core/io/unicode_text.h"
#include "core/printable_text.h"
#include "core/scene/materials/mixed_texture.h"
#include "core/scene/mesh.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

const std::string counts_as_white = "; it counts as white, and as black where it is an emission";

bool is_gltf(const fs::path& file) {
  const std::string extension = lower_case_extension(file);
  return extension == ".gltf" || extension == ".glb";
}

// Decodes the images and makes the meshes of a raw scene.
class SceneBuilder {
 public:
  SceneBuilder(const fs::path& file, RawScene raw, std::vector<std::string>& warnings)
      : file_(file), raw_(std::move(raw)), warnings_(warnings) {}

  std::shared_ptr<const ImportedScene> build(const std::stop_token& stop) {
    auto scene = std::make_shared<ImportedScene>();
    scene->files = std::move(raw_.files);
    for (RawPart& part : raw_.parts) {
      if (stop.stop_requested()) return nullptr;
      auto mesh =
          part.same_mesh_as ? scene->parts[*part.same_mesh_as].mesh : mesh_of(std::move(part.mesh));
      add_bytes(part.placements.size() * limits::copy_bytes + part.keys.bytes());
      if (part.deformation) add_bytes(part.deformation->bytes());
      scene->parts.push_back({part.node, std::move(mesh), material(part.material, *scene),
                              std::move(part.placements), std::move(part.keys),
                              std::move(part.deformation)});
    }
    scene->changed = latest_change(scene->files);
    scene->nodes = std::move(raw_.nodes);
    scene->cameras = std::move(raw_.cameras);
    scene->lights = std::move(raw_.lights);
    scene->left_out = std::move(raw_.left_out);
    return scene;
  }

 private:
  using TextureOfImage = std::pair<std::size_t, bool>;  // and whether it has colors

  std::shared_ptr<const TriangleMesh> mesh_of(MeshArrays arrays) {
    auto mesh = to_mesh(std::move(arrays), limits::scene_bytes - bytes_);
    if (!mesh) fail_too_large();
    add_bytes(mesh_bytes(*mesh));
    return mesh;
  }

  const Material& material(std::size_t index, ImportedScene& scene) {
    const auto [at, is_new] = materials_.try_emplace(index);
    if (!is_new) return at->second;
    const RawMaterial& raw = raw_.materials[index];
    Material& result = at->second;
    result.type = Material::Type::metallic_roughness;
    result.metallic_roughness = raw.values;
    const std::string name = raw.name.empty() ? "material " + std::to_string(index) : raw.name;
    result.name = name;
    // Materials are told apart by their names.
    for (int k = 2; !names_.insert(result.name).second; ++k) {
      result.name = name + " " + std::to_string(k);
    }
    for (std::size_t slot = 0; slot < raw.textures.size(); ++slot) {
      const std::optional<RawTexture>& use = raw.textures[slot];
      if (!use) continue;
      TextureReference& texture = *textures_of(result.metallic_roughness)[slot];
      texture.file = raw_.images[use->image].file;
      texture.content = this->texture({use->image, texture_has_colors[slot]}, scene);
      texture.wrap_u = use->wrap_u;
      texture.wrap_v = use->wrap_v;
      texture.uses_second_texcoords = use->uses_second_texcoords;
    }
    MetallicRoughness& values = result.metallic_roughness;
    if (raw.textures[3] && !values.emissive_texture.content) values.emissive = glm::dvec3(0.0);
    if (raw.opacity_image) add_opacity(*raw.opacity_image, values.base_color_texture, scene);
    if (raw.is_transmission_tinted) tint(values);
    return result;
  }

  // Makes an image of its own of what a scene has in two.
  void set_mixed(TextureReference& texture, std::shared_ptr<const Texture> mixed) {
    texture.file = file_;
    texture.content = std::move(mixed);
    add_bytes(texture.content->bytes());
  }

  void add_opacity(std::size_t image, TextureReference& base_color, ImportedScene& scene) {
    const std::shared_ptr<const Texture> opacity = texture({image, false}, scene);
    if (!opacity) return;
    const bool is_alpha = has_alpha(*opacity);
    set_mixed(base_color, mixed_texture(base_color.content.get(), opacity.get(),
                                        [is_alpha](glm::vec4 color, const glm::vec4& share) {
                                          color.a = is_alpha ? share.a
                                                             : (share.r + share.g + share.b) / 3.0f;
                                          return color;
                                        }));
  }

  // Light that crosses the surface has the base color.
  void tint(MetallicRoughness& values) {
    const TextureReference& base_color = values.base_color_texture;
    TextureReference& share = values.transmission_texture;
    if (!share.content) {
      share = base_color;
      return;
    }
    set_mixed(share, mixed_texture(base_color.content.get(), share.content.get(),
                                   [](const glm::vec4& color, const glm::vec4& crossing) {
                                     return color * crossing.r;
                                   }));
  }

  // Null, which is white, with a warning where it is missing or cannot be read. A surface that it
  // would make emit light here and there emits none then.
  std::shared_ptr<const Texture> texture(const TextureOfImage& use, ImportedScene& scene) {
    const auto [at, is_new] = textures_.try_emplace(use);
    if (!is_new) return at->second;
    const auto& [index, has_colors] = use;
    const RawImage& image = raw_.images[index];
    std::error_code error;
    if (image.file != file_ && !fs::exists(image.file, error)) {
      warn_of_texture(use, printable(image.file.string()) + " is missing");
      return nullptr;
    }
    if (fs::is_regular_file(image.file, error) && !std::ranges::count(scene.files, image.file)) {
      scene.files.push_back(image.file);
      if (image.is_absolute) scene.absolute_files.push_back(image.file);
    }
    if (!image.error.empty()) {
      warn_of_texture(use, image.error + counts_as_white);
      return nullptr;
    }
    try {
      at->second = image.file == file_ ? decode_texture(image.name, image.bytes, has_colors)
                                       : read_texture(image.file, has_colors, &warnings_);
    } catch (const InputError& mistake) {
      warn_of_texture(use, mistake.what() + counts_as_white);
      return nullptr;
    }
    add_bytes(at->second->bytes());
    return at->second;
  }

  // Once per image, should it be used both as colors and as other values.
  void warn_of_texture(const TextureOfImage& use, const std::string& message) {
    const auto other = textures_.find({use.first, !use.second});
    if (other != textures_.end() && other->second == nullptr) return;
    warnings_.push_back(InputError(file_, "", "the texture " + message).what());
  }

  void add_bytes(std::size_t bytes) {
    bytes_ += bytes;
    if (bytes_ > limits::scene_bytes) fail_too_large();
  }

  [[noreturn]] void fail_too_large() const {
    throw InputError(file_, "",
                     "its meshes and textures need more than the allowed " +
                         std::to_string(limits::scene_bytes) + " bytes of memory");
  }

  const fs::path& file_;
  RawScene raw_;
  std::vector<std::string>& warnings_;
  std::map<std::size_t, Material> materials_;
  std::set<std::string> names_;  // of them
  std::map<TextureOfImage, std::shared_ptr<const Texture>> textures_;
  std::size_t bytes_ = 0;
};

}  // namespace

bool is_imported_scene(const fs::path& file) {
  const std::string extension = lower_case_extension(file);
  return is_gltf(file) || extension == ".obj" || extension == ".fbx";
}

std::shared_ptr<const ImportedScene> read_imported_scene(const fs::path& file,
                                                         std::vector<std::string>& warnings,
                                                         const std::stop_token& stop) {
  regular_file_size(file);  // report a missing file before its extension
  if (!is_imported_scene(file)) {
    throw InputError(file, "",
                     "found a scene of format " + quoted_text(lower_case_extension(file)) +
                         "; allowed: .gltf, .glb, .obj, .fbx");
  }
  if (regular_file_size(file) == 0) throw InputError(file, "", "is empty");
  RawScene raw = is_gltf(file) ? read_gltf(file) : read_by_program(file, stop);
  if (stop.stop_requested()) return nullptr;
  warnings.insert(warnings.end(), raw.warnings.begin(), raw.warnings.end());
  return SceneBuilder(file, std::move(raw), warnings).build(stop);
}

fs::file_time_type latest_change(std::span<const fs::path> files) {
  fs::file_time_type latest = fs::file_time_type::min();
  for (const fs::path& file : files) {
    std::error_code error;
    const fs::file_time_type time = fs::last_write_time(file, error);
    if (!error) latest = std::max(latest, time);
  }
  return latest;
}

bool obj_has_materials(const fs::path& file) {
  // It stands before the faces that use a material.
  const std::string begin = as_utf8(read_first_bytes(file, std::size_t{1} << 20));
  TextScanner scanner(begin);
  while (scanner.next_line()) {
    if (scanner.next_token() == "mtllib") return true;
  }
  return false;
}

std::string imported_name(std::string_view name, const std::string& otherwise) {
  std::string result;
  for (const char c : name.substr(0, limits::name_length)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f) result += c;
  }
  // Not half a character of UTF-8.
  if (name.size() > limits::name_length) {
    while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0xC0) == 0x80)
      result.pop_back();
    if (!result.empty() && static_cast<unsigned char>(result.back()) >= 0xC0) result.pop_back();
  }
  return result.empty() ? otherwise : result;
}

}  // namespace brume
