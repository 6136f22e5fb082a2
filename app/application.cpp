#include "app/application.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace brume {

QColor accent_color() {
  return {240, 160, 48};
}

void set_up_application(QApplication& application) {
  QApplication::setOrganizationName("Brume");
  QApplication::setApplicationName("Brume");
  QApplication::setApplicationVersion(BRUME_VERSION);
  QApplication::setStyle(QStyleFactory::create("Fusion"));

  const QColor window(38, 40, 44);
  const QColor base(28, 30, 33);
  const QColor text(222, 224, 228);
  const QColor dim(128, 132, 138);
  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, QColor(33, 35, 38));
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::PlaceholderText, dim);
  palette.setColor(QPalette::Button, QColor(50, 53, 58));
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::Link, accent_color());
  palette.setColor(QPalette::LinkVisited, accent_color());
  // Muted, since whole lists can be selected.
  palette.setColor(QPalette::Highlight, QColor(124, 86, 34));
  palette.setColor(QPalette::HighlightedText, QColor(250, 246, 238));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, dim);
  }
  application.setPalette(palette);
}

}  // namespace brume
