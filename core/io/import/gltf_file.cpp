#include "core/io/import/gltf_file.h"

#include <algorithm>
#include <array>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/byte_reader.h"
#include "core/io/disk/alike_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/import/uri.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

// The numbers that glTF has from OpenGL.
enum : std::int64_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

std::size_t size_of(std::int64_t type) {
  return type <= u8 ? 1 : type <= u16 ? 2 : 4;
}

template <class Number>
double value_of(const char* bytes, bool is_normalized) {
  Number value;
  std::memcpy(&value, bytes, sizeof(Number));
  if (!is_normalized || std::is_floating_point_v<Number>) return static_cast<double>(value);
  return std::max(
      static_cast<double>(value) / static_cast<double>(std::numeric_limits<Number>::max()), -1.0);
}

double value_of(std::int64_t type, const char* bytes, bool is_normalized) {
  switch (type) {
    case i8:
      return value_of<std::int8_t>(bytes, is_normalized);
    case u8:
      return value_of<std::uint8_t>(bytes, is_normalized);
    case i16:
      return value_of<std::int16_t>(bytes, is_normalized);
    case u16:
      return value_of<std::uint16_t>(bytes, is_normalized);
    case u32:
      return value_of<std::uint32_t>(bytes, is_normalized);
    default:
      return value_of<float>(bytes, is_normalized);
  }
}

constexpr std::array<std::string_view, 8> read_extensions{"EXT_mesh_gpu_instancing",
                                                          "KHR_gaussian_splatting",
                                                          "KHR_lights_punctual",
                                                          "KHR_materials_emissive_strength",
                                                          "KHR_materials_pbrSpecularGlossiness",
                                                          "KHR_materials_transmission",
                                                          "KHR_mesh_quantization",
                                                          "KHR_texture_transform"};
// Extensions without which materials look different, values stay or nobody is named as the author,
// and that is all.
bool is_optional(std::string_view extension) {
  return extension == "KHR_animation_pointer" ||
         std::ranges::any_of(std::array{"_materials_", "_texture_", "_xmp"}, [&](const char* part) {
           return extension.find(part) != extension.npos;
         });
}

bool is_compression(std::string_view extension) {
  return extension.ends_with("_compression");
}

// The one for compression among an object's extensions; empty without.
std::string compression_in(const Json* extensions) {
  if (extensions == nullptr || !extensions->is_object()) return {};
  for (const auto& [name, value] : extensions->items()) {
    if (is_compression(name)) return name;
  }
  return {};
}

// An accessor without a buffer view is all zeros: nothing in the file bounds its size.
constexpr std::int64_t max_zeros = 1 << 20;
constexpr std::int64_t max_bytes = limits::file_bytes;

}  // namespace

struct GltfFile::Accessor {
  std::int64_t type = f32;  // of a component
  std::size_t components = 1;
  std::size_t count = 0;
  bool is_normalized = false;
  std::string_view bytes{};  // from its first element on; empty: zeros
  std::size_t stride = 0;    // in bytes
  const Json* sparse = nullptr;
};

std::string compression_kind(std::string_view extension) {
  const bool is_draco = extension.find("draco") != extension.npos;
  return is_draco ? "Draco compression" : "compression";
}

GltfFile::GltfFile(const fs::path& file, std::vector<std::string>& warnings)
    : context_(file, &warnings), files_{file} {
  const std::string bytes = read_bytes(file);
  if (bytes.starts_with("glTF")) {
    read_binary(bytes);
  } else {
    root_ = parse_json(file, bytes);
  }
  check_version();
}

void GltfFile::read_binary(std::string_view bytes) {
  ByteReader reader(context_.file(), bytes);
  reader.read_bytes(4);
  if (const auto version = reader.number<std::uint32_t>(); version != 2) {
    reader.fail("found glTF " + std::to_string(version) + "; allowed: 2");
  }
  reader.number<std::uint32_t>();  // the length of all: the chunks have their own
  constexpr std::uint32_t json_chunk = 0x4E4F534A;
  constexpr std::uint32_t binary_chunk = 0x004E4942;
  const auto json_length = reader.number<std::uint32_t>();
  if (reader.number<std::uint32_t>() != json_chunk) reader.fail("found no JSON chunk");
  root_ = parse_json(context_.file(), reader.read_bytes(json_length));
  if (bytes.size() - reader.position() < 8) return;
  const auto length = reader.number<std::uint32_t>();
  if (reader.number<std::uint32_t>() == binary_chunk) chunk_ = reader.read_bytes(length);
}

