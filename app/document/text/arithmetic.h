#pragma once

#include <QString>
#include <optional>

namespace brume {

// Evaluates an expression of numbers, + - * /, signs and parentheses, such as "0.5*3" or "(1 + 2) /
// 4"; nullopt for other text. Decimal point only.
std::optional<double> evaluate(const QString& text);

// A change of a number that it depends on.
struct Adjustment {
  double factor = 1.0;
  double shift = 0.0;

  [[nodiscard]] double of(double value) const { return factor * value + shift; }
};

// "*2", "/3", "+0.1" or "+=0.1", "-=0.1", with an expression for the number; nullopt for other
// text, such as "-0.1", which is a number.
std::optional<Adjustment> parse_adjustment(const QString& text);

}  // namespace brume
