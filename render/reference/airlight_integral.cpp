#include "render/reference/airlight_integral.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/math/quadrature.h"
#include "core/transport/phase_function.h"
#include "core/transport/view_line.h"

namespace brume {
namespace {

// Optical depth beyond which nothing returns: exp(-45) = 3e-20.
template <class Real>
constexpr Real opaque = Real(45);

// Gaussians are followed to this many radii from their centre, where they are down to 1e-7.
template <class Real>
constexpr Real extent = Real(4);

// Maximum length of initial intervals in radii: the 15-point rule then detects every Gaussian,
// integrates it to about 1e-6, and refines where needed.
template <class Real>
constexpr Real interval_radii = Real(6);

}  // namespace

template <class Real>
ViewRayMedium<Real>::ViewRayMedium(std::span<const GaussianTerm<Real>> gaussians, Real b0_,
                                   const Vec3<Real>& eye_, const Vec3<Real>& w_, Real d_,
                                   const RayNoise& noise, std::span<const RelativeOptics> optics,
                                   const FogInterval& fog_)
    : eye(eye_), w(w_), d(d_), b0(b0_), fog(fog_) {
  Real total = 0;
  for (std::size_t i = 0; i < gaussians.size(); ++i) {
    const GaussianTerm<Real>& g = gaussians[i];
    const LineProfile<Real> line = view_line_profile(g, eye, w, noise);
    if (!optics.empty()) optics_.push_back({line.a, line.t0, g.c * std::exp(-line.e), optics[i]});
    crossings_.add(g, line);
    total += optical_depth(g, line, d);
  }
  crossings_.finish();
  for (const auto& c : crossings_.all()) {
    const Real begin = std::max(c.t0 - extent<Real> / c.a, Real(0));
    const Real end = std::min(c.t0 + extent<Real> / c.a, d);
    // What is a millionth of the ray's depth is left to the adaptive rule.
    if (begin < end && 2 * c.scale > Real(1e-6) * total) {
      features_.push_back({begin, end, interval_radii<Real> / c.a});
    }
  }
}

template <class Real>
typename Crossings<Real>::Sums ViewRayMedium<Real>::at(Real t) const {
  auto sums = crossings_.at(t);
  const auto in_fog = static_cast<Real>(fog.before(static_cast<double>(t)));
  sums.depth = std::max(sums.depth, Real(0)) + (b0 > 0 ? b0 * in_fog : Real(0));
  return sums;
}

template <class Real>
RelativeOptics ViewRayMedium<Real>::optics_at(Real t) const {
  if (optics_.empty()) return {};
  OpticsMean mean(static_cast<double>(homogeneous_density(t)));
  for (const OpticsCrossing& c : optics_) {
    const Real u = c.a * (t - c.t0);
    mean.add(static_cast<double>(c.peak * std::exp(-u * u)), c.optics);
  }
  return mean.mean();
}

template <class Real>
Real ViewRayMedium<Real>::parameter_at_depth(Real level) const {
  Real lo = 0;
  Real hi = d;
  if (!std::isfinite(hi)) {
    if (!(depth(hi) > level)) return d;
    for (hi = 1; !(depth(hi) > level); hi *= 2) lo = hi;
  } else if (!(depth(hi) > level)) {
    return d;
  }
  for (int i = 0; i < 200; ++i) {
    const Real center = Real(0.5) * (lo + hi);
    if (!(lo < center && center < hi)) break;
    (depth(center) < level ? lo : hi) = center;
  }
  return hi;
}

namespace {

// An interval of the equi-angular variable with structure, and the longest interval integrated in
// one piece: `longest_t` along the ray, `longest_phi` in angle.
template <class Real>
struct AngularFeature {
  Real begin, end;
  Real longest_t, longest_phi;
};

template <class Real>
class Subdivision {
 public:
  Subdivision(const EquiAngular<Real>& angular, std::vector<Real>& breakpoints)
      : angular_(angular), breakpoints_(breakpoints) {}

  // Appends the ends of the pieces of (begin, end].
  void split(Real begin, Real end, const std::vector<AngularFeature<Real>>& features,
             int depth = 0) {
    std::vector<AngularFeature<Real>> inside;
    bool too_long = false;
    const Real length_t = angular_.t(end) - angular_.t(begin);
    for (const AngularFeature<Real>& f : features) {
      if (f.end <= begin || f.begin >= end) continue;
      inside.push_back(f);
      too_long = too_long || !(length_t <= f.longest_t) || end - begin > f.longest_phi;
    }
    const Real center = Real(0.5) * (begin + end);
    if (too_long && depth < 50 && begin < center && center < end && breakpoints_.size() < 4096) {
      split(begin, center, inside, depth + 1);
      split(center, end, inside, depth + 1);
    } else {
      breakpoints_.push_back(end);
    }
  }

