#include "tests/render/coverage_scenes.h"

#include <cmath>
#include <memory>

#include "brume/primitive.h"
#include "core/scene/materials/texture.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

constexpr int texels = 64;
const glm::dvec3 leaf_color(0.2, 0.5, 0.1);

Surface square(double side) {
  Surface surface;
  surface.primitive = Primitive{Primitive::Shape::plane, {side, 1.0, side}};
  surface.mesh = mesh_of(*surface.primitive);
  surface.material = metallic_roughness(leaf_color, 0.0, 0.8);
  return surface;
}

}  // namespace

bool is_leaf_there(double x, double z) {
  const auto cell = [](double p) { return static_cast<int>(std::floor(2.0 * (p + 1.0))); };
  return (cell(x) + cell(z)) % 2 != 0;
}

Surface checkered_leaf() {
  Surface surface = square(2.0);
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < texels; ++y) {
    for (int x = 0; x < texels; ++x) {
      // A plane shows +z at the bottom.
      const bool is_there = is_leaf_there((x + 0.5) / 32.0 - 1.0, (y + 0.5) / 32.0 - 1.0);
      rgba.insert(rgba.end(), {255, 255, 255, static_cast<std::uint8_t>(is_there ? 255 : 0)});
    }
  }
  MetallicRoughness& material = surface.material.metallic_roughness;
  material.base_color_texture = {
      "leaf.png", std::make_shared<const Texture>(texels, texels, rgba, Texture::Encoding::srgb)};
  material.alpha = AlphaMode::cutout;
  return surface;
}

std::vector<Surface> leaf_of_squares() {
  std::vector<Surface> squares;
  for (int z = 0; z < 4; ++z) {
    for (int x = 0; x < 4; ++x) {
      const glm::dvec3 middle(0.5 * x - 0.75, 0.0, 0.5 * z - 0.75);
      if (!is_leaf_there(middle.x, middle.z)) continue;
      squares.push_back(square(0.5));
      squares.back().translate = middle;
    }
  }
  return squares;
}

Surface pane(AlphaMode alpha, double opacity, const glm::dvec3& transmission) {
  Surface surface = square(2.0);
  MetallicRoughness& material = surface.material.metallic_roughness;
  material.alpha = alpha;
  material.opacity = opacity;
  material.transmission = transmission;
  return surface;
}

Scene lit_from_above() {
  Scene scene = seen_by({{2.5, 1.6, 4.0}, {0.0, 0.6, 0.0}, {0, 1, 0}, 40.0}, {48, 36});
  scene.lights = {{.position = {0.3, 2.2, 0.2}, .intensity = {30, 30, 30}}};
  Surface floor = square(12.0);
  floor.material.type = Material::Type::diffuse;
  scene.surfaces = {floor};
  return scene;
}

}  // namespace brume
