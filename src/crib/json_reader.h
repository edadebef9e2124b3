#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace stepmill::crib {

/// A value of a stranger's JSON with its place, for messages. Fields that are absent or null say nothing;
/// those of another kind than asked for are refused.
class JsonReader {
  public:
    /// \throws Error(InvalidCatalog) for text that is not JSON, naming line and column
    static nlohmann::json parse(std::string_view text, const std::string& file);

    /// \param value, file  must outlive the reader
    JsonReader(const nlohmann::json& value, const std::string& file, std::string pointer = "#")
        : value_(value), file_(file), pointer_(std::move(pointer)) {}

    const std::string& pointer() const { return pointer_; }
    const nlohmann::json& value() const { return value_; }
    bool has(const char* field) const { return find(field) != nullptr; }

    std::optional<JsonReader> object(const char* field) const;
    std::vector<JsonReader> list(const char* field) const;  ///< empty where absent
    std::string text(const char* field) const;              ///< empty where absent
    double number(const char* field) const;                 ///< 0 where absent
    double positive(const char* field) const;               ///< the same, refusing what is below 0
    bool flag(const char* field, bool otherwise) const;

    /// \throws Error(InvalidCatalog): the field is not what was expected
    [[noreturn]] void refuseField(const char* field, const std::string& expected) const;

  private:
    const nlohmann::json* find(const char* field) const;

    const nlohmann::json& value_;
    const std::string& file_;
    std::string pointer_;
};

}  // namespace stepmill::crib
