#pragma once

#include <QDialog>

#include "core/authoring/simplify.h"

class QCheckBox;
class QLabel;

namespace brume {

class Document;

// Asks within which error to merge the selected Gaussians, or all, and whether to ellipsoids; not
// modal.
class SimplifyDialog : public QDialog {
  Q_OBJECT
 public:
  SimplifyDialog(const Document& document, QWidget* window);

 Q_SIGNALS:
  void requested(const SimplifyLimits& limits);

 private:
  void show_count();

  const Document& document_;
  double percent_ = 1.0;
  QLabel* count_;
  QCheckBox* ellipsoids_;
};

}  // namespace brume
