#pragma once

#include <QColor>

class QApplication;

namespace brume {

// The accent colour of selected and active items.
QColor accent_color();

// Call before creating QApplication: sets its name, and makes the OpenGL contexts of all windows
// share objects.
void prepare_application();

// Sets style and palette.
void set_up_application(QApplication& application);

// The theme of the interface; stored in the settings.
enum class Theme { dark, light };
Theme theme();
void set_theme(Theme theme);

}  // namespace brume
