#include "stepmill/catalog/json_text.h"

#include <set>

namespace stepmill {
namespace {

using nlohmann::json;

/// Reads along to notice fields given twice, of which a json object keeps only the last. (The parser's own
/// callback would do, but searches a list from its start at each item's end.)
class DuplicateFields : public nlohmann::json_sax<json> {
  public:
    explicit DuplicateFields(std::vector<CatalogFinding>& findings) : findings_(findings) {}

    bool null() override { return nextItem(); }
    bool boolean(bool /*value*/) override { return nextItem(); }
    bool number_integer(number_integer_t /*value*/) override { return nextItem(); }
    bool number_unsigned(number_unsigned_t /*value*/) override { return nextItem(); }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return nextItem(); }
    bool string(string_t& /*value*/) override { return nextItem(); }
    bool binary(binary_t& /*value*/) override { return nextItem(); }
    bool start_object(std::size_t /*size*/) override { return open(false); }
    bool start_array(std::size_t /*size*/) override { return open(true); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        Frame& frame = frames_.back();
        frame.key = name;
        if (frame.keys.insert(name).second) return true;
        std::string pointer = "#";
        for (const Frame& step : frames_)
            pointer = step.is_array ? childPointer(pointer, step.index) : childPointer(pointer, step.key);
        findings_.push_back({pointer, "expected each field once, found it twice"});
        return true;
    }

    bool parse_error(std::size_t /*offset*/, const std::string& /*token*/,
                     const nlohmann::detail::exception& /*error*/) override {
        return false;
    }

  private:
    struct Frame {
        bool is_array;
        std::size_t index;
        std::string key;
        std::set<std::string> keys;
    };

    bool open(bool is_array) {
        frames_.push_back({is_array, 0, {}, {}});
        return true;
    }

    bool close() {
        frames_.pop_back();
        return nextItem();
    }

    bool nextItem() {
        if (!frames_.empty() && frames_.back().is_array) ++frames_.back().index;
        return true;
    }

    std::vector<CatalogFinding>& findings_;
    std::vector<Frame> frames_;
};

std::string lineAndColumn(std::string_view text, std::size_t offset) {
    std::size_t line = 1;
    std::size_t column = 1;
    for (const char c : text.substr(0, offset)) {
        const bool continues_character = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
        if (c == '\n') {
            ++line;
            column = 1;
        } else if (!continues_character) {
            ++column;
        }
    }
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// The part of nlohmann-json's message that says what it met, without its own tags.
std::string reason(const std::string& message) {
    const std::size_t dash = message.find(" - ");
    if (dash != std::string::npos) return message.substr(dash + 3);
    const std::size_t tag_end = message.find("] ");
    return tag_end == std::string::npos ? message : message.substr(tag_end + 2);
}

/// Where the quoted number of an overflow message stands; that exception carries no position.
std::size_t offsetOfQuoted(std::string_view text, const std::string& message) {
    const std::size_t first = message.find('\'');
    const std::size_t last = message.rfind('\'');
    if (first == std::string::npos || last <= first) return 0;
    const std::size_t found = text.find(message.substr(first + 1, last - first - 1));
    return found == std::string_view::npos ? 0 : found;
}

CatalogFinding notJson(std::string_view text, std::size_t offset, const std::string& message) {
    return {"#", "not JSON at " + lineAndColumn(text, offset) + ": " + reason(message)};
}

}  // namespace

ParsedJson parseJson(std::string_view text) {
    ParsedJson result;
    try {
        result.value = json::parse(text.begin(), text.end());
        DuplicateFields duplicates(result.findings);
        json::sax_parse(text.begin(), text.end(), &duplicates);
    } catch (const json::parse_error& error) {
        // `byte` counts the characters read, the offending one included.
        result.findings = {notJson(text, error.byte == 0 ? 0 : error.byte - 1, error.what())};
        result.value = json(json::value_t::discarded);
    } catch (const json::exception& error) {
        result.findings = {notJson(text, offsetOfQuoted(text, error.what()), error.what())};
        result.value = json(json::value_t::discarded);
    }
    return result;
}

std::string childPointer(const std::string& pointer, const std::string& name) {
    std::string step;
    for (const char c : name) {
        if (c == '~')
            step += "~0";
        else if (c == '/')
            step += "~1";
        else
            step += c;
    }
    return pointer + "/" + step;
}

std::string childPointer(const std::string& pointer, std::size_t index) {
    return pointer + "/" + std::to_string(index);
}

std::string quoted(const json& value) {
    constexpr std::size_t kLongest = 40;
    if (value.is_object()) return "an object";
    if (value.is_array()) return "a list of " + std::to_string(value.size());
    std::string text = value.dump(-1, ' ', true);
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return text;
}

}  // namespace stepmill
