#include "render/paths/area_sampler.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>
#include <variant>

#include "core/math/unit_direction.h"
#include "core/overloaded.h"
#include "render/paths/direction_sampling.h"

namespace brume {
namespace {

using std::numbers::pi;

// Below this solid angle a plane is as good as far away, and the angles between its edges lose
// their digits.
constexpr double min_solid_angle = 1e-6;

// A rectangle as seen from a point (Urena, Fajardo and King, "An Area-Preserving Parametrization
// for Spherical Rectangles", EGSR 2013), in coordinates along its sides and towards it.
class SphericalRectangle {
 public:
  // `middle` is at a distance of z > 0.
  SphericalRectangle(const glm::dvec3& middle, double half_width, double half_height)
      : SphericalRectangle(middle.x - half_width, middle.x + half_width, middle.y - half_height,
                           middle.y + half_height, middle.z) {}
  // Its sides are at x0, x1, y0 and y1.
  SphericalRectangle(double x0, double x1, double y0, double y1, double z)
      : x0_(x0), x1_(x1), y0_(y0), y1_(y1), z_(z) {
    // Components along z of the normals of the planes through the point and the sides; then the
    // angles between those planes.
    const double low_y = y0 / std::hypot(y0, z);
    const double high_y = y1 / std::hypot(y1, z);
    const double low_x = x0 / std::hypot(x0, z);
    const double high_x = x1 / std::hypot(x1, z);
    first_ = -low_y;
    last_ = high_y;
    rest_ = 2.0 * pi - std::acos(low_x * high_y) - std::acos(-low_x * low_y);
    solid_angle_ = std::acos(high_x * low_y) + std::acos(-high_x * high_y) - rest_;
  }

  [[nodiscard]] double solid_angle() const { return solid_angle_; }

  // Evenly over the solid angle, for u and v in (0, 1).
  [[nodiscard]] glm::dvec2 sample(double u, double v) const {
    const double angle = u * solid_angle_ + rest_;
    const double slope = (std::cos(angle) * first_ - last_) / std::sin(angle);
    const double cosine =
        std::clamp(std::copysign(1.0 / std::hypot(slope, first_), slope), -1.0, 1.0);
    const double x =
        std::clamp(cosine * z_ / std::sqrt(std::max(1.0 - cosine * cosine, 1e-300)), x0_, x1_);
    const double d = std::hypot(x, z_);
    const double low = y0_ / std::hypot(d, y0_);
    const double h = low + v * (y1_ / std::hypot(d, y1_) - low);
    const double y = std::clamp(h * d / std::sqrt(std::max(1.0 - h * h, 1e-300)), y0_, y1_);
    return {x, y};
  }

