#pragma once

#include <QDialog>

#include "app/export/medium_export.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;

namespace brume {

class Document;
class OpacityAlongBox;
class Timeline;
class WholeNumberBox;

// Dialog to export the medium; shows the memory of a grid. The format and the extension of the file
// follow each other.
class MediumDialog : public QDialog {
  Q_OBJECT
 public:
  // It offers what the document has now. `exposure` [stops] is offered for lit splats.
  MediumDialog(const Document& document, const Timeline& timeline, double exposure,
               QWidget* parent);

 Q_SIGNALS:
  void requested(const brume::MediumExport& request);

 private:
  void add_what();
  void add_options(QFormLayout* form, double exposure);
  void follow_format();  // with the extension
  void follow_file();    // with the format
  void show_options();
  void show_memory();
  [[nodiscard]] QString range_problem() const;  // empty: none
  [[nodiscard]] bool may_replace_all(const MediumExport& request);
  void browse();
  [[nodiscard]] MediumExport chosen() const;

  [[nodiscard]] Scene scene_now() const;
  [[nodiscard]] std::optional<std::vector<GaussianId>> only() const;

  std::shared_ptr<const Scene> scene_;
  std::vector<GaussianId> selection_;
  double time_;
  double frames_per_second_;
  QFormLayout* form_;
  QComboBox* what_;  // all, the selection, or a group, whose id is its data
  QComboBox* format_;
  QLineEdit* file_;
  QLineEdit* voxel_;
  QCheckBox* half_;
  QLayout* voxel_row_ = nullptr;
  OpacityAlongBox* along_;
  QComboBox* up_;
  QLineEdit* exposure_;
  QCheckBox* is_range_;
  WholeNumberBox* first_;
  WholeNumberBox* last_;
  QLabel* memory_;
  QPushButton* export_;
};

}  // namespace brume
