#include "render/cpu/tile_sampler.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "core/scene/camera_rays.h"
#include "render/prepare/upsampling_limits.h"
#include "render/visibility/holdout.h"

namespace brume {
namespace {

// The samples of all pixels that are traced together.
constexpr std::size_t batch_samples = 2048;

// Panes behind others that let less light through are not seen.
constexpr double negligible = 1e-4;

glm::vec3 rgb(std::span<const float> layer, std::size_t pixel) {
  return {layer[3 * pixel], layer[3 * pixel + 1], layer[3 * pixel + 2]};
}

}  // namespace

TileSampler::TileSampler(const SampledView& view, std::span<const PixelDetail> details,
                         std::span<const glm::dvec2> offsets, const Job& job, Frame& frame)
    : view_(view),
      details_(details),
      offsets_(offsets),
      job_(job),
      frame_(frame),
      waiting_(view.surfaces ? view.surfaces->surfaces.size() : 0) {}

void TileSampler::sample(std::size_t tile, std::vector<SampledPixel>& results) {
  tile_ = tile;
  tolerance_ = std::numeric_limits<float>::infinity();
  if (view_.medium) {
    tolerance_ = distance_tolerance(*view_.medium, view_.tiles.lists.gaussians_of(tile),
                                    view_.fog_tolerance);
  }
  const std::size_t most = std::max<std::size_t>(1, batch_samples / offsets_.size());
  const CameraRays::PixelRectangle r = view_.tiles.own_pixels(tile);
  for (int y = r.y0; y < r.y1; ++y) {
    for (int x = r.x0; x < r.x1; ++x) {
      if (details_[index({x, y})] == PixelDetail::none) continue;
      pixels_.emplace_back(x, y);
      if (pixels_.size() == most) finish_batch(results);
    }
  }
  finish_batch(results);
}

void TileSampler::finish_batch(std::vector<SampledPixel>& results) {
  if (job_.stop.stop_requested()) pixels_.clear();
  if (pixels_.empty()) return;
  find_parts();
  find_background();
  shade_parts();
  make_clusters();
  find_fog();
  add_up(results);
  pixels_.clear();
}

void TileSampler::find_parts() {
  const std::size_t count = pixels_.size() * offsets_.size();
  directions_.resize(count);
  ray_offsets_.resize(view_.tiles.rays.is_parallel() ? count : 0);
  hits_.assign(count, {});
  parts_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    directions_[i] = view_.tiles.rays.whole_direction(position(i));
    if (!ray_offsets_.empty()) ray_offsets_[i] = view_.tiles.rays.whole_offset(position(i));
  }
  for (std::size_t i = 0; view_.surfaces && i < count; i += Tiles::pixels) {
    const std::size_t some = std::min<std::size_t>(Tiles::pixels, count - i);
    const glm::dvec3& eye = view_.tiles.rays.eye();
    const std::span<const glm::dvec3> directions = std::span(directions_).subspan(i, some);
    std::span<const glm::dvec3> offsets = ray_offsets_;
    if (!offsets.empty()) offsets = offsets.subspan(i, some);
    const std::span<SurfaceHit> hits = std::span(hits_).subspan(i, some);
    view_.surfaces->ray_caster.first_hits(view_.tiles.rays, directions, offsets, hits);
    view_.surfaces->light_shapes.meet(eye, directions, offsets, hits);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (view_.surfaces && view_.surfaces->ray_caster.is_pane(hits_[i])) {
      add_panes(i, hits_[i]);
    } else {
      parts_.push_back({.sample = i, .hit = hits_[i]});
    }
  }
}

