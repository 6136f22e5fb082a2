#include "tests/render/random_scene.h"

#include <glm/geometric.hpp>

#include "brume/mesh_arrays.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/radiance_map.h"
#include "core/scene/lights/sky.h"
#include "core/scene/materials/measured_brdf.h"
#include "tests/random.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

class RandomScene {
 public:
  explicit RandomScene(unsigned seed) : random_(seed) {}

  Scene make() {
    if (one_in(3)) origin_ = random_.point(1.0) * random_.power(2, one_in(10) ? 12 : 6);
    spread_ = one_in(4) ? random_.power(-3, 4) : 1.0;
    scene_.film = {integer(1, 12), integer(1, 8)};
    add_camera();
    for (int i = integer(0, 3); i > 0; --i) add_surface();
    has_optics_ = one_in(4);
    for (int i = integer(0, one_in(3) ? 40 : 5); i > 0; --i) add_gaussian();
    for (int i = integer(0, 6); i > 0; --i) add_light();
    if (one_in(3)) scene_.medium.set_homogeneous_density(spread(random_.power(-3, 1), -9, 9));
    if (one_in(3)) scene_.optics.anisotropy = random_.uniform(-0.95, 0.95);
    if (one_in(8)) scene_.optics.anisotropy = one_in(2) ? 0.95 : -0.95;
    if (one_in(4)) scene_.optics.albedo = {albedo(), albedo(), albedo()};
    if (one_in(8)) scene_.optics.albedo = glm::dvec3(albedo());
    if (one_in(4)) add_noise();
    // Rarely: its airlight takes longer than all else.
    if (one_in(60)) add_environment();
    for (Light& light : scene_.lights) {
      if (!one_in(3)) continue;
      const light::Spot spot = cone_from(light.position);
      if (light.as<light::Point>()) light.kind = spot;
    }
    for (Light& light : scene_.lights) {
      LightProfile* profile = profile_member(light);
      if (profile && one_in(8)) *profile = lobed_profile(random_.uniform(-360.0, 360.0));
    }
    for (Light& light : scene_.lights) {
      const bool is_bare = light.as<light::Point>() && !profile_of(light);
      if (is_bare && one_in(4)) light.kind = area_at(light.position);
    }
    if (one_in(4)) scene_.camera.height = spread(spread_ * random_.power(-1, 1), -9, 9);
    return std::move(scene_);
  }

 private:
  int integer(int min, int max) {
    return min + static_cast<int>(random_.uniform(0.0, max - min + 1));
  }
  bool one_in(int n) { return integer(1, n) == 1; }
  // Mostly `ordinary`, at times any power of ten in the range.
  double spread(double ordinary, double low, double high) {
    return one_in(4) ? random_.power(low, high) : ordinary;
  }
  double albedo() { return one_in(6) ? 1e-6 : one_in(4) ? 1.0 : random_.uniform(0.01, 1.0); }

  glm::dvec3 point() {
    const glm::dvec3 p = random_.point(2.0 * spread_);
    return origin_ + (one_in(20) ? p * random_.power(0, 6) : p);
  }

  // A point where something else is, or any.
  glm::dvec3 place() {
    const Medium& medium = scene_.medium;
    if (one_in(8)) return scene_.camera.eye;
    if (one_in(8)) return scene_.camera.target;  // a view ray goes through it if sides are odd
    if (one_in(6) && !medium.empty()) {
      return medium
          .centers()[static_cast<std::size_t>(integer(0, static_cast<int>(medium.size()) - 1))];
    }
    if (one_in(6) && !scene_.lights.empty()) return scene_.lights.back().position;
    if (one_in(6) && !corners_.empty()) {
      return corners_[static_cast<std::size_t>(integer(0, static_cast<int>(corners_.size()) - 1))];
    }
    if (one_in(8) && corners_.size() > 2) return (corners_[0] + corners_[1] + corners_[2]) / 3.0;
    return point();
  }

