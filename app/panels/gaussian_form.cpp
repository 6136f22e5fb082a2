#include "app/panels/gaussian_form.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <optional>
#include <vector>

#include "app/commands/edit_medium.h"
#include "app/document/document.h"
#include "app/widgets/number_field.h"
#include "app/widgets/optics_editor.h"
#include "app/widgets/value_field.h"

namespace brume {
namespace {

constexpr double step = 0.01;  // u, or part of the value, for each pixel of a drag

using Values = std::array<double, shape_attributes>;

// The first selected Gaussian's numbers, and which of them all have.
struct Common {
  Values values{};
  std::array<bool, shape_attributes> is_mixed{};
  GaussianOptics optics{};
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
    if (next == selection.begin()) common.optics = gaussian.optics;
    for (std::size_t k = 0; k < shape_attributes; ++k) {
      const double value = attribute_value(gaussian, gaussian_attributes[k]);
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
    const GaussianAttribute field = gaussian_attributes[k];
    const bool is_center = k < 3;
    fields_[k] = new ValueField(
        is_center ? QString(QChar("xyz"[k])) : attribute_title(field), attribute_domain(field),
        is_center ? ValueField::Scale::linear : ValueField::Scale::logarithmic, step, this);
    if (is_center || field == GaussianAttribute::radius) fields_[k]->number().show_length_unit();
    fields_[k]->number().setObjectName(attribute_name(field).replace(' ', '_'));
    connect(fields_[k], &ValueField::edited, this, [this, field](double value, MergeId gesture) {
      const std::vector<GaussianId> ids = document_.selection();
      set_attribute(document_, ids, field, value, gesture);
    });
    connect(fields_[k], &ValueField::adjusted, this, [this, field](const Adjustment& adjustment) {
      const std::vector<GaussianId> ids = document_.selection();
      adjust_attribute(document_, ids, field, adjustment);
    });
    connect(fields_[k], &ValueField::refused, this, &GaussianForm::refused);
  }
  auto* center = new QHBoxLayout;
  for (std::size_t k = 0; k < 3; ++k) center->addWidget(fields_[k]);
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(8, 8, 8, 4);
  layout->addRow(tr("Center"), center);
  for (const std::size_t k : {3U, 4U}) {
    QLabel* title = fields_[k]->detach_title();
    title->setObjectName(fields_[k]->number().objectName() + "_title");
    layout->addRow(title, fields_[k]);
  }

  optics_ = new OpticsEditor(*layout, tr("Emission"), "gaussian", this);
  connect(optics_, &OpticsEditor::refused, this, &GaussianForm::refused);
  connect(optics_, &OpticsEditor::edited, this, &GaussianForm::change_optics);

  // What Gaussians without their own albedo show.
  connect(&document_, &Document::part_changed, this, [this] {
    if (document_.scene().optics.albedo != shown_albedo_) refresh();
  });
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
  shown_albedo_ = document_.scene().optics.albedo;
  optics_->show_optics(any ? std::optional(common.optics) : std::nullopt, shown_albedo_);
}

void GaussianForm::change_optics(const OpticsEditor::Change& change, MergeId gesture) {
  const std::vector<GaussianId> ids = document_.selection();
  std::vector<Gaussian> after;
  for (const GaussianId id : ids) {
    after.push_back(document_.medium().gaussian(*document_.medium().index_of(id)));
    change(after.back().optics);
  }
  change_gaussians(document_, ids, after, tr("Set colours of %1").arg(gaussians_text(ids.size())),
                   gesture);
}

}  // namespace brume
