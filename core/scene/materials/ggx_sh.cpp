#include "core/scene/materials/ggx_sh.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math/sphere_rule.h"

namespace brume {
namespace {

using std::numbers::pi;

using Row = std::array<double, GgxSh::coefficients>;

void add(Row& row, double weight, const ShVector<double>& y) {
  std::size_t index = 0;
  for (int l = 0; l < sh_max_bands; ++l) {
    for (int m = 0; m <= l; ++m) row[index++] += weight * y[sh_index(l, m)];
  }
}

void store(const Row& row, float* values) {
  std::ranges::transform(row, values, [](double x) { return static_cast<float>(x); });
}

double fresnel_weight(double v_dot_h) {
  return std::pow(1.0 - std::clamp(v_dot_h, 0.0, 1.0), 5.0);
}

// Calls visit(u in (0, 1), azimuth in (0, pi), weight) for a rule over [0, 1] x [0, 2 pi]; what is
// integrated is even in the azimuth.
void for_each_node(auto&& visit) {
  static const QuadratureRule rule = gauss_legendre(48);
  constexpr int azimuths = 32;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    for (int k = 0; k < azimuths; ++k) {
      visit(0.5 * (1.0 + rule.nodes[i]), (k + 0.5) * pi / azimuths,
            0.5 * rule.weights[i] * 2.0 * pi / azimuths);
    }
  }
}

glm::dvec3 direction(double cosine, double phi) {
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

Row diffuse_row(double theta_o) {
  const glm::dvec3 wo(std::sin(theta_o), 0.0, std::cos(theta_o));
  Row row{};
  for_each_node([&](double cosine, double phi, double weight) {
    const glm::dvec3 wi = direction(cosine, phi);
    const double s = fresnel_weight(0.5 * glm::length(wi + wo));
    add(row, weight * cosine / pi * (1.0 - s), sh_basis(sh_max_bands, wi));
  });
  return row;
}

// Over half vectors, in proportion to D N.H, so that highlights of all widths are as easy.
void specular_rows(double alpha, double theta_o, Row& scaled, Row& added) {
  const glm::dvec3 wo(std::sin(theta_o), 0.0, std::cos(theta_o));
  const double cos_eye = std::max(wo.z, min_ggx_cosine);
  for_each_node([&](double u, double phi, double weight) {
    const double cos_h = std::sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u));
    const glm::dvec3 h = direction(cos_h, phi);
    const double v_dot_h = glm::dot(wo, h);
    const glm::dvec3 wi = 2.0 * v_dot_h * h - wo;
    if (!(v_dot_h > 0.0) || !(wi.z > 0.0)) return;
    // Light moves four times as far as the half vector does; D N.H dH = du dphi / (2 pi).
    const double value =
        weight / (2.0 * pi) * 4.0 * v_dot_h / cos_h * wi.z * ggx_visibility(alpha, wi.z, cos_eye);
    const double s = fresnel_weight(v_dot_h);
    const ShVector<double> y = sh_basis(sh_max_bands, wi);
    add(scaled, value * (1.0 - s), y);
    add(added, value * s, y);
  });
}

// The position of x in [0, 1] among `count` intervals.
struct Position {
  std::size_t below;
  double fraction;

  Position(double x, int count) {
    const double place = std::clamp(x, 0.0, 1.0) * count;
    below = static_cast<std::size_t>(std::min(std::floor(place), count - 1.0));
    fraction = place - static_cast<double>(below);
  }
};

}  // namespace

const GgxSh& GgxSh::table() {
  static const GgxSh table;
  return table;
}

GgxSh::GgxSh() {
  constexpr std::size_t angles = angle_intervals + 1;
  constexpr std::size_t all = (roughness_intervals + 1) * angles;
  diffuse_.assign(angles * row_size, 0.0f);
  scaled_.assign(all * row_size, 0.0f);
  added_.assign(all * row_size, 0.0f);
  tbb::parallel_for(std::size_t{0}, angles, [&](std::size_t angle) {
    const double theta_o = 0.5 * pi * static_cast<double>(angle) / angle_intervals;
    store(diffuse_row(theta_o), diffuse_.data() + angle * row_size);
    for (std::size_t r = 0; r <= roughness_intervals; ++r) {
      const double roughness = static_cast<double>(r) / roughness_intervals;
      Row scaled{};
      Row added{};
      specular_rows(std::max(roughness * roughness, GgxReflection::min_alpha), theta_o, scaled,
                    added);
      const std::size_t first = (r * angles + angle) * row_size;
      store(scaled, scaled_.data() + first);
      store(added, added_.data() + first);
    }
  });
}

ShVector<glm::dvec3> GgxSh::operator()(const GgxReflection& reflection, double cos_theta_o) const {
  const Position angle(std::acos(std::clamp(cos_theta_o, 0.0, 1.0)) / (0.5 * pi), angle_intervals);
  const Position roughness(std::sqrt(reflection.alpha), roughness_intervals);
  const auto along_angle = [&](const std::vector<float>& table, std::size_t row, std::size_t i) {
    const double a = table[row * row_size + i];
    return a + angle.fraction * (table[(row + 1) * row_size + i] - a);
  };
  const std::size_t row = roughness.below * (angle_intervals + 1) + angle.below;
  const auto row_at = [&](const std::vector<float>& table, std::size_t i) {
    const double a = along_angle(table, row, i);
    return a + roughness.fraction * (along_angle(table, row + angle_intervals + 1, i) - a);
  };
  ShVector<glm::dvec3> result(sh_max_bands);
  std::size_t index = 0;
  for (int l = 0; l < sh_max_bands; ++l) {
    for (int m = 0; m <= l; ++m, ++index) {
      result[sh_index(l, m)] = reflection.diffuse * along_angle(diffuse_, angle.below, index) +
                               reflection.f0 * row_at(scaled_, index) +
                               glm::dvec3(row_at(added_, index));
    }
  }
  return result;
}

}  // namespace brume
