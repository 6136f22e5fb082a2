#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/scene/json_reader.h"

namespace brume {

// The kind of compression that an extension means, to be left out when the file is exported again.
std::string compression_kind(std::string_view extension);

// A glTF 2.0 file (.gltf or .glb) with its buffers: what its JSON refers to, each index, offset and
// count checked. Throws InputError naming the JSON path.
class GltfFile {
 public:
  // Warnings are collected in `warnings`.
  GltfFile(const std::filesystem::path& file, std::vector<std::string>& warnings);
  GltfFile(const GltfFile&) = delete;
  GltfFile& operator=(const GltfFile&) = delete;

  [[nodiscard]] JsonContext& context() { return context_; }
  [[nodiscard]] const JsonPath& path() const { return root_path_; }
  [[nodiscard]] JsonObject root() { return {context_, root_, root_path_}; }

  // The elements of a list at the top, such as `nodes`; empty if missing.
  [[nodiscard]] const Json::array_t& list(std::string_view key);
  // One of them.
  [[nodiscard]] JsonObject object(std::string_view list, std::size_t index);
  // The member `key` of an object, an index into the list `of`; nullopt if missing.
  std::optional<std::size_t> index(JsonObject& object, std::string_view key, std::string_view of);

  // The numbers of an accessor of `components` components (16: matrices), one element after the
  // other; integers that are normalized, and only those, become fractions. `user`: what refers to
  // it.
  std::vector<float> numbers(const JsonPath& user, std::size_t accessor, std::size_t components);
  // Linear colors in [0, 1]; others are taken as the nearest, with a warning.
  std::vector<glm::vec4> colors(const JsonPath& user, std::size_t accessor);
  // The number of elements of an accessor, all of them in its buffer view, if it has one.
  std::size_t count(std::size_t accessor);
  std::vector<std::uint32_t> indices(const JsonPath& user, std::size_t accessor);
  // The extension that compresses an accessor's numbers if they are in no buffer besides; else
  // empty. `extensions`: of the object that refers to it; null if it has none.
  std::string compression(const Json* extensions, std::size_t accessor);

  // Valid as long as this is.
  std::string_view buffer_view(std::size_t view);

  // A reference of the file: bytes of its own ("data:..."), or else a file, which need not exist.
  struct Resource {
    std::filesystem::path file{};
    std::string bytes{};
    bool is_embedded = false;
    std::string refusal{};  // not empty: it is neither, and why
  };
  [[nodiscard]] Resource resource(const std::string& uri) const;

  // The file itself and its buffers.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  struct Accessor;

  void read_binary(std::string_view bytes);
  void check_version();
  void check_extensions(JsonObject& root);
  Accessor accessor(std::size_t index, std::size_t components = 1);
  std::vector<float> read(const JsonPath& path, const Accessor& accessor);
  void apply_sparse(const JsonPath& path, const Json& sparse, const Accessor& accessor,
                    std::vector<float>& values);
  std::string_view buffer(std::size_t index);

  JsonContext context_;
  JsonPath root_path_;
  Json root_;
  std::optional<std::string> chunk_;                 // of a .glb; the first buffer
  std::vector<std::optional<std::string>> buffers_;  // as far as read
  std::vector<std::filesystem::path> files_;
};

}  // namespace brume
