#pragma once

#include <QColor>

class QApplication;

namespace brume {

// The one colour that marks what is selected or active.
QColor accent_color();

// Before there is an application: names it, and lets the OpenGL contexts of all its windows share
// their objects.
void prepare_application();

// Gives the application its look.
void set_up_application(QApplication& application);

// The look of everything but the picture; remembered.
enum class Theme { dark, light };
Theme theme();
void set_theme(Theme theme);

}  // namespace brume
