#pragma once

#include <QString>
#include <optional>

namespace brume {

// The value of an expression of numbers, + - * /, signs and parentheses, such as "0.5*3" or
// "(1 + 2) / 4"; nullopt where the text is something else. Numbers are written with a point.
std::optional<double> evaluate(const QString& text);

}  // namespace brume
