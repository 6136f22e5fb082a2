#include "render/prepare/merged_medium.h"

#include <algorithm>
#include <limits>
#include <span>

namespace brume {
namespace {

// All are merged anew when this share has changed.
constexpr std::size_t max_changed = 8;  // 1 / 8

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// Compares two media by their columns, which are the same memory where nothing was changed.
class Comparison {
 public:
  Comparison(const Medium& before, const Medium& after) : before_(before), after_(after) {
    each_common_range(
        [this](std::size_t i, std::size_t j, std::size_t count) { compare(i, j, count); });
  }
  // Indices of Gaussians that are not the same, or not there, in the other; sorted.
  [[nodiscard]] const std::vector<std::uint32_t>& gone() const { return gone_; }
  [[nodiscard]] const std::vector<std::uint32_t>& more() const { return more_; }

 private:
  // Calls visit(before, after, count) for ranges of the same ids; notes all others.
  template <class Visit>
  void each_common_range(Visit visit) {
    const std::span<const GaussianId> a = before_.ids();
    const std::span<const GaussianId> b = after_.ids();
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
      const std::size_t most = std::min(a.size() - i, b.size() - j);
      const auto end = a.data() == b.data() && i == j
                           ? a.begin() + static_cast<std::ptrdiff_t>(i + most)
                           : std::mismatch(a.begin() + static_cast<std::ptrdiff_t>(i),
                                           a.begin() + static_cast<std::ptrdiff_t>(i + most),
                                           b.begin() + static_cast<std::ptrdiff_t>(j))
                                 .first;
      const std::size_t count = static_cast<std::size_t>(end - a.begin()) - i;
      visit(i, j, count);
      i += count;
      j += count;
      while (i < a.size() && (j == b.size() || a[i] < b[j])) gone_.push_back(index(i++));
      while (j < b.size() && (i == a.size() || b[j] < a[i])) more_.push_back(index(j++));
    }
  }

  // Ranges of Gaussians with the same ids.
  void compare(std::size_t i, std::size_t j, std::size_t count) {
    constexpr std::size_t block = 1024;
    for (std::size_t first = 0; first < count; first += block) {
      const std::size_t size = std::min(block, count - first);
      if (are_same(i + first, j + first, size)) continue;
      for (std::size_t k = first; k < first + size; ++k) {
        if (are_same(i + k, j + k, 1)) continue;
        gone_.push_back(index(i + k));
        more_.push_back(index(j + k));
      }
    }
  }

  [[nodiscard]] bool are_same(std::size_t i, std::size_t j, std::size_t count) const {
    const auto same = [&](const auto& a, const auto& b) {
      const auto own = a.subspan(i, count);
      const auto other = b.subspan(j, count);
      return own.data() == other.data() || std::ranges::equal(own, other);
    };
    if (!same(before_.centers(), after_.centers()) || !same(before_.radii(), after_.radii()) ||
        !same(before_.densities(), after_.densities())) {
      return false;
    }
    if (!has_optics_) return true;
    for (std::size_t k = 0; k < count; ++k) {
      if (!(before_.optics(i + k) == after_.optics(j + k))) return false;
    }
    return true;
  }

  static std::uint32_t index(std::size_t i) { return static_cast<std::uint32_t>(i); }

  const Medium& before_;
  const Medium& after_;
  bool has_optics_ = before_.has_albedos() || before_.has_emission() || after_.has_albedos() ||
                     after_.has_emission();
  std::vector<std::uint32_t> gone_, more_;
};

// Groups are the editor's, and nothing to frames.
Gaussian without_group(Gaussian gaussian) {
  gaussian.group = 0;
  return gaussian;
}

}  // namespace

bool MergedMedium::update(const Medium& medium, const Limits& limits, const std::stop_token& stop) {
  if (made_from_ == medium.revision() && limits_ == limits) return true;
  made_from_.reset();
  if (!(limits.error > 0.0) || !may_merge(medium)) {
    *this = {};
    medium_ = medium;
  } else if (!follow(medium, limits, stop)) {
    if (stop.stop_requested() || !merge(medium, limits, stop)) return false;
  }
  made_from_ = medium.revision();
  limits_ = limits;
  return true;
}

