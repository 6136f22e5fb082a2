#pragma once

#include <QWidget>
#include <functional>

class QLabel;
class QProgressBar;

namespace brume {

// Says in the status bar what goes on in the background while it lasts, with a button to cancel it.
class JobBar : public QWidget {
  Q_OBJECT
 public:
  explicit JobBar(QWidget* parent = nullptr);

 Q_SIGNALS:
  void cancel_clicked();

 protected:
  void show_job(const QString& text);
  void show_progress(int percent);  // without, the bar says only that something goes on
  // Tells the bar, from another thread, which share of the work is done.
  [[nodiscard]] std::function<void(double)> progress();

 private:
  QLabel* label_;
  QProgressBar* bar_;
};

}  // namespace brume
