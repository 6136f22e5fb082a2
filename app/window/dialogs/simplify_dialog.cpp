#include "app/window/dialogs/simplify_dialog.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "app/commands/gaussians/simplify_gaussians.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/text/number_text.h"
#include "app/panels/forms/numbers_form.h"
#include "app/widgets/rows.h"

namespace brume {
SimplifyDialog::SimplifyDialog(Document& document, QWidget* window)
    : QDialog(window),
      document_(document),
      count_(named(new QLabel(this), "simplify_count")),
      result_(named(new QLabel(this), "simplify_result")) {
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName("simplify_dialog");
  setWindowTitle(tr("Simplify"));
  auto* numbers = new NumbersForm(
      document, "simplify_", std::function<const SimplifyNumbers*()>([this] { return &numbers_; }),
      std::function<void(const SimplifyNumbers&)>([this](const SimplifyNumbers& changed) {
        numbers_ = changed;
        show_count();
      }),
      this);
  connect(numbers, &SceneForm::refused, count_, &QLabel::setText);
  auto* simplify = named(new QPushButton(tr("Simplify")), "simplify_now");
  auto* form = new QFormLayout(this);
  form->addRow(count_);
  form->addRow(numbers);
  form->addRow(result_);
  form->addRow(dialog_buttons(this, simplify, [this] {
    Q_EMIT requested(numbers_);
    accept();
  }));
  pause_.setSingleShot(true);
  pause_.setInterval(300);
  connect(&pause_, &QTimer::timeout, this, &SimplifyDialog::show_count);
  on_change(document, Change::selection, this, &SimplifyDialog::show_count);
  on_change(document, Change::medium | Change::hidden_or_locked, &pause_,
            qOverload<>(&QTimer::start));
  show_count();
}

void SimplifyDialog::show_count() {
  const QString count = gaussians_text(to_simplify(document_).size());
  count_->setText(document_.selection().empty() ? tr("Merges all %1").arg(count)
                                                : tr("Merges %1, selected").arg(count));
  try_out();
}

void SimplifyDialog::try_out() {
  result_->setText(tr("Counting…"));
  const auto chosen =
      std::make_shared<const Medium>(chosen_gaussians(document_.medium(), to_simplify(document_)));
  trial_.start(
      [this, chosen, limits = limits_of(numbers_)](const Job& job) -> BackgroundJob::Apply {
        const auto found = simplify(*chosen, limits, job.stop, job.progress);
        if (!found) return {};
        const std::size_t left = found->kept.size() + found->merged.size();
        return [this, left, error = found->error, none = found->merged.empty()] {
          result_->setText(none ? tr("None can be merged within this error")
                                : tr("Leaves %1, with an error of %2 %")
                                      .arg(left)
                                      .arg(number_text(100.0 * error, 3)));
        };
      });
}

}  // namespace brume
