#pragma once

#include <QDialog>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/import/frame_run.h"
#include "app/import/volume_fit.h"
#include "app/jobs/background_job.h"
#include "core/io/volume/volume_file.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QSpinBox;
class QTreeWidget;

namespace brume {

class AppearanceFields;

// Dialog for the fit options of a volume or sequence. It says what the file holds, and what the fit
// will take.
class VolumeDialog : public QDialog {
  Q_OBJECT
 public:
  VolumeDialog(const std::filesystem::path& file, const std::optional<FrameRun>& run,
               QWidget* parent);

  // Output folder of a sequence.
  [[nodiscard]] std::filesystem::path folder() const;

 Q_SIGNALS:
  void requested(const brume::VolumeFit& how);

 private:
  void list_grids();
  void read_ranges();
  void show_ranges(std::vector<std::optional<ValueRange>> ranges);
  [[nodiscard]] const VolumeGridInfo* grid() const;  // that is chosen
  void choose_grid();
  void show_cost();
  [[nodiscard]] VolumeFit fit() const;
  void confirm();

  std::filesystem::path file_;
  std::vector<VolumeGridInfo> grids_;
  int frames_;
  QTreeWidget* grid_list_;
  QLabel* cost_;
  QSpinBox* count_;
  QComboBox* shape_;
  QDoubleSpinBox* error_;
  QLineEdit* scale_;
  QComboBox* up_;
  bool is_up_chosen_ = false;  // by the user, not guessed
  AppearanceFields* appearance_;
  QLineEdit* folder_ = nullptr;  // sequences only
  BackgroundJob reading_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
