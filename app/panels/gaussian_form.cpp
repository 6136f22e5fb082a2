#include "app/panels/gaussian_form.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <optional>
#include <vector>

#include "app/commands/edit_medium.h"
#include "app/document/document.h"
#include "app/panels/number_field.h"

namespace brume {
namespace {

std::optional<double> common_value(const Document& document, GaussianField field) {
  const Medium& medium = document.medium();
  std::optional<double> common;
  for (const GaussianId id : document.selection()) {
    const double value = field_value(medium.gaussian(*medium.index_of(id)), field);
    if (common && *common != value) return std::nullopt;
    common = value;
  }
  return common;
}

}  // namespace

GaussianForm::GaussianForm(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const GaussianField field = gaussian_fields[k];
    fields_[k] = new NumberField(this);
    fields_[k]->setObjectName(field_name(field).replace(' ', '_'));
    connect(fields_[k], &NumberField::committed, this, [this, field](double value) {
      const std::vector<GaussianId> ids = document_.selection();
      const QString problem = set_field(document_, ids, field, value);
      if (!problem.isEmpty()) Q_EMIT refused(problem);
    });
  }
  auto* center = new QHBoxLayout;
  for (std::size_t k = 0; k < 3; ++k) center->addWidget(fields_[k]);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(8, 8, 8, 4);
  layout->addRow(tr("Center"), center);
  layout->addRow(field_title(GaussianField::radius), fields_[3]);
  layout->addRow(field_title(GaussianField::density), fields_[4]);

  connect(&document_, &Document::scene_replaced, this, &GaussianForm::refresh);
  connect(&document_, &Document::medium_changed, this, &GaussianForm::refresh);
  connect(&document_, &Document::selection_changed, this, &GaussianForm::refresh);
  refresh();
}

void GaussianForm::refresh() {
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    fields_[k]->show_value(common_value(document_, gaussian_fields[k]));
    fields_[k]->setEnabled(!document_.selection().empty());
  }
}

}  // namespace brume