void TileSampler::add_panes(std::size_t sample, const SurfaceHit& first) {
  const RayCaster& ray_caster = view_.surfaces->ray_caster;
  SeenPane pane = ray_caster.pane(first, 0.0);
  Part part{.sample = sample, .hit = first};
  if (!(pane.passing > 0.0)) {
    parts_.push_back(part);
    return;
  }
  const glm::dvec3 eye =
      view_.tiles.rays.eye() + (ray_offsets_.empty() ? glm::dvec3(0.0) : ray_offsets_[sample]);
  const glm::dvec3& direction = directions_[sample];
  HitsOnRay on_ray =
      ray_caster.hits_on_ray(eye, direction, view_.tiles.rays.clip_end(eye, direction));
  view_.surfaces->light_shapes.meet(eye, directions_[sample], on_ray.end);
  std::erase_if(on_ray.panes,
                [&](const PaneHit& each) { return !(each.hit.distance < on_ray.end.distance); });
  double passing = 1.0;
  part.counted = 0.0f;
  bool is_counted = false;
  for (std::size_t k = 0; k <= on_ray.panes.size(); ++k) {
    const bool is_pane = k < on_ray.panes.size();
    part.hit = is_pane ? on_ray.panes[k].hit : on_ray.end;
    part.panes = k;
    pane = ray_caster.pane(part.hit, 0.0);
    const bool is_last = !is_pane || k == max_seen_panes || !(passing * pane.passing > negligible);
    const double next = is_last ? 0.0 : passing * pane.passing;
    part.airlight = static_cast<float>(passing - next);
    part.reaching = static_cast<float>(passing * pane.covered);
    // The transmittance is that of what is more than half opaque.
    part.is_opaque = pane.opaque > 0.5;
    const bool counts = !is_counted && (!part.hit || is_last || part.is_opaque);
    part.counted = !counts ? 0.0f : part.hit ? 1.0f : static_cast<float>(passing);
    is_counted |= counts;
    passing = next;
    const bool is_hole = is_pane && !(pane.covered > 0.0);
    if (!is_hole || is_last) parts_.push_back(part);
    if (is_last) return;
  }
}

void TileSampler::find_background() {
  if (!view_.environment) return;
  constexpr std::array open{std::numeric_limits<float>::infinity()};
  for (Part& part : parts_) {
    if (part.hit) continue;
    view_.environment->show(directions_[part.sample], glm::dvec3(0.0), 0, open,
                            std::span(&part.behind, 1));
  }
}

void TileSampler::shade_parts() {
  if (!view_.are_lit) return;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    if (!part.hit || is_held_out(view_.surfaces->surfaces, part.hit)) continue;
    if (part.hit.is_light()) {
      part.behind = view_.surfaces->radiance_of_light(part.hit);
      continue;
    }
    std::vector<std::size_t>& parts = waiting_[static_cast<std::size_t>(part.hit.surface)];
    parts.push_back(i);
    if (parts.size() == Tiles::pixels) shade(parts);
  }
  for (std::vector<std::size_t>& parts : waiting_) shade(parts);
}

void TileSampler::shade(std::vector<std::size_t>& parts) {
  if (parts.empty()) return;
  const std::size_t count = parts.size();
  std::array<SurfaceHit, Tiles::pixels> hits;
  std::array<glm::vec3, Tiles::pixels> directions, radiance;
  std::array<glm::dvec3, Tiles::pixels> offsets;
  std::array<glm::ivec2, Tiles::pixels> seen_in;
  std::array<std::size_t, Tiles::pixels> numbers;
  for (std::size_t k = 0; k < count; ++k) {
    const Part& part = parts_[parts[k]];
    hits[k] = part.hit;
    seen_in[k] = pixels_[pixel_of(part)];
    numbers[k] = part.sample % offsets_.size();
    directions[k] = glm::vec3(directions_[part.sample]);
    if (!ray_offsets_.empty()) offsets[k] = ray_offsets_[part.sample];
  }
  const auto own_hits = std::span(hits).first(count);
  const auto own_directions = std::span(directions).first(count);
  const auto own_offsets = std::span(offsets).first(ray_offsets_.empty() ? 0 : count);
  const auto own_radiance = std::span(radiance).first(count);
  light_pairs_ += view_.surfaces->shade(
      own_hits, own_directions, own_offsets,
      {std::span(seen_in).first(count), std::span(numbers).first(count), offsets_.size()},
      view_.highlights, own_radiance);
  for (std::size_t k = 0; k < count; ++k) parts_[parts[k]].behind = radiance[k];
  parts.clear();
}

