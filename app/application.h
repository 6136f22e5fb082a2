#pragma once

#include <QColor>

class QApplication;

namespace brume {

// The one colour that marks what is selected or active.
QColor accent_color();

// Before there is an application: the OpenGL contexts of all its windows share their objects.
void prepare_application();

// Names the application and gives it its look.
void set_up_application(QApplication& application);

// The look of everything but the picture; remembered.
enum class Theme { dark, light };
Theme theme();
void set_theme(Theme theme);

}  // namespace brume
