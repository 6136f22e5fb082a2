#pragma once

#include <QDialog>

#include "app/export/medium_export.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace brume {

class Timeline;

// Dialog to export the medium; shows the memory of a grid.
class MediumDialog : public QDialog {
  Q_OBJECT
 public:
  MediumDialog(std::shared_ptr<const Scene> scene, const Timeline& timeline, const QString& folder,
               QWidget* parent);

 Q_SIGNALS:
  void requested(const brume::MediumExport& request);

 private:
  void show_memory();
  void browse();
  [[nodiscard]] MediumExport chosen() const;

  [[nodiscard]] Scene scene_now() const;

  std::shared_ptr<const Scene> scene_;
  double time_;
  double frames_per_second_;
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
