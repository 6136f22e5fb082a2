#pragma once

#include <QLabel>
#include <QString>

namespace brume {

// Shows its text as it is: Qt takes a text with tags for markup, and names of files may have some.
// A line that is too long is cut, with an ellipsis, before it makes a panel wider.
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

// The same for tool tips, which have no format of their own.
QString plain_tool_tip(const QString& text);

}  // namespace brume
