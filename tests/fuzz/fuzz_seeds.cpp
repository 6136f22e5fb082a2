// Writes small valid files for the fuzzers to begin with: FOLDER/PARSER/NAME.

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "brume/medium.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/image/image_file.h"
#include "core/io/volume/volume_file.h"
#include "core/volume/medium_grid.h"
#include "tests/core/io/gaussians/splat_gltf_builder.h"
#include "tests/core/io/import/gltf_builder.h"
#include "tests/core/io/import/small_raw_scene.h"

namespace brume {
namespace {

constexpr std::string_view scene = R"({ "format": "brume-scene", "version": 1,
  "camera": { "eye": [0, 0.5, 6], "target": [0, 0, 0], "up": [0, 1, 0], "vertical_fov": 40.0 },
  "cameras": [ { "name": "B", "eye": [1, 0, 0], "keys": { "eye": [ { "time": 1, "value": [2, 0, 0] } ] } } ],
  "film": { "width": 80, "height": 60 },
  "output": { "file": "a/b.exr", "paths": 64, "exposure": 0.5, "layers": ["Z", "airlight"] },
  "timeline": { "first": 1, "last": 9, "loop": false, "frames_per_second": 24 },
  "medium": { "density": 0.01, "albedo": [1, 0.9, 0.8], "anisotropy": 0.3,
    "noise": { "amplitude": 0.1, "frequency": 2, "velocity": [0, 1, 0], "seed": 3 },
    "emitters": [ { "position": [0, 0, 0], "rate": 10, "albedo": [1, 0.5, 1], "emission": [4, 1, 0],
      "emission_at_death": [1, 0, 0], "keys": { "radius": [ { "time": 1, "value": [0.1, 0.5] } ] } } ],
    "groups": [ { "name": "a", "parent": "b", "albedo_factor": [1, 0.5, 1], "keys": {
      "density_factor": [ { "time": 0, "value": 2 } ] } }, { "name": "b", "visible": false } ],
    "gaussians": [ { "center": [0, 0, 0], "radius": 0.35, "density": 1.25, "group": "a" } ] },
  "lights": [ { "type": "point", "position": [2.5, 2, 1.5], "intensity": [60, 60, 60] } ],
  "surfaces": [ { "mesh": "none.obj", "translate": [0, 0, 0], "rotate": [1, 0, 0, 0], "scale": 1.0,
    "material": { "type": "phong", "reflectance": [0.5, 0.5, 0.5], "exponent": 8 } } ] })";

constexpr std::string_view obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 .5\nvn 0 0 1\nvt 0 0\nf 1//1 2//1 3//1\nf -4 -2/1 -1/1/1\n";
constexpr std::string_view off =
    "NOFF\n4 2 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n"
    "3 0 1 2\n4 0 1 2 3\n";
constexpr std::string_view stl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid a\n";
constexpr std::string_view mesh =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
constexpr std::string_view points =
    "ply\nformat ascii 1.0\ncomment points\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nproperty double radius\nproperty double density\nend_header\n"
    "1 2 3 .5 1e-2\n-1 +2 0 4 5\n";
constexpr std::string_view splats =
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
    "property float z\nproperty float opacity\nproperty float scale_0\nproperty float scale_1\n"
    "property float scale_2\nproperty float rot_0\nproperty float rot_1\nproperty float rot_2\n"
    "property float rot_3\nend_header\n1 2 3 .5 -1 -2 -3 1 0 .5 0\n";

constexpr std::string_view ies =
    "IESNA:LM-63-2002\n[TEST] seed\nTILT=INCLUDE\n1\n2\n0 90\n1 .9\n"
    "1 -1 1.5 3 4 1 2 0 0 0\n1 1 60\n0 45 90\n0 30,60,90\n10 5 0\n8 4 0\n6 3 0\n4 2 0\n";

void write(const std::filesystem::path& file, std::string_view content) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
}

// Materials, textures, transforms, cameras and lights, and accessors of all kinds.
std::string gltf_scene() {
  GltfBuilder builder;
  const std::string pixel = encode_png(1, 1, std::vector<std::uint8_t>{255, 128, 0});
  builder.json["images"] = {{{"bufferView", builder.add_view(pixel.data(), pixel.size())}},
                            {{"uri", "none.png"}}};
  builder.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
  builder.json["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}};
  builder.json["materials"] = {
      {{"pbrMetallicRoughness",
        {{"baseColorFactor", {0.1, 0.2, 0.3, 1.0}},
         {"metallicFactor", 0.5},
         {"roughnessFactor", 0.5},
         {"baseColorTexture",
          {{"index", 0},
           {"extensions",
            {{"KHR_texture_transform",
              {{"offset", {0.5, 0.25}}, {"rotation", 1.0}, {"scale", {2, 3}}}}}}}}}},
       {"normalTexture", {{"index", 1}, {"scale", 0.75}}},
       {"emissiveFactor", {1.0, 0.5, 0.0}},
       {"alphaMode", "MASK"}}};
  builder.primitive()["material"] = 0;
  const std::uint8_t index = 2;
  const std::array<float, 3> point{1, 1, 5};
  builder.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", builder.add_view(&index, 1)}, {"componentType", 5121}}},
      {"values", {{"bufferView", builder.add_view(point.data(), sizeof point)}}}};
  const std::size_t joints =
      builder.add_integers<std::uint8_t>(std::vector<std::uint8_t>(16), "VEC4");
  builder.primitive()["attributes"]["JOINTS_0"] = joints;
  builder.primitive()["attributes"]["WEIGHTS_0"] = joints;
  builder.json["skins"] = {{{"joints", {1, 2}}}};
  builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"intensity", 5}, {"spot", {{"innerConeAngle", 0.1}}}},
      {{"type", "directional"}, {"color", {1, 0.5, 0}}}};
  builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}}}}};
  builder.json["nodes"] = {
      {{"name", "a"}, {"mesh", 0}, {"skin", 0}, {"children", {1, 2}}, {"scale", {-1, 2, 1}}},
      {{"camera", 0}, {"rotation", {0, 0.6, 0, 0.8}}, {"translation", {1, 2, 3}}},
      {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
       {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1}}}};
  return builder.binary();
}

