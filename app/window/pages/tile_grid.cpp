#include "app/window/pages/tile_grid.h"

#include <QPainter>
#include <QToolButton>
#include <algorithm>

namespace brume {
namespace {

constexpr int tile_gap = 6;       // pixels
constexpr int picture_scale = 2;  // for screens with fine pixels

QPixmap filled_tile(const QPixmap& picture) {
  const QSize size = TileGrid::picture_size * picture_scale;
  QPixmap tile(size);
  tile.fill(QColor(52, 56, 62));
  if (!picture.isNull()) {
    const QImage large =
        picture.toImage().scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    QPainter painter(&tile);
    painter.drawImage(
        QRect(QPoint(0, 0), size), large,
        QRect(QPoint((large.width() - size.width()) / 2, (large.height() - size.height()) / 2),
              size));
  }
  tile.setDevicePixelRatio(picture_scale);
  return tile;
}

}  // namespace

QToolButton* TileGrid::add(const QPixmap& picture, const QString& title) {
  auto* tile = new QToolButton(this);
  tile->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  tile->setIconSize(picture_size);
  tile->setIcon(filled_tile(picture));
  tile->setText(tile->fontMetrics().elidedText(title, Qt::ElideMiddle, picture_size.width()));
  tile->setAccessibleName(title);
  tile->setAutoRaise(true);
  tile->setFocusPolicy(Qt::StrongFocus);
  tiles_.push_back(tile);
  tile->show();
  arrange();
  return tile;
}

void TileGrid::clear() {
  for (QToolButton* tile : tiles_) {
    tile->hide();
    tile->deleteLater();  // it may be the one that is being pressed
  }
  tiles_.clear();
  arrange();
}

void TileGrid::resizeEvent(QResizeEvent* /*event*/) {
  arrange();
}

void TileGrid::arrange() {
  if (tiles_.empty()) {
    setFixedHeight(0);
    return;
  }
  QSize size;
  for (const QToolButton* tile : tiles_) size = size.expandedTo(tile->sizeHint());
  const int columns = std::max(1, (width() + tile_gap) / (size.width() + tile_gap));
  int k = 0;
  for (QToolButton* tile : tiles_) {
    tile->setGeometry(QRect(
        QPoint(k % columns * (size.width() + tile_gap), k / columns * (size.height() + tile_gap)),
        size));
    ++k;
  }
  setFixedHeight(((k - 1) / columns + 1) * (size.height() + tile_gap) - tile_gap);
}

}  // namespace brume