 private:
  const EquiAngular<Real>& angular_;
  std::vector<Real>& breakpoints_;
};

// Position of a Gaussian in the fan of rays from the light to the view ray, as the feature
// that its shadow is.
template <class Real>
void add_shadow(const GaussianTerm<Real>& g, const ViewRayMedium<Real>& medium,
                const LightSource<Real>& light, const EquiAngular<Real>& angular, Real tolerance,
                std::vector<AngularFeature<Real>>& features) {
  // In the plane of light and ray: x along the ray, y from the light towards it.
  Vec3<Real> q = g.b - light.position;
  const Vec3<Real> to_eye = medium.eye - light.position;
  Vec3<Real> down = to_eye + angular.path.ts * medium.w;
  const Real length = glm::length(down);
  const Real peak = g.c / g.a * std::sqrt(std::numbers::pi_v<Real>);
  if (!(peak > tolerance)) return;
  if (!(length > 0)) return;  // the light is on the ray: there is no plane, and no shadow edge
  down /= length;
  const Vec3<Real> normal = glm::cross(medium.w, down);
  const Real offset = glm::dot(q, normal);
  const Real across = g.a * offset / (g.ellipsoid ? g.ellipsoid->reach(normal) : Real(1));
  if (!(peak * std::exp(-across * across) > tolerance)) return;
  if (g.ellipsoid) {  // where it is densest in the plane
    const Vec3<Real> image = g.ellipsoid->squared(normal);
    q -= offset / glm::dot(normal, image) * image;
  }
  const Real x = glm::dot(q, medium.w);
  const Real y = glm::dot(q, down);
  const Real distance = std::hypot(x, y);
  // Across the ray of the fan through its center.
  const Vec3<Real> aside =
      distance > 0 ? (y * medium.w - x * down) / distance : Vec3<Real>(medium.w);
  Real half = 1 / g.a;
  if (g.ellipsoid) {  // of its section with the plane
    const Vec3<Real> u = g.ellipsoid->warp * aside;
    const Vec3<Real> v = g.ellipsoid->warp * glm::cross(normal, aside);
    half *= glm::length(v) / glm::length(glm::cross(u, v));
  }
  const Real width = distance > 0 ? half / distance : Real(10);
  if (width > Real(0.5)) return;  // as wide as the fan: the adaptive rule resolves it
  const Real start = std::atan2(-angular.path.ts, angular.path.h);
  const Real phi = std::atan2(x, y) - start;
  features.push_back({phi - extent<Real> * width, phi + extent<Real> * width,
                      std::numeric_limits<Real>::infinity(), interval_radii<Real> * width});
}

// Splits the range that holds t.
template <class Real>
void split_at(Real t, std::vector<std::pair<Real, Real>>& ranges) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const auto [begin, end] = ranges[i];
    if (!(begin < t && t < end)) continue;
    ranges[i].second = t;
    ranges.insert(ranges.begin() + static_cast<std::ptrdiff_t>(i) + 1, {t, end});
    return;
  }
}

}  // namespace