// Two nodes with the same splats, of integers.
std::string gltf_splats() {
  SplatGltfBuilder builder;
  builder.set("OPACITY", builder.add_normalized<std::uint8_t>({51, 255}, "SCALAR"));
  builder.set("SCALE", builder.add_integers<std::uint8_t>({1, 2, 3, 4, 4, 4}, "VEC3"));
  builder.json["nodes"] = {
      {{"children", {1, 2}}, {"rotation", {0, 0.6, 0, 0.8}}, {"scale", {2, 2, 2}}},
      {{"mesh", 0}},
      {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, -3, 0, 0, 0, 1, 1, 0, 0, 0, 5, 1}}}};
  return builder.binary();
}

void write_seeds(const std::filesystem::path& folder) {
  for (const char* parser :
       {"gaussian_ply", "gaussian_csv", "splat_ply", "splat_gltf", "exr", "vdb"}) {
    std::filesystem::create_directories(folder / parser);
  }
  write(folder / "scene/all.brume", scene);
  write(folder / "obj/quad.obj", obj);
  write(folder / "off/quad.off", off);
  write(folder / "stl/text.stl", stl);
  std::string binary = std::string(80, ' ') + std::string("\2\0\0\0", 4);
  binary += std::string(2 * 50, '\1');
  write(folder / "stl/binary.stl", binary);
  write(folder / "mesh_ply/text.ply", mesh);
  write(folder / "gaussian_ply/text.ply", points);
  write(folder / "gaussian_ply/splats.ply", splats);
  write(folder / "splat_ply/text.ply", splats);
  const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n-Y 1 +X 8\n";
  write(folder / "hdr/flat.hdr", hdr + std::string(8 * 4, '\x80'));
  write(folder / "hdr/runs.hdr", hdr + std::string("\2\2\0\10\210\12\210\13\210\14\210\210", 12));
  const std::string tga("\0\0\12\0\0\0\0\0\0\0\0\0\4\0\2\0\30\0", 18);
  write(folder / "tga/runs.tga", tga + "\203abc\3abcdefghijkl");
  const std::string bmp("BM\0\0\0\0\0\0\0\0\76\0\0\0\50\0\0\0\4\0\0\0\2\0\0\0\1\0\10\0\1\0\0\0",
                        34);
  write(folder / "bmp/runs.bmp",
        bmp + std::string(20, '\0') + "abc abc " + std::string("\4\1\0\0\0\3\1\1\1\0\0\1", 12));
  write(folder / "ies/quadrant.ies", ies);
  write(folder / "gltf/scene.glb", gltf_scene());
  write(folder / "gltf/text.gltf", GltfBuilder().text("none.bin"));
  write(folder / "raw_scene/scene.bytes", bytes_of(small_scene()));
  write(folder / "merl/header.binary", std::string("\132\0\0\0\132\0\0\0\264\0\0\0", 12));

  Medium medium;
  std::vector<Gaussian> gaussians{{{0.1, 0.2, 0.3}, 0.5, 1.0}, {{-0.2, 0.0, 0.1}, 0.3, 0.5}};
  for (const Gaussian& gaussian : gaussians) medium.append(gaussian);
  write_gaussians(folder / "gaussian_ply/binary.ply", gaussians);
  write_gaussians(folder / "gaussian_csv/table.csv", gaussians);
  gaussians.back().set_radii({0.3, 0.1, 0.2}, {0.5, 0.5, -0.5, 0.5});
  write_splats(folder / "splat_ply/binary.ply", gaussians);
  write_splats(folder / "splat_gltf/floats.glb", gaussians);
  write_splats(folder / "splat_gltf/text.gltf", gaussians);
  write(folder / "splat_gltf/placed.glb", gltf_splats());
  ImageLayers image;
  image.width = image.height = 4;
  for (const char* channel : {"R", "G", "B", "Z"}) {
    image.channels[channel] = std::vector<float>(16, 0.5f);
  }
  image.metadata["text"] = "some";
  write_exr(folder / "exr/layers.exr", image);
  const DensityGrid grid = *MediumSampling::plan(medium, 0.25, 1000)->sample();
  write_volume(folder / "vdb/float.vdb", grid, false);
  write_volume(folder / "vdb/half.vdb", grid, true);
  const VolumeColors colors{ColorGrid{grid, grid, grid}, ColorGrid{grid, grid, grid}};
  write_volume(folder / "vdb/colors.vdb", grid, false, colors);
}

}  // namespace
}  // namespace brume

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  brume::write_seeds(arguments[1]);
}
