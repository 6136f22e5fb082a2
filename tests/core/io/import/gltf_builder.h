#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/io/import/imported_scene_file.h"
#include "core/scene/imported_scene.h"
#include "tests/core/io/folder_test.h"

namespace brume {

// Makes small glTF files: a scene of one node with a square, to change and to add to.
class GltfBuilder {
 public:
  using Json = nlohmann::ordered_json;

  Json json;

  // The square from (0, 0, 0) to (1, 1, 0), facing +z; (u, v) of its corners as glTF has them.
  GltfBuilder() {
    json["asset"]["version"] = "2.0";
    json["scene"] = 0;
    json["scenes"] = {{{"nodes", {0}}}};
    json["nodes"] = {{{"name", "square"}, {"mesh", 0}}};
    const std::size_t points = add({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
    const std::size_t normals = add({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const std::size_t texcoords = add({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
    const std::size_t indices = add_integers<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
    json["meshes"] = {
        {{"primitives",
          {{{"attributes", {{"POSITION", points}, {"NORMAL", normals}, {"TEXCOORD_0", texcoords}}},
            {"indices", indices}}}}}};
  }

  Json& primitive() { return json["meshes"][0]["primitives"][0]; }

  // Add an accessor and return its index.
  std::size_t add(const std::vector<float>& numbers, const char* type) {
    return add(numbers.data(), numbers.size(), 5126, type);
  }
  template <class Integer>
  std::size_t add_integers(const std::vector<Integer>& numbers, const char* type) {
    const int component = sizeof(Integer) == 1 ? 5121 : sizeof(Integer) == 2 ? 5123 : 5125;
    return add(numbers.data(), numbers.size(), component, type);
  }
  // Adds a buffer view and returns its index.
  std::size_t add_view(const void* data, std::size_t bytes) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes}});
    buffer_.append(static_cast<const char*>(data), bytes);
    return json["bufferViews"].size() - 1;
  }

  // A .glb.
  [[nodiscard]] std::string binary() const {
    Json root = json;
    root["buffers"] = {{{"byteLength", buffer_.size()}}};
    std::string text = root.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string chunk = buffer_;
    chunk.resize((chunk.size() + 3) / 4 * 4);
    std::string bytes = "glTF" + number(2) + number(28 + text.size() + chunk.size());
    bytes += number(text.size()) + "JSON" + text;
    return bytes + number(chunk.size()) + std::string("BIN\0", 4) + chunk;
  }
  // A .gltf whose buffer is the file `name`, with buffer() as content.
  [[nodiscard]] std::string text(const char* name) const {
    Json root = json;
    root["buffers"] = {{{"byteLength", buffer_.size()}, {"uri", name}}};
    return root.dump();
  }
  [[nodiscard]] const std::string& buffer() const { return buffer_; }

 private:
  static std::string number(std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    return {reinterpret_cast<const char*>(&number), sizeof number};
  }

  template <class Number>
  std::size_t add(const Number* numbers, std::size_t count, int component, const char* type) {
    const std::size_t components = type[0] == 'S' ? 1 : static_cast<std::size_t>(type[3] - '0');
    json["accessors"].push_back({{"bufferView", add_view(numbers, count * sizeof(Number))},
                                 {"componentType", component},
                                 {"count", count / components},
                                 {"type", type}});
    return json["accessors"].size() - 1;
  }

  std::string buffer_;
};

// A test that reads such files.
class GltfTest : public FolderTest {
 protected:
  std::shared_ptr<const ImportedScene> read(const GltfBuilder& builder) {
    warnings_.clear();
    return read_imported_scene(folder_.write("scene.glb", builder.binary()), warnings_);
  }
  MeshArrays mesh_of(const GltfBuilder& builder) {
    return to_arrays(*read(builder)->parts.at(0).mesh);
  }

  GltfBuilder builder_;
  std::vector<std::string> warnings_;
};

}  // namespace brume
