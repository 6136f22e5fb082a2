#include <QApplication>
#include <QCommandLineParser>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "app/document/paths.h"
#include "app/files/scene_files.h"
#include "app/widgets/application.h"
#include "app/window/dialogs/preferences.h"
#include "app/window/main_window.h"
#include "app/window/pages/start_page.h"
#include "app/window/session_end.h"
#include "core/io/disk/temporary_files.h"
#include "render/util/frame_memory.h"

namespace {

constexpr int bad_usage = 2;

// WIDTHxHEIGHT; not valid if it is anything else.
QSize parse_size(const QString& text) {
  const QStringList parts = text.split('x');
  const QSize size(parts.value(0).toInt(), parts.value(1).toInt());
  return parts.size() == 2 && size.width() > 0 && size.height() > 0 ? size : QSize();
}

void declare_options(QCommandLineParser& parser) {
  parser.setApplicationDescription("The Brume editor for fog, smoke and steam.");
  // Options are read as Qt reads its own, such as -platform.
  parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("scene", "The scene to open.", "[SCENE]");
  parser.addOptions({{"screenshot", "Save a screenshot of the window to FILE and quit.", "FILE"},
                     {"size", "The size of the window.", "WxH"}});
}

// --help and --version need no display.
void answer_without_display(int argc, char* argv[]) {
  const QCoreApplication application(argc, argv);
  QCommandLineParser parser;
  declare_options(parser);
  parser.parse(QCoreApplication::arguments());
  if (parser.isSet("help")) parser.showHelp();
  if (parser.isSet("version")) parser.showVersion();
}

// Qt's messages while it looks for a display. If it finds none it would abort.
QStringList startup_messages;

void keep_message(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
  if (type != QtFatalMsg) {
    startup_messages << message;
    return;
  }
  const bool names_display =
      qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
  const QString why = startup_messages.isEmpty() ? message : startup_messages.first();
  std::fprintf(stderr, "brume-editor: error: no display: %s\n",
               names_display ? qUtf8Printable(why.simplified())
                             : "neither DISPLAY nor WAYLAND_DISPLAY is set");
  std::_Exit(bad_usage);
}

}  // namespace

int main(int argc, char* argv[]) {
  brume::remove_temporary_files_on_signals();
  brume::keep_frame_memory();
  brume::prepare_application();
  answer_without_display(argc, argv);
  const QtMessageHandler handler = qInstallMessageHandler(keep_message);
  QApplication application(argc, argv);
  qInstallMessageHandler(handler);
  for (const QString& message : startup_messages) qWarning("%s", qUtf8Printable(message));
  brume::set_up_application(application);

  QCommandLineParser parser;
  declare_options(parser);
  parser.process(application);

  brume::apply_chosen_threads();
  brume::MainWindow window;
  const brume::SessionEnd session_end;
  QObject::connect(&session_end, &brume::SessionEnd::announced, &window,
                   &brume::MainWindow::keep_unsaved_work);
  QObject::connect(&session_end, &brume::SessionEnd::ended, &window, [](int signal) {
    if (signal != 0) std::raise(signal);
    QApplication::exit();
  });
  if (parser.isSet("size")) {
    const QSize size = parse_size(parser.value("size"));
    if (!size.isValid()) {
      std::fprintf(stderr, "--size: \"%s\" is not WxH\n", qUtf8Printable(parser.value("size")));
      return bad_usage;
    }
    window.resize(size);
  }
  if (parser.isSet("screenshot")) {
    window.quit_with_screenshot(parser.value("screenshot"));
  } else {
    window.keep_layout();
  }
  window.show();
  const QStringList scenes = parser.positionalArguments();
  if (scenes.isEmpty()) {
    if (!parser.isSet("screenshot") && brume::StartPage::is_wanted()) window.start_page().open();
  } else {
    if (parser.isSet("screenshot")) {
      // The window has said why. A user may go on from here, a picture of nothing helps nobody.
      QObject::connect(&window.files(), &brume::SceneFiles::failed,
                       [] { QApplication::exit(bad_usage); });
    }
    window.files().open_file(brume::to_path(scenes.first()));
  }
  return QApplication::exec();
}
