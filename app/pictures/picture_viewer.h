#pragma once

#include <QWidget>
#include <optional>

#include "app/jobs/background_job.h"
#include "app/pictures/picture_canvas.h"
#include "app/pictures/picture_slots.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QLineEdit;

namespace brume {

class PictureScope;
class SlotStrip;

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
  void save_asked_for(std::shared_ptr<const brume::Picture> picture, const QString& name,
                      const QString& note);
  void visibility_changed(bool visible);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void add_tools(QBoxLayout& row);
  [[nodiscard]] QBoxLayout* new_side();
  void add_layer_names();  // of A
  void show_pictures();
  void show_both(const std::shared_ptr<const Picture>& a, const std::shared_ptr<const Picture>& b);
  void take_labels();  // that have been typed
  void show_labels();
  void compare();  // A with B, in the background
  void show_info();
  void show_pixel(std::optional<QPoint> pixel);
  [[nodiscard]] const std::shared_ptr<const Picture>& a() const;
  [[nodiscard]] const std::shared_ptr<const Picture>& b() const;

  PictureSlots slots_;
  SlotStrip* strip_;
  PictureCanvas* canvas_;
  PictureScope* scope_;
  QComboBox* mode_;
  QComboBox* gain_;
  QComboBox* layer_;
  QLineEdit* name_;
  QLineEdit* note_;
  std::size_t labelled_ = 0;  // the slot of both
  QLabel* info_;
  QLabel* pixel_;
  // The pictures that are shown of A and B: they, or a layer.
  std::shared_ptr<const Picture> shown_a_;
  std::shared_ptr<const Picture> shown_b_;
  std::optional<double> difference_;  // of A from B; nullopt: not known
  BackgroundJob layering_{BackgroundJob::Policy::latest_wins};
  BackgroundJob comparing_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
