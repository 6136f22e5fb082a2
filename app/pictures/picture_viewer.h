#pragma once

#include <QWidget>
#include <optional>

#include "app/jobs/background_job.h"
#include "app/pictures/picture_canvas.h"
#include "app/pictures/picture_slots.h"

class QBoxLayout;
class QButtonGroup;
class QComboBox;
class QLabel;

namespace brume {

// Pictures in slots, one of them shown or two compared.
class PictureViewer : public QWidget {
  Q_OBJECT
 public:
  explicit PictureViewer(QWidget* parent = nullptr);

  [[nodiscard]] PictureSlots& pictures() { return slots_; }
  // Shows a slot as A; what A was before is B, to compare with.
  void show_new(std::size_t slot);

 Q_SIGNALS:
  void keep_view_asked_for();
  void save_asked_for(std::shared_ptr<const brume::Picture> picture);

 private:
  void add_slots(QBoxLayout& row, QButtonGroup& group, const QString& title, const char* name);
  void add_tools(QBoxLayout& row);
  void show_slot(std::size_t slot);
  void show_pictures();
  void compare();  // A with B, in the background
  void show_info(std::optional<double> difference);
  void show_pixel(std::optional<QPoint> pixel);
  [[nodiscard]] const std::shared_ptr<const Picture>& a() const;
  [[nodiscard]] const std::shared_ptr<const Picture>& b() const;

  PictureSlots slots_;
  PictureCanvas* canvas_;
  QButtonGroup* a_;
  QButtonGroup* b_;
  QComboBox* mode_;
  QComboBox* gain_;
  QLabel* info_;
  QLabel* pixel_;
  BackgroundJob comparing_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
