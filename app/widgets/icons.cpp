#include "app/widgets/icons.h"

#include <QBuffer>
#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QImageReader>
#include <QPainter>
#include <QPalette>
#include <QPixmap>

#include "app/widgets/application.h"

namespace brume {
namespace {

// Takes its colour when it is drawn, so that it follows the theme.
class ThemedIcon : public QIconEngine {
 public:
  ThemedIcon(QByteArray svg, bool accents) : svg_(std::move(svg)), accents_(accents) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const QSize size = (QSizeF(rect.size()) * painter->device()->devicePixelRatio()).toSize();
    painter->drawPixmap(rect, pixmap(size, mode, state));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    const QPalette palette = QGuiApplication::palette();
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const QColor color = accents_ && state == QIcon::On
                             ? accent_color()
                             : palette.color(group, QPalette::ButtonText);
    QByteArray svg = svg_;
    svg.replace("currentColor", color.name().toLatin1());
    QBuffer buffer(&svg);
    QImageReader reader(&buffer, "svg");
    reader.setScaledSize(size);
    return QPixmap::fromImageReader(&reader);
  }

  [[nodiscard]] QIconEngine* clone() const override { return new ThemedIcon(svg_, accents_); }

 private:
  QByteArray svg_;
  bool accents_;
};

QIcon load(const QString& name, bool accents) {
  QFile file(":/icons/" + name + ".svg");
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QIcon(new ThemedIcon(file.readAll(), accents));
}

}  // namespace

QIcon load_icon(const QString& name) {
  return load(name, true);
}

QIcon load_tree_icon(const QString& name) {
  return load(name, false);
}

}  // namespace brume
