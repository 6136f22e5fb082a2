#pragma once

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QToolButton>
#include <QTreeWidget>
#include <QWidget>
#include <functional>

namespace brume {

class FrontierPlot;
class FrameScheduler;
struct RenderedFrame;

// Shows the current frame's cost, error and method, each in a line; the rest, and
// the state of auto, below Details, which stays open or closed.
class PerformancePanel : public QWidget {
  Q_OBJECT
 public:
  // `active_frames`: those of the active view.
  explicit PerformancePanel(std::function<const FrameScheduler&()> active_frames,
                            QWidget* parent = nullptr);

  // The bound that is chosen here, and kept for the next session.
  [[nodiscard]] double max_error() const;
  // To be told when the frame shown, or its error, is another.
  void update_frame();
  void update_quality();
  void clear_numbers();  // of the error

 Q_SIGNALS:
  void max_error_changed(double max_error);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QLabel* add_row(QFormLayout& form, const QString& title, const char* name, const QString& tip);
  QWidget* make_details();
  QToolButton* make_details_button(QWidget& details);
  void show_stages(const RenderedFrame& frame);
  void fill_max_error();

  std::function<const FrameScheduler&()> active_frames_;
  QComboBox* max_error_;
  QLabel* time_;
  QLabel* method_;
  QLabel* why_;
  QLabel* error_;
  QLabel* interval_;
  QLabel* blocks_;
  QLabel* picture_blocks_;
  QLabel* gaussians_;
  QLabel* scattering_;
  QLabel* pairs_;
  QLabel* picture_;
  QLabel* backend_;
  FrontierPlot* frontier_;
  QTreeWidget* stages_;
};

}  // namespace brume
