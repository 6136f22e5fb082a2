#pragma once

#include <QFrame>

class QLabel;
class QVBoxLayout;

namespace brume {

class Document;
class NumbersForm;

// The numbers of what was done last, to be adjusted, in the lower left corner of the views.
class AdjustPanel : public QFrame {
  Q_OBJECT
 public:
  AdjustPanel(Document& document, QWidget* views);

 Q_SIGNALS:
  void refused(const QString& why);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show_operation();
  template <class Numbers>
  bool show_numbers();
  void place();

  Document& document_;
  QLabel* title_;
  QVBoxLayout* layout_;
  NumbersForm* form_ = nullptr;
};

}  // namespace brume
