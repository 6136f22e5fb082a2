#include <QApplication>
#include <QCommandLineParser>

#include "app/application.h"
#include "app/document/paths.h"
#include "app/main_window.h"
#include "app/scene_files.h"
#include "render/frame_memory.h"

namespace {

// WIDTHxHEIGHT; not valid if it is anything else.
QSize parse_size(const QString& text) {
  const QStringList parts = text.split('x');
  const QSize size(parts.value(0).toInt(), parts.value(1).toInt());
  return parts.size() == 2 && size.width() > 0 && size.height() > 0 ? size : QSize();
}

}  // namespace

int main(int argc, char* argv[]) {
  brume::keep_frame_memory();
  brume::prepare_application();
  QApplication application(argc, argv);
  brume::set_up_application(application);

  QCommandLineParser parser;
  parser.setApplicationDescription("The Brume editor: lights and edits fog, smoke and steam.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("scene", "The scene to open.", "[SCENE]");
  parser.addOptions({{"screenshot", "Save a picture of the window to FILE and quit.", "FILE"},
                     {"size", "The size of the window.", "WxH"}});
  parser.process(application);

  brume::MainWindow window;
  if (parser.isSet("size")) {
    const QSize size = parse_size(parser.value("size"));
    if (!size.isValid()) {
      std::fprintf(stderr, "--size: \"%s\" is not WxH\n", qUtf8Printable(parser.value("size")));
      return 2;
    }
    window.resize(size);
  }
  if (parser.isSet("screenshot")) window.quit_with_screenshot(parser.value("screenshot"));
  window.show();
  const QStringList scenes = parser.positionalArguments();
  if (!scenes.isEmpty()) {
    if (parser.isSet("screenshot")) {
      // The window has said why. A user may go on from here, a picture of nothing helps nobody.
      QObject::connect(&window.files(), &brume::SceneFiles::failed, [] { QApplication::exit(2); });
    }
    window.files().open_file(brume::to_path(scenes.first()));
  }
  return QApplication::exec();
}
