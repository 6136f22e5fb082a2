#pragma once

#include <sstream>
#include <string>

#include "core/io/import/raw_scene_bytes.h"

namespace brume {

// A scene with one of each kind of object, and the bytes that it is sent as.
inline RawScene small_scene() {
  RawScene scene;
  scene.nodes = {{"a"}, {"b", 0}};
  scene.materials.resize(1);
  scene.materials[0].textures[2] = RawTexture{0, TextureWrap::clamp, TextureWrap::mirror};
  scene.images = {{"/a/b.png", "bytes"}};
  RawPart part{1, 0, {}};
  part.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  part.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 0}};
  part.mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
  part.mesh.triangles = {{0, 1, 2}};
  scene.parts = {part};
  scene.cameras = {{"c", Camera{}, {}}};
  Light spot{.position = {1, 2, 3}, .kind = light::Spot{{0, -1, 0}, 10.0, 20.0}, .name = "s"};
  Light sun{.kind = light::Directional{{0, -1, 0}}};
  scene.lights = {spot, sun};
  scene.files = {"/a/a.obj", "/a/a.mtl"};
  scene.warnings = {"w"};
  return scene;
}

inline std::string bytes_of(const RawScene& scene) {
  std::ostringstream out;
  write_raw_scene(out, scene);
  return out.str();
}

}  // namespace brume
