#pragma once

#include <QDialog>
#include <filesystem>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace brume {

class Timeline;
class WholeNumberBox;

// Dialog to export an animation.
class AnimationDialog : public QDialog {
  Q_OBJECT
 public:
  AnimationDialog(const Timeline& timeline, const QString& folder, QWidget* parent);

 Q_SIGNALS:
  // The extension selects the format: numbered .png or .exr frames, or .mp4.
  void requested(const std::filesystem::path& file, int first, int last);

 private:
  void show_names();
  void browse();
  void confirm();

  QComboBox* format_;
  QLineEdit* file_;
  WholeNumberBox* first_;
  WholeNumberBox* last_;
  QLabel* names_;  // that will be written
  QPushButton* export_;
};

}  // namespace brume