void GltfFile::check_version() {
  JsonObject top = root();
  JsonObject asset = top.object("asset");
  const std::string version = asset.text("version", {});
  if (!version.starts_with("2.")) {
    asset.fail("version", "found " + quoted_text(version) + "; allowed: 2.0");
  }
  check_extensions(top);
}

void GltfFile::check_extensions(JsonObject& root) {
  const auto is_in = [](const Json& name, const auto& names) {
    return name.is_string() && std::ranges::count(names, name.get_ref<const std::string&>()) > 0;
  };
  const Json::array_t& required = root.array("extensionsRequired", limits::keys);
  for (std::size_t i = 0; i < required.size(); ++i) {
    const std::string name = required[i].is_string() ? required[i].get<std::string>() : "";
    if (is_in(required[i], read_extensions) || is_optional(name)) continue;
    const JsonPath list = root.path_of("extensionsRequired");
    if (is_compression(name)) {
      context_.fail(list.element(i), "found meshes compressed by " + quoted_text(name) +
                                         "; allowed: others; export the scene again without " +
                                         compression_kind(name));
    }
    std::string names;
    for (const std::string_view known : read_extensions) (names += known) += ", ";
    context_.fail(list.element(i), "found " + quoted_json(required[i]) + "; allowed: " + names +
                                       "extensions of materials and textures");
  }
  for (const Json& used : root.array("extensionsUsed", limits::keys)) {
    if (is_in(used, read_extensions)) continue;
    context_.warn(root.path_of("extensionsUsed"), quoted_json(used) + " is left out");
  }
}

const Json::array_t& GltfFile::list(std::string_view key) {
  constexpr std::size_t longest = 1 << 20;
  return root().array(key, longest);
}

JsonObject GltfFile::object(std::string_view list, std::size_t index) {
  return {context_, this->list(list)[index], root_path_.member(list).element(index)};
}

std::optional<std::size_t> GltfFile::index(JsonObject& object, std::string_view key,
                                           std::string_view of) {
  if (object.find(key) == nullptr) return std::nullopt;
  const std::size_t count = list(of).size();
  if (count == 0) object.fail(key, "refers to " + std::string(of) + "; the file has none");
  return static_cast<std::size_t>(object.integer(key, 0, static_cast<std::int64_t>(count) - 1, 0));
}

GltfFile::Accessor GltfFile::accessor(std::size_t index, std::size_t components) {
  JsonObject object = this->object("accessors", index);
  Accessor result;
  result.type = object.integer("componentType", i8, f32, 0);
  if (object.find("componentType") == nullptr || result.type == 5124) {
    object.fail("componentType", "allowed: 5120, 5121, 5122, 5123, 5125, 5126");
  }
  result.components = components == 16
                          ? 16 + object.choice("type", {"MAT4"}, {})
                          : 1 + object.choice("type", {"SCALAR", "VEC2", "VEC3", "VEC4"}, {});
  static_cast<void>(object.required("count"));
  result.is_normalized = object.boolean("normalized", false);
  result.sparse = object.find("sparse");
  const std::size_t size = size_of(result.type) * result.components;
  const auto view = this->index(object, "bufferView", "bufferViews");
  result.count =
      static_cast<std::size_t>(object.integer("count", 1, view ? max_bytes : max_zeros, 1));
  if (!view) return result;
  result.bytes = buffer_view(*view);
  JsonObject of_view = this->object("bufferViews", *view);
  result.stride = of_view.find("byteStride")
                      ? static_cast<std::size_t>(of_view.integer("byteStride", 1, 252, 4))
                      : size;
  const auto offset = static_cast<std::size_t>(object.integer("byteOffset", 0, max_bytes, 0));
  const std::size_t needed = offset + result.stride * (result.count - 1) + size;
  if (needed > result.bytes.size()) {
    object.fail("count", "needs " + std::to_string(needed) + " bytes of a buffer view of " +
                             std::to_string(result.bytes.size()));
  }
  result.bytes.remove_prefix(offset);
  return result;
}

