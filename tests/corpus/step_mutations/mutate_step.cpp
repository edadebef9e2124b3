#include "mutate_step.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <random>

#include <fmt/format.h>

namespace stepmill::test {

namespace {

bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Offset behind the string or comment that begins at `at`, or `at` if none does.
std::size_t skipText(std::string_view text, std::size_t at) {
    if (text[at] == '\'') {
        const std::size_t end = text.find('\'', at + 1);
        return end == std::string_view::npos ? text.size() : end + 1;
    }
    if (text.substr(at, 2) == "/*") {
        const std::size_t end = text.find("*/", at + 2);
        return end == std::string_view::npos ? text.size() : end + 2;
    }
    return at;
}

std::size_t endOf(std::string_view text, std::size_t at, std::string_view characters) {
    const std::size_t end = text.find_first_not_of(characters, at);
    return end == std::string_view::npos ? text.size() : end;
}

/// True if the id that ends here is the one an entity is defined by.
bool isDefinition(std::string_view text, std::size_t end) {
    return text[endOf(text, end, " \r\n\t")] == '=';
}

using Random = std::mt19937_64;

template <class List>
const auto& pick(const List& list, Random& random) {
    return list[random() % list.size()];
}

std::string editedNumber(const std::string& old, Random& random) {
    const double value = std::stod(old);
    const bool integer = old.find_first_of(".eE") == std::string::npos;
    if (integer) return std::to_string(std::stol(old) + static_cast<long>(random() % 5) - 2);
    const std::array<double, 11> choices = {0,
                                            -value,
                                            2 * value,
                                            0.5 * value,
                                            value + 1,
                                            value - 0.1,
                                            value + 1e-3,
                                            value * (1 + 1e-5),
                                            10 * value,
                                            value * 1e-4,
                                            1};
    std::string shown = fmt::format("{:#.15g}", pick(choices, random));
    std::replace(shown.begin(), shown.end(), 'e', 'E');
    return shown;
}

/// Another reference of the file, so that most edits stay well-formed; half of them of the neighbourhood,
/// where entities of the same kind stand.
std::string editedReference(std::string_view text, const std::vector<EditSpot>& references, std::size_t index,
                            Random& random) {
    constexpr std::size_t kNear = 40;
    const bool near = random() % 2 == 0;
    const std::size_t low = near && index > kNear ? index - kNear : 0;
    const std::size_t high = near ? std::min(references.size(), index + kNear) : references.size();
    const EditSpot& other = references[low + random() % (high - low)];
    return std::string(text.substr(other.begin, other.end - other.begin));
}

std::string editedFlag(const std::string& old, Random& random) {
    if (old == ".T.") return ".F.";
    if (old == ".F.") return ".T.";
    static constexpr std::array<std::string_view, 8> kWords = {".T.",     ".F.",     ".U.",     ".MILLI.",
                                                               ".CENTI.", ".MICRO.", ".METRE.", ".RADIAN."};
    return std::string(pick(kWords, random));
}

std::string lineAround(const std::string& text, std::size_t at) {
    const std::size_t begin = text.rfind(';', at);
    const std::size_t first = text.find('#', begin == std::string::npos ? 0 : begin);
    const std::string entity = text.substr(first, text.find(';', at) - first);
    std::string flat;
    for (const char c : entity)
        if (c != '\n' && c != '\r') flat += c;
    constexpr std::size_t kShown = 150;
    return flat.size() > kShown ? flat.substr(0, kShown) + "..." : flat;
}

}  // namespace

std::string_view wordOf(EditKind kind) {
    static constexpr std::array<std::string_view, 3> kWords = {"number", "reference", "flag"};
    return kWords[static_cast<std::size_t>(kind)];
}

std::vector<EditSpot> editSpots(std::string_view text) {
    std::vector<EditSpot> spots;
    std::size_t at = text.find("DATA;");
    const std::size_t last = text.rfind("ENDSEC;");
    bool in_word = false;
    while (at < last) {
        const std::size_t begin = at;
        const char c = text[at];
        if (const std::size_t behind = skipText(text, at); behind != at) {
            at = behind;
        } else if (c == '#') {
            at = endOf(text, at + 1, "0123456789");
            if (!isDefinition(text, at)) spots.push_back({EditKind::Reference, begin, at});
        } else if (c == '.' && std::isalpha(static_cast<unsigned char>(text[at + 1]))) {
            at = text.find('.', at + 1) + 1;
            spots.push_back({EditKind::Flag, begin, at});
        } else if (!in_word && (isDigit(c) || ((c == '-' || c == '.') && isDigit(text[at + 1])))) {
            at = endOf(text, at + 1, "0123456789.eE+-");
            spots.push_back({EditKind::Number, begin, at});
        } else {
            ++at;
        }
        const auto before = static_cast<unsigned char>(text[at - 1]);
        in_word = std::isalnum(before) != 0 || before == '_';
    }
    return spots;
}

EditedStep editStep(const std::string& text, const std::vector<EditSpot>& spots, EditKind kind,
                    std::uint64_t seed) {
    Random random(seed);
    std::vector<EditSpot> of_kind;
    for (const EditSpot& spot : spots)
        if (spot.kind == kind) of_kind.push_back(spot);
    const std::size_t index = random() % of_kind.size();
    const EditSpot& spot = of_kind[index];
    const std::string old = text.substr(spot.begin, spot.end - spot.begin);
    std::string fresh = old;
    for (int tries = 0; fresh == old && tries < 20; ++tries)
        fresh = kind == EditKind::Number      ? editedNumber(old, random)
                : kind == EditKind::Reference ? editedReference(text, of_kind, index, random)
                                              : editedFlag(old, random);
    EditedStep result{kind, text, fmt::format("{} : {} -> {}", lineAround(text, spot.begin), old, fresh)};
    result.text.replace(spot.begin, spot.end - spot.begin, fresh);
    return result;
}

}  // namespace stepmill::test
