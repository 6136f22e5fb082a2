#include "render/gl/tile_lists.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <vector>

#include "core/math/max_component.h"
#include "render/geometry/tiles.h"
#include "render/gl/film_airlight.h"
#include "render/gl/shader_source.h"
#include "render/gl/shader_structs.h"

namespace brume::gl {
void MediumBuffers::update(const MediumIndex& medium) {
  if (revision_ == medium.revision()) return;
  revision_ = 0;
  std::vector<std::uint32_t> all(medium.size());
  std::iota(all.begin(), all.end(), 0u);
  GaussianBatch batch;
  batch.assign(medium, glm::dvec3(0.0), all);
  std::vector<glm::dvec3> centers(all.size());
  std::vector<GaussianShape> shapes(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    centers[i] = medium.gaussians()[i].b;
    shapes[i] = {batch.a[i], batch.scale[i], batch.max_e[i],
                 static_cast<float>(medium.cutoff_radii()[i])};
  }
  centers_.upload(std::span<const glm::dvec3>(centers));
  shapes_.upload(std::span<const GaussianShape>(shapes));
  upload_optics(medium.optics());
  upload_ellipsoids(batch, medium);
  count_ = all.size();
  revision_ = medium.revision();
}

void MediumBuffers::upload_optics(std::span<const RelativeOptics> all) {
  has_optics_ = !all.empty();
  if (!has_optics_) {
    optics_.release();
    return;
  }
  const glm::ivec2 size(optics_width, (static_cast<int>(all.size()) - 1) / optics_width + 1);
  std::vector<glm::vec4> texels(static_cast<std::size_t>(size.x) *
                                static_cast<std::size_t>(size.y));
  std::ranges::transform(all, texels.begin(), [](const RelativeOptics& own) {
    return glm::vec4(own.emission, own.albedo);
  });
  optics_.reserve(Texture::Format::rgba32f, size);
  optics_.upload({&texels[0].x, 4 * texels.size()});
}

void MediumBuffers::upload_ellipsoids(const GaussianBatch& batch, const MediumIndex& medium) {
  has_ellipsoids_ = !batch.ellipsoids.empty();
  if (!has_ellipsoids_) {
    ellipsoids_.release();
    return;
  }
  const int texels = 2 * static_cast<int>(batch.size());
  const glm::ivec2 size(optics_width, (texels - 1) / optics_width + 1);
  std::vector<glm::vec4> values(static_cast<std::size_t>(size.x) *
                                static_cast<std::size_t>(size.y));
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!batch.is_ellipsoid(i)) continue;
    const auto& [xx, yy, zz, yz, xz, xy] = batch.ellipsoids[i].warp;
    const glm::dvec3& stretch = medium.gaussians()[i].ellipsoid->stretch;
    values[2 * i] = {xx, yy, zz, yz};
    values[2 * i + 1] = {xz, xy, static_cast<float>(min_component(stretch)), 1.0f};
  }
  ellipsoids_.reserve(Texture::Format::rgba32f, size);
  ellipsoids_.upload({&values[0].x, 4 * values.size()});
}

void MediumBuffers::bind(const Program& program) {
  program.bind("Centers", centers_);
  program.bind("Shapes", shapes_);
  bind_ellipsoids(program);
}

void TileLists::bind(const Program& program) {
  program.bind("Seen", seen_);
  program.bind("Offsets", offsets_);
  program.bind("Entries", entries_);
  medium_->bind_ellipsoids(program);
}