std::vector<float> GltfFile::read(const JsonPath& path, const Accessor& accessor) {
  std::vector<float> values(accessor.count * accessor.components, 0.0f);
  const std::size_t size = size_of(accessor.type);
  for (std::size_t i = 0; i < accessor.count && !accessor.bytes.empty(); ++i) {
    for (std::size_t k = 0; k < accessor.components; ++k) {
      const char* bytes = accessor.bytes.data() + i * accessor.stride + k * size;
      values[i * accessor.components + k] =
          static_cast<float>(value_of(accessor.type, bytes, accessor.is_normalized));
    }
  }
  if (accessor.sparse != nullptr) apply_sparse(path, *accessor.sparse, accessor, values);
  return values;
}

void GltfFile::apply_sparse(const JsonPath& path, const Json& sparse, const Accessor& accessor,
                            std::vector<float>& values) {
  JsonObject object(context_, sparse, path.member("sparse"));
  const auto count = static_cast<std::size_t>(
      object.integer("count", 0, static_cast<std::int64_t>(accessor.count), 0));
  const auto part = [&](const char* key, std::int64_t type, std::size_t components) {
    JsonObject part_object = object.object(key);
    static_cast<void>(part_object.required("bufferView"));
    Accessor result = accessor;
    result.type = type != 0 ? type : part_object.integer("componentType", u8, u32, u16);
    result.components = components;
    result.stride = size_of(result.type) * components;
    result.bytes = buffer_view(*index(part_object, "bufferView", "bufferViews"));
    const auto offset =
        static_cast<std::size_t>(part_object.integer("byteOffset", 0, max_bytes, 0));
    if (offset + count * result.stride > result.bytes.size()) {
      part_object.fail("byteOffset", "the buffer view ends before");
    }
    result.bytes.remove_prefix(offset);
    return result;
  };
  const Accessor indices = part("indices", 0, 1);
  const Accessor replaced = part("values", accessor.type, accessor.components);
  for (std::size_t i = 0; i < count; ++i) {
    const double vertex = value_of(indices.type, indices.bytes.data() + i * indices.stride, false);
    if (!(vertex >= 0.0 && vertex < static_cast<double>(accessor.count))) {
      object.fail("indices", "found " + quoted_text(vertex) + "; allowed: less than " +
                                 std::to_string(accessor.count));
    }
    for (std::size_t k = 0; k < accessor.components; ++k) {
      const char* bytes = replaced.bytes.data() + i * replaced.stride + k * size_of(replaced.type);
      values[static_cast<std::size_t>(vertex) * accessor.components + k] =
          static_cast<float>(value_of(replaced.type, bytes, accessor.is_normalized));
    }
  }
}

std::vector<float> GltfFile::numbers(const JsonPath& user, std::size_t index,
                                     std::size_t components) {
  const JsonPath path = root_path_.member("accessors").element(index);
  const Accessor found = accessor(index, components);
  if (found.components != components) {
    context_.fail(user, "refers to " + path.text() + ", which has " +
                            std::to_string(found.components) +
                            " components; allowed: " + std::to_string(components));
  }
  return read(path, found);
}

std::vector<glm::vec4> GltfFile::colors(const JsonPath& user, std::size_t index) {
  const JsonPath path = root_path_.member("accessors").element(index);
  const Accessor found = accessor(index);
  const bool is_color =
      found.type == f32 || (found.is_normalized && (found.type == u8 || found.type == u16));
  if (!is_color || found.components < 3) {
    context_.fail(user, "refers to " + path.text() +
                            "; allowed: one with 3 or 4 components, floats or normalized unsigned "
                            "integers of 8 or 16 bits");
  }
  const std::vector<float> numbers = read(path, found);
  std::vector<glm::vec4> colors(found.count, glm::vec4(1.0f));
  bool are_all_allowed = true;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const float value = numbers[i] > 0.0f ? std::min(numbers[i], 1.0f) : 0.0f;
    are_all_allowed = are_all_allowed && value == numbers[i];
    colors[i / found.components][static_cast<int>(i % found.components)] = value;
  }
  if (!are_all_allowed) context_.warn(user, "found colors outside [0, 1]; the nearest are taken");
  return colors;
}

std::size_t GltfFile::count(std::size_t index) {
  return accessor(index).count;
}

