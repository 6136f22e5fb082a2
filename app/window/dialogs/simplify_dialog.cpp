#include "app/window/dialogs/simplify_dialog.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "app/commands/simplify_gaussians.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/number_text.h"
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
        try_out();
      }),
      this);
  connect(numbers, &SceneForm::refused, this, &SimplifyDialog::refuse);
  auto* simplify = named(new QPushButton(tr("Simplify")), "simplify_now");
  auto* form = new QFormLayout(this);
  form->addRow(count_);
  form->addRow(numbers);
  form->addRow(result_);
  form->addRow(dialog_buttons(this, simplify, [this] {
    Q_EMIT requested(numbers_);
    accept();
  }));
  connect(&trial_, &BackgroundJob::failed, result_, &QLabel::setText);
  constexpr int pause_ms = 300;
  pause_.setSingleShot(true);
  pause_.setInterval(pause_ms);
  connect(&pause_, &QTimer::timeout, this, &SimplifyDialog::try_out);
  on_change(document,
            Change::scene | Change::selection | Change::medium | Change::groups |
                Change::hidden_or_locked,
            this, &SimplifyDialog::try_out_later);
  try_out();
}

void SimplifyDialog::refuse(const QString& why) {
  pause_.stop();
  trial_.cancel();
  count_->setText(why);
  result_->clear();
}

// A stroke changes the Gaussians many times a second.
void SimplifyDialog::try_out_later() {
  trial_.cancel();
  result_->setText(tr("Counting…"));
  pause_.start();
}

void SimplifyDialog::try_out() {
  pause_.stop();
  result_->setText(tr("Counting…"));
  trial_.start([this, scene = document_.snapshot(), selection = document_.selection(),
                hidden = document_.all_hidden(), locked = document_.all_locked(),
                limits = limits_of(numbers_)](const Job& job) -> BackgroundJob::Apply {
    const std::vector<GaussianId> ids = to_simplify(scene->medium, selection, hidden, locked);
    const QString count = gaussians_text(ids.size());
    const QString text =
        selection.empty() ? tr("Merges all %1").arg(count) : tr("Merges %1, selected").arg(count);
    trial_.deliver(job, [this, text] { count_->setText(text); });
    const auto found =
        simplify(chosen_gaussians(scene->medium, ids), limits, job.stop, job.progress);
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
