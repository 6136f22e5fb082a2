#pragma once

#include <QFrame>
#include <vector>

#include "app/document/autosave.h"

class QLabel;

namespace brume {

// Offers recovery files one by one in a bar above the picture.
class RecoveryBar : public QFrame {
  Q_OBJECT
 public:
  explicit RecoveryBar(QWidget* parent);

  void offer(std::vector<RecoveryFile> work);

 Q_SIGNALS:
  void restore(const brume::RecoveryFile& work);

 private:
  void show_next();
  void drop_first();

  std::vector<RecoveryFile> work_;
  QLabel* label_;
};

}  // namespace brume
