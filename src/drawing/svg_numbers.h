#pragma once

#include <optional>
#include <string_view>

namespace stepmill::drawing {

/// Numbers of SVG attributes one after another: "10-5.5.5,1e3" are four.
class SvgNumbers {
  public:
    explicit SvgNumbers(std::string_view text) : text_(text) {}

    /// The next number; nothing where something else or nothing follows.
    std::optional<double> number();
    /// The next number.
    /// \throws std::invalid_argument without one
    double need();
    /// A flag of an arc: "0" or "1", which need no blank behind them.
    bool flag();
    /// The next character that is no blank or comma, without taking it; 0 at the end.
    char peek();
    char take();

  private:
    void skip();

    std::string_view text_;
};

}  // namespace stepmill::drawing
