#pragma once

namespace brume {

// A cubic over [0, length], given by its values and slopes at both ends (Hermite form).
struct HermiteCubic {
  double length;  // > 0
  double begin, end;
  double begin_slope, end_slope;

  // All for arguments in [0, length].
  [[nodiscard]] double value(double x) const;
  [[nodiscard]] double integral(double low, double high) const;  // low <= high
  // The integral of the value, or of `floor` where the value is below it.
  [[nodiscard]] double integral_above(double floor, double low, double high) const;

  // Bounds of the value, not tight: its control points in Bernstein form.
  [[nodiscard]] double lower_bound() const;
  [[nodiscard]] double upper_bound() const;
};

}  // namespace brume
