#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "render/paths/camera_ray.h"
#include "render/paths/path_random.h"
#include "render/paths/path_scene.h"

namespace brume {

// Radiance by how often its light was scattered or reflected on the way: once, twice, more often.
struct OrderedRadiance {
  std::array<glm::dvec3, 3> orders{};

  void add(int order, const glm::dvec3& radiance) {
    orders[static_cast<std::size_t>(order < 3 ? order - 1 : 2)] += radiance;
  }
  [[nodiscard]] glm::dvec3 sum() const { return orders[0] + orders[1] + orders[2]; }
};

// Unbiased estimates of the light along view rays: random walks through medium and surfaces with
// next-event estimation at every vertex, all orders, optical depths in closed form. Environments
// are sampled by their radiance and by phase function or material, combined by the balance
// heuristic (Veach), and so are emissive surfaces, by what they send; points of area lights
// by their solid angle, and for collisions near them evenly (AreaSampler), of smooth surfaces by
// the material, too; lights inside the medium
// by collisions and equi-angularly (Kulla and Fajardo 2012); light that Gaussians emit by
// collisions and by what they emit, combined likewise.
//
// Their biases are: culling (PathMedium), h_min of lights and max_growth, all far below any noise,
// and the end of endless fog (PathFog). Thread-safe.
class PathTracer {
 public:
  explicit PathTracer(const PathScene& scene) : scene_(scene) {}

  // Radiance scattered towards the eye along a ray of depth > 0, per unit of albedo at the first
  // collision, as elsewhere (prepare/albedo.h). `stratified` places the first collision and the
  // samples of lights on the ray.
  [[nodiscard]] OrderedRadiance airlight(const CameraRay& ray, const StratifiedPair& stratified,
                                         PathRandom& random) const;

  // The part of it that is light of the scene's lights and of surfaces that emit, scattered once.
  [[nodiscard]] glm::dvec3 lights_once(const CameraRay& ray, const StratifiedPair& stratified,
                                       PathRandom& random) const;

  // Outgoing radiance of a surface point towards the eye, or the part of it that PathScene says.
  [[nodiscard]] OrderedRadiance surface(const SurfacePoint& point, PathRandom& random) const;

  // Surfaces behind more than this optical depth are not seen: exp(-50) = 2e-22.
  static constexpr double hidden_depth = 50.0;
  // Russian roulette by throughput begins after so many scattering events.
  static constexpr int first_roulette = 5;
  // Where nothing absorbs, paths end by chance after so many, and so many more on average: light
  // diffuses through an optical depth of 100 in fewer.
  static constexpr int long_path = 10'000;
  // How much throughput may grow, against surfaces that make energy.
  static constexpr double max_growth = 1e20;
  // Where there are more lights, one is chosen at random.
  static constexpr std::size_t max_lights_each = 3;

 private:
  // Where a path is scattered or reflected.
  struct Vertex {
    glm::dvec3 position{0.0};  // origin of the rays that leave it
    glm::dvec3 w{0.0};         // unit, in which the path came
    glm::dvec3 start{0.0};     // of the segment that ended here
    double t = 0.0;            // and its length
    bool is_surface = false;
    bool is_view = false;    // reached by a view ray, mirrored perhaps: its highlight shows lights
    bool is_mirror = false;  // sends on what it mirrors, without the lights of its highlight
    SurfacePoint point{};    // of a surface

    static Vertex in_medium(const glm::dvec3& start, const glm::dvec3& w, double t);
    static Vertex on_surface(const SurfacePoint& point);
  };

  // The first collision on a ray from the eye.
  struct FirstCollision {
    FirstCollision(const CameraRay& ray, double u);

    // Of a point of a light, by the balance heuristic with lights_on_camera_ray().
    [[nodiscard]] double weight(const PathLight& light, const glm::dvec3& light_point) const;

    const CameraRay& ray;
    double opacity;  // of the ray
    CameraRay::Point point;
    Vertex vertex;
    double density;  // of finding it [1/u]
  };

  // A walk goes here from a vertex, up to a surface or endlessly, and where it is in fog.
  struct Segment {
    glm::dvec3 origin{0.0};
    glm::dvec3 w{0.0};
    SurfaceHit hit;
    FogInterval fog;
  };

  [[nodiscard]] const MaterialSampler& material(const Vertex& vertex) const;
  // Phase function, or BRDF and cosine, for light from the unit direction l [1/sr].
  [[nodiscard]] glm::dvec3 scattering(const Vertex& vertex, const glm::dvec3& l) const;
  // Draws a direction; returns it and its probability density [1/sr].
  struct Direction {
    glm::dvec3 w{0.0};
    double pdf = 0.0;
  };
  [[nodiscard]] Direction sample_direction(const Vertex& vertex, PathRandom& random) const;
  [[nodiscard]] double direction_pdf(const Vertex& vertex, const glm::dvec3& l) const;

  // Light that arrives at a vertex from a point, and what of it is scattered there: 0 where none
  // is.
  struct Arrival {
    glm::dvec3 l{0.0};  // unit, to the point
    double r = 0.0;     // its distance
    glm::dvec3 value{0.0};
  };
  [[nodiscard]] Arrival arrival(const Vertex& vertex, const glm::dvec3& point) const;

  // The optics of the matter that light collides with at a point of the medium.
  [[nodiscard]] RelativeOptics optics_at(const glm::dvec3& x) const;

