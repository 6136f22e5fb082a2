#include "render/samples/pixel_filter.h"
#include "core/scene/camera_rays.h"
#include "render/samples/exposure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace brume {
namespace {

TEST(PixelFilter, IsADensityOfUnitIntegral) {
  constexpr int steps = 3000;
  double integral = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double x = pixel_filter::width * ((i + 0.5) / steps - 0.5);
    EXPECT_GE(pixel_filter::density(x), 0.0);
    EXPECT_NEAR(pixel_filter::density(x), pixel_filter::density(-x), 1e-12);
    integral += pixel_filter::density(x) * pixel_filter::width / steps;
  }
  EXPECT_NEAR(integral, 1.0, 1e-9);
  EXPECT_EQ(pixel_filter::density(0.76), 0.0);
  EXPECT_LT(pixel_filter::density(0.749), 1e-3);
}

TEST(PixelFilter, SamplesByItsDensity) {
  // The derivative of the inverse of the cumulative distribution is 1 / density.
  for (const double u : {0.01, 0.2, 0.5, 0.7, 0.99}) {
    const double slope = (pixel_filter::sample(u + 1e-6) - pixel_filter::sample(u - 1e-6)) / 2e-6;
    EXPECT_NEAR(slope * pixel_filter::density(pixel_filter::sample(u)), 1.0, 1e-4);
  }
  EXPECT_NEAR(pixel_filter::sample(0.5), 0.0, 1e-12);
}

TEST(PixelSamples, OneIsTheCenter) {
  EXPECT_EQ(pixel_samples(1), std::vector{glm::dvec2(0.0)});
}

// An edge over the left or upper half of a pixel covers half of it, to half a sample.
TEST(PixelSamples, HaveNoPreferredSide) {
  for (const int count : {2, 4, 7, 16, 33, 64}) {
    const std::vector<glm::dvec2> samples = pixel_samples(count);
    ASSERT_EQ(samples.size(), static_cast<std::size_t>(count));
    glm::dvec2 mean(0.0);
    for (const glm::dvec2& s : samples) {
      EXPECT_LE(std::max(std::abs(s.x), std::abs(s.y)), 0.5 * pixel_filter::width);
      mean += s / static_cast<double>(count);
    }
    EXPECT_NEAR(mean.x, 0.0, 1e-12);
    const bool is_power_of_two = (count & (count - 1)) == 0;
    EXPECT_NEAR(mean.y, 0.0, is_power_of_two ? 1e-12 : 0.5 / count);
    const auto left = std::ranges::count_if(samples, [](auto& s) { return s.x < 0.0; });
    const auto above = std::ranges::count_if(samples, [](auto& s) { return s.y < 0.0; });
    EXPECT_LE(std::abs(2 * left - count), 1);
    EXPECT_LE(std::abs(2 * above - count), 2);
  }
}

// The coverage of straight edges of all slopes, against that of many samples.
TEST(PixelSamples, FindTheCoverageOfEdges) {
  const std::vector<glm::dvec2> many = pixel_samples(4096);
  const auto coverage = [](const std::vector<glm::dvec2>& samples, double angle, double distance) {
    const auto inside = std::ranges::count_if(samples, [&](const glm::dvec2& s) {
      return s.x * std::cos(angle) + s.y * std::sin(angle) > distance;
    });
    return static_cast<double>(inside) / static_cast<double>(samples.size());
  };
  const auto rms_error = [&](int count) {
    const std::vector<glm::dvec2> samples = pixel_samples(count);
    double sum = 0.0;
    int edges = 0;
    for (double angle = 0.05; angle < 6.28; angle += 0.1) {
      for (double distance = -0.45; distance < 0.5; distance += 0.1, ++edges) {
        const double error = coverage(samples, angle, distance) - coverage(many, angle, distance);
        sum += error * error;
      }
    }
    return std::sqrt(sum / edges);
  };
  // The measured errors are 0.042 and 0.015; random samples have 0.1 and 0.05.
  EXPECT_LT(rms_error(16), 0.05);
  EXPECT_LT(rms_error(64), 0.02);
}

// Films whose pixels are not sampled at their centers, as frames that are samples of others have.

const Camera slanted_camera{{1, 2, 8}, {0.5, 0, 0}, {0.1, 1, 0}, 35.0};

TEST(FilmShift, MovesWherePixelsAreSampled) {
  const Film film{64, 48};
  Film shifted = film;
  shifted.shift = {0.3, -1.7};
  const CameraRays rays(slanted_camera, film), moved(slanted_camera, shifted);
  const glm::dvec3 direction = moved.direction(10.5, 20.5);
  EXPECT_NEAR(glm::distance(direction, rays.direction(10.8, 18.8)), 0.0, 1e-14);
  const glm::dvec3 seen = moved.project(moved.eye() + 3.0 * direction);
  EXPECT_NEAR(seen.x, 10.5, 1e-9);
  EXPECT_NEAR(seen.y, 20.5, 1e-9);
  const glm::dvec2 axis = moved.axis();
  EXPECT_NEAR(glm::distance(moved.direction(axis.x, axis.y), moved.forward()), 0.0, 1e-14);
}

