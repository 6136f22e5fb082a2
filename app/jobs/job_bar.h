#pragma once

#include <QWidget>
#include <functional>

class QLabel;
class QProgressBar;

namespace brume {

// A status-bar widget for a running background job, with a cancel button.
class JobBar : public QWidget {
  Q_OBJECT
 public:
  explicit JobBar(QWidget* parent = nullptr);

 Q_SIGNALS:
  void cancel_clicked();

 protected:
  void show_job(const QString& text);
  void show_progress(int percent);  // without it the bar is indeterminate
  // A callback for the completed fraction, callable from other threads.
  [[nodiscard]] std::function<void(double)> progress();

 private:
  QLabel* label_;
  QProgressBar* bar_;
};

}  // namespace brume
