#pragma once

#include <QWidget>

class QFormLayout;

namespace brume {

// The page of the preferences about how scenes are shown: unit, colours, handles.
class DisplayPreferences : public QWidget {
  Q_OBJECT
 public:
  explicit DisplayPreferences(QWidget* parent = nullptr);

 private:
  void add_unit(QFormLayout& form);
  void add_colors(QFormLayout& form);
  void add_handles(QFormLayout& form);
};

}  // namespace brume
