#include <glm/common.hpp>
#include <glm/ext/vector_double1.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "core/io/byte_reader.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/splat_gltf.h"
#include "core/io/import/uri.h"
#include "core/medium/splat.h"

namespace brume {
namespace {

using OrderedJson = nlohmann::ordered_json;

// The attributes one after the other, each in a buffer view of its own.
class GltfSplatWriter {
 public:
  GltfSplatWriter(std::span<const Gaussian> gaussians, const SplatOutput& output)
      : gaussians_(gaussians) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "Brume"}};
    json_["extensionsUsed"] = {"KHR_gaussian_splatting"};
    json_["scene"] = 0;
    if (gaussians.empty()) {  // lists of glTF are not empty
      json_["scenes"] = {{{"name", "Fog"}}};
      return;
    }
    json_["scenes"] = {{{"nodes", {0}}}};
    json_["nodes"] = {{{"name", "Fog"}, {"mesh", 0}}};
    OrderedJson& primitive = json_["meshes"][0]["primitives"][0];
    primitive["mode"] = 0;
    OrderedJson& attributes = primitive["attributes"];
    attributes["POSITION"] = add<3>([](const Gaussian& g) { return g.center; });
    add_bounds();
    attributes["KHR_gaussian_splatting:ROTATION"] = add<4>([](const Gaussian& g) {
      const glm::dquat& q = g.shape.rotation;
      return glm::dvec4(q.x, q.y, q.z, q.w);
    });
    attributes["KHR_gaussian_splatting:SCALE"] =
        add<3>([](const Gaussian& g) { return splat_of(g).deviations; });
    attributes["KHR_gaussian_splatting:OPACITY"] = add<1>([&](const Gaussian& g) {
      return glm::dvec1(opacity_of_depth(depth_along(g, output.along)));
    });
    attributes["KHR_gaussian_splatting:SH_DEGREE_0_COEF_0"] =
        add<3>([&](const Gaussian& g) { return sh_color(g, output); });
    primitive["extensions"]["KHR_gaussian_splatting"] = {{"kernel", "ellipse"},
                                                         {"colorSpace", "srgb_rec709_display"},
                                                         {"projection", "perspective"},
                                                         {"sortingMethod", "cameraDistance"}};
  }

  // A .gltf.
  [[nodiscard]] std::string text() {
    if (!buffer_.empty()) add_buffer()["uri"] = encoded_data_uri(buffer_);
    return json_.dump(1) + "\n";
  }

  // A .glb: a header, and chunks whose lengths are multiples of four.
  [[nodiscard]] std::string binary() {
    if (!buffer_.empty()) add_buffer();
    std::string text = json_.dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string bytes = "glTF";
    const auto append = [&bytes](std::size_t value) {
      append_little_endian(bytes, static_cast<std::uint32_t>(value));
    };
    const std::size_t chunk = buffer_.empty() ? 0 : 8 + buffer_.size();
    append(2);
    append(12 + 8 + text.size() + chunk);
    append(text.size());
    bytes += "JSON" + text;
    if (buffer_.empty()) return bytes;
    append(buffer_.size());
    return bytes + std::string("BIN\0", 4) + buffer_;
  }

 private:
  OrderedJson& add_buffer() {
    OrderedJson& buffer = json_["buffers"][0];
    buffer["byteLength"] = buffer_.size();
    return buffer;
  }

  // The index of the accessor.
  template <int size, class ValueOf>
  std::size_t add(ValueOf value_of) {
    static constexpr const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    const std::size_t offset = buffer_.size();
    for (const Gaussian& g : gaussians_) {
      const auto value = value_of(g);
      for (int k = 0; k < size; ++k) append_little_endian(buffer_, static_cast<float>(value[k]));
    }
    constexpr int array_buffer = 34962;
    constexpr int floats = 5126;
    const std::size_t view = json_["bufferViews"].size();
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", offset},
                                    {"byteLength", buffer_.size() - offset},
                                    {"target", array_buffer}});
    json_["accessors"].push_back({{"bufferView", view},
                                  {"componentType", floats},
                                  {"count", gaussians_.size()},
                                  {"type", types[size - 1]}});
    return view;
  }

  // The bounds of the positions, as glTF asks for.
  void add_bounds() {
    glm::vec3 low(gaussians_.front().center);
    glm::vec3 high = low;
    for (const Gaussian& g : gaussians_) {
      low = glm::min(low, glm::vec3(g.center));
      high = glm::max(high, glm::vec3(g.center));
    }
    OrderedJson& accessor = json_["accessors"].back();
    accessor["min"] = {low.x, low.y, low.z};
    accessor["max"] = {high.x, high.y, high.z};
  }

  std::span<const Gaussian> gaussians_;
  OrderedJson json_;
  std::string buffer_;
};

}  // namespace

void write_splats_gltf(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                       const SplatOutput& output) {
  GltfSplatWriter writer(gaussians, output);
  write_atomically(file, lower_case_extension(file) == ".glb" ? writer.binary() : writer.text());
}

}  // namespace brume
