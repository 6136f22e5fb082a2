#pragma once

#include <QWidget>
#include <array>

#include "app/document/gaussian_attribute.h"

namespace brume {

class Document;
class ValueField;

// Fields of the selection's attributes: the common value, or "mixed". Edits apply to all selected
// Gaussians.
class GaussianForm : public QWidget {
  Q_OBJECT
 public:
  explicit GaussianForm(Document& document, QWidget* parent = nullptr);

 Q_SIGNALS:
  void refused(const QString& problem);

 private:
  void refresh();

  Document& document_;
  std::array<ValueField*, gaussian_attributes.size()> fields_{};
};

}  // namespace brume
