#pragma once

#include <QColor>

class QApplication;

namespace brume {

// The one colour that marks what is selected or active.
QColor accent_color();

// Names the application and gives it its dark look.
void set_up_application(QApplication& application);

}  // namespace brume
