#include "drawing/svg_numbers.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace stepmill::drawing {

void SvgNumbers::skip() {
    const std::size_t first = text_.find_first_not_of(" \t\r\n,");
    text_.remove_prefix(first == std::string_view::npos ? text_.size() : first);
}

char SvgNumbers::peek() {
    skip();
    return text_.empty() ? '\0' : text_.front();
}

char SvgNumbers::take() {
    const char c = peek();
    if (c != '\0') text_.remove_prefix(1);
    return c;
}

std::optional<double> SvgNumbers::number() {
    skip();
    constexpr double kFarthest = 1e7;
    const std::size_t plus = !text_.empty() && text_.front() == '+' ? 1 : 0;
    double value = 0;
    const char* const last = text_.data() + text_.size();
    const auto [end, trouble] = std::from_chars(text_.data() + plus, last, value);
    if (trouble != std::errc() || !std::isfinite(value) || std::abs(value) > kFarthest) return std::nullopt;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
}

double SvgNumbers::need() {
    if (const std::optional<double> value = number()) return *value;
    throw std::invalid_argument("expected a number, found '" + std::string(text_.substr(0, 20)) + "'");
}

bool SvgNumbers::flag() {
    const char c = take();
    if (c != '0' && c != '1') throw std::invalid_argument("expected a flag 0 or 1 of an arc");
    return c == '1';
}

}  // namespace stepmill::drawing
