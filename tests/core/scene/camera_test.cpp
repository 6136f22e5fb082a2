#include "core/scene/camera_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/scene/cameras.h"
#include "core/transport/optical_depth.h"

namespace brume {
namespace {

TEST(CameraRays, CenterOfTheFilmLooksAtTheTarget) {
  const CameraRays rays({{1, 2, 3}, {4, 0, -1}, {0, 1, 0}, 50.0}, {640, 480});
  const glm::dvec3 forward = glm::normalize(glm::dvec3(3, -2, -4));
  EXPECT_LT(glm::length(rays.direction(320, 240) - forward), 1e-12);
}

TEST(CameraRays, VerticalFieldOfViewIsTheFullAngle) {
  const CameraRays rays({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40.0}, {800, 600});
  const double cosine = glm::dot(rays.direction(400, 0), rays.direction(400, 600));
  EXPECT_NEAR(std::acos(cosine), 40.0 / 180.0 * std::acos(-1.0), 1e-12);
  EXPECT_GT(rays.direction(400, 0).y, 0.0);  // rows from the top
  EXPECT_GT(rays.direction(800, 300).x, 0.0);
}

TEST(CameraRays, ProjectUndoesDirection) {
  const CameraRays rays({{1, 2, 3}, {4, 0, -1}, {0.1, 1, 0}, 70.0}, {640, 480});
  for (const auto& [x, y] : {std::pair{0.5, 0.5}, {320.0, 17.0}, {639.0, 479.0}}) {
    const glm::dvec3 p = rays.project(rays.eye() + 7.0 * rays.direction(x, y));
    EXPECT_NEAR(p.x, x, 1e-9);
    EXPECT_NEAR(p.y, y, 1e-9);
    EXPECT_GT(p.z, 0.0);
  }
  EXPECT_LT(rays.project(rays.eye() - rays.forward()).z, 0.0);
}

Camera orthographic_camera() {
  Camera camera{{1, 2, 3}, {4, 0, -1}, {0.1, 1, 0}};
  camera.height = 3.0;
  return camera;
}

TEST(CameraRays, OfAnOrthographicCameraAreParallelAndStartInThePlaneOfTheEye) {
  const CameraRays rays(orthographic_camera(), {640, 480});
  EXPECT_EQ(rays.direction(3.0, 400.0), rays.forward());
  for (const auto& [x, y] : {std::pair{0.5, 0.5}, {320.0, 17.0}, {639.0, 479.0}}) {
    EXPECT_NEAR(glm::dot(rays.offset(x, y), rays.forward()), 0.0, 1e-14);
    const glm::dvec3 p = rays.project(rays.origin(x, y) + 7.0 * rays.direction(x, y));
    EXPECT_NEAR(p.x, x, 1e-9);
    EXPECT_NEAR(p.y, y, 1e-9);
    EXPECT_NEAR(p.z, 7.0, 1e-12);
    EXPECT_NEAR(rays.distance_to(rays.origin(x, y) - 2.0 * rays.forward()), -2.0, 1e-12);
    EXPECT_EQ(rays.towards(rays.origin(x, y)), rays.forward());
  }
  const glm::dvec3 down = rays.offset(320.0, 480.0) - rays.offset(320.0, 0.0);
  EXPECT_LT(glm::length(down + 3.0 * rays.up()), 1e-14);
  EXPECT_LT(glm::length(rays.offset(320.0, 240.0)), 1e-15);
  EXPECT_NEAR(glm::length(rays.offset(640.0, 240.0)), 2.0, 1e-14);
  EXPECT_NEAR(rays.max_offset(), 2.5, 1e-14);
  EXPECT_NEAR(rays.pixel_width(), 3.0 / 480.0, 1e-15);
  EXPECT_EQ(rays.pixel_half_angle(), 0.0);
}

// A region of a shifted film has the rays of the whole one.
TEST(CameraRays, OfAnOrthographicCameraAreThoseOfTheWholeFilmInARegion) {
  Film whole{64, 48};
  whole.shift = {0.3, -1.7};
  Film part{10, 8, FilmRegion{20, 30, 64, 48}, whole.shift};
  const CameraRays rays(orthographic_camera(), whole), region(orthographic_camera(), part);
  EXPECT_EQ(region.offset(2.5, 3.5), rays.offset(22.5, 33.5));
  Film unshifted{64, 48};
  EXPECT_LT(glm::length(rays.offset(10.5, 20.5) -
                        CameraRays(orthographic_camera(), unshifted).offset(10.8, 18.8)),
            1e-14);
}

TEST(CameraRays, OfAnOrthographicCameraBoundBallsAndEllipsoids) {
  const Film film{64, 48};
  const CameraRays rays(orthographic_camera(), film);
  Gaussian needle{{}, 0.6, 1.0};
  needle.set_radii({0.6, 0.1, 0.3}, glm::normalize(glm::dquat(0.3, 0.5, -0.2, 0.7)));
  for (const Gaussian& shape : {Gaussian{{}, 0.4, 1.0}, needle}) {
    for (const double x : {-9.0, 3.0, 31.5, 62.0, 70.0}) {
      for (const double along : {-0.3, 0.2, 5.0}) {
        Gaussian gaussian = shape;
        gaussian.center = rays.origin(x, 20.0) + along * rays.forward();
        const StandaloneTerm term(gaussian);
        const double radius = gaussian.radius;
        const CameraRays::PixelRectangle r = rays.bounds_on_whole(*term, radius);
        for (int j = 0; j < film.height; ++j) {
          for (int i = 0; i < film.width; ++i) {
            const LineProfile<double> line =
                line_profile(*term, rays.origin(i + 0.5, j + 0.5), rays.forward());
            const double e = (0.999 * radius * (*term).a) * (0.999 * radius * (*term).a);
            if (line.e > e || line.t0 + std::sqrt(e - line.e) / line.a <= 0.0) continue;
            EXPECT_TRUE(i >= r.x0 && i < r.x1 && j >= r.y0 && j < r.y1) << i << ' ' << j;
          }
        }
      }
    }
    Gaussian behind = shape;
    behind.center = rays.eye() - 0.7 * rays.forward();
    EXPECT_TRUE(rays.bounds_on_whole(*StandaloneTerm(behind), behind.radius).empty());
  }
}

TEST(Cameras, OrthographicAndPerspectiveSeeAsMuchAtTheTarget) {
  Camera camera{{0, 1, 5}, {0, 1, 0}, {0, 1, 0}, 40.0};
  camera.aperture = 0.1;
  const Camera parallel = orthographic(camera);
  EXPECT_EQ(parallel.aperture, 0.0);
  EXPECT_NEAR(*parallel.height, 10.0 * std::tan(glm::radians(20.0)), 1e-12);
  const Film film{64, 48};
  const glm::dvec3 corner = CameraRays(camera, film).project({1.0, 2.0, 0.0});
  EXPECT_LT(glm::length(glm::dvec2(CameraRays(parallel, film).project({1.0, 2.0, 0.0})) -
                        glm::dvec2(corner)),
            1e-9);
  const Camera back = perspective(parallel);
  EXPECT_FALSE(back.height);
  EXPECT_NEAR(back.vertical_fov, 40.0, 1e-12);
}

TEST(CameraRays, UpAlongTheViewStillHasAFrame) {
  const CameraRays rays({{0, 5, 0}, {0, 0, 0}, {0, 1, 0}, 40.0}, {8, 8});
  const glm::dvec3 d = rays.direction(1, 1);
  EXPECT_NEAR(glm::length(d), 1.0, 1e-12);
  EXPECT_LT(d.y, 0.0);
}

TEST(CameraRays, RollLeansTheTopToItsOwnRight) {
  Camera camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40.0};
  camera.roll = 90.0;
  const Film film{64, 64};
  const CameraRays rays(camera, film);
  EXPECT_LT(glm::length(rays.up() - glm::dvec3(1, 0, 0)), 1e-15);
  // What was on top is on the left.
  const glm::dvec3 top = rays.project({0, 1, 0});
  EXPECT_LT(top.x, 32.0);
  EXPECT_NEAR(top.y, 32.0, 1e-12);
  // Turned by the angle, `up` alone gives the same rays.
  camera.roll = 30.0;
  Camera turned = camera;
  turned.roll = 0.0;
  turned.up = {std::sin(glm::radians(30.0)), std::cos(glm::radians(30.0)), 0.0};
  EXPECT_LT(glm::length(CameraRays(camera, film).direction(3, 5) -
                        CameraRays(turned, film).direction(3, 5)),
            1e-15);
}

TEST(CameraRays, ARegionHasTheRaysOfTheWholeFilm) {
  const Camera camera{{1, 2, 3}, {4, 0, -1}, {0.1, 1, 0}, 70.0};
  const Film whole{640, 480};
  const Film part = film_region(whole, {0.75, 0.5}, {0.25, 0.25});
  EXPECT_EQ(part, (Film{320, 120, FilmRegion{160, 120, 640, 480}}));
  const CameraRays all(camera, whole);
  const CameraRays rays(camera, part);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(rays.direction(3 * i + 0.5, i + 0.5), all.direction(3 * i + 160.5, i + 120.5));
  }
  EXPECT_EQ(rays.pixel_half_angle(), all.pixel_half_angle());
  const glm::dvec3 point = rays.eye() + 7.0 * rays.direction(30.0, 40.0);
  EXPECT_NEAR(rays.project(point).x, 30.0, 1e-9);
  EXPECT_NEAR(rays.project(point).y, 40.0, 1e-9);
  EXPECT_EQ(rays.project_on_whole(point), all.project(point));
  const GaussianTerm<double> ball(1.0, 1.0, point);
  EXPECT_EQ(rays.bounds_on_whole(ball, 0.3), all.bounds_on_whole(ball, 0.3));
  EXPECT_FALSE(rays.bounds_on_whole(ball, 0.3).empty());
}

TEST(CameraRays, RegionsHaveAtLeastAPixelOfTheFilm) {
  for (const glm::dvec2 at : {glm::dvec2(0.0), glm::dvec2(1.0), glm::dvec2(0.5, 0.999)}) {
    const Film film = film_region({10, 10}, at, at);
    EXPECT_EQ(film.width, 1);
    EXPECT_EQ(film.height, 1);
    EXPECT_LT(film.region->x, 10);
    EXPECT_LT(film.region->y, 10);
  }
  EXPECT_EQ(film_region({10, 20}, {0, 0}, {1, 1}), (Film{10, 20, FilmRegion{0, 0, 10, 20}}));
  // A third of three pixels is one, whatever rounding makes of it.
  EXPECT_EQ(film_region({3, 3}, {1.0 / 3.0, 0.0}, {2.0 / 3.0, 1.0}).width, 1);
}

}  // namespace
}  // namespace brume
