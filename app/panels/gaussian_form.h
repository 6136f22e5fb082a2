#pragma once

#include <QWidget>
#include <array>

#include "app/document/gaussian_field.h"

namespace brume {

class Document;
class ValueField;

// The selection's numbers, one field each: the common value, or "mixed" where they differ. What is
// entered, or comes of a drag on the title, is written to all of them.
class GaussianForm : public QWidget {
  Q_OBJECT
 public:
  explicit GaussianForm(Document& document, QWidget* parent = nullptr);

 Q_SIGNALS:
  void refused(const QString& problem);

 private:
  void refresh();

  Document& document_;
  std::array<ValueField*, gaussian_fields.size()> fields_{};
};

}  // namespace brume
