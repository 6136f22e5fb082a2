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

using Values = std::array<double, gaussian_fields.size()>;

// The first selected Gaussian's numbers, and which of them all have.
struct Common {
  Values values{};
  std::array<bool, gaussian_fields.size()> is_mixed{};
};

Common common_values(const Document& document) {
  const Medium& medium = document.medium();
  const std::vector<GaussianId>& selection = document.selection();
  Common common;
  auto next = selection.begin();
  // Both are sorted by id.
  for (std::size_t i = 0; i < medium.size() && next != selection.end(); ++i) {
    if (medium.ids()[i] != *next) continue;
    const Gaussian gaussian = medium.gaussian(i);
    for (std::size_t k = 0; k < gaussian_fields.size(); ++k) {
      const double value = field_value(gaussian, gaussian_fields[k]);
      if (next == selection.begin()) common.values[k] = value;
      if (value != common.values[k]) common.is_mixed[k] = true;
    }
    ++next;
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
  const bool any = !document_.selection().empty();
  const Common common = common_values(document_);
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    if (common.is_mixed[k]) {
      fields_[k]->show_mixed();
    } else {
      fields_[k]->show_value(any ? std::optional(common.values[k]) : std::nullopt);
    }
    fields_[k]->setEnabled(any);
  }
}

}  // namespace brume
