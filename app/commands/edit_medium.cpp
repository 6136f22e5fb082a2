#include "app/commands/edit_medium.h"

#include <QCoreApplication>
#include <vector>

#include "app/document/document.h"

namespace brume {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Undo", text);
}

void push(Document& document, MediumEdit edit, const QString& text, MergeId merge_id = no_merge) {
  if (edit.empty()) return;  // pushing it would cost the user what can be redone
  document.undo_stack().push(new MediumCommand(document, std::move(edit), text, merge_id));
}

}  // namespace

void add_gaussian(Document& document, const Gaussian& gaussian) {
  const Gaussian added = within_domains(gaussian);
  push(document, MediumEdit::add(document.medium(), {&added, 1}), tr("Add Gaussian"));
}

void delete_selection(Document& document) {
  const std::size_t count = document.selection().size();
  push(document, MediumEdit::remove(document.medium(), document.selection()),
       tr("Delete %1").arg(gaussians_text(count)));
}

QString set_field(Document& document, std::span<const GaussianId> ids, GaussianField field,
                  double value) {
  if (QString problem = field_problem(field, value); !problem.isEmpty()) return problem;
  const Medium& medium = document.medium();
  std::vector<Gaussian> after;
  after.reserve(ids.size());
  for (const GaussianId id : ids) {
    after.push_back(medium.gaussian(*medium.index_of(id)));
    set_field_value(after.back(), field, value);
  }
  push(document, MediumEdit::change(medium, ids, after),
       tr("Set %1 of %2 to %3")
           .arg(field_name(field), gaussians_text(ids.size()), number_text(value)));
  return {};
}

void move_gaussians(Document& document, std::span<const GaussianId> ids,
                    std::span<const glm::dvec3> centers, MergeId merge_id) {
  const Medium& medium = document.medium();
  std::vector<Gaussian> after;
  after.reserve(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    after.push_back(medium.gaussian(*medium.index_of(ids[k])));
    after.back().center = centers[k];
    after.back() = within_domains(after.back());
  }
  push(document, MediumEdit::change(medium, ids, after),
       tr("Move %1").arg(gaussians_text(ids.size())), merge_id);
}

}  // namespace brume
