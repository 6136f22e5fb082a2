#include "core/scene/lights/radiance_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/sphere_rule.h"

namespace brume {
namespace {

using std::numbers::pi;

}  // namespace

namespace {

template <class Real>
glm::vec<2, Real> position_of(const RadianceMap& map, const glm::vec<3, Real>& d) {
  // acos(y) loses half its digits near the poles.
  const Real polar = std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y);
  const Real azimuth = std::atan2(d.x, -d.z);
  return {(Real(0.5) + azimuth / Real(2.0 * pi)) * Real(map.width),
          polar / Real(pi) * Real(map.height)};
}

template <class Real>
glm::vec<3, Real> radiance_of(const RadianceMap& map, const glm::vec<3, Real>& direction) {
  using Color = glm::vec<3, Real>;
  const glm::vec<2, Real> position = position_of(map, direction) - Real(0.5);
  const Real column = std::floor(position.x);
  const Real row = std::floor(position.y);
  const Real s = position.x - column;
  const Real t = position.y - row;
  const int x0 = (static_cast<int>(column) + map.width) % map.width;
  const int x1 = (x0 + 1) % map.width;
  const int y0 = std::clamp(static_cast<int>(row), 0, map.height - 1);
  const int y1 = std::clamp(static_cast<int>(row) + 1, 0, map.height - 1);
  const auto along = [&](int y) {
    const Color left(map.pixel(x0, y));
    return left + s * (Color(map.pixel(x1, y)) - left);
  };
  const Color above = along(y0);
  return above + t * (along(y1) - above);
}

}  // namespace

glm::dvec2 map_position(const RadianceMap& map, const glm::dvec3& d) {
  return position_of(map, d);
}

glm::dvec3 map_direction(const RadianceMap& map, const glm::dvec2& position) {
  const double azimuth = (position.x / map.width - 0.5) * 2.0 * pi;
  const double polar = position.y / map.height * pi;
  const double r = std::sin(polar);
  return {r * std::sin(azimuth), std::cos(polar), -r * std::cos(azimuth)};
}

glm::dvec3 map_radiance(const RadianceMap& map, const glm::dvec3& direction) {
  return radiance_of(map, direction);
}

glm::vec3 map_radiance(const RadianceMap& map, const glm::vec3& direction) {
  return radiance_of(map, direction);
}

namespace {

constexpr auto orders = static_cast<std::size_t>(sh_max_bands);

// The integrals of cos(m phi) and sin(m phi) over the columns of the map, phi the azimuth.
struct Columns {
  std::array<std::vector<double>, orders> cosine, sine;

  Columns(int width, int order) {
    const double step = 2.0 * pi / width;
    for (int m = 0; m < order; ++m) {
      const double half = 0.5 * step * m;
      const double length = m == 0 ? step : 2.0 * std::sin(half) / m;
      for (int x = 0; x < width; ++x) {
        const double phi = m * ((x + 0.5) * step - pi);
        cosine[static_cast<std::size_t>(m)].push_back(length * std::cos(phi));
        sine[static_cast<std::size_t>(m)].push_back(length * std::sin(phi));
      }
    }
  }
};

// The integral of Y_lm at azimuth 0 over the polar angles of a row, with the sphere's sin(theta).
// For m >= 0; the harmonics of -m differ only in the azimuth.
ShVector<double> row_integral(int row, int height, int order) {
  static const QuadratureRule rule = gauss_legendre(8);
  ShVector<double> sum(order);
  const double step = pi / height;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double theta = (row + 0.5 * (1.0 + rule.nodes[i])) * step;
    const ShVector<double> y = sh_basis(order, glm::dvec3(std::sin(theta), 0.0, std::cos(theta)));
    const double weight = 0.5 * step * rule.weights[i] * std::sin(theta);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * y[k];
  }
  return sum;
}

}  // namespace

ShVector<glm::dvec3> map_sh(const RadianceMap& map, int order) {
  // In a frame whose z is up and whose x is the middle column, so that y is the left, the harmonics
  // are products of a function of the row and one of the column.
  const Columns columns(map.width, order);
  ShVector<glm::dvec3> sum(order);
  for (int row = 0; row < map.height; ++row) {
    std::array<glm::dvec3, orders> even{};
    std::array<glm::dvec3, orders> odd{};
    for (int x = 0; x < map.width; ++x) {
      const glm::dvec3 radiance(map.pixel(x, row));
      for (std::size_t m = 0; m < static_cast<std::size_t>(order); ++m) {
        even[m] += columns.cosine[m][static_cast<std::size_t>(x)] * radiance;
        odd[m] -= columns.sine[m][static_cast<std::size_t>(x)] * radiance;
      }
    }
    const ShVector<double> polar = row_integral(row, map.height, order);
    for (int l = 0; l < order; ++l) {
      for (int m = 0; m <= l; ++m) {
        const auto k = static_cast<std::size_t>(m);
        const double factor = polar[sh_index(l, m)];
        sum[sh_index(l, m)] += factor * even[k];
        if (m > 0) sum[sh_index(l, -m)] += factor * odd[k];
      }
    }
  }
  // x, y, z of that frame are -z, -x, y of the scene.
  const glm::dmat3 to_scene(glm::dvec3(0, 0, -1), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0));
  return sh_rotate(sum, glm::quat_cast(to_scene));
}

}  // namespace brume
