// Fog is laid on what is under the mouse, where the camera sees it: strokes, sprays, emitters and
// what is pasted, in all templates; and where strokes go on from there.

#include <QClipboard>
#include <QGuiApplication>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/commands/gaussians/clipboard.h"
#include "app/tools/brushes/airbrush_tool.h"
#include "app/tools/brushes/paintbrush_tool.h"
#include "app/view/drawing/overlay.h"
#include "app/view/paint_point.h"
#include "brume/render.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/desk.h"

using namespace brume;

namespace {

constexpr double shrink = 5.0;  // of pictures that are compared

class TemplateDesk : public Desk {
 public:
  explicit TemplateDesk(const char* name) {
    document().open(
        load_scene(std::filesystem::path(BRUME_RESOURCES) / "templates" / (name + suffix)), {});
    if (!picks()) qFatal("no surfaces to pick");
  }

  QPoint place(double x, double y) {
    return (QPointF(view().width() * x, view().height() * y)).toPoint();
  }
  // The picture that the view's camera sees at a time, in light scattered once.
  Frame picture(double time = 0.0) {
    Film film = view().film();
    film.width = static_cast<int>(film.width / shrink);
    film.height = static_cast<int>(film.height / shrink);
    return *renderer_.render(scene(), {.film = film,
                                       .camera = view().shown_camera(),
                                       .time = time,
                                       .airlight = AirlightMethod::sliced,
                                       .scattering = Scattering::single,
                                       .slices = 8,
                                       .samples = 1});
  }

 private:
  inline static const std::string suffix = ".brume";
  SceneRenderer renderer_;
};

double luminance_at(const Frame& frame, std::size_t pixel) {
  const float* rgba = &frame.beauty[4 * pixel];
  return rgba[0] + rgba[1] + rgba[2];
}

bool has_changed(const Frame& before, const Frame& after, std::size_t pixel) {
  const double was = luminance_at(before, pixel);
  return std::abs(luminance_at(after, pixel) - was) > 0.01 * was;
}

// The share of the pixels along a line of the view that changed by more than 1%.
double changed_share(const Frame& before, const Frame& after, QPointF first, QPointF last) {
  constexpr int count = 40;
  int changed = 0;
  for (int k = 0; k < count; ++k) {
    const QPointF at = (first + (last - first) * (k + 0.5) / count) / shrink;
    const auto pixel =
        static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(before.film.width) +
        static_cast<std::size_t>(at.x());
    changed += has_changed(before, after, pixel);
  }
  return static_cast<double>(changed) / count;
}

int changed_pixels(const Frame& before, const Frame& after) {
  int changed = 0;
  for (std::size_t k = 0; 4 * k < before.beauty.size(); ++k)
    changed += has_changed(before, after, k);
  return changed;
}

QString text(const char* name, QPointF at, double value) {
  return QString("%1, %2, %3: %4").arg(name).arg(at.x()).arg(at.y()).arg(value);
}

// Strokes begin near the ground, on walls, on what stands there, and in the sky.
constexpr double places[10][2] = {{0.15, 0.85}, {0.5, 0.92}, {0.8, 0.8},   {0.3, 0.65},
                                  {0.6, 0.6},   {0.08, 0.4}, {0.88, 0.45}, {0.45, 0.5},
                                  {0.35, 0.2},  {0.55, 0.25}};

Surface solid(Primitive::Shape shape, const glm::dvec3& size, const glm::dvec3& center) {
  Surface surface;
  surface.primitive = Primitive{shape, size};
  surface.mesh = mesh_of(*surface.primitive);
  surface.translate = center;
  return surface;
}

// The eye at the origin's height 2 looks along -z at a point 10 away: a floor until z = -10, a post
// at z = -4, a wall at z = -30 whose upper half is the sky.
Scene post_and_wall() {
  Scene scene = small_scene();
  scene.medium = {};
  scene.camera = {{0, 2, 0}, {0, 2, -10}, {0, 1, 0}, 60.0};
  scene.surfaces = {solid(Primitive::Shape::box, {30, 1, 30}, {0, -0.5, 5}),
                    solid(Primitive::Shape::box, {0.5, 4, 0.5}, {1, 2, -4}),
                    solid(Primitive::Shape::box, {60, 40, 1}, {0, -20 + 4, -30.5})};
  return scene;
}

double depth(Desk& desk, const glm::dvec3& point) {
  return desk.view().rays().project(point).z;
}

}  // namespace

class UnderMouseTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void strokes_are_seen_where_they_are_drawn_data() { add_templates(); }
  void strokes_are_seen_where_they_are_drawn() {
    QFETCH(QByteArray, name);
    TemplateDesk desk(name);
    desk.key(Qt::Key_B);
    const Frame before = desk.picture();
    for (const auto& [x, y] : places) {
      const QPoint first = desk.place(x, y);
      const QPoint last = desk.place(x + 0.08, y - 0.03);
      const std::size_t count = desk.document().medium().size();
      desk.drag(first, last);
      QCOMPARE(step_count(desk.document()), 1);
      QVERIFY(desk.document().medium().size() > count);
      const double share = changed_share(before, desk.picture(), first, last);
      QVERIFY2(share > 0.7, qPrintable(text(name, QPointF(x, y), share)));
      desk.document().undo_stack().undo();
      desk.document().undo_stack().clear();
    }
  }

  void sprays_emitters_and_pastes_are_seen_data() { add_templates(); }
  void sprays_emitters_and_pastes_are_seen() {
    QFETCH(QByteArray, name);
    TemplateDesk desk(name);
    Document& document = desk.document();
    const Frame before = desk.picture();
    constexpr int enough = 20;
    qint64 now = 0;
    const auto verify_seen = [&](const char* what, double time) {
      const int changed = changed_pixels(before, desk.picture(time));
      QVERIFY2(changed > enough, qPrintable(text(name + what, {}, changed)));
      document.undo_stack().undo();
      document.undo_stack().clear();
    };
    for (const auto& [x, y] : {std::pair(0.3, 0.85), std::pair(0.6, 0.6), std::pair(0.1, 0.4)}) {
      const QPoint place = desk.place(x, y);
      desk.key(Qt::Key_A);
      auto& airbrush = dynamic_cast<AirbrushTool&>(desk.tools().tool());
      airbrush.set_clock([&now] { return now; });
      desk.press(place);
      now += 1000;
      desk.move(place + QPoint(1, 0));
      desk.release(place);
      verify_seen(" spray", 0.0);

      desk.key(Qt::Key_P);
      desk.click(place);
      verify_seen(" emitter", 1.0);

      QTest::mouseMove(&desk.view(), place);
      QTRY_VERIFY(desk.view().underMouse());
      QGuiApplication::clipboard()->setText(gaussians_to_text(
          {{{0, 0, 0}, 0.05 * desk.view().distance(), 10.0 / desk.view().distance()}}));
      paste_gaussians(document, desk.view().place_under_mouse(clipboard_radius()));
      const glm::dvec3 pasted = document.medium().centers().back();
      const QPoint shown = film_position(desk.view(), pasted);
      QVERIFY2((shown - place).manhattanLength() < 3, qPrintable(text(name, shown, 0.0)));
      verify_seen(" paste", 0.0);
    }
  }

  // The stroke goes beyond the floor's edge, over the wall far behind and the sky above that.
  void a_stroke_that_leaves_a_surface_keeps_its_depth() {
    Desk desk(post_and_wall());
    QVERIFY(desk.picks());
    DeskView& view = desk.view();
    const QPoint edge = film_position(view, {-1, 0, -10});
    std::optional<StrokeDepth> stroke;
    const auto extend = [&](double x, double y) {
      const auto point = paint_point(view, {}, {x, y}, 0.1, stroke);
      if (!point) qFatal("no point");
      if (stroke) {
        stroke->extend(*point);
      } else {
        stroke.emplace(*point);
      }
      return *point;
    };
    double last = 0.0;
    for (int y = view.height() - 5; y > edge.y() + 1; y -= 2) {
      const PaintPoint point = extend(edge.x(), y);
      QVERIFY(point.on_surface);
      QVERIFY(point.position.y > 0.0 && point.position.y < 0.11);
      QVERIFY(depth(desk, point.position) > last);  // on along the floor
      last = depth(desk, point.position);
    }
    QVERIFY(last > 9.0 && last < 10.0);
    for (int y = edge.y() - 1; y > 5; y -= 2) {
      const PaintPoint point = extend(edge.x(), y);
      QVERIFY(!point.on_surface);
      QVERIFY(std::abs(depth(desk, point.position) - last) < 1e-9);
    }
    // It comes back to the floor.
    QVERIFY(extend(edge.x(), view.height() - 5).on_surface);
  }

  void a_stroke_passes_in_front_of_a_post() {
    Desk desk(post_and_wall());
    QVERIFY(desk.picks());
    desk.key(Qt::Key_B);
    auto& tool = dynamic_cast<PaintbrushTool&>(desk.tools().tool());
    tool.set_brush({.radius = 0.2, .density = 1.0, .spacing = 0.5, .scatter = 0.0});
    const QPoint post = film_position(desk.view(), {1, 1.9, -3.75});
    desk.drag(post - QPoint(100, 0), post + QPoint(100, 0));
    int before_post = 0;
    for (const glm::dvec3& center : desk.document().medium().centers()) {
      const bool on_wall = center.z < -29.4;
      const bool on_post = center.z > -4.25 && center.z < -3.4;
      QVERIFY2(on_wall || on_post, qPrintable(QString::number(center.z)));  // nothing between
      before_post += on_post;
    }
    QVERIFY(before_post > 0);
    const auto centers = desk.document().medium().centers();
    QVERIFY(centers.front().z < -20.0 && centers.back().z < -20.0);
  }

  void without_surfaces_fog_has_the_depth() {
    Scene scene = post_and_wall();
    scene.surfaces.clear();
    scene.medium.append({{0, 2, -5}, 0.5, 0.4});
    Desk desk(scene);
    const QPointF middle = QRectF(desk.view().rect()).center();
    const auto depth_at = [&](QPointF at) {
      return depth(desk, paint_point(desk.view(), {}, at, 0.1)->position);
    };
    QVERIFY(std::abs(depth_at(middle) - 5.0) < 0.05);
    // There is only the plane through what the camera looks at.
    QVERIFY(std::abs(depth_at(middle + QPointF(250, 0)) - 10.0) < 1e-6);
    // A stroke that began in the fog goes on at its depth.
    const auto begin = paint_point(desk.view(), {}, middle, 0.1);
    const auto next =
        paint_point(desk.view(), {}, middle + QPointF(250, 0), 0.1, StrokeDepth(*begin));
    QVERIFY(std::abs(depth(desk, next->position) - depth_at(middle)) < 1e-6);
  }

  // The grid moves points, not the plane that a stroke stays on.
  void a_grid_leaves_the_plane_of_a_stroke() {
    Desk desk(post_and_wall());
    const QPointF middle = QRectF(desk.view().rect()).center();
    const PaintTarget target{.plane = PaintPlane::view, .snaps_to_grid = true, .grid = 0.7};
    const auto begin = paint_point(desk.view(), target, middle, 0.1);
    const auto next =
        paint_point(desk.view(), target, middle + QPointF(60, 0), 0.1, StrokeDepth(*begin));
    QVERIFY(std::abs(std::remainder(next->position.z, 0.7)) < 1e-9);
    QVERIFY(std::abs(depth(desk, next->unsnapped) - 10.0) < 1e-9);
  }

  // Half of the light is lost after ln 2 mean free paths; the wall is 30 away.
  void fog_that_hides_a_surface_is_painted_in() {
    Scene scene = post_and_wall();
    scene.medium.set_homogeneous_density(0.1);
    scene.optics.albedo = glm::dvec3(0.5);
    Desk desk(scene);
    QVERIFY(desk.picks());
    const QPoint wall = film_position(desk.view(), {-5, 3, -30});
    const auto point = paint_point(desk.view(), {}, wall, 0.1);
    QVERIFY(!point->on_surface);
    QVERIFY(std::abs(glm::distance(point->position, scene.camera.eye) - std::log(2.0) / 0.2) <
            1e-4);
    QVERIFY(paint_point(desk.view(), {}, film_position(desk.view(), {0, 0, -2}), 0.1)->on_surface);
  }

  void the_cursor_shows_what_a_click_lays() {
    Desk desk(post_and_wall());
    QVERIFY(desk.picks());
    desk.key(Qt::Key_B);
    auto& tool = dynamic_cast<PaintbrushTool&>(desk.tools().tool());
    tool.set_brush({.radius = 0.3, .density = 2.0});
    const QPoint floor = film_position(desk.view(), {0, 0, -4});
    struct Cursor {
      std::size_t lines = 0;
      int max_alpha = 0;
      double width = 0.0;  // of the ghost [pixels]
    };
    const auto cursor_on = [&](PaintPlane plane) {
      tool.set_plane(plane);
      tool.hover(floor);
      Overlay overlay;
      tool.draw(overlay, desk.view().rays());
      Cursor cursor{overlay.lines.size()};
      for (const Overlay::Vertex& vertex : overlay.triangles) {
        cursor.max_alpha = std::max(cursor.max_alpha, qAlpha(vertex.color));
        cursor.width = std::max(cursor.width, 2.0 * std::abs(vertex.x - floor.x()));
      }
      return cursor;
    };
    const Cursor seen = cursor_on(PaintPlane::under_mouse);
    QVERIFY(seen.max_alpha > 50);
    // The ghost is as wide as 1% of the density reaches.
    const CameraRays rays = desk.view().rays();
    const auto point = paint_point(desk.view(), {}, floor, 0.3);
    const double reach = 0.3 * std::sqrt(std::log(100.0));
    const double pixels_per_unit = glm::length(rays.project(point->position + glm::dvec3(1, 0, 0)) -
                                               rays.project(point->position));
    QVERIFY(std::abs(seen.width / (2.0 * reach * pixels_per_unit) - 1.0) < 0.05);
    // Below the floor it is dashed, and nothing of it would be seen.
    const Cursor hidden = cursor_on(PaintPlane::view);
    QCOMPARE(hidden.max_alpha, 0);
    QVERIFY(hidden.lines < seen.lines);
  }

 private:
  static void add_templates() {
    QTest::addColumn<QByteArray>("name");
    for (const char* name : {"street", "room", "landscape", "stage"}) {
      QTest::newRow(name) << QByteArray(name);
    }
  }
};

BRUME_APP_SUITE("under_mouse", UnderMouseTest)
#include "under_mouse_test.moc"