 private:
  double x0_, x1_, y0_, y1_, z_;
  double first_ = 0.0, last_ = 0.0;  // components along z of the normals at y0 and at y1
  double rest_ = 0.0;
  double solid_angle_ = 0.0;
};

}  // namespace

AreaSampler::AreaSampler(const AreaLight& area, const glm::dvec3& center)
    : is_disk_(std::holds_alternative<light::Disk>(area)),
      is_sphere_(std::holds_alternative<light::Sphere>(area)),
      is_two_sided_(is_two_sided(area)),
      center_(center),
      surface_area_(surface_area(area)) {
  std::visit(Overloaded{[this](const light::Rectangle& rectangle) { set_plane(rectangle); },
                        [this](const light::Disk& disk) {
                          radius_ = disk.radius;
                          set_plane({.direction = disk.direction,
                                     .width = 2.0 * radius_,
                                     .height = 2.0 * radius_});
                        },
                        [this](const light::Sphere& sphere) { radius_ = sphere.radius; }},
             area);
}

void AreaSampler::set_plane(const light::Rectangle& rectangle) {
  normal_ = unit_direction(rectangle.direction, {0.0, -1.0, 0.0});
  std::tie(right_, up_) = rectangle_axes(rectangle);
  half_width_ = 0.5 * rectangle.width;
  half_height_ = 0.5 * rectangle.height;
}

AreaSampler::Point AreaSampler::on_surface(PathRandom& random) const {
  if (is_sphere_) {
    const glm::dvec3 normal =
        direction_around({0.0, 0.0, 1.0}, 2.0 * random.uniform() - 1.0, random);
    return {center_ + radius_ * normal, normal};
  }
  double x = 2.0 * random.uniform() - 1.0;
  double y = 2.0 * random.uniform() - 1.0;
  if (is_disk_) {
    const double radius = std::sqrt(0.5 * (x + 1.0));
    const double turn = pi * y;
    x = radius * std::cos(turn);
    y = radius * std::sin(turn);
  }
  return {center_ + x * half_width_ * right_ + y * half_height_ * up_, normal_};
}

double AreaSampler::cosine(const Point& point, const glm::dvec3& x) const {
  const glm::dvec3 q = x - point.position;
  const double r = glm::length(q);
  if (!(r > 0.0)) return 0.0;
  const double cosine = glm::dot(q, point.normal) / r;
  if (cosine > 0.0) return cosine;
  const bool reaches_back = is_two_sided_ && (!is_sphere_ || glm::length(x - center_) < radius_);
  return reaches_back ? -cosine : 0.0;
}

bool AreaSampler::shines_to(const glm::dvec3& x) const {
  const glm::dvec3 q = x - center_;
  if (is_sphere_) return is_two_sided_ || glm::length(q) > radius_;
  const double in_front = glm::dot(q, normal_);
  return in_front > 0.0 || (is_two_sided_ && in_front < 0.0);
}

AreaSampler::SeenPoint AreaSampler::seen_from(const glm::dvec3& x, PathRandom& random) const {
  if (!shines_to(x)) return {};
  return is_sphere_ ? seen_on_sphere(x, random) : seen_on_plane(x, random);
}

double AreaSampler::direction_pdf(const glm::dvec3& x, const glm::dvec3& position) const {
  if (is_sphere_) return 1.0 / (2.0 * pi * sphere_versine(x));
  const double solid_angle = plane_solid_angle(x);
  if (solid_angle > 0.0) return 1.0 / solid_angle;
  const glm::dvec3 q = position - x;
  const double seen = cosine({position, normal_}, x) * surface_area_;
  return seen > 0.0 ? glm::dot(q, q) / seen : 0.0;
}

double AreaSampler::sphere_versine(const glm::dvec3& x) const {
  const double sine = radius_ / glm::length(center_ - x);
  return sine < 1.0 ? sine * sine / (1.0 + std::sqrt(1.0 - sine * sine)) : 2.0;
}

glm::dvec3 AreaSampler::to_plane(const glm::dvec3& x) const {
  const glm::dvec3 q = center_ - x;
  return {glm::dot(q, right_), glm::dot(q, up_), std::abs(glm::dot(q, normal_))};
}

double AreaSampler::plane_solid_angle(const glm::dvec3& x) const {
  // A disk is drawn from the square around it, a fifth of which is none of it: only nearby that
  // makes less noise than drawing it evenly.
  if (is_disk_ && glm::length(center_ - x) > radius_) return 0.0;
  const double solid_angle =
      SphericalRectangle(to_plane(x), half_width_, half_height_).solid_angle();
  return solid_angle > min_solid_angle ? solid_angle : 0.0;
}

AreaSampler::SeenPoint AreaSampler::seen_on_sphere(const glm::dvec3& x, PathRandom& random) const {
  const glm::dvec3 q = center_ - x;
  const double distance = glm::length(q);
  const bool is_inside = !(radius_ / distance < 1.0);
  const double versine = sphere_versine(x);
  const glm::dvec3 axis = distance > 0.0 ? q / distance : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 w = direction_around(axis, 1.0 - versine * random.uniform(), random);
  // Where the ray enters it, or leaves it from within.
  const double middle = glm::dot(q, w);
  const glm::dvec3 nearest = q - middle * w;
  const double half = std::sqrt(std::max(radius_ * radius_ - glm::dot(nearest, nearest), 0.0));
  const double r = is_inside ? middle + half : middle - half;
  return {x + r * w, 2.0 * pi * versine * r * r / surface_area_};
}

AreaSampler::SeenPoint AreaSampler::seen_on_plane(const glm::dvec3& x, PathRandom& random) const {
  if (!(plane_solid_angle(x) > 0.0)) {
    const Point point = on_surface(random);
    return {point.position, cosine(point, x)};
  }
  const glm::dvec3 q = to_plane(x);
  const SphericalRectangle rectangle(q, half_width_, half_height_);
  const double u = random.uniform();
  const glm::dvec2 place = rectangle.sample(u, random.uniform());
  const glm::dvec2 offset = place - glm::dvec2(q);
  if (is_disk_ && glm::dot(offset, offset) > radius_ * radius_) return {};
  const glm::dvec3 position = center_ + offset.x * right_ + offset.y * up_;
  const glm::dvec3 way = position - x;
  return {position, rectangle.solid_angle() * glm::dot(way, way) / surface_area_};
}

}  // namespace brume
