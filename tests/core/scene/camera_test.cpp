#include "core/scene/camera_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

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
