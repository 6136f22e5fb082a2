#pragma once

#include <QWidget>

namespace brume {

class BackgroundJob;

// A status-bar widget that shows a background job while it runs, with a cancel button. Work without
// a title is not shown.
class JobBar : public QWidget {
  Q_OBJECT
 public:
  explicit JobBar(BackgroundJob& job, QWidget* parent = nullptr);
  [[nodiscard]] const BackgroundJob& job() const { return job_; }

 private:
  const BackgroundJob& job_;
};

}  // namespace brume
