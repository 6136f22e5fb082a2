#include "app/icons.h"

#include <QBuffer>
#include <QColor>
#include <QFile>
#include <QImageReader>
#include <QPixmap>

namespace brume {

QIcon load_icon(const QString& name, const QColor& color) {
  QFile file(":/icons/" + name + ".svg");
  QIcon icon;
  if (!file.open(QIODevice::ReadOnly)) return icon;
  QByteArray svg = file.readAll();
  svg.replace("currentColor", color.name().toLatin1());
  constexpr int side = 24;
  for (const int scale : {1, 2, 3}) {
    QBuffer buffer(&svg);
    QImageReader reader(&buffer, "svg");
    reader.setScaledSize(QSize(side, side) * scale);
    QPixmap pixmap = QPixmap::fromImageReader(&reader);
    pixmap.setDevicePixelRatio(scale);
    icon.addPixmap(pixmap);
  }
  return icon;
}

}  // namespace brume