std::vector<std::uint32_t> GltfFile::indices(const JsonPath& user, std::size_t index) {
  const JsonPath path = root_path_.member("accessors").element(index);
  const Accessor found = accessor(index);
  const bool is_index = found.type == u8 || found.type == u16 || found.type == u32;
  if (!is_index || found.components != 1 || found.is_normalized || found.sparse != nullptr) {
    context_.fail(user, "refers to " + path.text() + "; allowed: one with unsigned integers");
  }
  std::vector<std::uint32_t> values(found.count, 0);
  for (std::size_t i = 0; i < found.count && !found.bytes.empty(); ++i) {
    values[i] = static_cast<std::uint32_t>(
        value_of(found.type, found.bytes.data() + i * found.stride, false));
  }
  return values;
}

std::string GltfFile::compression(const Json* extensions, std::size_t index) {
  // Mistakes are found where it is read.
  const auto referred = [this](const Json& object, const char* key, const char* of) -> const Json* {
    const auto reference = object.is_object() ? object.find(key) : object.end();
    if (reference == object.end() || !reference->is_number_unsigned()) return nullptr;
    const auto element = reference->get<std::size_t>();
    return element < list(of).size() ? &list(of)[element] : nullptr;
  };
  const Json& accessor = list("accessors")[index];
  if (accessor.contains("sparse")) return {};
  if (!accessor.contains("bufferView")) return compression_in(extensions);
  const Json* const view = referred(accessor, "bufferView", "bufferViews");
  const Json* const buffer = view ? referred(*view, "buffer", "buffers") : nullptr;
  if (buffer == nullptr || buffer->contains("uri")) return {};
  const bool is_chunk = chunk_ && buffer == &list("buffers")[0];
  return is_chunk || !view->contains("extensions") ? "" : compression_in(&(*view)["extensions"]);
}

std::string_view GltfFile::buffer_view(std::size_t view) {
  JsonObject object = this->object("bufferViews", view);
  static_cast<void>(object.required("buffer"));
  const std::string_view bytes = buffer(*index(object, "buffer", "buffers"));
  const auto offset = static_cast<std::size_t>(object.integer("byteOffset", 0, max_bytes, 0));
  static_cast<void>(object.required("byteLength"));
  const auto length = static_cast<std::size_t>(object.integer("byteLength", 1, max_bytes, 1));
  if (offset + length > bytes.size()) {
    object.fail("byteLength", "ends at byte " + std::to_string(offset + length) +
                                  " of a buffer of " + std::to_string(bytes.size()) + " bytes");
  }
  return bytes.substr(offset, length);
}

std::string_view GltfFile::buffer(std::size_t index) {
  buffers_.resize(list("buffers").size());
  std::optional<std::string>& bytes = buffers_[index];
  if (bytes) return *bytes;
  JsonObject object = this->object("buffers", index);
  if (object.find("uri") == nullptr) {
    if (index > 0) object.fail("uri", "missing");
    bytes = std::move(chunk_).value_or("");
    return *bytes;
  }
  const JsonPath uri = object.path_of("uri");
  Resource found = resource(object.text("uri", {}));
  if (!found.refusal.empty()) context_.fail(uri, found.refusal);
  if (!found.is_embedded) {
    try {
      found.bytes = read_bytes(found.file);
    } catch (const InputError& error) {
      context_.fail(uri, error.what());
    }
    files_.push_back(found.file);
  }
  bytes = std::move(found.bytes);
  return *bytes;
}

GltfFile::Resource GltfFile::resource(const std::string& uri) const {
  if (uri.starts_with("data:")) {
    auto bytes = decoded_data_uri(uri);
    if (bytes) return {context_.file(), std::move(*bytes), true};
    return {.refusal = "found " + quoted_text(uri, 40) + "; allowed: base64 data"};
  }
  const std::optional<std::string> name = decoded_relative_uri(uri);
  if (!name) {
    return {.refusal = "found " + quoted_text(uri, 80) + "; allowed: a relative path, or data"};
  }
  const auto place = [this](const std::string& text) {
    return find_file_named_alike((context_.file().parent_path() / text).lexically_normal());
  };
  std::error_code error;
  const fs::path decoded = place(*name);
  const fs::path literal = place(uri);  // as programs write it that encode nothing
  return {fs::exists(literal, error) && !fs::exists(decoded, error) ? literal : decoded};
}

}  // namespace brume
