// Files of splats that are broken, in every way there is: each is refused by one error that names
// the file, and none crashes, hangs or takes memory.

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <functional>
#include <limits>

#include "brume/error.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/scene/json_reader.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/gaussians/splat_gltf_builder.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

class MalformedSplats : public FolderTest {
 protected:
  void expect_refused(const std::string& what, const char* name, const std::string& bytes) {
    SCOPED_TRACE(what);
    ++count_;
    const auto file = folder_.write(name, bytes);
    const std::string error = error_of([&] { read_gaussians(file); });
    EXPECT_TRUE(contains(error, file.string() + ":"));
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    EXPECT_LT(error.size(), file.string().size() + 400) << error;
    try {  // it may be right as far as this looks
      EXPECT_LE(max_gaussian_count(file), std::size_t{1} << 62);
    } catch (const InputError&) {
    }
  }
  void expect_refused_glb(const std::string& what,
                          const std::function<void(SplatGltfBuilder&)>& break_it) {
    SplatGltfBuilder builder;
    break_it(builder);
    expect_refused(what, "a.glb", builder.binary());
  }

  int count_ = 0;
};

constexpr std::array required_attributes{"POSITION", "KHR_gaussian_splatting:ROTATION",
                                         "KHR_gaussian_splatting:SCALE",
                                         "KHR_gaussian_splatting:OPACITY"};

