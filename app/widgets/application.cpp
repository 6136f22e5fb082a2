#include "app/widgets/application.h"

#include <QApplication>
#include <QPalette>
#include <QSettings>

#include "app/widgets/editor_style.h"
#include "app/widgets/interface_settings.h"
#include "app/widgets/mnemonics.h"
#include "app/widgets/translation.h"
#include "brume/version.h"

#include "app/widgets/field_filter.h"

namespace brume {
namespace {

constexpr const char* theme_key = "view/theme";
constexpr const char* scale_variable = "QT_SCALE_FACTOR";  // which QApplication reads
bool has_set_scale = false;

QPalette palette_of(Theme theme) {
  const bool dark = theme == Theme::dark;
  const auto pick = [dark](const QColor& on_dark, const QColor& on_light) {
    return dark ? on_dark : on_light;
  };
  const QColor window = pick({38, 40, 44}, {236, 237, 239});
  const QColor base = pick({28, 30, 33}, {252, 252, 253});
  const QColor text = pick({222, 224, 228}, {32, 34, 38});
  const QColor dim = pick({128, 132, 138}, {132, 136, 142});
  const QColor link = pick(accent_color(), {168, 92, 0});
  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, pick({33, 35, 38}, {243, 244, 246}));
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::PlaceholderText, dim);
  palette.setColor(QPalette::Button, pick({50, 53, 58}, {224, 226, 229}));
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::BrightText, pick(Qt::white, Qt::black));
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::Link, link);
  palette.setColor(QPalette::LinkVisited, link);
  // Muted, since whole lists can be selected.
  palette.setColor(QPalette::Highlight, pick({124, 86, 34}, {250, 214, 160}));
  palette.setColor(QPalette::HighlightedText, pick({250, 246, 238}, {44, 30, 8}));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, dim);
  }
  return palette;
}

}  // namespace

QColor accent_color() {
  return {240, 160, 48};
}

void prepare_application() {
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  QCoreApplication::setOrganizationName("Brume");
  QCoreApplication::setApplicationName("Brume");
  QCoreApplication::setApplicationVersion(version());
  const double scale = InterfaceSettings::instance().interface_scale();
  if (scale != 0.0 && !qEnvironmentVariableIsSet(scale_variable)) {
    has_set_scale = qputenv(scale_variable, QByteArray::number(scale));
  }
}

void set_up_application(QApplication& application) {
  if (has_set_scale) qunsetenv(scale_variable);  // programs that it starts have their own
  // By this name a desktop finds the icon of the windows.
  QApplication::setDesktopFileName("brume-editor");
  QApplication::setStyle(new EditorStyle);
  application.setPalette(palette_of(theme()));
  application.installEventFilter(new FieldFilter(&application));
  application.installEventFilter(new Mnemonics(&application));
  install_translations(application, InterfaceSettings::instance().language());
}

Theme theme() {
  return QSettings().value(theme_key) == "light" ? Theme::light : Theme::dark;
}

void set_theme(Theme theme) {
  QSettings().setValue(theme_key, theme == Theme::light ? "light" : "dark");
  QApplication::setPalette(palette_of(theme));
}

}  // namespace brume
