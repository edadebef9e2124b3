#include "support/random_forms.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace stepmill::test {
namespace {

class FormMaker {
  public:
    FormMaker(const FormRoom& room, Dice& dice) : room_(room), dice_(dice) {}

    FormCut make() {
        switch (dice_.below(7)) {
            case 0:
                return withDraft();
            case 1:
                return withRoundFloor();
            case 2:
                return channelAlong();
            case 3:
                return dimpleAt();
            case 4:
                return withFreeSides(1);
            case 5:
                return withFreeSides(dice_.between(1.02, 1.4));
            default:
                return withFreeFloor();
        }
    }

  private:
    const Rounded& place() const { return room_.place; }
    double width() const { return place().x1 - place().x0; }
    double height() const { return place().y1 - place().y0; }
    double smaller() const { return std::min(width(), height()); }
    std::string size() const {
        return fmt::format("{:.4g}x{:.4g}x{:.4g} r{:.4g}", width(), height(), room_.deep_mm, place().radius);
    }

    FormCut withDraft() {
        const double draft_deg = dice_.oneOf({0.5, 1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 15.0, 30.0, 45.0});
        return {drafted(place(), -room_.deep_mm, room_.beyond_mm, draft_deg),
                fmt::format("{} degrees draft {}", draft_deg, size())};
    }

    FormCut withRoundFloor() {
        const double fillet = std::min(
            {dice_.oneOf({0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0}), 0.4 * smaller(), 0.9 * room_.deep_mm});
        return {roundFloored(place(), -room_.deep_mm, room_.beyond_mm, fillet),
                fmt::format("round floor {:.4g} {}", fillet, size())};
    }

    double ballMm() { return dice_.oneOf({3.0, 4.0, 6.0, 8.0, 10.0, 12.0, 16.0}); }

    FormCut channelAlong() {
        const double wide = ballMm();
        const double deep = std::max(room_.deep_mm, wide / 2);
        const double from = dice_.chance(0.5) ? -room_.beyond_mm : place().x0;
        const double to = dice_.chance(0.5) ? room_.length_mm + room_.beyond_mm : place().x1;
        return {channel(from, to, place().y0, wide, -deep, room_.beyond_mm),
                fmt::format("channel {} wide {} deep", wide, deep)};
    }

    FormCut dimpleAt() {
        const double radius = ballMm() * dice_.between(1, 3);
        const double deep = std::min(room_.deep_mm, radius);
        return {dimple(place().x0, place().y0, radius, -deep),
                fmt::format("dimple R{:.4g} {} deep", radius, deep)};
    }

    /// \param top_share  how much wider it is at the top
    FormCut withFreeSides(double top_share) {
        std::vector<double> reaches(6 + dice_.below(7));
        for (double& reach : reaches)
            reach = dice_.between(0.35, 0.5) * smaller();
        const bool through = top_share == 1 && dice_.chance(0.2);
        const double floor_z = through ? -room_.through_mm - room_.beyond_mm : -room_.deep_mm;
        return {
            splineSided(place().x0 + width() / 2, place().y0 + height() / 2, reaches, floor_z,
                        room_.beyond_mm, top_share),
            fmt::format("free sides {:.4g} wide {:.4g} deep x{:.3g}", 0.85 * smaller(), -floor_z, top_share)};
    }

    FormCut withFreeFloor() {
        std::vector<double> heights(4 + dice_.below(4));
        for (double& height : heights)
            height = -dice_.between(0.2, 1) * room_.deep_mm;
        return {splineFloored(place().x0, place().x1, place().y0, place().y1, heights, room_.beyond_mm),
                fmt::format("free floor {}", size())};
    }

    const FormRoom& room_;
    Dice& dice_;
};

}  // namespace

FormCut randomForm(const FormRoom& room, Dice& dice) {
    return FormMaker(room, dice).make();
}

}  // namespace stepmill::test
