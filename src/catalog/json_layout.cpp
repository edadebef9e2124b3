#include "catalog/json_layout.h"

#include <algorithm>

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLine = 110;

std::string leaf(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// A value without parts, or a list of such.
bool isRow(const Json& value) {
    if (value.is_object()) return false;
    return std::none_of(value.begin(), value.end(), [](const Json& item) { return item.is_structured(); });
}

/// Appends the value on one line and tells whether it stayed within `end` characters of text; where it did
/// not the text is cut off somewhere.
bool addLine(const Json& value, std::size_t end, std::string& text) {
    if (!value.is_structured()) {
        text += leaf(value);
        return text.size() <= end;
    }
    text += value.is_object() ? '{' : '[';
    bool first = true;
    for (const auto& [key, item] : value.items()) {
        if (!first) text += ',';
        first = false;
        if (value.is_object()) text += leaf(Json(key)) + ":";
        if (!addLine(item, end, text)) return false;
    }
    text += value.is_object() ? '}' : ']';
    return text.size() <= end;
}

/// Lays out values below each other.
class Layout {
  public:
    std::string text() && { return std::move(text_); }

    void add(const Json& value) {
        if (!value.is_structured()) {
            text_ += leaf(value);
        } else if (!fits(value)) {
            text_ += value.is_object() ? '{' : '[';
            ++depth_;
            addItems(value);
            --depth_;
            newLine();
            text_ += value.is_object() ? '}' : ']';
        }
    }

  private:
    /// Adds the value where it fits on what is left of the line.
    bool fits(const Json& value) {
        const std::size_t before = text_.size();
        if (addLine(value, line_start_ + kLine, text_)) return true;
        text_.resize(before);
        return false;
    }

    void newLine() {
        text_ += '\n';
        line_start_ = text_.size();
        text_.append(depth_, ' ');
    }

    void addItems(const Json& value) {
        const bool filled = value.is_array() && std::all_of(value.begin(), value.end(), isRow);
        bool first = true;
        for (const auto& [key, item] : value.items()) {
            if (!first) text_ += ',';
            if (first || !filled || !fits(item)) {
                newLine();
                if (value.is_object()) text_ += leaf(Json(key)) + ": ";
                add(item);
            }
            first = false;
        }
    }

    std::string text_;
    std::size_t line_start_ = 0;
    std::size_t depth_ = 0;
};

}  // namespace

std::string laidOut(const Json& value) {
    Layout layout;
    layout.add(value);
    return std::move(layout).text();
}

}  // namespace stepmill
