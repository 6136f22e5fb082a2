#pragma once

#include <QString>
#include <optional>

namespace brume {

// Evaluates an expression of numbers, + - * /, signs and parentheses, such as "0.5*3" or "(1 + 2) /
// 4"; nullopt for other text. Decimal point only.
std::optional<double> evaluate(const QString& text);

}  // namespace brume
