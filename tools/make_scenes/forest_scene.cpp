#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tools/make_scenes/generated_files.h"
#include "tools/make_scenes/patch_mesh.h"
#include "tools/make_scenes/random.h"
#include "tools/make_scenes/sample_scene.h"
#include "tools/make_scenes/scenes.h"

namespace brume {
namespace {

// An aisle along the view has no trees [u].
constexpr double path_half_width = 0.75;

double ground(double x, double z) {
  return 0.12 * std::sin(0.9 * x + 0.4) * std::cos(0.7 * z) + 0.05 * std::sin(2.3 * x - 1.1 * z);
}

struct Tree {
  double x, z, height, radius;
  glm::dvec3 lean;  // of its top
};

glm::dvec3 stem(const Tree& tree, double share) {
  return glm::dvec3(tree.x, ground(tree.x, tree.z) - 0.05, tree.z) +
         glm::dvec3(0.0, share * tree.height, 0.0) + share * share * tree.lean;
}

// Wider at its foot.
void add_trunk(const Tree& tree, PatchMesh& mesh) {
  add_patch(
      9, 7,
      [&](double u, double v) {
        const double angle = -2.0 * std::numbers::pi * u;
        const double radius = tree.radius * (1.0 - 0.75 * v + 0.5 * std::pow(1.0 - v, 8));
        return stem(tree, v) + radius * glm::dvec3(std::cos(angle), 0.0, std::sin(angle));
      },
      mesh);
}

void add_bough(const glm::dvec3& root, const glm::dvec3& reach, double radius, PatchMesh& mesh) {
  const glm::dvec3 side = glm::normalize(glm::cross(reach, glm::dvec3(0.0, 1.0, 0.0)));
  const glm::dvec3 up = glm::normalize(glm::cross(side, reach));
  add_patch(
      4, 3,
      [&](double u, double v) {
        const double angle = -2.0 * std::numbers::pi * u;
        const double r = radius * (1.0 - 0.8 * v);
        return root + v * reach + glm::dvec3(0.0, 0.15 * v * v, 0.0) +
               r * (std::cos(angle) * side + std::sin(angle) * up);
      },
      mesh);
}

void add_leaf(const glm::dvec3& center, double size, HashRandom& random, PatchMesh& mesh) {
  const glm::dvec3 a = glm::normalize(random.in_ball());
  const glm::dvec3 b = glm::normalize(glm::cross(a, random.in_ball() + glm::dvec3(0.0, 0.1, 0.0)));
  add_rectangle(1, 1, center - size * (a + b), 2.0 * size * a, 2.0 * size * b, mesh);
}

// Boughs with leaves around their ends.
void add_crown(const Tree& tree, HashRandom& random, PatchMesh& wood, PatchMesh& leaves) {
  constexpr int boughs = 9;
  for (int k = 0; k < boughs; ++k) {
    const double share = 0.42 + 0.55 * (k + random.uniform()) / boughs;
    const double angle = 2.4 * k + random.uniform(0.0, 0.8);
    const double length = tree.height * (0.36 - 0.26 * share) * random.uniform(0.8, 1.2);
    const glm::dvec3 reach =
        length * glm::dvec3(std::cos(angle), random.uniform(0.1, 0.4), std::sin(angle));
    const glm::dvec3 root = stem(tree, share);
    add_bough(root, reach, 0.3 * tree.radius * (1.2 - share), wood);
    for (int i = 0; i < 27; ++i) {
      const glm::dvec3 place = root + random.uniform(0.45, 1.15) * reach;
      add_leaf(place + 0.32 * length * random.in_ball(), random.uniform(0.05, 0.1), random, leaves);
    }
  }
}

std::vector<Tree> trees() {
  std::vector<Tree> result;
  HashRandom random(2211);
  while (result.size() < 64) {
    Tree tree{};
    tree.x = random.uniform(-7.5, 7.5);
    tree.z = random.uniform(-14.0, 4.2);
    tree.height = random.uniform(4.2, 6.4);
    tree.radius = random.uniform(0.09, 0.19);
    tree.lean = glm::dvec3(random.uniform(-0.4, 0.4), 0.0, random.uniform(-0.4, 0.4));
    if (std::abs(tree.x + 0.12 * tree.z) < path_half_width) continue;
    bool is_free = true;
    for (const Tree& other : result) {
      is_free &= std::hypot(tree.x - other.x, tree.z - other.z) > 1.05;
    }
    if (is_free) result.push_back(tree);
  }
  return result;
}

}  // namespace

void write_forest_scene(const std::filesystem::path& folder) {
  PatchMesh wood;
  PatchMesh leaves;
  HashRandom random(7);
  for (const Tree& tree : trees()) {
    add_trunk(tree, wood);
    add_crown(tree, random, wood, leaves);
  }
  PatchMesh soil;
  add_patch(
      40, 48,
      [](double u, double v) {
        const double x = 20.0 * (u - 0.5);
        const double z = 8.0 - 28.0 * v;
        return glm::dvec3(x, ground(x, z), z);
      },
      soil);
  write_mesh_ply(folder / "forest_wood.ply", wood.vertices, wood.triangles);
  write_mesh_ply(folder / "forest_leaves.ply", leaves.vertices, leaves.triangles);
  write_mesh_ply(folder / "forest_soil.ply", soil.vertices, soil.triangles);

  SampleScene scene;
  scene.camera = {{0.1, 0.7, 4.6}, {0.5, 1.8, 0.0}, {0.0, 1.0, 0.0}, 48.0};
  scene.anisotropy = 0.7;
  // Low, behind a crown on the right.
  SampleLight sun{.position = {}, .intensity = {28.0, 20.0, 12.0}};
  sun.directions = {{0.0, {-0.45, -0.5, 0.8}}};
  sun.is_directional = true;
  scene.lights = {sun};
  scene.environment_intensity = 0.2;
  scene.environment = "../environments/dawn.exr";
  scene.surfaces = {{"forest_soil.ply", {0.0, 0.0, 0.0}, 1.0, {0.2, 0.17, 0.1}},
                    {"forest_wood.ply", {0.0, 0.0, 0.0}, 1.0, {0.2, 0.15, 0.11}},
                    {"forest_leaves.ply", {0.0, 0.0, 0.0}, 1.0, {0.2, 0.28, 0.08}}};
  // Mist over the ground, haze between the trees.
  HashRandom place(31);
  while (scene.gaussians.size() < 60) {
    const double x = place.uniform(-5.0, 5.0);
    const double z = place.uniform(-8.0, 3.0);
    const double radius = place.uniform(0.4, 0.9);
    const double height = ground(x, z) + place.uniform(0.05, 0.45);
    scene.gaussians.push_back({{x, height, z}, radius, place.uniform(0.005, 0.035)});
  }
  while (scene.gaussians.size() < 84) {
    const double x = place.uniform(-4.0, 4.0);
    const double y = place.uniform(0.8, 2.4);
    const double z = place.uniform(-7.0, 2.0);
    scene.gaussians.push_back({{x, y, z}, place.uniform(1.4, 2.4), 0.022});
  }
  write_sample_scene(folder / "forest.brume", scene);
}

}  // namespace brume