  // Calls visit(light, probability) for each light, or for one chosen by importance(light).
  template <class Importance, class Visit>
  void choose_lights(Importance importance, PathRandom& random, Visit visit) const;

  // Radiance of a light that reaches the vertex and is scattered once there; weight(light, a point
  // of it) is that of the technique.
  template <class Weight>
  [[nodiscard]] glm::dvec3 light_at(const Vertex& vertex, Weight weight, PathRandom& random) const;
  // The same of the environment.
  [[nodiscard]] glm::dvec3 environment_at(const Vertex& vertex, PathRandom& random) const;
  // The same of surfaces that emit.
  [[nodiscard]] glm::dvec3 emitters_at(const Vertex& vertex, PathRandom& random) const;
  // The same, found by a direction in which the vertex scatters.
  [[nodiscard]] glm::dvec3 emitters_around(const Vertex& vertex, PathRandom& random) const;
  // The light of what a ray that was drawn with a density hits, by its share of the balance
  // heuristic with emitters_at().
  [[nodiscard]] glm::dvec3 emitted_by(const SurfaceHit& hit, const SurfacePoint& point,
                                      const Direction& direction) const;
  // Whether a vertex mirrors: on a surface that shows what is around it.
  [[nodiscard]] static bool is_smooth(const Vertex& vertex);
  // The light of area lights that a ray from a smooth vertex passes within a length, by its share
  // of the balance heuristic with light_at().
  [[nodiscard]] glm::dvec3 lights_passed(const Vertex& vertex, const Direction& direction,
                                         double length) const;
  // The share of scattering() that is mirrored.
  [[nodiscard]] glm::dvec3 mirrored_share(const Vertex& vertex, const glm::dvec3& l) const;
  // The emission of Gaussians at the end of a segment, as it arrives at its origin per solid angle
  // there and length; the densities of finding that point [1/u^3] by a collision, and by
  // EmissionSampler.
  struct Emission {
    glm::dvec3 arriving;
    double collision_pdf, pdf;

    // The weight of collisions, by the balance heuristic.
    [[nodiscard]] double weight() const {
      return pdf > 0.0 ? collision_pdf / (collision_pdf + pdf) : 1.0;
    }
  };
  [[nodiscard]] Emission emission_of(const RaySegment& way, double direction_pdf) const;
  // The same as light_at() of what Gaussians emit, where EmissionSampler finds it.
  [[nodiscard]] glm::dvec3 emission_at(const Vertex& vertex, PathRandom& random) const;
  // The same of all lights, on a random walk.
  [[nodiscard]] glm::dvec3 direct_light(const Vertex& vertex, PathRandom& random) const;
  // Transmittance and visibility of a point of a light from x.
  [[nodiscard]] double visibility(const glm::dvec3& x, const PathLight& light,
                                  const glm::dvec3& point) const;

  // The weight of equi-angular samples on the segments of walks, by the distance from the light;
  // that of collisions is the rest.
  static double equi_angular_weight(const PathLight& light, double r) {
    const double near2 = light.near_radius * light.near_radius;
    return near2 > 0.0 ? near2 / (near2 + r * r) : 0.0;
  }
  [[nodiscard]] glm::dvec3 lights_on_camera_ray(const CameraRay& ray, double opacity, double u,
                                                PathRandom& random) const;
  // A segment passes panes by chance.
  [[nodiscard]] Segment segment(const Vertex& vertex, const glm::dvec3& w,
                                PathRandom& random) const;
  // The transmittance of the medium along so much of a segment.
  [[nodiscard]] double transmittance(const Segment& segment, double length) const;
  // Ends the segment at a light that is seen, by chance: mirrored light does not pass it, other
  // light does. The factor of the throughput.
  [[nodiscard]] glm::dvec3 end_at_light(const Vertex& vertex, Segment& segment,
                                        PathRandom& random) const;
  // The share of the light from a point in the unit direction l, so far away [u], that is not
  // hidden by the shape of a light: what a highlight mirrors is.
  [[nodiscard]] glm::dvec3 shapes_pass(const Vertex& vertex, const glm::dvec3& l,
                                       double distance) const;
  // The light of a light in the medium that a segment scatters, the share of equi-angular samples.
  [[nodiscard]] glm::dvec3 light_on_segment(const PathLight& light, const Segment& segment,
                                            PathRandom& random) const;

  // The same falls off like 1 / distance from the light, so segments are chosen in two ways: as the
  // walk goes, and uniformly in the angle from the light, combined by the balance heuristic.
  struct AngularSampling {
    glm::dvec3 axis{0.0};  // unit, to the light
    double rate = 0.0;     // how often the second way is taken

    AngularSampling(const PathLight& light, const Vertex& vertex);
    // Density of the second way, times its rate [1/sr].
    [[nodiscard]] double density(const glm::dvec3& w) const;
  };
  // By the second way, without albedo.
  [[nodiscard]] glm::dvec3 lights_around(const Vertex& vertex, PathRandom& random) const;
  // By the first.
  [[nodiscard]] glm::dvec3 lights_along(const Vertex& vertex, const Segment& segment, double pdf,
                                        PathRandom& random) const;

  // Adds the light scattered and reflected after the first vertex, whose own light is not included.
  void walk(Vertex vertex, glm::dvec3 throughput, PathRandom& random, OrderedRadiance& sum) const;

  const PathScene& scene_;
};

}  // namespace brume