// The pixels that a ball covers are those whose rays pass through it, also beyond the unshifted
// film.
TEST(FilmShift, BoundsBallsOnTheShiftedFilm) {
  for (const glm::dvec2 shift : {glm::dvec2(0.4, 0.2), glm::dvec2(-30.3, 21.0)}) {
    Film film{64, 48};
    film.shift = shift;
    const CameraRays rays(slanted_camera, film);
    for (const double along : {-20.5, 3.0, 31.5, 60.0, 80.0}) {
      const glm::dvec3 center = rays.eye() + 5.0 * rays.direction(along, 0.5 * along);
      const double radius = 0.2;
      const CameraRays::PixelRectangle r =
          rays.bounds_on_whole(GaussianTerm<double>(1.0, 1.0, center), radius);
      for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
          const glm::dvec3 w = rays.direction(x + 0.5, y + 0.5);
          const double distance = glm::length(glm::cross(center - rays.eye(), w));
          if (distance > 0.999 * radius) continue;
          EXPECT_TRUE(x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1)
              << x << ' ' << y << " of a ball at " << along;
        }
      }
    }
  }
}

// All points of the lens see a point of the plane in focus in one pixel, and others in more.
TEST(Lens, FocusesOnItsPlane) {
  Camera lens = slanted_camera;
  lens.aperture = 0.3;
  lens.focus_distance = 6.0;
  Film film{64, 48};
  film.shift = {0.2, 0.1};
  const CameraRays center(lens, film);
  const glm::dvec3 direction = center.direction(50.25, 9.5);
  const double along_axis = glm::dot(direction, center.forward());
  const auto spread = [&](double distance) {
    const glm::dvec3 point = center.eye() + distance / along_axis * direction;
    double farthest = 0.0;
    for (const ExposureSample& sample : exposure_samples(32)) {
      const LensView view = seen_through(lens, film, sample.lens);
      EXPECT_EQ(view.camera.aperture, 0.0);
      const glm::dvec3 seen = CameraRays(view.camera, view.film).project(point);
      farthest = std::max(farthest, std::hypot(seen.x - 50.25, seen.y - 9.5));
    }
    return farthest;
  };
  EXPECT_LT(spread(6.0), 1e-9);
  // Similar triangles: the disk at 12 is as large as the lens, half of its tangent at 6.
  const double pixels_per_tangent = 24.0 / std::tan(0.5 * lens.vertical_fov * M_PI / 180.0);
  EXPECT_NEAR(spread(12.0), lens.aperture / 12.0 * pixels_per_tangent, 0.01);
  EXPECT_NEAR(spread(3.0), lens.aperture / 6.0 * pixels_per_tangent, 0.01);
}

TEST(ExposureSamples, AreEvenInEachDimension) {
  for (const int count : {2, 5, 16, 64, 100}) {
    const std::vector<ExposureSample> samples = exposure_samples(count);
    ASSERT_EQ(samples.size(), static_cast<std::size_t>(count));
    std::vector<int> moments(static_cast<std::size_t>(count));
    double square = 0.0;
    glm::dvec2 lens(0.0);
    for (const ExposureSample& s : samples) {
      ++moments[static_cast<std::size_t>(s.time * count)];
      EXPECT_LE(glm::length(s.lens), 1.0 + 1e-12);
      square += glm::dot(s.lens, s.lens) / count;
      lens += s.lens / static_cast<double>(count);
    }
    for (const int moment : moments) EXPECT_EQ(moment, 1);
    EXPECT_NEAR(square, 0.5, 1e-12);
    EXPECT_LT(glm::length(lens), count < 16 ? 0.6 : 0.1);
  }
}

// Blur is independent of where pixels are sampled: no covariance between the dimensions.
TEST(ExposureSamples, AreIndependent) {
  const std::vector<ExposureSample> samples = exposure_samples(64);
  glm::dmat2 lens_by_pixel(0.0);
  glm::dvec2 time_by_pixel(0.0), time_by_lens(0.0);
  for (const ExposureSample& s : samples) {
    lens_by_pixel += glm::outerProduct(s.lens, s.pixel) / 64.0;
    time_by_pixel += (s.time - 0.5) * s.pixel / 64.0;
    time_by_lens += (s.time - 0.5) * s.lens / 64.0;
  }
  // The covariance is a tenth of the products of standard deviations 0.5, 0.21 and 0.29 at most.
  for (int k = 0; k < 2; ++k) {
    EXPECT_LT(glm::length(lens_by_pixel[k]), 0.0105);
    EXPECT_LT(std::abs(time_by_pixel[k]), 0.006);
    EXPECT_LT(std::abs(time_by_lens[k]), 0.0145);
  }
}

}  // namespace

}  // namespace brume
