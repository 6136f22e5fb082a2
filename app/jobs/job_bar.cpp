#include "app/jobs/job_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <utility>

#include "app/widgets/plain_text.h"

namespace brume {

JobBar::JobBar(QWidget* parent)
    : QWidget(parent), label_(new PlainLabel(this)), bar_(new QProgressBar(this)) {
  bar_->setFixedWidth(90);
  bar_->setTextVisible(false);
  auto* stop = new QToolButton(this);
  stop->setText(tr("Cancel"));
  connect(stop, &QToolButton::clicked, this, &JobBar::cancel_clicked);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(label_);
  layout->addWidget(bar_);
  layout->addWidget(stop);
  hide();
}

void JobBar::show_job(const QString& text) {
  label_->setText(text);
  bar_->setRange(0, 0);
  show();
}

void JobBar::show_progress(int percent) {
  bar_->setRange(0, 100);
  bar_->setValue(percent);
}

std::function<void(double)> JobBar::progress() {
  return [this, told = 0](double done) mutable {
    const int percent = static_cast<int>(100.0 * done);
    if (percent == std::exchange(told, percent)) return;
    QMetaObject::invokeMethod(
        this, [this, percent] { show_progress(percent); }, Qt::QueuedConnection);
  };
}

}  // namespace brume
