#pragma once

#include <QLabel>
#include <QString>

namespace brume {

// A label for plain text: Qt would interpret tags, which file names may contain, as markup. Long
// lines are elided instead of widening a panel.
class PlainLabel : public QLabel {
  Q_OBJECT
 public:
  explicit PlainLabel(QWidget* parent = nullptr) : PlainLabel(QString(), parent) {}
  explicit PlainLabel(const QString& text, QWidget* parent = nullptr);

  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] bool is_line() const;
};

// Escapes plain text for tool tips.
QString plain_tool_tip(const QString& text);

}  // namespace brume