TEST_F(MalformedSplats, GlbWithBrokenAccessors) {
  const Json huge = 1e18;
  const std::pair<const char*, Json> values[] = {{"bufferView", 99},
                                                 {"bufferView", -1},
                                                 {"bufferView", "0"},
                                                 {"count", 0},
                                                 {"count", -2},
                                                 {"count", 1},
                                                 {"count", 1'000'000},
                                                 {"count", 4'000'000'000u},
                                                 {"count", huge},
                                                 {"count", "two"},
                                                 {"componentType", 0},
                                                 {"componentType", 5124},
                                                 {"componentType", 1e9},
                                                 {"type", "MAT4"},
                                                 {"type", "VEC2"},
                                                 {"type", 3},
                                                 {"byteOffset", 1'000'000},
                                                 {"byteOffset", -4},
                                                 {"byteOffset", huge},
                                                 {"sparse", {{"count", 99}}},
                                                 {"sparse", 7}};
  for (const char* attribute : required_attributes) {
    for (const auto& [key, value] : values) {
      expect_refused_glb(std::string(attribute) + "." + key + " = " + value.dump(),
                         [&, key = key, value = value](SplatGltfBuilder& b) {
                           b.accessor_of(attribute)[key] = value;
                         });
    }
    for (const Json& index : {Json(99), Json(-1), Json("0"), Json(0.5), Json(nullptr)}) {
      expect_refused_glb(std::string(attribute) + " = " + index.dump(),
                         [&](SplatGltfBuilder& b) { b.attributes()[attribute] = index; });
    }
    expect_refused_glb(std::string("no ") + attribute,
                       [&](SplatGltfBuilder& b) { b.attributes().erase(attribute); });
  }
  EXPECT_EQ(count_, 4 * 27);
}

TEST_F(MalformedSplats, GlbWithNumbersThatNoSplatHas) {
  const auto with = [&](const char* attribute, const char* type, std::vector<float> numbers,
                        std::size_t place, float number) {
    numbers[place] = number;
    expect_refused_glb(
        std::string(attribute) + " of " + std::to_string(number),
        [&](SplatGltfBuilder& b) { b.attributes()[attribute] = b.add(numbers, type); });
  };
  for (const float bad : {nan_value, infinite, -infinite, 1e13f, -3e38f}) {
    for (std::size_t place = 0; place < 6; place += 2) {
      with("POSITION", "VEC3", std::vector<float>(6, 1.0f), place, bad);
    }
  }
  for (const float bad : {nan_value, infinite, -infinite, 1e13f, -1e-3f}) {
    for (std::size_t place = 0; place < 6; ++place) {
      with("KHR_gaussian_splatting:SCALE", "VEC3", std::vector<float>(6, 1.0f), place, bad);
    }
  }
  with("KHR_gaussian_splatting:SCALE", "VEC3", std::vector<float>(6, 0.0f), 0, 0.0f);
  with("KHR_gaussian_splatting:SCALE", "VEC3", std::vector<float>(6, 1e-13f), 0, 1e-13f);
  for (const float bad : {nan_value, infinite, -infinite, -0.01f, 1.01f}) {
    with("KHR_gaussian_splatting:OPACITY", "SCALAR", {0.5f, 0.5f}, 1, bad);
  }
  EXPECT_EQ(count_, 15 + 30 + 2 + 5);
}

TEST_F(MalformedSplats, GlbWithABrokenTree) {
  expect_refused_glb("kernel", [](auto& b) { b.extension()["kernel"] = "disc"; });
  expect_refused_glb("kernel of another type", [](auto& b) { b.extension()["kernel"] = 3; });
  expect_refused_glb("extension that is a list", [](auto& b) { b.extension() = Json::array(); });
  expect_refused_glb("extensions that are text",
                     [](auto& b) { b.primitive()["extensions"] = "x"; });
  expect_refused_glb("compressed", [](auto& b) {
    b.extension()["extensions"]["KHR_gaussian_splatting_compression_spz_2"]["bufferView"] = 0;
  });
  expect_refused_glb("triangles", [](auto& b) { b.primitive()["mode"] = 4; });
  expect_refused_glb("no mode", [](auto& b) { b.primitive().erase("mode"); });
  expect_refused_glb("a mode of text", [](auto& b) { b.primitive()["mode"] = "points"; });
  expect_refused_glb("no attributes", [](auto& b) { b.primitive().erase("attributes"); });
  expect_refused_glb("attributes that are a list",
                     [](auto& b) { b.primitive()["attributes"] = Json::array(); });
  expect_refused_glb("primitives that are no list",
                     [](auto& b) { b.json["meshes"][0]["primitives"] = 1; });
  expect_refused_glb("a mesh that is a number", [](auto& b) { b.json["meshes"][0] = 1; });
  expect_refused_glb("meshes that are text", [](auto& b) { b.json["meshes"] = "x"; });
  expect_refused_glb("no splats and no extension", [](auto& b) {
    b.primitive().erase("extensions");
    b.json.erase("extensionsUsed");
  });
  expect_refused_glb("no meshes", [](auto& b) {
    b.json.erase("meshes");
    b.json["nodes"][0].erase("mesh");
    b.json.erase("extensionsUsed");
  });
  expect_refused_glb("a node without its mesh", [](auto& b) { b.json["nodes"][0]["mesh"] = 1; });
  expect_refused_glb("a node that is its own child",
                     [](auto& b) { b.json["nodes"][0]["children"] = {0}; });
  expect_refused_glb("a child that is none", [](auto& b) { b.json["nodes"][0]["children"] = {7}; });
  expect_refused_glb("a scene without its node",
                     [](auto& b) { b.json["scenes"][0]["nodes"] = {1}; });
  expect_refused_glb("a scene that is none", [](auto& b) { b.json["scene"] = 5; });
  expect_refused_glb("a node of size 0", [](auto& b) { b.json["nodes"][0]["scale"] = {0, 0, 0}; });
  expect_refused_glb("a node beyond coordinates", [](auto& b) {
    b.json["nodes"][0]["scale"] = {1e13, 1, 1};
  });
  expect_refused_glb("a node far away", [](auto& b) {
    b.json["nodes"][0]["translation"] = {1e12, 1e13, 0};
  });
  expect_refused_glb("a matrix of 15",
                     [](auto& b) { b.json["nodes"][0]["matrix"] = std::vector<int>(15, 1); });
  expect_refused_glb("a matrix of zeros",
                     [](auto& b) { b.json["nodes"][0]["matrix"] = std::vector<int>(16, 0); });
  expect_refused_glb("a rotation of 0", [](auto& b) {
    b.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
  });
  expect_refused_glb("a view without its buffer",
                     [](auto& b) { b.json["bufferViews"][4]["buffer"] = 1; });
  expect_refused_glb("a view beyond its buffer",
                     [](auto& b) { b.json["bufferViews"][4]["byteLength"] = 9999; });
  expect_refused_glb("a view of length 0",
                     [](auto& b) { b.json["bufferViews"][4]["byteLength"] = 0; });
  expect_refused_glb("a view that starts behind",
                     [](auto& b) { b.json["bufferViews"][4]["byteOffset"] = 9999; });
  expect_refused_glb("no views", [](auto& b) { b.json.erase("bufferViews"); });
  expect_refused_glb("no accessors", [](auto& b) { b.json.erase("accessors"); });
  expect_refused_glb("glTF 1", [](auto& b) { b.json["asset"]["version"] = "1.0"; });
  expect_refused_glb("no asset", [](auto& b) { b.json.erase("asset"); });
  expect_refused_glb("something required",
                     [](auto& b) { b.json["extensionsRequired"] = {"EXT_x"}; });

  const SplatGltfBuilder builder;
  for (const char* uri : {"none.bin", "http://x/y.bin", "data:;base64,!!!!", "data:x", ""}) {
    expect_refused(uri, "a.gltf", builder.text(uri));
  }
  expect_refused("JSON alone", "a.gltf", "{}");
  expect_refused("JSON that ends early", "a.gltf", "{\"asset\":");
  EXPECT_EQ(count_, 42);
}

// More than any scene may have, by nodes that share a mesh, or by an accessor without a buffer.
TEST_F(MalformedSplats, GlbWithMoreThanAllowed) {
  SplatGltfBuilder builder;
  Json accessor = builder.accessor_of("POSITION");
  for (const char* attribute : required_attributes) {
    builder.accessor_of(attribute).erase("bufferView");
    builder.accessor_of(attribute)["count"] = 1'000'000;
  }
  builder.json["nodes"] = std::vector<Json>(11, {{"mesh", 0}});
  std::vector<int> nodes;
  for (int i = 0; i < 11; ++i) nodes.push_back(i);
  builder.json["scenes"][0]["nodes"] = nodes;
  const auto file = folder_.write("a.glb", builder.binary());
  expect_error([&] { read_gaussians(file); }, "found 11000000 splats; allowed: at most 10000000");
  EXPECT_EQ(max_gaussian_count(file), 11'000'000u);
  const auto two = folder_.write("b.glb", SplatGltfBuilder().binary());
  expect_error([&] { read_gaussians(two, nullptr, 1); }, "found 2 splats");
}

TEST_F(MalformedSplats, GlbThatIsCutOrChanged) {
  const std::string whole = SplatGltfBuilder().binary();
  for (std::size_t size = 0; size < whole.size(); size += 23) {
    expect_refused(std::to_string(size) + " bytes", "a.glb", whole.substr(0, size));
  }
  EXPECT_GT(count_, 40);
  const std::pair<std::size_t, std::uint32_t> numbers[] = {
      {4, 1}, {4, 3}, {12, 0}, {12, 0xffffffff}, {12, 7}, {16, 0}, {16, 0x004E4942}};
  for (const auto& [place, number] : numbers) {
    std::string changed = whole;
    std::memcpy(changed.data() + place, &number, sizeof number);
    expect_refused(std::to_string(number) + " at " + std::to_string(place), "a.glb", changed);
  }
}

class MalformedSplatPly : public MalformedSplats {
 protected:
  static constexpr std::array properties{"x",       "y",       "z",       "opacity",
                                         "scale_0", "scale_1", "scale_2", "rot_0",
                                         "rot_1",   "rot_2",   "rot_3"};

  static std::string header(const std::string& count = "2") {
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " + count + "\n";
    for (const char* property : properties) {
      text += "property float " + std::string(property) + "\n";
    }
    return text + "end_header\n";
  }
  static std::string rows(std::array<float, 22> values = good) {
    return {reinterpret_cast<const char*>(values.data()), sizeof values};
  }
  static constexpr std::array<float, 22> good{1, 2, 3, 0, -1, -2, -1, 1, 0, 0, 0,
                                              0, 1, 0, 1, -1, -1, -1, 0, 1, 0, 0};
};

TEST_F(MalformedSplatPly, Truncated) {
  const std::string whole = header() + rows();
  ASSERT_EQ(read_gaussians(folder_.write("a.ply", whole)).size(), 2u);
  for (std::size_t size = 0; size < whole.size(); size += 5) {
    expect_refused(std::to_string(size) + " bytes", "a.ply", whole.substr(0, size));
  }
  EXPECT_GT(count_, 60);
}

TEST_F(MalformedSplatPly, Header) {
  const std::string whole = header() + rows();
  const auto replaced = [&](const std::string& what, const std::string& other) {
    std::string text = whole;
    text.replace(text.find(what), what.size(), other);
    expect_refused(what + " -> " + other, "a.ply", text);
  };
  for (const char* property : {"x", "y", "z", "opacity", "scale_0"}) {
    const std::string line = std::string("property float ") + property + "\n";
    replaced(line, "");
    replaced(line, std::string("property quad ") + property + "\n");
    replaced(line, std::string("property list uchar float ") + property + "\n");
    replaced(line, std::string("property float no_") + property + "\n");
    replaced(line, std::string("property double ") + property + "\n");
  }
  for (const char* count : {"-1", "3", "1000000", "10000001", "4000000000", "18446744073709551615",
                            "99999999999999999999999", "1.5", "nan", "x", ""}) {
    replaced("vertex 2", std::string("vertex ") + count);
  }
  replaced("vertex", "point");
  replaced("format binary_little_endian 1.0\n", "");
  replaced("binary_little_endian", "ebcdic");
  replaced("end_header", "end");
  replaced("property float x\n", "property\n");
  replaced("property float x\n", "property float\n");
  replaced("property float x\n", "what is this\n");
  replaced("element vertex 2\n", "");
  EXPECT_EQ(count_, 25 + 11 + 8);
}

TEST_F(MalformedSplatPly, Numbers) {
  const auto with = [&](std::size_t place, float number) {
    std::array<float, 22> values = good;
    values[place] = number;
    expect_refused(std::string(properties[place % 11]) + " = " + std::to_string(number), "a.ply",
                   header() + rows(values));
  };
  for (const std::size_t vertex : {0u, 11u}) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const float bad : {nan_value, infinite, -infinite, 1e13f}) with(vertex + k, bad);
    }
    for (const float bad : {nan_value, infinite, 1e30f}) with(vertex + 3, bad);
    for (std::size_t k = 4; k < 7; ++k) {
      for (const float bad : {nan_value, infinite, 60.0f, 1e30f}) with(vertex + k, bad);
    }
  }
  EXPECT_EQ(count_, 2 * (12 + 3 + 12));
}

}  // namespace
}  // namespace brume
