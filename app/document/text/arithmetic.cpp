#include "app/document/text/arithmetic.h"

#include <charconv>

namespace brume {
namespace {

constexpr int deepest = 100;  // parentheses and signs within one another

// Recursive descent; each rule answers what it has read, or nothing.
class Parser {
 public:
  explicit Parser(std::string_view text) : rest_(text) {}

  std::optional<double> all() {
    const auto value = sum();
    skip_blanks();
    return rest_.empty() ? value : std::nullopt;
  }

 private:
  // Between numbers and signs; within a number, or between two, they are not allowed.
  void skip_blanks() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
  }

  bool take(char sign) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != sign) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::optional<double> sum() {
    auto value = product();
    while (value) {
      const bool plus = take('+');
      if (!plus && !take('-')) break;
      const auto next = product();
      if (!next) return std::nullopt;
      *value += plus ? *next : -*next;
    }
    return value;
  }

  std::optional<double> product() {
    auto value = factor();
    while (value) {
      const bool times = take('*');
      if (!times && !take('/')) break;
      const auto next = factor();
      if (!next) return std::nullopt;
      *value = times ? *value * *next : *value / *next;
    }
    return value;
  }

  std::optional<double> factor() {
    if (++depth_ > deepest) return std::nullopt;
    std::optional<double> value;
    if (take('-')) {
      value = factor();
      if (value) *value = -*value;
    } else if (take('+')) {
      value = factor();
    } else if (take('(')) {
      value = sum();
      if (!take(')')) value.reset();
    } else {
      value = number();
    }
    --depth_;
    return value;
  }

  std::optional<double> number() {
    skip_blanks();
    // from_chars would also take "inf" and "nan".
    if (rest_.empty() ||
        !(rest_.front() == '.' || (rest_.front() >= '0' && rest_.front() <= '9'))) {
      return std::nullopt;
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  std::string_view rest_;
  int depth_ = 0;
};

}  // namespace

std::optional<double> evaluate(const QString& text) {
  return Parser(text.simplified().toStdString()).all();
}

std::optional<Adjustment> parse_adjustment(const QString& text) {
  QString rest = text.simplified();
  const QChar sign = rest.isEmpty() ? QChar() : rest.front();
  rest.remove(0, 1);
  const bool has_equals = rest.startsWith('=');
  if (has_equals) rest.remove(0, 1);
  const std::optional<double> number = evaluate(rest);
  if (!number) return std::nullopt;
  if (sign == '*') return Adjustment{*number, 0.0};
  if (sign == '/') return Adjustment{1.0 / *number, 0.0};
  if (sign == '+') return Adjustment{1.0, *number};
  if (sign == '-' && has_equals) return Adjustment{1.0, -*number};
  return std::nullopt;
}

}  // namespace brume
