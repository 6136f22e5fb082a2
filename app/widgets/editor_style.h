#pragma once

#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>

namespace brume {

// A flat widget style, independent of the desktop.
class EditorStyle : public QProxyStyle {
 public:
  EditorStyle() : QProxyStyle("Fusion") {}

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    // A light copy of the text below it looks embossed on a dark ground.
    if (hint == SH_EtchDisabledText) return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }

  // Fusion's outline of check boxes is as dark as a dark ground, and its line below tabs is white.
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    if (element == PE_FrameTabBarBase) return;
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck) return;
    QColor outline = option->palette.color(QPalette::Text);
    outline.setAlphaF(option->state.testFlag(State_Enabled) ? 0.5F : 0.25F);
    painter->setPen(outline);
    painter->setBrush(Qt::NoBrush);
    painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
  }
};

}  // namespace brume
