#include "app/document/text/number_text.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "brume/limits.h"
#include "core/io/frame_loop.h"

namespace brume {
namespace {

constexpr double min_shown_share = 1e-4;
// Smaller and larger numbers are written with an exponent.
constexpr int min_exponent = -4;
constexpr int max_exponent = 9;

void remove_end_zeros(QString& decimal) {
  if (!decimal.contains('.')) return;
  while (decimal.endsWith('0')) decimal.chop(1);
  if (decimal.endsWith('.')) decimal.chop(1);
}

// "1.20e-05" -> "1.2e-5"
QString short_scientific(const QString& text) {
  const qsizetype e = text.indexOf('e');
  if (e < 0) return text;
  QString mantissa = text.left(e);
  remove_end_zeros(mantissa);
  return QString("%1e%2").arg(mantissa).arg(text.mid(e + 1).toInt());
}

}  // namespace

QString number_text(double value, int digits) {
  if (!std::isfinite(value)) return QString::number(value);
  if (std::abs(value) < limits::min_length) return "0";
  const QString scientific = QString::number(value, 'e', digits - 1);
  // After rounding, which may have made it longer.
  const int exponent = scientific.mid(scientific.indexOf('e') + 1).toInt();
  if (exponent < min_exponent || exponent > max_exponent) return short_scientific(scientific);
  QString text = QString::number(value, 'f', std::max(0, digits - 1 - exponent));
  remove_end_zeros(text);
  return text;
}

QString exact_number_text(double value) {
  if (value == 0.0) return "0";  // -0, too
  return short_scientific(QString::number(value, 'g', QLocale::FloatingPointShortest));
}

QString fixed_text(double value, int decimals) {
  const QString text = QString::number(value, 'f', decimals);
  const bool is_zero =
      std::ranges::all_of(text, [](QChar c) { return QString("-0.").contains(c); });
  return is_zero && text.startsWith('-') ? text.mid(1) : text;
}

QString duration_text(double milliseconds) {
  if (milliseconds >= 999.5) return fixed_text(1e-3 * milliseconds, 1) + " s";
  return fixed_text(milliseconds, milliseconds < 99.95 ? 1 : 0) + " ms";
}

QString estimated_time_text(double seconds) {
  return QString::fromStdString(estimated_seconds_text(std::max(1.0, seconds)));
}

QString percent_text(double share) {
  if (share > 0.0 && share < min_shown_share) return "< 0.01 %";
  return number_text(100.0 * share, 2) + " %";
}

}  // namespace brume
