#include "app/window/dialogs/simplify_dialog.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "app/commands/simplify_gaussians.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/widgets/rows.h"
#include "app/widgets/value_field.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr NumberDomain percent_domain{0.01, 100.0, "a number from 0.01 to 100"};

}  // namespace

SimplifyDialog::SimplifyDialog(const Document& document, QWidget* window)
    : QDialog(window),
      document_(document),
      count_(named(new QLabel(this), "simplify_count")),
      ellipsoids_(named(new QCheckBox(tr("Ellipsoids"), this), "simplify_ellipsoids")) {
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName("simplify_dialog");
  setWindowTitle(tr("Simplify"));
  auto* error = new ValueField(tr("Max error [%]"), percent_domain, ValueField::Scale::logarithmic,
                               0.02, this);
  error->setObjectName("simplify_error");
  error->setToolTip(
      tr("Gaussians that overlap are merged while lines through the fog keep their optical depth "
         "up to this, relative RMS"));
  error->show_value(percent_);
  connect(error, &ValueField::edited, this, [this, error](double percent) {
    percent_ = percent;
    error->show_value(percent);
    show_count();
  });
  connect(error, &ValueField::refused, count_, &QLabel::setText);
  ellipsoids_->setToolTip(
      tr("What is merged may be ellipsoids: fewer are left along strands and layers of fog. Else "
         "it is balls"));
  ellipsoids_->setChecked(true);
  auto* simplify = named(new QPushButton(tr("Simplify")), "simplify_now");
  auto* form = new QFormLayout(this);
  form->addRow(count_);
  form->addRow(error->detach_title(), error);
  form->addRow(ellipsoids_);
  form->addRow(dialog_buttons(this, simplify, [this] {
    Q_EMIT requested({.max_error = 0.01 * percent_, .ellipsoids = ellipsoids_->isChecked()});
    accept();
  }));
  on_change(document, Change::selection, this, &SimplifyDialog::show_count);
  show_count();
}

void SimplifyDialog::show_count() {
  const QString count = gaussians_text(to_simplify(document_).size());
  count_->setText(document_.selection().empty() ? tr("Merges all %1").arg(count)
                                                : tr("Merges %1, selected").arg(count));
}

}  // namespace brume
