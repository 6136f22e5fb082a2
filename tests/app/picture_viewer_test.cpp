// Pictures kept in slots, and their comparison.

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QWheelEvent>
#include <QWindow>
#include <limits>

#include "app/document/paths.h"
#include "app/pictures/picture_scope.h"
#include "app/pictures/picture_viewer.h"
#include "app/viewport/viewport.h"
#include "brume/error.h"
#include "brume/frame.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

std::shared_ptr<const Picture> plain(const QString& name, float red, int width = 40,
                                     int height = 30) {
  Frame frame;
  frame.film = {width, height};
  for (int k = 0; k < width * height; ++k) {
    frame.beauty.insert(frame.beauty.end(), {red, 0.25F, 0.0F, 1.0F});
  }
  return make_picture(frame, {}, name, "made by hand");
}

// Other pixels of one colour are dithered otherwise.
bool are_alike(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) <= 1 && std::abs(a.green() - b.green()) <= 1 &&
         std::abs(a.blue() - b.blue()) <= 1;
}

// A viewer whose canvas is large enough for a wipe.
class TestViewer {
 public:
  TestViewer() {
    viewer.resize(800, 600);
    viewer.show();
    static_cast<void>(QTest::qWaitForWindowExposed(&viewer, patience));
  }
  void click(const char* name) { viewer.findChild<QAbstractButton*>(name)->click(); }
  void set_mode(int index) { viewer.findChild<QComboBox*>("picture_mode")->setCurrentIndex(index); }
  PictureCanvas& canvas() { return *viewer.findChild<PictureCanvas*>(); }
  QString text(const char* name) { return viewer.findChild<QLabel*>(name)->text(); }
  QColor color(QPointF fraction) {
    const QRectF rect = canvas().picture_rect();
    const QPointF at =
        rect.topLeft() + QPointF(fraction.x() * rect.width(), fraction.y() * rect.height());
    return canvas().grab().toImage().pixelColor(at.toPoint());
  }
  void move(QPointF to, Qt::MouseButton button) { move_mouse(canvas(), to, button); }
  void drag(QPointF from, QPointF to) {
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, from.toPoint());
    move(to, Qt::LeftButton);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, to.toPoint());
  }

  PictureViewer viewer;
};

}  // namespace

class PictureViewerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void slots_fill_in_order_and_the_oldest_goes_first() {
    PictureSlots pictures;
    for (std::size_t k = 0; k < PictureSlots::count; ++k) {
      QCOMPARE(pictures.keep(plain("a", 1.0F)), k);
    }
    pictures.set(0, plain("newer", 1.0F));
    QCOMPARE(pictures.keep(plain("b", 1.0F)), 1u);
    pictures.set(5, nullptr);
    QCOMPARE(pictures.keep_of_job(7, plain("c", 1.0F)), 5u);
    QCOMPARE(pictures.keep_of_job(7, plain("d", 1.0F)), 5u);
    QCOMPARE(*pictures.slot_of_job(7), 5u);
    pictures.set(5, nullptr);
    QVERIFY(!pictures.slot_of_job(7));
  }

  void layers_beyond_their_memory_go_from_the_oldest_pictures() {
    PictureSlots pictures;
    for (int k = 0; k < 3; ++k) {
      auto picture = std::make_shared<Picture>(*plain("a", 1.0F));
      picture->layers = {{"airlight", 3, picture->rgb}};
      pictures.keep(picture);
    }
    const std::size_t each = layer_bytes(*pictures.at(0));
    QCOMPARE(each, std::size_t{40 * 30 * 3 * 4});
    pictures.set_max_layer_bytes(2 * each);
    QVERIFY(pictures.at(0)->layers.empty());
    QVERIFY(!pictures.at(0)->image.isNull());
    QVERIFY(!pictures.at(1)->layers.empty() && !pictures.at(2)->layers.empty());
    pictures.set(0, pictures.at(2));
    QVERIFY(pictures.at(1)->layers.empty() && !pictures.at(0)->layers.empty());
  }

  void the_divider_shows_a_left_and_b_right() {
    TestViewer test;
    test.viewer.pictures().keep(plain("red", 1.0F));
    test.viewer.pictures().keep(plain("green", 0.0F));
    const QColor red = test.color({0.3, 0.2});
    QVERIFY(red.red() > 200);
    QVERIFY(are_alike(test.color({0.9, 0.2}), red));
    test.set_mode(1);
    QCOMPARE(test.color({0.3, 0.2}), red);
    const QColor green = test.color({0.9, 0.2});
    QVERIFY(green.red() < 10 && green.green() > 100);
    const QRectF rect = test.canvas().picture_rect();
    test.drag({rect.center().x(), rect.top() + 20}, {rect.left() + 0.1 * rect.width(), rect.top()});
    QVERIFY(std::abs(test.canvas().divider() - 0.1) < 0.01);
    QVERIFY(are_alike(test.color({0.3, 0.2}), green));
    QVERIFY(test.text("picture_info").contains("red") &&
            test.text("picture_info").contains("green"));
    test.click("slot_a_2");
    test.click("slot_b_1");
    QCOMPARE(test.color({0.3, 0.2}), red);
  }

  void differences_are_seen_and_told() {
    TestViewer test;
    test.viewer.pictures().keep(plain("a", 1.0F));
    test.viewer.pictures().keep(plain("b", 0.5F));
    test.set_mode(2);
    // rms(0.5, 0, 0) / rms(0.5, 0.25, 0)
    QTRY_VERIFY(test.text("picture_info").contains("89 %"));
    const QColor once = test.color({0.5, 0.5});
    QCOMPARE(once.green(), 0);
    QVERIFY(once.red() > 100);
    test.viewer.pictures().set(1, plain("b", 0.99F));
    QTRY_VERIFY(test.text("picture_info").contains("differs"));
    const int faint = test.color({0.5, 0.5}).red();
    QVERIFY(faint < once.red());
    test.viewer.findChild<QComboBox*>("difference_gain")->setCurrentIndex(2);
    QTRY_VERIFY(test.color({0.5, 0.5}).red() > faint);
    test.viewer.pictures().set(1, plain("other size", 1.0F, 20, 30));
    QVERIFY(!test.text("picture_info").contains("differs"));
    test.viewer.pictures().set(1, plain("b", 1.0F));
    QTRY_VERIFY(test.text("picture_info").contains("differs from B by 0"));
    test.viewer.pictures().set(1, nullptr);
    QVERIFY(!test.text("picture_info").contains("B"));
  }

  void the_pixel_under_the_mouse_is_told_at_any_zoom() {
    TestViewer test;
    test.viewer.pictures().keep(plain("a", 2.5F));
    PictureCanvas& canvas = test.canvas();
    const auto at = [&](double x, double y) {
      const QRectF rect = canvas.picture_rect();
      return rect.topLeft() + QPointF(x * rect.width() / 40.0, y * rect.height() / 30.0);
    };
    test.move(at(7.5, 3.5), Qt::NoButton);
    QVERIFY2(test.text("picture_pixel").contains("Pixel 7, 3\nA 2.5 0.25 0"),
             qPrintable(test.text("picture_pixel")));
    const QPointF fixed = at(7.5, 3.5);
    turn_wheel(canvas, fixed, 480);
    QVERIFY(canvas.picture_rect().width() > canvas.width());
    QCOMPARE(*canvas.pixel_at(fixed), QPoint(7, 3));
    test.drag(fixed, fixed + QPointF(30, 20));
    QCOMPARE(*canvas.pixel_at(fixed + QPointF(30, 20)), QPoint(7, 3));
    test.click("picture_fit");
    QVERIFY(canvas.picture_rect().width() <= canvas.width());
    test.move({-5, -5}, Qt::NoButton);
    QVERIFY(test.text("picture_pixel").trimmed().isEmpty());
    test.click("clear_slot");
    QVERIFY(!canvas.pixel_at(fixed));
  }

  void thumbnails_names_and_notes_tell_pictures_apart() {
    TestViewer test;
    PictureSlots& pictures = test.viewer.pictures();
    pictures.keep_of_job(3, plain("red", 1.0F));
    pictures.keep(plain("green", 0.0F));
    const auto thumbnail = [&](const char* name) {
      const QIcon icon = test.viewer.findChild<QToolButton*>(name)->icon();
      return icon.pixmap(96, 60).toImage().pixelColor(48, 30);
    };
    QVERIFY(thumbnail("slot_1").red() > 200 && thumbnail("slot_2").green() > 100);
    QVERIFY(thumbnail("slot_2").red() < 10);
    test.click("slot_2");
    QVERIFY(test.viewer.findChild<QAbstractButton*>("slot_a_2")->isChecked());
    test.click("slot_1");
    const auto type = [&](const char* field, const QString& text) {
      auto* line = test.viewer.findChild<QLineEdit*>(field);
      QTest::mouseClick(line, Qt::LeftButton);
      line->selectAll();
      QTest::keyClicks(line, text);
      QTest::keyClick(line, Qt::Key_Return);
    };
    type("picture_name", "with more fog");
    type("picture_note", "the client likes this one");
    QVERIFY(test.text("picture_info").startsWith("A: with more fog"));
    QVERIFY(test.viewer.findChild<QWidget*>("slot_1")->toolTip().contains("likes"));
    // The next frame of a render keeps both, another picture has its own.
    pictures.keep_of_job(3, plain("blue", 0.5F));
    QCOMPARE(pictures.name(0), "with more fog");
    test.click("slot_2");
    QCOMPARE(test.viewer.findChild<QLineEdit*>("picture_name")->text(), "green");
    QVERIFY(test.viewer.findChild<QLineEdit*>("picture_note")->text().isEmpty());
    pictures.set(0, plain("other", 1.0F));
    QCOMPARE(pictures.name(0), "other");
    QVERIFY(pictures.note(0).isEmpty());
  }

  void what_is_typed_stays_while_a_render_goes_on() {
    TestViewer test;
    PictureSlots& pictures = test.viewer.pictures();
    pictures.keep_of_job(3, plain("red", 1.0F));
    auto* note = test.viewer.findChild<QLineEdit*>("picture_note");
    QTest::mouseClick(note, Qt::LeftButton);
    QTest::keyClicks(note, "less");
    pictures.keep_of_job(3, plain("blue", 0.5F));
    QTest::keyClicks(note, " fog");
    QCOMPARE(note->text(), "less fog");
    // The first picture of another render takes the place of A.
    test.viewer.show_new(pictures.keep_of_job(4, plain("green", 0.0F)));
    QCOMPARE(pictures.note(0), "less fog");
    QVERIFY(note->text().isEmpty() && pictures.note(1).isEmpty());
  }

  void layers_of_pictures_are_shown_compared_and_told() {
    constexpr int width = 40;
    constexpr int height = 30;
    Frame frame;  // its right half is black, and far away
    frame.film = {width, height};
    std::vector<float> ones, nothing;
    for (int k = 0; k < width * height; ++k) {
      const float left = k % width < width / 2 ? 1.0F : 0.0F;
      frame.beauty.insert(frame.beauty.end(), {left, left, left, 1.0F});
      frame.airlight.insert(frame.airlight.end(), {0.0F, left, 0.0F});
      frame.depth.push_back(left > 0.0F ? 3.0F : std::numeric_limits<float>::infinity());
      ones.push_back(left);
      nothing.push_back(0.0F);
    }
    frame.layers.channels = {{"airlight.key.R", ones},
                             {"airlight.key.G", nothing},
                             {"airlight.key.B", nothing},
                             {"CryptoObject00.R", nothing}};
    TestViewer test;
    test.viewer.pictures().keep(make_picture(frame, {}, "frame", "by hand"));
    auto* layers = test.viewer.findChild<QComboBox*>("picture_layer");
    QStringList names;
    for (int k = 0; k < layers->count(); ++k) names << layers->itemText(k);
    QCOMPARE(names, (QStringList{"Picture", "airlight", "distance", "airlight.key"}));
    const auto show = [&](int index) {
      layers->setCurrentIndex(index);
      Q_EMIT layers->activated(index);
    };
    show(1);
    QTRY_VERIFY(test.color({0.25, 0.5}).green() > 100 && test.color({0.25, 0.5}).red() < 100);
    show(3);
    QTRY_VERIFY(test.color({0.25, 0.5}).red() > 100 && test.color({0.25, 0.5}).green() < 100);
    show(2);
    QTRY_VERIFY(test.color({0.25, 0.5}).blue() > 100 && test.color({0.75, 0.5}).blue() < 5);
    const QRectF rect = test.canvas().picture_rect();
    test.move(rect.topLeft() + QPointF(0.25 * rect.width(), 0.5 * rect.height()), Qt::NoButton);
    QVERIFY2(test.text("picture_pixel").contains("A 3 3 3"),
             qPrintable(test.text("picture_pixel")));
    // Another picture without the layer is shown as it is.
    test.viewer.pictures().keep(plain("plain", 1.0F));
    test.click("slot_a_2");
    QCOMPARE(layers->currentText(), "Picture");
    QVERIFY(test.color({0.5, 0.5}).red() > 200);
  }

  void scopes_show_how_values_are_spread() {
    TestViewer test;
    test.viewer.pictures().keep(plain("red", 0.2F));
    auto& scope = *test.viewer.findChild<PictureScope*>();
    QVERIFY(!scope.isVisible());
    auto* kind = test.viewer.findChild<QComboBox*>("picture_scope_kind");
    kind->setCurrentIndex(2);
    QVERIFY(scope.isVisible());
    // The row where a column of the scope is brightest in a channel, as a value of the display.
    const QImage shown = test.viewer.pictures().at(0)->image;
    const auto brightest = [&](int channel) {
      const QImage image = scope.grab().toImage();
      int best = 0;
      int value = -1;
      for (int y = 0; y < image.height(); ++y) {
        const QColor color = image.pixelColor(image.width() / 3, y);
        const int found = channel == 0 ? color.red() : color.blue();
        if (found > best) {
          best = found;
          value = 255 - 255 * y / image.height();
        }
      }
      return value;
    };
    QVERIFY(std::abs(brightest(0) - shown.pixelColor(13, 15).red()) < 8);
    QVERIFY(brightest(2) < 8);
    kind->setCurrentIndex(1);
    const QImage histogram = scope.grab().toImage();
    const int x = shown.pixelColor(13, 15).red() * histogram.width() / 256;
    int reds = 0;
    for (int dx = -2; dx <= 2; ++dx) {
      reds = std::max(reds, histogram.pixelColor(x + dx, histogram.height() / 2).red());
    }
    QVERIFY(reds > 100);
    QVERIFY(histogram.pixelColor(histogram.width() - 4, histogram.height() / 2).red() < 100);
    kind->setCurrentIndex(0);
    QVERIFY(!scope.isVisible());
  }

  void the_viewer_is_a_window_that_remembers_its_place() {
    QRect place;
    {
      TestWindow window(tiny_scene());
      auto& viewer = *window->findChild<PictureViewer*>();
      auto* action = window->findChild<QAction*>("render.viewer");
      QVERIFY(viewer.isWindow() && !viewer.isModal() && !viewer.isVisible());
      invoke(window, "render.viewer");
      QVERIFY(viewer.isVisible() && action->isChecked());
      QVERIFY(!viewer.windowHandle()->transientParent());
      viewer.setGeometry(123, 45, 678, 567);
      place = viewer.geometry();
      viewer.close();
      QVERIFY(!action->isChecked());
    }
    TestWindow window(tiny_scene());
    auto& viewer = *window->findChild<PictureViewer*>();
    invoke(window, "render.viewer");
    QCOMPARE(viewer.geometry(), place);
    viewer.showMinimized();
    window->findChild<QAction*>("render.keep_view")->trigger();
    QTRY_VERIFY(viewer.pictures().at(0) && !viewer.isMinimized());
    viewer.pictures().set(0, nullptr);
    // Keys of renders are its own, too; it goes with the window.
    QTest::keyClick(&viewer, Qt::Key_F9);
    QTRY_VERIFY(viewer.pictures().at(0));
    QVERIFY(window->close());
    QVERIFY(!viewer.isVisible());
  }

  void a_click_after_typing_leaves_the_viewer_active() {
    TestWindow window(tiny_scene());
    auto& viewer = *window->findChild<PictureViewer*>();
    invoke(window, "render.viewer");
    viewer.pictures().keep(plain("a", 1.0F));
    QTRY_VERIFY(viewer.isActiveWindow());
    auto& name = *viewer.findChild<QLineEdit*>("picture_name");
    QTest::mouseClick(&name, Qt::LeftButton);
    QTest::keyClicks(&name, "b");
    QTest::mouseClick(viewer.findChild<PictureCanvas*>(), Qt::LeftButton);
    QCOMPARE(viewer.pictures().name(0), "ab");
    QVERIFY(!name.hasFocus());
    QCoreApplication::processEvents();
    QVERIFY(viewer.isActiveWindow());
  }

  void pictures_are_saved_as_they_look() {
    const QTemporaryDir folder;
    const auto picture = plain("a", 0.5F);
    const std::filesystem::path file = to_path(folder.filePath("a.png"));
    save_picture(*picture, file, "a name", "a note");
    QCOMPARE(QImage(to_qstring(file)).text("Title"), "a name");
    QCOMPARE(QImage(to_qstring(file)).text("Comment"), "a note");
    const QImage saved = QImage(to_qstring(file)).convertToFormat(picture->image.format());
    QCOMPARE(saved.size(), picture->image.size());
    QCOMPARE(saved.pixelColor(3, 4), picture->image.pixelColor(3, 4));
    QVERIFY_EXCEPTION_THROWN(save_picture(*picture, file / "b.png", "b", {}), InputError);
  }

  void the_view_is_kept() {
    TestWindow window;
    auto& viewer = *window->findChild<PictureViewer*>();
    window.key(Qt::Key_F9);
    QVERIFY(viewer.isVisible());
    const RenderedFrame& shown = *window->viewport().frames().shown();
    const Picture& kept = *viewer.pictures().at(0);
    QCOMPARE(kept.width, shown.frame.film.width);
    QVERIFY(kept.image == shown.picture.convertToFormat(kept.image.format()));
    QVERIFY2(kept.details.contains("error"), qPrintable(kept.details));
  }
};

BRUME_APP_SUITE("picture_viewer", PictureViewerTest)
#include "picture_viewer_test.moc"
