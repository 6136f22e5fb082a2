#pragma once

#include <QDialog>

#include "app/commands/gaussians/add_fog.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace brume {

class Document;
class NumbersForm;

// Numbers of a shape of fog, to add as often as one likes; not modal.
class FogShapeDialog : public QDialog {
  Q_OBJECT
 public:
  // Shapes are as large as suits the place, and stand on its ground.
  FogShapeDialog(Document& document, const FogPlace& place, QWidget* window);

  [[nodiscard]] const FogShape& shape() const { return shape_; }

 private:
  void set_kind(FogShape::Kind kind);
  void update_count();
  void add_shape();

  Document& document_;
  FogPlace place_;
  FogShape shape_;
  QComboBox* kind_;
  QLabel* count_;
  QPushButton* add_;
  NumbersForm* form_ = nullptr;
};

}  // namespace brume
