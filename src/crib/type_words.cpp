#include "crib/type_words.h"

#include <array>
#include <cctype>

#include <fmt/format.h>

#include "stepmill/core/enum_words.h"

namespace stepmill::crib {
namespace {

constexpr EnumWord<ToolType> kHsmWords[] = {
    {ToolType::Flat, "flat end mill"},      {ToolType::Ball, "ball end mill"},
    {ToolType::Bull, "bull nose end mill"}, {ToolType::Drill, "drill"},
    {ToolType::Face, "face mill"},          {ToolType::Chamfer, "chamfer mill"},
    {ToolType::Tap, "tap right hand"},      {ToolType::Spot, "spot drill"},
    {ToolType::Reamer, "reamer"},           {ToolType::Boring, "boring bar"},
    {ToolType::Countersink, "counter sink"}};

/// Types that other programs have and Stepmill does not. They come first: a "centre drill" is no drill.
constexpr std::array kUnfit = {" center drill ",    " centre drill ", " counter bore ", " counterbore ",
                               " thread mill ",     " threadmill ",   " dovetail ",     " lollipop ",
                               " slot mill ",       " slitting ",     " slittingsaw ",  " tapered ",
                               " taperedballnose ", " radius mill ",  " form mill ",    " circle segment ",
                               " turning ",         " probe ",        " holder ",       " laser ",
                               " waterjet ",        " plasma ",       " left hand ",    " engraver ",
                               " engraving ",       " saw "};

/// The special before the plain.
constexpr EnumWord<ToolType> kWords[] = {{ToolType::Countersink, " counter sink "},
                                         {ToolType::Countersink, " countersink "},
                                         {ToolType::Chamfer, " chamfer "},
                                         {ToolType::Chamfer, " v bit "},
                                         {ToolType::Chamfer, " vbit "},
                                         {ToolType::Ball, " ball "},
                                         {ToolType::Ball, " ballend "},
                                         {ToolType::Ball, " ballnose "},
                                         {ToolType::Bull, " bull "},
                                         {ToolType::Bull, " bullnose "},
                                         {ToolType::Bull, " torus "},
                                         {ToolType::Face, " face "},
                                         {ToolType::Face, " facemill "},
                                         {ToolType::Face, " shell mill "},
                                         {ToolType::Tap, " tap "},
                                         {ToolType::Reamer, " reamer "},
                                         {ToolType::Boring, " boring "},
                                         {ToolType::Spot, " spot drill "},
                                         {ToolType::Spot, " spotdrill "},
                                         {ToolType::Spot, " spotting drill "},
                                         {ToolType::Drill, " drill "},
                                         {ToolType::Flat, " flat "},
                                         {ToolType::Flat, " end mill "},
                                         {ToolType::Flat, " endmill "},
                                         {ToolType::Flat, " slot drill "},
                                         {ToolType::Spot, " spot "}};

}  // namespace

std::string plainWords(std::string_view text) {
    std::string words = " ";
    for (const char c : text) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (words.back() != ' ')
            words += ' ';
    }
    if (words.back() != ' ') words += ' ';
    return words;
}

TypeWord typeOfWords(std::string_view text) {
    const std::string words = plainWords(text);
    if (words.find(" slot drill ") != std::string::npos) return {ToolType::Flat, ""};
    for (const std::string_view unfit : kUnfit)
        if (words.find(unfit) != std::string::npos)
            return {std::nullopt, fmt::format("'{}' is no type of tool that Stepmill plans with",
                                              unfit.substr(1, unfit.size() - 2))};
    for (const EnumWord<ToolType>& entry : kWords)
        if (words.find(entry.word) != std::string::npos) return {entry.value, ""};
    return {};
}

void setType(ToolAssembly& tool, ToolType type) {
    tool.type = type;
    if (tool.isSpot()) tool.point_angle_deg = kUsualSpotPointDeg;
}

std::string hsmWord(ToolType type) {
    return wordOf(kHsmWords, type);
}

}  // namespace stepmill::crib
