#include "core/authoring/eraser.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace brume {

namespace {

// Whether a cone may touch a center: nearly all it does not, and this takes no square root.
bool may_touch(const EraserCone& cone, const glm::dvec3& center) {
  const glm::dvec3 view = center - cone.eye;
  const double along = glm::dot(view, cone.direction);
  const double reach = cone.reach(along);
  const glm::dvec3 across = view - along * cone.direction;
  return along > 0.0 && glm::dot(across, across) <= 1.000001 * reach * reach;
}

// One that holds all of some with one eye; nullopt if they are too far apart.
std::optional<EraserCone> hull(std::span<const EraserCone> cones) {
  if (cones.empty()) return std::nullopt;
  glm::dvec3 sum(0.0);
  for (const EraserCone& cone : cones) {
    if (cone.eye != cones[0].eye || cone.radius > 0.0) return std::nullopt;
    sum += cone.direction;
  }
  if (!(glm::length(sum) > 0.0)) return std::nullopt;
  const glm::dvec3 axis = glm::normalize(sum);
  double angle = 0.0;
  for (const EraserCone& cone : cones) {
    const double apart = std::acos(std::min(glm::dot(cone.direction, axis), 1.0));
    angle = std::max(angle, apart + std::atan(cone.slope));
  }
  constexpr double widest = 1.4;
  if (!(angle < widest)) return std::nullopt;
  return EraserCone{cones[0].eye, axis, std::tan(angle + 1e-6)};
}

}  // namespace

double eraser_cover(const EraserCone& cone, const glm::dvec3& center) {
  const glm::dvec3 view = center - cone.eye;
  const double along = glm::dot(view, cone.direction);
  if (!(along > 0.0)) return 0.0;
  const double x = glm::length(view - along * cone.direction) / cone.reach(along);
  return x < 1.0 ? (1.0 - x * x) * (1.0 - x * x) : 0.0;
}

MediumEdit EraserStroke::touch(const Medium& medium, std::span<const EraserCone> cones,
                               const std::function<bool(GaussianId)>& may_erase) {
  std::vector<GaussianId> thinned_ids;
  std::vector<Gaussian> after;
  std::vector<GaussianId> erased_ids;
  const std::optional<EraserCone> all = hull(cones);
  for (std::size_t i = 0; i < medium.size(); ++i) {
    if (all && !may_touch(*all, medium.centers()[i])) continue;
    const GaussianId id = medium.ids()[i];
    Touched* touched = nullptr;
    for (const EraserCone& cone : cones) {
      if (!may_touch(cone, medium.centers()[i])) continue;
      const double cover = eraser_cover(cone, medium.centers()[i]);
      if (!(cover > 0.0)) continue;
      if (!touched && !may_erase(id)) break;
      touched = &touched_.try_emplace(id, Touched{medium.densities()[i], 0.0}).first->second;
      touched->erased += strength_ * cover;
    }
    if (!touched) continue;
    // Rounding shall not leave a trace of what ten tenths have taken away.
    if (touched->erased > 1.0 - 1e-9) {
      erased_ids.push_back(id);
      continue;
    }
    thinned_ids.push_back(id);
    after.push_back(medium.gaussian(i));
    after.back().density = touched->density * (1.0 - touched->erased);
  }
  MediumEdit edit = MediumEdit::change(medium, thinned_ids, after);
  edit.merge(MediumEdit::remove(medium, erased_ids));
  return edit;
}

}  // namespace brume
