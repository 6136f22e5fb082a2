#pragma once

#include <QFrame>
#include <vector>

#include "app/document/autosave.h"

class QLabel;

namespace brume {

// Offers unsaved work that another session left behind, one piece after the other, in a bar above
// the picture.
class RecoveryBar : public QFrame {
  Q_OBJECT
 public:
  explicit RecoveryBar(QWidget* parent);

  void offer(std::vector<LeftBehind> work);

 Q_SIGNALS:
  void restore(const brume::LeftBehind& work);

 private:
  void show_next();
  void drop_first();

  std::vector<LeftBehind> work_;
  QLabel* label_;
};

}  // namespace brume
