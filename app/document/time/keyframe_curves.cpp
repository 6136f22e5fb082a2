#include "app/document/time/keyframe_curves.h"

#include <QCoreApplication>

#include "app/document/time/visit_keyed_part.h"
#include "core/scene/animation/keys_in_domain.h"

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

}  // namespace

double Curve::at(double time) const {
  return std::visit(
      [&](const auto& of) {
        const auto now = value_at(of, time, domain);
        return number_of(now, component);
      },
      keys);
}

double Curve::key_value(double time) const {
  return std::visit(
      [&](const auto& all) {
        const auto found = find_key(all, time);
        return found == all.end() ? 0.0 : number_of(found->value, component);
      },
      keys);
}

std::vector<Curve::Point> Curve::points() const {
  std::vector<Point> points;
  std::visit(
      [&](const auto& of) {
        for (std::size_t i = 0; i < of.size(); ++i) {
          const auto [in, out] = slopes_at(of, i);
          points.push_back({of[i].time,
                            number_of(of[i].value, component),
                            of[i].interpolation,
                            tangents_of(of[i]),
                            {number_of(in, component), number_of(out, component)}});
        }
      },
      keys);
  return points;
}

std::vector<Curve> curves_of(const Scene& scene, const Track& row) {
  std::vector<Curve> curves;
  std::size_t i = 0;
  visit_scene_values(
      scene, row.part,
      [&]<class T>(const char* name, const auto&, const Keys<T>& keys, const NumberDomain& domain) {
        const std::size_t value = i++;
        if (!row.has_value(value) || keys.empty()) return;
        if constexpr (std::is_same_v<T, glm::dquat>) {
          const QString title = QCoreApplication::translate("Curves", "turned, degrees");
          curves.push_back({{value, 0}, 0, title, domain, turned_angles(keys), true});
        } else {
          constexpr int count = components_of<T>;
          for (int k = 0; k < count; ++k) {
            curves.push_back({{value, k}, 0, curve_title(name, k, count, domain), domain, keys});
          }
        }
      });
  return curves;
}

namespace {

// Calls visit(keys, index, name, domain) for the key of a curve at a time; a rotation has none.
void visit_key(ScenePart& part, const CurveId& curve, double time, auto&& visit) {
  std::size_t i = 0;
  visit_keyed_part(
      part, [&]<class T>(const char* name, const auto&, Keys<T>& keys, const NumberDomain& domain) {
        if (i++ != curve.value) return;
        if constexpr (!std::is_same_v<T, glm::dquat>) {
          const auto found = find_key(keys, time);
          if (found == keys.end() || curve.component >= components_of<T>) return;
          visit(keys, static_cast<std::size_t>(found - keys.begin()), name, domain);
        }
      });
}

}  // namespace

void set_key_value(ScenePart& part, const CurveId& curve, double time, double value) {
  visit_key(
      part, curve, time,
      [&]<class T>(Keys<T>& keys, std::size_t i, const char* name, const NumberDomain& domain) {
        T changed = keys[i].value;
        number_of(changed, curve.component) = domain.nearest(value);
        if (may_be_value(name, changed)) keys[i].value = changed;
      });
}

void set_tangent(ScenePart& part, const CurveId& curve, const TangentEdit& edit) {
  visit_key(part, curve, edit.time,
            [&]<class T>(Keys<T>& keys, std::size_t i, const char*, const NumberDomain&) {
              Key<T>& key = keys[i];
              const bool both = !edit.alone && tangents_of(key) != Tangents::free;
              auto [in, out] = slopes_at(keys, i);
              const double slope = domain::slope.nearest(edit.slope);
              if (both || edit.side == TangentSide::in) number_of(in, curve.component) = slope;
              if (both || edit.side == TangentSide::out) number_of(out, curve.component) = slope;
              key.in = in;
              key.out = out;
              key.aligned = both;
            });
}

}  // namespace brume
