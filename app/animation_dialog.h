#pragma once

#include <QDialog>
#include <filesystem>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace brume {

class Timeline;

// Asks what of an animation is exported, and where to.
class AnimationDialog : public QDialog {
  Q_OBJECT
 public:
  AnimationDialog(const Timeline& timeline, const QString& folder, QWidget* parent);

 Q_SIGNALS:
  // The extension says what of: .png or .exr, each frame numbered, or .mp4.
  void wanted(const std::filesystem::path& file, int first, int last);

 private:
  void show_names();
  void browse();
  void take();

  QComboBox* format_;
  QLineEdit* file_;
  QSpinBox* first_;
  QSpinBox* last_;
  QLabel* names_;  // that will be written
  QPushButton* export_;
};

}  // namespace brume
