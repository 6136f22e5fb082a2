// The panel Output as the one place of renders and exports.

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

#include "app/document/paths.h"
#include "app/panels/forms/output_panel.h"
#include "app/pictures/picture_viewer.h"
#include "app/viewport/camera_frame.h"
#include "app/viewport/viewport.h"
#include "core/io/image/image_file.h"
#include "tests/app/listed_queue.h"

using namespace brume;

namespace {

const Picture& newest(TestWindow& window) {
  const PictureSlots& pictures = window->findChild<PictureViewer*>()->pictures();
  return *pictures.at(window->output().queue().items().size() - 1);
}

}  // namespace

class OutputFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { std::filesystem::remove_all(kept_renders_folder()); }

  void export_leads_to_the_file_of_the_panel_output() {
    TestWindow window(tiny_scene());
    auto* file = window->findChild<QLineEdit*>("output_file");
    QVERIFY(!file->hasFocus());
    window.key(Qt::Key_E, Qt::ControlModifier);
    QTRY_VERIFY(file->isVisible() && file->hasFocus());
    QVERIFY(!file->visibleRegion().isEmpty());
    QTest::keyClicks(file, "shot.exr");
    QTest::keyClick(file, Qt::Key_Return);
    QCOMPARE(last_step(window.document()), "Set file of output");
    // The key renders from within the field, too.
    QTest::keyClick(file, Qt::Key_F12);
    QTRY_VERIFY(std::filesystem::exists(window.file("shot.exr")));
    QCOMPARE(read_exr(window.file("shot.exr")).width, 32);
  }

  void a_png_of_16_bits_is_rendered() {
    TestWindow window(tiny_scene());
    auto* bits = window->findChild<QComboBox*>("output_bits");
    QVERIFY(!bits->isEnabled());
    type(window, "output_file", "fine.exr");
    QVERIFY(!bits->isEnabled());
    type(window, "output_file", "fine.png");
    QVERIFY(bits->isEnabled());
    for (const int k : {1, 0}) {
      choose(window, "output_bits", k);
      QVERIFY(render_picture(window));
      QFile written(to_qstring(window.file("fine.png")));
      QVERIFY(written.open(QIODevice::ReadOnly));
      QCOMPARE(int{written.read(25).back()}, k == 1 ? 16 : 8);  // bits of a value, in the header
    }
  }

  void the_view_is_rendered_in_place_of_the_camera() {
    TestWindow window(tiny_scene());
    window.drag({300, 300}, {420, 320}, Qt::MiddleButton);
    QVERIFY(window.settle());
    QVERIFY(render_picture(window));
    QCOMPARE(newest(window).name, "Camera, frame 0");
    const std::vector<float> seen_by_camera = newest(window).rgb;
    click(window, "output_from_view");
    // The region is of the camera's picture.
    CameraFrame& frame = window.view().camera_frame();
    frame.set_region(QRectF(0.0, 0.0, 0.5, 0.5));
    QVERIFY(!window->findChild<QLabel*>("region_text")->isEnabled());
    QVERIFY(render_picture(window));
    QCOMPARE(newest(window).name, "View, frame 0");
    QCOMPARE(newest(window).width, 32);
    frame.set_region(std::nullopt);
    QVERIFY(newest(window).rgb != seen_by_camera);
    invoke(window, "view.store_camera");
    click(window, "output_from_view");
    const std::vector<float> seen_by_view = newest(window).rgb;
    QVERIFY(render_picture(window));
    QCOMPARE(newest(window).name, "Camera, frame 0");
    QVERIFY(newest(window).rgb == seen_by_view);
    // It is of no other scene.
    click(window, "output_from_view");
    window->document().create();
    QVERIFY(!window->findChild<QCheckBox*>("output_from_view")->isChecked());
  }

  void a_view_that_is_path_traced_is_rendered_by_paths() {
    TestWindow window(tiny_scene());
    type(window, "output_file", "shot.exr");
    const auto header = [&](const char* name) {
      const auto metadata = read_exr(window.file("shot.exr")).metadata;
      const auto found = metadata.find(name);
      return found == metadata.end() ? std::string() : found->second;
    };
    window.view().frames().set_mode(ViewMode::path_traced);
    QVERIFY(render_picture(window));
    QCOMPARE(header("brume:airlight"), std::string("path:64"));
    QCOMPARE(header("brume:denoise"), std::string("solved"));
    QVERIFY2(newest(window).details.startsWith("64 paths, denoised"),
             qPrintable(newest(window).details));
    window.view().frames().set_mode(ViewMode::final);
    QVERIFY(render_picture(window));
    QVERIFY(!header("brume:airlight").starts_with("path"));
  }
};

BRUME_APP_SUITE("output_files", OutputFilesTest)
#include "output_files_test.moc"
