// How large the window and its panels are, and how the plot in them is lettered.

#include <QDockWidget>
#include <QMenu>
#include <QScreen>
#include <QSettings>

#include "app/panels/plots/frontier_plot.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

// A small laptop, less the bars of its desktop and the frame of the window.
constexpr QSize small_screen{1280, 660};

QList<QRectF> places_of(const std::vector<FrontierPlot::Label>& labels) {
  QList<QRectF> places;
  for (const FrontierPlot::Label& label : labels) places << label.place;
  return places;
}

FrontierPlot::Point point(double error, double milliseconds) {
  FrontierPlot::Point made;
  made.error.rel_rmse = error;
  made.error.low = 0.5 * error;
  made.error.high = 3.0 * error;
  made.milliseconds = milliseconds;
  return made;
}

}  // namespace

class LayoutTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_first_window_fits_on_the_screen() {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    const QSize room = window.screen()->availableSize();
    QVERIFY(window.frameSize().width() <= room.width());
    QVERIFY(window.frameSize().height() <= room.height());
  }

  void a_window_left_on_a_larger_screen_fits_on_this_one() {
    QWidget left;
    left.setGeometry(0, 0, 5000, 4000);
    QSettings().setValue("window/geometry", left.saveGeometry());
    MainWindow window;
    window.show();
    QVERIFY(window.screen()->availableGeometry().contains(window.geometry()));
    QSettings().clear();
  }

  void every_panel_fits_on_a_small_screen() {
    TestWindow window;
    const auto fits = [&window] {
      const QSize min_value = window->minimumSizeHint();
      return min_value.width() <= small_screen.width() &&
             min_value.height() <= small_screen.height();
    };
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
      QCoreApplication::processEvents();
      const QSize min_value = window->minimumSizeHint();
      QVERIFY2(fits(), qPrintable(QString("%1: %2 x %3")
                                      .arg(dock->objectName())
                                      .arg(min_value.width())
                                      .arg(min_value.height())));
    }
    window->resize(small_screen);
    QTRY_COMPARE(window->size(), small_screen);
  }

  void numbers_of_the_axis_do_not_overlap_however_large_errors_are() {
    FrontierPlot plot;
    for (const double error : {0.01, 20.58, 1e9}) {
      plot.show_points({point(0.01, 3.0), point(error, 40.0)}, 0.02);
      for (const QSize size : {plot.minimumSizeHint(), plot.sizeHint(), QSize(400, 300)}) {
        plot.resize(size);
        const auto labels = plot.error_labels();
        QVERIFY(labels.size() >= 2);
        const QList<QRectF> places = places_of(labels);
        for (int a = 0; a < places.size(); ++a) {
          for (int b = 0; b < a; ++b) QVERIFY(!places[a].intersects(places[b]));
        }
        const QFontMetricsF metrics(plot.font());
        for (const FrontierPlot::Label& label : labels) {
          QVERIFY2(!label.text.contains('+'), qPrintable(label.text));  // as in 1e+03 %
          QVERIFY2(metrics.horizontalAdvance(label.text) <= label.place.width() + 0.5,
                   qPrintable(label.text));
        }
        QVERIFY(plot.minimumSizeHint() == QSize(110, 90));  // whatever it shows
      }
    }
  }

  void disabled_entries_of_menus_are_flat() {
    QMenu menu;
    menu.addAction("MMMMMMMM")->setEnabled(false);
    menu.resize(menu.sizeHint());
    const QImage picture = menu.grab().toImage();
    // Nothing is brighter than the text on the dark ground: an embossed text has a light edge.
    const int text = menu.palette().color(QPalette::Disabled, QPalette::WindowText).lightness();
    int brightest = 0;
    for (int y = 4; y < picture.height() - 4; ++y) {
      for (int x = 4; x < picture.width() - 4; ++x) {
        brightest = std::max(brightest, picture.pixelColor(x, y).lightness());
      }
    }
    QVERIFY2(brightest <= text + 3, qPrintable(QString::number(brightest)));
    QVERIFY(brightest > text / 2);
  }
};

BRUME_APP_SUITE("layout", LayoutTest)
#include "layout_test.moc"