bool TileSampler::continues(double nearest, double last, double distance) const {
  constexpr double max_relative_span = 0.2;
  return distance - nearest <= std::max<double>(tolerance_, max_relative_span * nearest) &&
         distance - last <= std::max<double>(tolerance_, max_relative_step * last);
}

void TileSampler::make_clusters() {
  clusters_.clear();
  order_.resize(parts_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  for (std::size_t first = 0; first < parts_.size();) {
    const std::size_t pixel = pixel_of(parts_[first]);
    std::size_t end = first;
    while (end < parts_.size() && pixel_of(parts_[end]) == pixel) ++end;
    make_clusters(pixel, std::span(order_).subspan(first, end - first));
    first = end;
  }
}

void TileSampler::make_clusters(std::size_t pixel, std::span<std::size_t> parts) {
  std::ranges::sort(
      parts, {}, [&](std::size_t i) { return std::pair(parts_[i].panes, parts_[i].hit.distance); });
  const bool is_apart = view_.medium && details_[index(pixels_[pixel])] == PixelDetail::fog;
  const std::size_t first_cluster = clusters_.size();
  double nearest = 0.0, last = 0.0;
  std::size_t panes = 0;
  for (const std::size_t i : parts) {
    Part& part = parts_[i];
    const bool is_open = !part.hit;
    const double length = part.hit.distance;
    // Fog between a pane and what is behind it is none of either's.
    if (clusters_.size() == first_cluster || is_apart || part.panes != panes ||
        (is_open ? std::isfinite(last) : !continues(nearest, last, length))) {
      clusters_.push_back({.pixel = pixel, .is_open = is_open});
      nearest = length;
    }
    last = length;
    panes = part.panes;
    // Sums for now.
    Cluster& c = clusters_.back();
    c.position += position(part.sample);
    c.length += is_open ? view_.tiles.ends.open : length;
    ++c.parts;
    part.cluster = clusters_.size() - 1;
  }
  for (Cluster& c : std::span(clusters_).subspan(first_cluster)) {
    c.position /= static_cast<double>(c.parts);
    c.length /= static_cast<double>(c.parts);
  }
}

void TileSampler::find_fog() {
  if (!view_.medium) return;
  exact_.clear();
  for (std::size_t i = 0; i < clusters_.size(); ++i) {
    Cluster& c = clusters_[i];
    const bool has_details = details_[index(pixels_[c.pixel])] == PixelDetail::fog;
    const std::optional<Known> known = has_details ? std::nullopt : known_fog(pixels_[c.pixel], c);
    if (!known) {
      exact_.push_back(i);
      if (exact_.size() == Tiles::pixels) evaluate_fog();
      continue;
    }
    c.airlight = rgb(known->fog->airlight, known->pixel);
    c.transmittance = known->fog->transmittance[3 * known->pixel];
  }
  evaluate_fog();
}

std::optional<TileSampler::Known> TileSampler::known_fog(const glm::ivec2& middle,
                                                         const Cluster& c) const {
  std::optional<Known> found;
  double nearest = std::numeric_limits<double>::infinity();
  // Nothing is known beside a region's pixels unless they are sampled.
  const int reach = offsets_.size() > 1 ? 1 : 0;
  const glm::ivec2 low = glm::max(middle - reach, glm::ivec2(0));
  const glm::ivec2 high =
      glm::min(middle + reach, glm::ivec2(frame_.film.width, frame_.film.height) - 1);
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const std::size_t pixel = index({x, y});
      for (const KnownFog& fog : view_.fogs) {
        const bool is_open = !std::isfinite(fog.depth[pixel]);
        if (is_open != c.is_open) continue;
        if (!is_open && std::abs(fog.ends.distance(fog.depth, pixel) - c.length) > tolerance_) {
          continue;
        }
        const double distance = glm::distance(center({x, y}), c.position);
        if (distance < nearest) {
          nearest = distance;
          found = {&fog, pixel};
        }
      }
    }
  }
  return found;
}

