#pragma once

#include <QDialog>

class QLabel;

namespace brume {

class Document;

// Asks within which error to merge the selected Gaussians, or all; not modal.
class SimplifyDialog : public QDialog {
  Q_OBJECT
 public:
  SimplifyDialog(const Document& document, QWidget* window);

 Q_SIGNALS:
  void requested(double max_error);  // relative

 private:
  void show_count();

  const Document& document_;
  double percent_ = 1.0;
  QLabel* count_;
};

}  // namespace brume
