#include <cmath>
#include <glm/geometric.hpp>

#include "brume/mesh_arrays.h"
#include "core/scene/cameras.h"
#include "core/scene/lights/radiance_map.h"
#include "tests/random.h"
#include "tests/render/random_scene.h"

namespace brume {
namespace {

class RandomFogScene {
 public:
  explicit RandomFogScene(unsigned seed) : random_(seed) {}

  Scene make() {
    Camera& camera = scene_.camera;
    camera.vertical_fov = random_.uniform(20.0, 80.0);
    // So far that a ball of radius 1.5 fills the picture more or less; at times inside it.
    const double distance = one_in(8) ? random_.uniform(0.3, 1.5) : random_.uniform(2.0, 6.0);
    camera.eye = distance * direction();
    camera.target = random_.point(0.5);
    scene_.film = {32, 24};
    for (int i = integer(1, one_in(3) ? 60 : 8); i > 0; --i) add_gaussian();
    for (int i = integer(1, 4); i > 0; --i) add_light();
    for (int i = one_in(2) ? integer(1, 2) : 0; i > 0; --i) add_wall();
    if (one_in(3)) scene_.medium.set_homogeneous_density(random_.power(-3, -0.5));
    if (one_in(3)) scene_.optics.anisotropy = random_.uniform(-0.6, 0.8);
    if (one_in(4)) scene_.optics.albedo = random_.point(0.4) + glm::dvec3(0.6);
    if (one_in(6)) {
      scene_.optics.noise.amplitude = random_.uniform(0.0, 0.5);
      scene_.optics.noise.frequency = random_.uniform(0.5, 5.0);
    }
    if (one_in(50)) add_environment();
    if (one_in(4)) camera = orthographic(camera);
    return std::move(scene_);
  }

 private:
  int integer(int min, int max) {
    return min + static_cast<int>(random_.uniform(0.0, max - min + 1));
  }
  bool one_in(int n) { return integer(1, n) == 1; }

  glm::dvec3 direction() {
    glm::dvec3 p;
    do p = random_.point(1.0);
    while (!(glm::length(p) > 0.1 && glm::length(p) < 1.0));
    return glm::normalize(p);
  }

  // Some fill the picture, some are smaller than a pixel; some are thin, some opaque.
  void add_gaussian() {
    Gaussian g;
    g.center = random_.point(1.2);
    g.radius = one_in(4) ? random_.power(-2.5, -1) : random_.power(-1, 0.2);
    const double depth = one_in(5) ? random_.power(1, 3) : random_.power(-2, 1);
    g.density = depth / (std::sqrt(3.141592653589793) * g.radius);
    scene_.medium.append(g);
  }

  void add_light() {
    Light light;
    // In the fog, where it may be seen; in a Gaussian; or around all of it.
    light.position = one_in(2) ? random_.point(1.2) : random_.uniform(2.0, 5.0) * direction();
    if (one_in(6)) {
      light.position = scene_.medium.centers()[static_cast<std::size_t>(
          integer(0, static_cast<int>(scene_.medium.size()) - 1))];
    }
    light.intensity = glm::dvec3(random_.power(0, 2));
    if (one_in(2)) light.intensity *= random_.point(0.5) + glm::dvec3(0.5);
    scene_.lights.push_back(light);
  }

  void add_wall() {
    MeshArrays mesh;
    const glm::dvec3 quad_center = random_.point(1.5);
    const glm::dvec3 right = random_.power(-1.3, 0.3) * direction();
    const glm::dvec3 down = random_.power(-1.3, 0.3) * direction();
    const glm::dvec3 n = glm::normalize(glm::cross(down, right));
    for (const glm::dvec3& p : {quad_center - right - down, quad_center + right - down,
                                quad_center + right + down, quad_center - right + down}) {
      mesh.points.emplace_back(p);
      mesh.normals.emplace_back(n);
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    Surface surface;
    surface.mesh = to_mesh(mesh);
    scene_.surfaces.push_back(surface);
  }

  // A sky that is brighter above, with a sun at times.
  void add_environment() {
    auto map = std::make_shared<RadianceMap>(RadianceMap{8, 4, {}});
    for (int row = 0; row < map->height; ++row) {
      for (int column = 0; column < map->width; ++column) {
        map->pixels.emplace_back(glm::dvec3(0.2 * (map->height - row)));
      }
    }
    if (one_in(2)) {
      map->pixels[static_cast<std::size_t>(integer(0, 15))] *=
          static_cast<float>(random_.power(0, 2));
    }
    Environment& environment = scene_.environment.emplace();
    environment.map = map;
  }

  Random random_;
  Scene scene_;
};

}  // namespace

Scene random_fog_scene(unsigned seed) {
  return RandomFogScene(seed).make();
}

}  // namespace brume