bool MergedMedium::merge(const Medium& medium, const Limits& limits, const std::stop_token& stop) {
  std::vector<Gaussian> gaussians;
  std::vector<std::uint32_t> indices;
  gaussians.reserve(medium.size());
  indices.reserve(medium.size());
  for (std::size_t i = 0; i < medium.size(); ++i) {
    gaussians.push_back(without_group(medium.gaussian(i)));
    indices.push_back(static_cast<std::uint32_t>(i));
  }
  *this = {};
  depths_.emplace(gaussians);
  is_merged_ = estimated_share(gaussians, limits.error, *depths_) <= limits.share;
  if (is_merged_) {
    const auto simplified = simplify(gaussians, limits.error, *depths_, stop);
    if (!simplified) {
      *this = {};
      return false;
    }
    part_of_.resize(medium.size());
    append(*simplified, gaussians, indices);
  }
  source_ = medium;
  is_changed_.assign(medium.size(), false);
  assemble();
  return true;
}

bool MergedMedium::follow(const Medium& medium, const Limits& limits, const std::stop_token& stop) {
  if (limits_ != limits || source_.empty()) return false;
  const Comparison change(source_, medium);
  // Indices in `medium` of what is left of source_.
  std::vector<std::uint32_t> now(source_.size(), none);
  std::vector<bool> is_changed(medium.size(), true);
  std::size_t changed = medium.size();
  auto gone = change.gone().begin();
  auto more = change.more().begin();
  std::uint32_t j = 0;
  for (std::uint32_t i = 0; i < now.size(); ++i) {
    if (gone != change.gone().end() && *gone == i) {
      ++gone;
      continue;
    }
    while (more != change.more().end() && *more == j) ++more, ++j;
    now[i] = j;
    is_changed[j] = is_changed_[i];
    if (!is_changed_[i]) --changed;
    ++j;
  }
  const std::size_t removed =
      removed_ + change.gone().size() - std::min(change.gone().size(), change.more().size());
  if ((changed + removed) * max_changed > medium.size()) return false;
  if (is_merged_) {
    std::vector<bool> is_touched(parts_.size());
    for (const std::uint32_t i : change.gone()) is_touched[part_of_[i]] = true;
    std::vector<std::uint32_t> indices = change.more();
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (!is_touched[k]) continue;
      for (const std::uint32_t i : parts_[k].members) {
        if (now[i] != none) indices.push_back(now[i]);
      }
    }
    std::ranges::sort(indices);
    std::vector<Gaussian> gaussians;
    gaussians.reserve(indices.size());
    for (const std::uint32_t i : indices) gaussians.push_back(without_group(medium.gaussian(i)));
    const auto simplified = simplify(gaussians, limits.error, *depths_, stop);
    if (!simplified) return false;

    std::size_t kept = 0;
    part_of_.resize(medium.size());
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (is_touched[k]) continue;
      if (kept != k) parts_[kept] = std::move(parts_[k]);
      for (std::uint32_t& i : parts_[kept].members) {
        i = now[i];
        part_of_[i] = static_cast<std::uint32_t>(kept);
      }
      ++kept;
    }
    parts_.resize(kept);
    append(*simplified, gaussians, indices);
  }
  source_ = medium;
  is_changed_ = std::move(is_changed);
  removed_ = removed;
  assemble();
  return true;
}

void MergedMedium::append(const Simplified& simplified, std::span<const Gaussian> gaussians,
                          std::span<const std::uint32_t> indices) {
  const auto add = [&](const Gaussian& gaussian, std::span<const std::uint32_t> members) {
    Part& part = parts_.emplace_back(Part{gaussian, {}});
    part.members.reserve(members.size());
    for (const std::uint32_t i : members) {
      part.members.push_back(indices[i]);
      part_of_[indices[i]] = static_cast<std::uint32_t>(parts_.size() - 1);
    }
  };
  for (const std::uint32_t i : simplified.kept) add(gaussians[i], {&i, 1});
  for (std::size_t k = 0; k < simplified.merged.size(); ++k) {
    add(simplified.merged[k], simplified.members_of(k));
  }
}

void MergedMedium::assemble() {
  if (!is_merged_) {
    medium_ = source_;
    return;
  }
  medium_ = {};
  medium_.set_homogeneous_density(source_.homogeneous_density());
  medium_.reserve(parts_.size());
  for (const Part& part : parts_) medium_.append(part.gaussian);
}

}  // namespace brume
