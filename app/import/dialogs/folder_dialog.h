#pragma once

#include <QDialog>
#include <filesystem>

#include "app/import/frame_run.h"

class QFormLayout;
class QLineEdit;

namespace brume {

// A form row for the output folder of a sequence's Gaussians, by default beside the files.
QLineEdit* add_folder_row(QFormLayout* form, const std::filesystem::path& file,
                          const FrameRun& run);

// Dialog with that row only.
class FolderDialog : public QDialog {
  Q_OBJECT
 public:
  FolderDialog(const std::filesystem::path& file, const FrameRun& run, QWidget* parent);

 Q_SIGNALS:
  void requested(const QString& folder);
};

}  // namespace brume
