#pragma once

#include <vector>

#include "plan/forms/form_site.h"
#include "stepmill/layers/section_cutter.h"

namespace stepmill {

struct Heights {
    double bottom_mm = 0;
    double top_mm = 0;
};

/// How finely walls that lean are cut.
struct BandLimits {
    double skin_mm = 0;  ///< a band leaves a skin no thicker than this, its height times the sine of its lean
    double thickest_mm = 0;  ///< nor is it higher than this, or than the skin where that is more
};

/// The walls that form cutters work on in a setup, and how the part is cut for them.
class SiteWalls {
  public:
    SiteWalls() = default;
    SiteWalls(const SiteWalls&) = delete;
    SiteWalls& operator=(const SiteWalls&) = delete;
    virtual ~SiteWalls() = default;

    virtual std::string groundId(const std::string& setup_id) const = 0;
    /// What is to go, from below.
    virtual std::vector<Obstacle> stairs() const = 0;
    /// Where the work ends below at the foot of a wall, ascending.
    virtual std::vector<double> feet() const = 0;
    /// Is the layer cut finer, and its part not the layer's own?
    virtual bool cuts(const Layer& layer) const = 0;
    /// The bands of such a layer from below.
    virtual std::vector<Heights> bandsOf(const Layer& layer, const BandLimits& limits) const = 0;
    /// What must stay of the part at all heights of a band.
    virtual Region mustStay(const Heights& band) const = 0;
    /// How walls lean there, as FormSite::leans.
    virtual std::vector<double> leans(const Heights& band) const = 0;
};

/// The ground of these walls with what must stand beside them.
/// \param widest_mm  radius of the widest cutter
/// \return nothing where nothing is to go
/// \throws Error(TimedOut) soon after the deadline
std::optional<FormSite> siteOf(const FormSources& sources, const SiteWalls& walls, double skin_mm,
                               double widest_mm, const Tolerances& tol, const Deadline& deadline);

}  // namespace stepmill