void TileLists::build(Programs& programs, MediumBuffers& medium, const MediumIndex& index,
                      const CameraRays& rays, const Film& film, int scale, std::int64_t max_bytes) {
  const Film samples = brume::sample_film(film, scale);
  sample_film_ = {samples.width, samples.height};
  const Tiles tiles(samples);
  tiles_ = {tiles.columns(), tiles.rows()};
  const Tiles whole_tiles(brume::sample_film({rays.whole_size().x, rays.whole_size().y}, scale));
  const auto tile_count = static_cast<std::size_t>(tiles_.x) * static_cast<std::size_t>(tiles_.y);
  const std::size_t count = medium.count();
  seen_.reserve(count * sizeof(SeenGaussian));
  rectangles_.reserve(count * sizeof(glm::uvec2));
  totals_.reserve(sizeof(TileTotals));
  totals_.clear();
  cursors_.reserve(tile_count * sizeof(std::uint32_t));
  cursors_.clear();
  offsets_.reserve((tile_count + 1) * sizeof(std::uint32_t));

  const CameraRays::FilmPlane plane = rays.plane();
  medium_ = &medium;
  const Program& project = programs.get("project", medium.defined() + ray_definitions(rays));
  project.set("count", static_cast<unsigned>(count));
  project.set("eye", rays.eye());
  project.set("forward", rays.forward());
  project.set("right", glm::normalize(plane.per_x));
  project.set("up", -glm::normalize(plane.per_y));
  const CameraRays::Surround surround = rays.surround();
  project.set("half_width", 0.5 * surround.size.x * glm::length(plane.per_x));
  project.set("half_height", 0.5 * surround.size.y * glm::length(plane.per_y));
  project.set("whole_film", rays.whole_size());
  project.set("surround", surround.size);
  project.set("whole_start", glm::dvec3(surround.start, 0.0));
  project.set("whole_tiles", glm::ivec2(whole_tiles.columns(), whole_tiles.rows()));
  project.set("first_tile", rays.first_pixel() / (scale * glm::ivec2(Tiles::width, Tiles::height)));
  project.set("tiles", tiles_);
  project.set("scale", scale);
  const RayNoise& noise = index.noise();
  project.set("farther",
              noise.on() ? static_cast<float>(RayNoise::max_shift * noise.amplitude()) : 0.0f);
  medium.bind(project);
  project.bind("Seen", seen_);
  project.bind("Rectangles", rectangles_);
  project.bind("Totals", totals_);
  project.dispatch_linear_over(count);

  // Every Gaussian counts at least one part of `coarse_entries`.
  const auto max_coarse =
      static_cast<std::uint64_t>(max_bytes) / sizeof(std::uint32_t) / coarse_entries + count;
  const Program& list = programs["list"];
  list.set("count", static_cast<unsigned>(count));
  list.set("columns", tiles_.x);
  list.set("max_coarse", static_cast<unsigned>(std::min<std::uint64_t>(max_coarse, ~0u)));
  const auto run_list = [&](bool fills) {
    list.set("fill", fills ? 1 : 0);
    list.bind("Rectangles", rectangles_);
    list.bind("Totals", totals_);
    list.bind("Cursors", cursors_);
    list.bind("Entries", entries_);
    list.dispatch_linear_over(invocations_per_gaussian * count);
  };
  run_list(false);
  const Program& scan = programs["scan"];
  scan.set("tiles", static_cast<int>(tile_count));
  scan.bind("Totals", totals_);
  scan.bind("Cursors", cursors_);
  scan.bind("Offsets", offsets_);
  scan.dispatch(1);

  TileTotals totals;
  totals_.download(std::span(&totals, 1));
  used_ = totals.used;
  const std::uint64_t bytes = std::uint64_t{totals.entries} * sizeof(std::uint32_t);
  if (totals.coarse > max_coarse || bytes > static_cast<std::uint64_t>(max_bytes)) {
    throw OutOfMemory("the Gaussians of all tiles do not fit into device memory");
  }
  entries_.reserve(bytes);
  run_list(true);
  const Program& sort = programs["sort_list"];
  sort.set("tiles", static_cast<unsigned>(tile_count));
  sort.bind("Entries", entries_);
  sort.bind("Offsets", offsets_);
  sort.dispatch_linear(tile_count);
}

}  // namespace brume::gl
