#include "app/jobs/job_bar.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QToolButton>

#include "app/jobs/background_job.h"
#include "app/widgets/plain_text.h"

namespace brume {

JobBar::JobBar(BackgroundJob& job, QWidget* parent) : QWidget(parent), job_(job) {
  auto* label = new PlainLabel(this);
  auto* bar = new QProgressBar(this);
  bar->setFixedWidth(90);
  bar->setTextVisible(false);
  auto* stop = new QToolButton(this);
  stop->setText(tr("Cancel"));
  connect(stop, &QToolButton::clicked, &job, &BackgroundJob::cancel);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(label);
  layout->addWidget(bar);
  layout->addWidget(stop);
  hide();
  connect(&job, &BackgroundJob::started, this, [this, label, bar](const QString& title) {
    label->setText(title);
    bar->setRange(0, 0);  // indeterminate, until progress is reported
    setVisible(!title.isEmpty());
  });
  connect(&job, &BackgroundJob::progressed, bar, [bar](int percent) {
    bar->setRange(0, 100);
    bar->setValue(percent);
  });
  connect(&job, &BackgroundJob::ended, this, &JobBar::hide);
}

}  // namespace brume
