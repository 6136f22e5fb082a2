#pragma once

#include <QWidget>

#include "app/panels/gaussians/gaussian_filter.h"

class QAbstractButton;
class QLabel;
class QLineEdit;

namespace brume {

// The line that asks a table of Gaussians; while it asks, below it how many are shown, or what is
// wrong with the question, and what can be done with those.
class FilterBar : public QWidget {
  Q_OBJECT
 public:
  explicit FilterBar(QWidget* parent = nullptr);

  [[nodiscard]] QString text() const;
  void show_count(std::size_t shown, std::size_t all);

 Q_SIGNALS:
  void asked(const brume::GaussianFilter& filter);
  void select_asked();  // of what is shown: by a button, or Enter
  void group_asked();

 private:
  void parse(const QString& text);
  void show_answer();

  QLineEdit* line_;
  QWidget* answer_;
  QLabel* count_;
  QList<QAbstractButton*> buttons_;
  QString problem_;
  std::size_t shown_ = 0;
  std::size_t all_ = 0;
};

}  // namespace brume
