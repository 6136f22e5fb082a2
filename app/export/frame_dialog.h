#pragma once

#include <QDialog>
#include <filesystem>
#include <optional>

class QComboBox;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace brume {

// Dialog to export one frame.
class FrameDialog : public QDialog {
  Q_OBJECT
 public:
  // `path_traced`: offered first.
  FrameDialog(const QString& folder, bool path_traced, QWidget* parent);

 Q_SIGNALS:
  // The extension selects the format: .png or .exr. `paths` per pixel; nullopt: rendered by the
  // method of the view.
  void requested(const std::filesystem::path& file, std::optional<int> paths);

 private:
  [[nodiscard]] std::filesystem::path with_extension(const QString& name) const;
  void update_enabled();
  void browse();
  void confirm();

  QComboBox* format_;
  QLineEdit* file_;
  QComboBox* method_;
  QSpinBox* paths_;
  QPushButton* export_;
};

}  // namespace brume
