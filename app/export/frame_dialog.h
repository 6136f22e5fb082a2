#pragma once

#include <QDialog>
#include <filesystem>

class QComboBox;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace brume {

class LayerBoxes;
class MethodBox;
struct Output;
struct OutputLayers;

// Dialog to export one frame.
class FrameDialog : public QDialog {
  Q_OBJECT
 public:
  // `path_traced` and `layers`: offered first.
  FrameDialog(const QString& folder, bool path_traced, const OutputLayers& layers, QWidget* parent);

 Q_SIGNALS:
  // The extension selects the format: .png, .exr or .deep.exr. Paths, denoising and layers are set
  // in `output`, `bits` are those of each value of .png, 8 or 16.
  void requested(const std::filesystem::path& file, const brume::Output& output, int bits);

 private:
  [[nodiscard]] std::filesystem::path with_extension(const QString& name) const;
  void update_enabled();
  void browse();
  void confirm();

  QComboBox* format_;
  QComboBox* bits_;
  QLineEdit* file_;
  MethodBox* method_;
  QSpinBox* paths_;
  LayerBoxes* layers_;
  QPushButton* export_;
};

}  // namespace brume
