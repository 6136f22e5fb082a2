#pragma once

#include <QDialog>

#include "app/medium_export.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace brume {

class Timeline;

// Asks where the medium is exported to, and how; says what memory a grid of it takes.
class MediumDialog : public QDialog {
  Q_OBJECT
 public:
  MediumDialog(std::shared_ptr<const Scene> scene, const Timeline& timeline, const QString& folder,
               QWidget* parent);

 Q_SIGNALS:
  void wanted(const brume::MediumExport& what);

 private:
  void show_memory();
  void browse();
  [[nodiscard]] MediumExport chosen() const;

  std::shared_ptr<const Scene> scene_;
  double time_;
  QLineEdit* file_;
  QLineEdit* voxel_;
  QCheckBox* half_;
  QCheckBox* is_range_;
  QSpinBox* first_;
  QSpinBox* last_;
  QLabel* memory_;
  QPushButton* export_;
};

}  // namespace brume