  void add_camera() {
    Camera& camera = scene_.camera;
    camera.eye = point();
    do camera.target = point();
    while (!(glm::length(camera.target - camera.eye) > 0.0));
    if (one_in(3)) camera.up = random_.point(1.0) + glm::dvec3(0, 1e-3, 0);
    if (one_in(8)) camera.up = camera.target - camera.eye;
    camera.vertical_fov = one_in(8) ? 179.9 : one_in(8) ? 1e-3 : random_.uniform(1.0, 120.0);
  }

  void add_gaussian() {
    Gaussian g;
    g.center = place();
    g.radius = spread_ * spread(random_.power(-1, 0.5), -9, 8);
    g.density = one_in(10) ? 0.0 : spread(random_.power(-1, 1) / g.radius, -6, 6);
    if (has_optics_ && one_in(2)) {
      if (one_in(2)) g.optics.albedo = glm::dvec3(albedo(), albedo(), albedo());
      if (one_in(2)) g.optics.emission = {spread(1.0, -9, 9), 0.0, spread(1.0, -9, 9)};
    }
    scene_.medium.append(g);
  }

  // Towards a place, or none in particular; of any width.
  light::Spot cone_from(const glm::dvec3& position) {
    light::Spot cone;
    if (const glm::dvec3 towards = place() - position; towards != glm::dvec3(0.0)) {
      cone.direction = glm::clamp(towards, -1e12, 1e12);
    }
    cone.outer_angle = one_in(4) ? 180.0 : spread(5.0 * random_.power(0, 1), 0.1, 179);
    cone.inner_angle = one_in(3) ? 0.0 : 0.6 * cone.outer_angle;
    return cone;
  }

  Light::Kind area_at(const glm::dvec3& position) {
    const int shape = integer(0, 2);
    glm::dvec3 direction = light::Disk().direction;
    if (const glm::dvec3 towards = place() - position; towards != glm::dvec3(0.0)) {
      direction = glm::clamp(towards, -1e12, 1e12);
    }
    const glm::dvec3 up = one_in(3) ? direction : light::Rectangle().up;
    const auto size = [&] {
      return std::clamp(spread_ * spread(0.3 * random_.power(-1, 1), -9, 9), 1e-12, 1e12);
    };
    const double width = size();
    const double height = size();
    const double radius = size();
    const bool two_sided = one_in(2);
    if (shape == 0) return light::Rectangle{direction, up, width, height, two_sided};
    if (shape == 1) return light::Disk{direction, radius, two_sided};
    return light::Sphere{radius, two_sided};
  }

  void add_light() {
    Light light;
    light.position = place();
    const auto channel = [&] { return one_in(5) ? 0.0 : spread(random_.power(0, 2), -20, 20); };
    light.intensity.x = channel();
    light.intensity.y = channel();
    light.intensity.z = channel();
    light.on = !one_in(10);
    if (one_in(6)) {
      auto& sun = light.kind.emplace<light::Directional>();
      if (const glm::dvec3 towards = place(); towards != glm::dvec3(0.0)) {
        sun.direction = glm::clamp(towards, -1e12, 1e12);
      }
      if (one_in(3)) sun.angular_diameter = spread(random_.power(0, 1), 0.0, 89.0);
    }
    scene_.lights.push_back(light);
  }

  void add_noise() {
    Noise& noise = scene_.optics.noise;
    noise.amplitude = spread(random_.uniform(0.0, 1.0), -9, 9);
    noise.frequency = spread(random_.uniform(0.0, 5.0) / spread_, -9, 12);
    noise.velocity = random_.point(1.0);
    noise.seed = integer(0, 1000);
  }

