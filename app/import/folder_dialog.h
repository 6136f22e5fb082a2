#pragma once

#include <QDialog>
#include <filesystem>

#include "app/import/scene_import.h"

class QFormLayout;
class QLineEdit;

namespace brume {

// The row of a form that asks where the Gaussians of a run of frames are written to: beside the
// files, in a folder of their own.
QLineEdit* add_folder_row(QFormLayout* form, const std::filesystem::path& file,
                          const FrameRun& run);

// Asks that and nothing else.
class FolderDialog : public QDialog {
  Q_OBJECT
 public:
  FolderDialog(const std::filesystem::path& file, const FrameRun& run, QWidget* parent);

 Q_SIGNALS:
  void wanted(const QString& folder);
};

}  // namespace brume
