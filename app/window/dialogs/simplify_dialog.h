#pragma once

#include <QDialog>
#include <QTimer>

#include "app/commands/gaussians/operation_numbers.h"
#include "app/jobs/background_job.h"

class QLabel;

namespace brume {

class Document;

// Asks within which error to merge the selected Gaussians, or all, and whether to ellipsoids, and
// says how many will be left; not modal.
class SimplifyDialog : public QDialog {
  Q_OBJECT
 public:
  SimplifyDialog(Document& document, QWidget* window);

 Q_SIGNALS:
  void requested(const brume::SimplifyNumbers& numbers);

 private:
  void show_count();
  void try_out();

  const Document& document_;
  SimplifyNumbers numbers_;
  QLabel* count_;
  QLabel* result_;
  QTimer pause_;  // from a change of the fog: strokes change it again and again
  BackgroundJob trial_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