  // Any pixels, many of them black, or a sky and its sun.
  void add_environment() {
    if (one_in(3)) {
      Environment& environment = scene_.environment.emplace();
      environment.sky = Sky{.elevation = random_.uniform(-20.0, 90.0),
                            .azimuth = random_.uniform(-360.0, 360.0),
                            .turbidity = random_.uniform(1.0, 10.0),
                            .sun = one_in(2)};
      environment.intensity = spread(1.0, -20, 20);
      apply_sky(scene_);
      return;
    }
    auto map = std::make_shared<RadianceMap>(RadianceMap{integer(1, 6), integer(1, 4), {}});
    for (int i = map->width * map->height; i > 0; --i) {
      const double radiance = one_in(3) ? 0.0 : spread(random_.power(-1, 1), -20, 20);
      map->pixels.emplace_back(glm::dvec3(1.0, random_.uniform(0.0, 1.0), 0.0) * radiance);
    }
    Environment& environment = scene_.environment.emplace();
    environment.map = map;
    environment.intensity = one_in(6) ? 0.0 : spread(1.0, -20, 20);
    environment.rotation = random_.uniform(-360.0, 360.0);
  }

  // A few triangles with any normals, some of no area.
  void add_surface() {
    MeshArrays mesh;
    Surface surface;
    surface.translate = point();
    surface.scale = spread_ * spread(1.0, -9, 7);
    for (int i = integer(1, 4); i > 0; --i) {
      const bool is_flat = one_in(8);
      const glm::dvec3 a = random_.point(2.0);
      const glm::dvec3 ab = random_.point(2.0);
      const glm::dvec3 ac = is_flat ? 0.5 * ab : random_.point(2.0);
      const std::size_t first = mesh.points.size();
      mesh.triangles.emplace_back(first, first + 1, first + 2);
      for (const glm::dvec3& p : {a, a + ab, a + ac}) {
        mesh.points.emplace_back(p);
        glm::dvec3 n = glm::normalize(random_.point(1.0) + glm::dvec3(0, 0, 1e-3));
        if (one_in(20)) n = glm::dvec3(0.0);
        mesh.normals.emplace_back(n);
        corners_.push_back(surface.translate + surface.scale * p);
      }
    }
    surface.mesh = to_mesh(mesh);
    surface.material.reflectance = {random_.uniform(0, 1), one_in(3) ? 0.0 : 1.0, 0.5};
    if (one_in(4)) {
      surface.transfer = one_in(2) ? Surface::Transfer::shadow : Surface::Transfer::interreflection;
    }
    // Rarely: what is prepared for one takes as long as the frame.
    if (one_in(200)) {
      surface.material.type = Material::Type::measured;
      surface.material.measured = measured();
    } else if (one_in(40)) {
      surface.material.type = Material::Type::phong;
      surface.material.specular = glm::dvec3(random_.uniform(0, 1));
      surface.material.exponent = one_in(6) ? 0.0 : random_.power(-1, one_in(3) ? 12 : 3);
    }
    scene_.surfaces.push_back(surface);
  }

  // With dark, bright and black pixels.
  // One for all scenes, since it is large: nothing in it is smooth, and a part was not measured.
  static std::shared_ptr<const MeasuredBrdf> measured() {
    static const auto brdf = [] {
      Random random(1);
      std::vector<glm::vec3> values(MeasuredBrdf::samples);
      for (glm::vec3& value : values) {
        const double x = random.power(-3, 3);
        value = random.uniform(0, 1) < 0.1 ? glm::vec3(-1.0f) : glm::vec3(glm::dvec3(x, 0.1, 0.0));
      }
      return std::make_shared<const MeasuredBrdf>(std::move(values));
    }();
    return brdf;
  }

  Random random_;
  glm::dvec3 origin_{0.0};
  double spread_ = 1.0;  // of the scene [u]
  Scene scene_;
  bool has_optics_ = false;          // of Gaussians
  std::vector<glm::dvec3> corners_;  // of the triangles
};

}  // namespace

Scene random_scene(unsigned seed) {
  return RandomScene(seed).make();
}

}  // namespace brume
