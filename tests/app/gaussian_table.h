#pragma once

#include <QHeaderView>
#include <QLineEdit>
#include <QTableView>
#include <QTest>

#include "app/panels/gaussians/gaussian_panel.h"

namespace brume {

// The panel Gaussians of a window or a desk.
inline QTableView* table_of(const QWidget& window) {
  return window.findChild<GaussianPanel*>()->table();
}

inline void click_header(QTableView* table, int k) {
  QHeaderView* header = table->horizontalHeader();
  const QPoint at(header->sectionViewportPosition(k) + header->sectionSize(k) / 2,
                  header->height() / 2);
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, at);
}

inline void set_filter(const QWidget& window, const QString& text) {
  auto* filter = window.findChild<QLineEdit*>("gaussian_filter");
  filter->setFocus();
  filter->clear();
  QTest::keyClicks(filter, text);
}

}  // namespace brume
