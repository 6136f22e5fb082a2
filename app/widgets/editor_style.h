#pragma once

#include <QProxyStyle>

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
};

}  // namespace brume
