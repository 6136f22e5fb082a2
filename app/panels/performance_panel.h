#pragma once

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QTreeWidget>
#include <QWidget>

namespace brume {

class FrontierPlot;
class ViewGrid;

// Cost and error of the current frame, and the state of auto.
class PerformancePanel : public QWidget {
  Q_OBJECT
 public:
  explicit PerformancePanel(ViewGrid& views, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QLabel* add_row(QFormLayout& form, const QString& title, const char* name);
  void fill_max_error();
  void update_quality();
  void update_frame();

  ViewGrid& views_;
  QComboBox* max_error_;
  QLabel* shown_;
  QLabel* why_;
  QLabel* error_;
  QLabel* interval_;
  QLabel* gaussians_;
  QLabel* pairs_;
  QLabel* picture_;
  QLabel* backend_;
  FrontierPlot* frontier_;
  QTreeWidget* stages_;
};

}  // namespace brume
