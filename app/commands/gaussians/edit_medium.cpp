#include "app/commands/gaussians/edit_medium.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/commands/gaussian_budget.h"
#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/text/number_text.h"
#include "core/number_domain.h"

namespace brume {
namespace {

void push(Document& document, MediumEdit edit, const QString& text, MergeId merge_id = no_merge) {
  if (edit.empty()) return;  // pushing it would cost the user what can be redone
  if (!has_room(document, edit.added().size(), edit.removed().size())) return;
  document.undo_stack().push(new MediumCommand(document, std::move(edit), text, merge_id));
}

std::vector<Gaussian> allowed(std::span<const Gaussian> gaussians) {
  std::vector<Gaussian> result;
  result.reserve(gaussians.size());
  for (const Gaussian& gaussian : gaussians) result.push_back(within_domains(gaussian));
  return result;
}

}  // namespace

void add_gaussian(Document& document, const Gaussian& gaussian) {
  if (const QString problem = adding_problem(document); !problem.isEmpty()) {
    Q_EMIT document.refused(problem);
    return;
  }
  Gaussian added = within_domains(gaussian);
  added.group = group_of_new(document);
  push(document, MediumEdit::add(document.medium(), {&added, 1}), undo_text("Add Gaussian"));
}

void add_gaussians(Document& document, std::span<const Gaussian> gaussians, const QString& verb) {
  push(document, MediumEdit::add(document.medium(), allowed(gaussians)),
       undo_text("%1 %2").arg(verb, gaussians_text(gaussians.size())));
}

void replace_gaussians(Document& document, std::span<const GaussianId> removed,
                       std::span<const Gaussian> added, const QString& text) {
  if (!has_room(document, added.size(), removed.size())) return;
  MediumEdit edit = MediumEdit::remove(document.medium(), removed);
  edit.merge(MediumEdit::add(document.medium(), allowed(added)));
  document.undo_stack().push(new MediumCommand(document, std::move(edit), text, no_merge,
                                               AfterAdding::select_like_removed));
}

void delete_selection(Document& document, const QString& verb) {
  const std::size_t count = document.selection().size();
  push(document, MediumEdit::remove(document.medium(), document.selection()),
       undo_text("%1 %2").arg(verb, gaussians_text(count)));
}

void set_homogeneous_density(Document& document, double b0, MergeId merge_id) {
  const QString text = undo_text("Set homogeneous density to %1").arg(number_text(b0));
  const Keys<double>& keys = document.scene().density_keys;
  if (keys.empty()) {
    push(document, MediumEdit::set_homogeneous_density(document.medium(), b0), text, merge_id);
  } else {
    set_scene_part(document, KeyedDensity{b0, keys}, text, merge_id);
  }
}

QString set_attribute_text(GaussianAttribute field, std::size_t count, double value) {
  return undo_text("Set %1 of %2 to %3")
      .arg(attribute_name(field), gaussians_text(count), number_text(value));
}

QString set_attribute(Document& document, std::span<const GaussianId> ids, GaussianAttribute field,
                      double value, MergeId merge_id) {
  if (QString problem = attribute_problem(field, value); !problem.isEmpty()) return problem;
  std::vector<Gaussian> after = document.gaussians(ids);
  for (Gaussian& gaussian : after) {
    set_attribute_value(gaussian, field, value);
    // A thin ellipsoid may have got a radius that is too small.
    if (!gaussian.is_ball()) gaussian = within_domains(gaussian);
  }
  push(document, MediumEdit::change(document.medium(), ids, after),
       set_attribute_text(field, ids.size(), value), merge_id);
  return {};
}

void change_optics(Document& document, std::span<const GaussianId> ids,
                   const std::function<void(GaussianOptics&)>& change, MergeId merge_id) {
  const glm::dvec3& of_medium = document.scene().optics.albedo;
  std::vector<Gaussian> after = document.gaussians(ids);
  for (Gaussian& gaussian : after) {
    const glm::dvec3 old_albedo = gaussian.optics.albedo.value_or(of_medium);
    change(gaussian.optics);
    const glm::dvec3 albedo = gaussian.optics.albedo.value_or(of_medium);
    if (albedo == old_albedo) continue;
    gaussian.density *= extinction_over_density(old_albedo) / extinction_over_density(albedo);
  }
  change_gaussians(document, ids, after,
                   undo_text("Set colours of %1").arg(gaussians_text(ids.size())), merge_id);
}

void adjust_attribute(Document& document, std::span<const GaussianId> ids, GaussianAttribute field,
                      const Adjustment& adjustment) {
  const NumberDomain& domain = attribute_domain(field);
  std::vector<Gaussian> after = document.gaussians(ids);
  for (Gaussian& gaussian : after) {
    const double value = adjustment.of(attribute_value(gaussian, field));
    if (std::isnan(value)) return;  // as of 0 * (1 / 0)
    set_attribute_value(gaussian, field, std::clamp(value, domain.min_value, domain.max_value));
  }
  change_gaussians(
      document, ids, after,
      undo_text("Change %1 of %2").arg(attribute_name(field), gaussians_text(ids.size())),
      no_merge);
}

void change_gaussians(Document& document, std::span<const GaussianId> ids,
                      std::span<const Gaussian> after, const QString& text, MergeId merge_id) {
  push(document, MediumEdit::change(document.medium(), ids, allowed(after)), text, merge_id);
}

}  // namespace brume
