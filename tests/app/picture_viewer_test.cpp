// Pictures kept in slots, and their comparison.

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <QWheelEvent>

#include "app/document/paths.h"
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

// A viewer 400 pixels wide, its canvas large enough for a wipe.
class TestViewer {
 public:
  TestViewer() {
    viewer.resize(440, 480);
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
    QVERIFY2(test.text("picture_pixel").contains("Pixel 7, 3   A 2.5 0.25 0"),
             qPrintable(test.text("picture_pixel")));
    const QPointF fixed = at(7.5, 3.5);
    QWheelEvent wheel(fixed, canvas.mapToGlobal(fixed), {}, {0, 480}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas, &wheel);
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

  void pictures_are_saved_as_they_look() {
    const QTemporaryDir folder;
    const auto picture = plain("a", 0.5F);
    const std::filesystem::path file = to_path(folder.filePath("a.png"));
    save_picture(*picture, file);
    const QImage saved = QImage(to_qstring(file)).convertToFormat(picture->image.format());
    QCOMPARE(saved.size(), picture->image.size());
    QCOMPARE(saved.pixelColor(3, 4), picture->image.pixelColor(3, 4));
    QVERIFY_EXCEPTION_THROWN(save_picture(*picture, file / "b.png"), InputError);
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