template <class Real>
Real airlight_integral(const ViewRayMedium<Real>& medium, const LightSource<Real>& light,
                       Real tolerance, ScatteredBy scattered_by) {
  const PointLightRay<Real> path(light.position, medium.eye, medium.w, light.h_min);
  const Real end_t = medium.parameter_at_depth(opaque<Real>);
  const EquiAngular<Real> angular(path, end_t);
  if (!(angular.span > 0)) return 0;

  // A Gaussian farther than its reach from a path takes less than a thousandth of the tolerance.
  GaussiansAroundLight<Real> around_light(light.position);
  std::vector<const GaussianTerm<Real>*> near_light;
  for (const GaussianTerm<Real>& g : light.gaussians) {
    const Real peak = g.c / g.a * std::sqrt(std::numbers::pi_v<Real>);
    const Real eps = Real(1e-3) * tolerance / Real(light.gaussians.size());
    if (!(peak > eps)) continue;
    around_light.add(g, std::sqrt(std::log(peak / eps)) / g.a);
    near_light.push_back(&g);
  }
  around_light.finish();
  const auto integrand = [&](Real phi) {
    const Real t = std::min(angular.t(phi), end_t);
    const auto [gaussian_density, view_depth] = medium.at(t);
    Real density = scattered_by == ScatteredBy::homogeneous ? Real(0) : gaussian_density;
    if (scattered_by != ScatteredBy::gaussians) density += medium.homogeneous_density(t);
    if (!(density > 0) || view_depth > opaque<Real>) return Real(0);
    if (medium.has_optics()) density *= static_cast<Real>(medium.optics_at(t).albedo);
    const Vec3<Real> q = medium.eye + t * medium.w - light.position;
    const Real r = glm::length(q);
    const Real falloff = r > 0 ? static_cast<Real>(light.falloff.at(glm::dvec3(q / r))) : Real(1);
    if (!(falloff > 0)) return Real(0);
    Real fog_length = r;
    if (!light.fog.is_endless() && r > 0) {
      const glm::dvec3 x(medium.eye + t * medium.w);
      fog_length =
          static_cast<Real>(light.fog.length(x, -glm::dvec3(q / r), static_cast<double>(r)));
    }
    const Real light_depth =
        r > 0 ? around_light.depth(q / r, r) + medium.b0 * fog_length : Real(0);
    const Real phase =
        light.anisotropy != 0 ? henyey_greenstein(path.cos_theta(t), light.anisotropy) : Real(1);
    return phase * density * falloff * std::exp(-(view_depth + light_depth));
  };

  std::vector<AngularFeature<Real>> features;
  const Real unbounded = std::numeric_limits<Real>::infinity();
  for (const auto& f : medium.features()) {
    if (f.begin < end_t) {
      features.push_back({angular.angle(f.begin), angular.angle(f.end), f.longest, unbounded});
    }
  }
  for (const GaussianTerm<Real>* g : near_light) {
    add_shadow(*g, medium, light, angular, tolerance, features);
  }
  // In dense media all happens within the first few units of depth.
  std::vector<Real> levels;
  if (medium.depth(end_t) > Real(4)) {
    for (const Real level : {Real(0.3), Real(1.5), Real(5), Real(14)}) {
      const Real t = medium.parameter_at_depth(level);
      if (t < end_t) levels.push_back(angular.angle(t));
    }
  }

  Integral<Real> sum;
  std::vector<std::pair<Real, Real>> ranges{{Real(0), end_t}};
  if (light.lit) ranges = *light.lit;
  for (const double edge : light.falloff.edges(glm::dvec3(light.position), glm::dvec3(medium.eye),
                                               glm::dvec3(medium.w))) {
    split_at(static_cast<Real>(edge), ranges);
  }
  split_at(static_cast<Real>(medium.fog.begin), ranges);
  split_at(static_cast<Real>(medium.fog.end), ranges);
  for (const auto& [begin_t, stop_t] : ranges) {
    const Real begin = angular.angle(begin_t);
    const Real end = std::min(angular.angle(stop_t), angular.span);
    if (!(begin < end)) continue;
    std::vector<Real> breakpoints{begin};
    Subdivision<Real> subdivision(angular, breakpoints);
    for (const Real level : levels) {
      if (level > breakpoints.back() && level < end) {
        subdivision.split(breakpoints.back(), level, features);
      }
    }
    subdivision.split(breakpoints.back(), end, features);
    sum.value += integrate<Real>(integrand, breakpoints, tolerance).value;
  }
  return sum.value / (4 * std::numbers::pi_v<Real> * path.h);
}

glm::dvec3 emission_integral(const ViewRayMedium<double>& medium, double tolerance) {
  glm::dvec3 sum(0.0);
  if (!medium.has_optics()) return sum;
  const double end = medium.parameter_at_depth(opaque<double>);
  // Of the Gaussians' extents, in pieces that the rule detects each of them in.
  std::vector<double> breakpoints;
  const auto add = [&](double t) {
    if (t >= 0.0 && t < end) breakpoints.push_back(t);
  };
  double last = 0.0;
  for (const auto& feature : medium.features()) {
    const double pieces = std::ceil(3.0 * (feature.end - feature.begin) / feature.longest);
    for (double k = 0.0; k <= pieces; ++k) {
      add(feature.begin + (feature.end - feature.begin) * k / pieces);
    }
    last = std::max(last, std::min(feature.end, end));
  }
  if (breakpoints.empty()) return sum;
  for (const double level : {0.3, 1.5, 5.0, 14.0}) add(medium.parameter_at_depth(level));
  breakpoints.push_back(last);
  std::ranges::sort(breakpoints);
  const auto repeated = std::ranges::unique(breakpoints);
  breakpoints.erase(repeated.begin(), repeated.end());
  for (int c = 0; c < 3; ++c) {
    const auto radiance = [&](double t) {
      const auto [density, depth] = medium.at(t);
      return (density + medium.homogeneous_density(t)) * medium.optics_at(t).emission[c] *
             std::exp(-depth);
    };
    sum[c] = integrate<double>(radiance, breakpoints, tolerance).value;
  }
  return sum;
}

template class ViewRayMedium<double>;
template class ViewRayMedium<float>;
template double airlight_integral(const ViewRayMedium<double>&, const LightSource<double>&, double,
                                  ScatteredBy);
template float airlight_integral(const ViewRayMedium<float>&, const LightSource<float>&, float,
                                 ScatteredBy);

}  // namespace brume
