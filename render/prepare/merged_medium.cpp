#include "render/prepare/merged_medium.h"

#include <algorithm>
#include <cmath>

namespace brume {
namespace {

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
      const auto own_part = a.subspan(i, count);
      const auto other = b.subspan(j, count);
      return own_part.data() == other.data() || std::ranges::equal(own_part, other);
    };
    if (!same(before_.centers(), after_.centers()) || !same(before_.radii(), after_.radii()) ||
        !same(before_.densities(), after_.densities())) {
      return false;
    }
    if (!has_optics_ && !has_ellipsoids_) return true;
    for (std::size_t k = 0; k < count; ++k) {
      if (!(before_.optics(i + k) == after_.optics(j + k))) return false;
      if (!(before_.shape(i + k) == after_.shape(j + k))) return false;
    }
    return true;
  }

  static std::uint32_t index(std::size_t i) { return static_cast<std::uint32_t>(i); }

  const Medium& before_;
  const Medium& after_;
  bool has_optics_ = before_.has_albedos() || before_.has_emission() || after_.has_albedos() ||
                     after_.has_emission();
  bool has_ellipsoids_ = !before_.shapes().empty() || !after_.shapes().empty();
  std::vector<std::uint32_t> gone_, more_;
};

// Groups are the editor's, and nothing to frames.
SimplifyLimits in_frames(const MergedMedium::Limits& limits) {
  return {limits.error, true};
}
Gaussian without_group(Gaussian gaussian) {
  gaussian.group = 0;
  return gaussian;
}

}  // namespace

bool MergedMedium::update(const Medium& medium, const Limits& limits, const std::stop_token& stop) {
  const bool is_same = made_from_ == medium.revision() && limits_ == limits;
  if (is_same && !is_assumed_) return true;
  made_from_.reset();
  if (!(limits.error > 0.0) || !may_merge(medium)) {
    *this = {};
    medium_ = medium;
  } else if (is_same) {
    if (decide(medium, limits) != is_merged_ && !merge(medium, limits, stop)) return false;
    is_assumed_ = false;
  } else if (!follow(medium, limits, stop)) {
    if (stop.stop_requested() || !merge(medium, limits, stop)) return false;
  }
  made_from_ = medium.revision();
  limits_ = limits;
  return true;
}

bool MergedMedium::is_like_last(const Medium& medium, const Limits& limits) const {
  const auto size = static_cast<double>(medium.size());
  const auto known = static_cast<double>(decision_.size);
  return decision_.limits == limits && std::abs(size - known) <= 0.1 * known;
}

bool MergedMedium::decide(const Medium& medium, const Limits& limits) {
  depths_.emplace(medium);
  const double share = estimated_share(medium, in_frames(limits), *depths_);
  decision_ = {limits, medium.size(), share <= limits.share};
  return decision_.merges;
}

bool MergedMedium::merge(const Medium& medium, const Limits& limits, const std::stop_token& stop) {
  // The decision about the same medium has just been made.
  const Decision decision = decision_;
  const bool is_assumed = limits.followed > 0.0 && is_like_last(medium, limits);
  *this = {};
  decision_ = decision;
  is_assumed_ = is_assumed;
  first_id_ = medium.ids().front();
  const std::size_t count = medium.ids().back() + 1 - first_id_;
  is_changed_.resize(count);
  if (is_assumed ? decision_.merges : decide(medium, limits)) {
    if (!depths_) depths_.emplace(medium);
    const auto simplified = simplify(medium, in_frames(limits), *depths_, stop);
    if (!simplified) return false;
    part_of_.resize(count);
    append(*simplified, medium, medium.ids());
    is_merged_ = true;
  }
  source_ = medium;
  assemble();
  return true;
}

bool MergedMedium::follow(const Medium& medium, const Limits& limits, const std::stop_token& stop) {
  if (!(limits.followed > 0.0) || limits_ != limits || source_.empty()) return false;
  if (medium.ids().front() < first_id_) return false;
  const Comparison change(source_, medium);
  is_changed_.resize(std::max<std::size_t>(is_changed_.size(), medium.next_id() - first_id_));
  const auto note_changed = [this](GaussianId id) {
    if (is_changed_[id - first_id_]) return;
    is_changed_[id - first_id_] = true;
    ++changed_;
  };
  for (const std::uint32_t i : change.gone()) note_changed(source_.ids()[i]);
  for (const std::uint32_t i : change.more()) note_changed(medium.ids()[i]);
  if (static_cast<double>(changed_) > limits.followed * static_cast<double>(medium.size())) {
    return false;
  }
  if (is_merged_) {
    part_of_.resize(is_changed_.size());
    std::vector<std::uint32_t> touched;
    for (const std::uint32_t i : change.gone()) touched.push_back(part_of(source_.ids()[i]));
    std::ranges::sort(touched);
    touched.erase(std::ranges::unique(touched).begin(), touched.end());
    // Gaussians that are new or changed, and those that they were merged with before.
    std::vector<GaussianId> ids;
    for (const std::uint32_t i : change.more()) ids.push_back(medium.ids()[i]);
    for (const std::uint32_t k : touched) {
      for (const GaussianId id : parts_[k].members) {
        if (medium.index_of(id)) ids.push_back(id);
      }
    }
    std::ranges::sort(ids);
    ids.erase(std::ranges::unique(ids).begin(), ids.end());
    Medium some;
    some.reserve(ids.size());
    for (const GaussianId id : ids) some.append(medium.gaussian(*medium.index_of(id)));
    const auto exchange = [this](const Medium& from, const std::vector<std::uint32_t>& less,
                                 const Medium& to, const std::vector<std::uint32_t>& more) {
      for (const std::uint32_t i : less) depths_->remove(from.gaussian(i));
      for (const std::uint32_t i : more) depths_->add(to.gaussian(i));
    };
    exchange(source_, change.gone(), medium, change.more());
    const auto simplified = simplify(some, in_frames(limits), *depths_, stop);
    if (!simplified) {
      exchange(medium, change.more(), source_, change.gone());
      return false;
    }
    remove_parts(touched);
    append(*simplified, some, ids);
  }
  source_ = medium;
  assemble();
  return true;
}

// The last ones come in their place. `places` ascend.
void MergedMedium::remove_parts(std::span<const std::uint32_t> places) {
  for (std::size_t k = places.size(); k-- > 0;) {
    const std::uint32_t place = places[k];
    if (place + 1 != parts_.size()) parts_[place] = std::move(parts_.back());
    parts_.pop_back();
    if (place == parts_.size()) continue;
    for (const GaussianId id : parts_[place].members) part_of(id) = place;
  }
}

void MergedMedium::append(const Simplified& simplified, const Medium& medium,
                          std::span<const GaussianId> ids) {
  const auto add = [&](const Gaussian& gaussian, std::span<const std::uint32_t> members) {
    Part& part = parts_.emplace_back(Part{gaussian, {}});
    part.members.reserve(members.size());
    for (const std::uint32_t i : members) {
      part.members.push_back(ids[i]);
      part_of(ids[i]) = static_cast<std::uint32_t>(parts_.size() - 1);
    }
  };
  for (const std::uint32_t i : simplified.kept) add(without_group(medium.gaussian(i)), {&i, 1});
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
