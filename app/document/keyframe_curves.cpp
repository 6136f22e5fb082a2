#include "app/document/keyframe_curves.h"

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>

#include "app/document/visit_keyed_part.h"

namespace brume {
namespace {

template <class T>
constexpr int components_of = std::is_same_v<T, double>       ? 1
                              : std::is_same_v<T, glm::dvec2> ? 2
                                                              : 3;

template <class T>
auto& number_of(T& value, int component) {
  if constexpr (std::is_same_v<std::remove_const_t<T>, double>) {
    return value;
  } else {
    return value[component];
  }
}

QString curve_title(const char* name, int component, int count, const NumberDomain& domain) {
  QString title = QString(name).replace('_', ' ');
  if (count == 1) return title;
  // Places and directions have axes, light and albedo channels.
  const bool has_axes = domain.min_value < 0.0;
  return title + ' ' + (has_axes ? "xyz" : "rgb")[component];
}

bool may_vanish(const char* name) {
  return std::strcmp(name, "direction") != 0 && std::strcmp(name, "up") != 0;
}

}  // namespace

double Curve::at(double time) const {
  return std::visit(
      [&](const auto& of) {
        const auto now = value_at(of, time);
        return number_of(now, component);
      },
      keys);
}

std::vector<Curve::Point> Curve::points() const {
  std::vector<Point> points;
  std::visit(
      [&](const auto& of) {
        for (const auto& key : of) {
          points.push_back({key.time, number_of(key.value, component), key.interpolation});
        }
      },
      keys);
  return points;
}

std::vector<Curve> curves_of(const Scene& scene, const Track& row) {
  std::vector<Curve> curves;
  const ScenePart part = scene_part(scene, row.part);
  std::size_t i = 0;
  visit_keyed_part(part, [&]<class T>(const char* name, const auto&, const Keys<T>& keys,
                                      const NumberDomain& domain) {
    const std::size_t value = i++;
    if (value < row.first || value >= row.first + row.count || keys.empty()) return;
    constexpr int count = components_of<T>;
    for (int k = 0; k < count; ++k) {
      curves.push_back({value, k, curve_title(name, k, count, domain), keys});
    }
  });
  return curves;
}

void set_key_value(ScenePart& part, const Curve& curve, double time, double value) {
  std::size_t i = 0;
  visit_keyed_part(
      part, [&]<class T>(const char* name, const auto&, Keys<T>& keys, const NumberDomain& domain) {
        if (i++ != curve.value || curve.component >= components_of<T>) return;
        const auto at = find_key(keys, time);
        if (at == keys.end()) return;
        T changed = at->value;
        number_of(changed, curve.component) =
            domain.open ? value : std::clamp(value, domain.min_value, domain.max_value);
        if (!domain.contains(number_of(changed, curve.component))) return;
        if constexpr (components_of<T> == 3) {
          if (!may_vanish(name) && glm::length(changed) == 0.0) return;
        }
        keys[static_cast<std::size_t>(at - keys.begin())].value = changed;
      });
}

}  // namespace brume