void TileSampler::evaluate_fog() {
  if (exact_.empty()) return;
  std::array<glm::dvec3, Tiles::pixels> directions, offsets;
  std::array<double, Tiles::pixels> lengths, depths;
  std::array<glm::vec2, Tiles::pixels> places;
  std::array<glm::vec3, Tiles::pixels> airlight;
  const std::size_t count = exact_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Cluster& c = clusters_[exact_[k]];
    directions[k] = view_.tiles.rays.whole_direction(c.position);
    offsets[k] = view_.tiles.rays.whole_offset(c.position);
    lengths[k] = c.length;
    places[k] = view_.tiles.place(tile_, c.position);
  }
  const std::uint64_t pairs = view_.method->evaluate(
      view_.tiles.lists.gaussians_of(tile_),
      {view_.tiles.rays.eye(), std::span(directions).first(count), std::span(lengths).first(count),
       tile_, std::span(places).first(count),
       std::span(offsets).first(view_.tiles.rays.is_parallel() ? count : 0)},
      {std::span(airlight).first(count), std::span(depths).first(count)});
  const float each = static_cast<float>(pairs) / static_cast<float>(count);
  for (std::size_t k = 0; k < count; ++k) {
    Cluster& c = clusters_[exact_[k]];
    c.airlight = {finite(airlight[k].x), finite(airlight[k].y), finite(airlight[k].z)};
    c.transmittance = finite(static_cast<float>(std::exp(-depths[k])));
    frame_.statistics.pixel_pairs[index(pixels_[c.pixel])] += each;
  }
  view_pairs_ += pairs;
  exact_.clear();
}

void TileSampler::add_up(std::vector<SampledPixel>& results) const {
  const auto n = static_cast<float>(offsets_.size());
  const float share = 1.0f / n;
  for (std::size_t i = 0; i < parts_.size();) {
    const std::size_t pixel = pixel_of(parts_[i]);
    SampledPixel sum{.pixel = index(pixels_[pixel])};
    float square = 0.0f;  // mean of the samples' beauty squared, sum over channels
    while (i < parts_.size() && pixel_of(parts_[i]) == pixel) {
      const std::size_t sample = parts_[i].sample;
      glm::vec3 beauty(0.0f);
      sum.depth = std::numeric_limits<float>::infinity();
      for (; i < parts_.size() && parts_[i].sample == sample; ++i) {
        const Part& part = parts_[i];
        const Cluster& c = clusters_[part.cluster];
        const glm::vec3 attenuated = part.reaching * c.transmittance * part.behind;
        beauty += part.airlight * c.airlight + attenuated;
        sum.airlight += share * part.airlight * c.airlight;
        sum.transmittance += share * part.counted * c.transmittance;
        if (!part.hit) sum.background += share * attenuated;
        const bool is_solid = part.hit && !is_held_out(view_.surfaces->surfaces, part.hit);
        sum.alpha += share * part.airlight * (is_solid ? 1.0f : 1.0f - c.transmittance);
        if (part.hit && part.counted > 0.0f && part.is_opaque)
          sum.depth = static_cast<float>(part.hit.distance);
      }
      sum.beauty += share * beauty;
      square += share * glm::dot(beauty, beauty);
    }
    // The variance of an edge in a stratified set of n samples falls with n^1.5. It is unknown for
    // radiances whose squares no float holds, and taken for none.
    const float spread = square - glm::dot(sum.beauty, sum.beauty);
    sum.variance = std::isfinite(spread) ? std::max(spread, 0.0f) / (n * std::sqrt(n)) : 0.0f;
    results.push_back(sum);
  }
}

}  // namespace brume
