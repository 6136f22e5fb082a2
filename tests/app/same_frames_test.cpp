// One scene and one request make one frame, bit by bit, whichever program is asked.

#include <QProcess>
#include <bit>
#include <map>

#include "app/document/paths.h"
#include "app/document/time/timeline.h"
#include "app/export/render_queue.h"
#include "core/io/image/image_file.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;

// Moves while the shutter is open, behind the edge of a floor.
Scene blurred_scene() {
  Scene scene = tiny_scene();
  scene.camera_keys.target = {{.time = 0.0, .value = {0, 0, 0}}, {.time = 2.0, .value = {2, 1, 0}}};
  Surface floor;
  floor.primitive = Primitive{.shape = Primitive::Shape::plane, .size = {4.0, 1.0, 2.0}};
  floor.mesh = mesh_of(*floor.primitive);
  floor.translate.y = -0.5;
  scene.surfaces.push_back(floor);
  Group group{.id = 1, .name = "thinner"};
  group.density_factor = 0.5;
  scene.groups.push_back(group);
  Gaussian grouped{{0.3, 0.3, 0.6}, 0.3, 0.8};
  grouped.group = group.id;
  scene.medium.append(grouped);
  scene.output.samples = 5;
  scene.output.shutter = Shutter{0.0, 2.0};
  scene.playback = Playback{.last = 12, .frames_per_second = 6.0};
  scene.output.layers.lights = true;
  scene.output.layers.normal = true;
  return scene;
}

// The programs may say these differently of one frame.
std::map<std::string, std::string> metadata_of(ImageLayers image) {
  std::erase_if(image.metadata, [](const auto& entry) {
    return !entry.first.starts_with("brume:") || entry.first == "brume:frame" ||
           entry.first == "brume:scene";
  });
  return image.metadata;
}

QString differences(const ImageLayers& image, const ImageLayers& expected) {
  if (image.width != expected.width || image.height != expected.height) return "another size";
  if (metadata_of(image) != metadata_of(expected)) {
    QString text = "the headers:";
    for (const ImageLayers& each : {image, expected}) {
      for (const auto& [name, value] : metadata_of(each)) {
        text += QString(" %1=%2").arg(name.c_str(), value.c_str());
      }
      text += " |";
    }
    return text;
  }
  QString text;
  for (const auto& [name, values] : expected.channels) {
    const auto found = image.channels.find(name);
    const auto same = [](float a, float b) {
      return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
    };
    if (found == image.channels.end() || !std::ranges::equal(found->second, values, same)) {
      text += QString::fromStdString(name) + " ";
    }
  }
  return image.channels.size() == expected.channels.size() ? text : text + "(other channels)";
}

class Programs {
 public:
  explicit Programs(const Scene& scene) : window_(scene) {
    window_->findChild<QAction*>("backend_cpu")->trigger();
    window_->timeline().set_frame(6);
    type(window_, "output_file", "editor.exr");
  }
  TestWindow& window() { return window_; }

  ImageLayers of_the_editor() {
    auto& queue = *window_->findChild<RenderQueue*>();
    window_.key(Qt::Key_F12);
    if (!QTest::qWaitFor([&] { return queue.unfinished() == 0 && !queue.items().empty(); },
                         patience)) {
      qFatal("the editor has not rendered");
    }
    return read_exr(window_.file("editor.exr"));
  }

  // Asks for what the header of the editor's frame says. Those that scenes have are in the scene.
  ImageLayers of_the_command_line(const ImageLayers& asked) {
    QStringList arguments{
        "render", path("scene.brume"), "-o",           path("command.exr"), "--backend",
        "cpu",    "--layers",          "lights,normal"};
    for (const auto& [option, value] : request_of(asked)) {
      arguments << "--" + option << value;
    }
    run(BRUME_PROGRAM, arguments);
    return read_exr(window_.file("command.exr"));
  }

#ifdef BRUME_PYTHON_MODULE
  ImageLayers of_python(const ImageLayers& asked) {
    QString options;
    for (const auto& [option, value] : request_of(asked)) {
      bool is_number = false;
      static_cast<void>(value.toDouble(&is_number));
      options += QString(", %1=%2").arg(QString(option).replace('-', '_'),
                                        is_number ? value : '"' + value + '"');
    }
    const QString program =
        QString(
            "import brume\n"
            "frame = brume.render(brume.load('%1'), backend='cpu', layers=['lights', 'normal']"
            "%2)\n"
            "frame.save('%3')\n")
            .arg(path("scene.brume"), options, path("python.exr"));
    run(BRUME_PYTHON, {"-c", program});
    return read_exr(window_.file("python.exr"));
  }
#endif

 private:
  [[nodiscard]] QString path(const char* name) const {
    return to_qstring(window_.file(name));
  }

  // The options of the header, by their names on the command line.
  static std::map<QString, QString> request_of(const ImageLayers& image) {
    std::map<QString, QString> options;
    for (const char* name : {"airlight", "scattering", "airlight_scale", "time"}) {
      const auto found = image.metadata.find(std::string("brume:") + name);
      if (found == image.metadata.end()) continue;
      options[QString(name).replace('_', '-')] = QString::fromStdString(found->second);
    }
    return options;
  }

  static void run(const QString& program, const QStringList& arguments) {
    QProcess process;
#ifdef BRUME_PYTHON_MODULE
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PYTHONPATH", BRUME_PYTHON_MODULE);
    environment.insert("PYTHONDONTWRITEBYTECODE", "1");
    process.setProcessEnvironment(environment);
#endif
    process.start(program, arguments);
    if (!process.waitForFinished(patience) || process.exitCode() != 0) {
      qFatal("%s: %s", qPrintable(program), process.readAllStandardError().constData());
    }
  }

  TestWindow window_;
};

}  // namespace

class SameFramesTest : public QObject {
  Q_OBJECT

 private:
  static void expect_same_frames(Programs& programs, const char* method) {
    const ImageLayers editor = programs.of_the_editor();
    QVERIFY2(editor.metadata.at("brume:airlight").starts_with(method),
             editor.metadata.at("brume:airlight").c_str());
    QCOMPARE(editor.metadata.at("brume:samples"), "5");
    QVERIFY(editor.channels.contains("airlight.light_1.R") && editor.channels.contains("normal.X"));
    const QString by_command = differences(programs.of_the_command_line(editor), editor);
    QVERIFY2(by_command.isEmpty(), qPrintable(by_command));
#ifdef BRUME_PYTHON_MODULE
    const QString by_python = differences(programs.of_python(editor), editor);
    QVERIFY2(by_python.isEmpty(), qPrintable(by_python));
#endif
  }

 private Q_SLOTS:
  void as_the_view_has_them() {
    Programs programs(blurred_scene());
    expect_same_frames(programs, "sliced:");
  }

  void with_chosen_slices() {
    Programs programs(blurred_scene());
    programs.window()->viewport().frames().quality().set_airlight(AirlightMethod::sliced, 8);
    expect_same_frames(programs, "sliced:8");
  }

  void traced() {
    Programs programs(blurred_scene());
    choose(programs.window(), "output_method", 1);
    enter(programs.window(), "output_paths", "16");
    expect_same_frames(programs, "path:16");
  }
};

BRUME_APP_SUITE("same_frames", SameFramesTest)
#include "same_frames_test.moc"
