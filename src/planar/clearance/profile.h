#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planar/clearance/tree.h"

namespace stepmill::clearance {

/// Stops that are not sites: no stop at all, or the centre of the concave arc on which the disc grows.
inline constexpr int kUnbounded = -1;
inline constexpr int kOwnCentre = -2;
/// Clearance where nothing stops the disc [mm].
inline constexpr double kOpenMm = 1e7;

/// A stretch of one site on which one stop limits the discs. The clearance rises or falls all along it, or
/// stays the same.
struct Piece {
    double from = 0;
    double to = 0;
    int stop = kUnbounded;
    double at_from = 0;  ///< clearance at both ends [mm]
    double at_to = 0;
};

/// Clearance as a function along the whole boundary: for every site its pieces, in order and without gaps.
///
/// On each site this is the lower envelope of the clearances that all other sites allow. The search asks the
/// tree for the stops at both ends of a site. Where they differ, it asks at the point where both stop the
/// disc alike: either no site is nearer, and the point is a vertex of the Voronoi diagram, or a third stop
/// shows up. Where they are equal, only an island can hide between them; its own profile then names this site
/// as a stop, so the search looks up such one-sided pairs until there are none. Where the middle of an arc
/// looks away from the stop of both its ends, the search asks at the middle too. Build O(n log n) for n edges
/// on ordinary regions, sites in parallel.
class Profile {
  public:
    /// `outside`: of the space around the region.
    Profile(const Region& region, bool outside);

    const std::vector<Site>& sites() const { return tree_.sites(); }
    const SiteTree& tree() const { return tree_; }
    std::span<const Piece> pieces(int site) const {
        return {pieces_.data() + first_[site], pieces_.data() + first_[site + 1]};
    }
    /// Clearance at a point of `site` if `stop` were the only one.
    double clearanceAt(int site, double u, int stop) const;
    /// Parameter at which the clearance along the piece equals `clearance`, which lies between its ends.
    double crossing(int site, const Piece& piece, double clearance) const;
    /// Centre of the disc at a point with that clearance.
    Vec2 centreAt(int site, double u, double clearance) const;

  private:
    struct Sample {
        double u = 0;
        int stop = kUnbounded;
        double clearance = 0;
    };
    using Pieces = std::vector<Piece>;

    double clearanceAt(int site, const Contact& contact, int stop) const;
    double soughtBelow(int site, const Contact& contact, int hint, double limit) const;
    /// `hint`: a site that may well be the stop, or none.
    Sample sample(int site, double u, int hint) const;
    Sample nearerAt(int site, double u, double limit) const;
    Pieces envelope(int site, int hint) const;
    std::optional<Sample> hiddenBetween(int site, const Sample& a, const Sample& b) const;
    void between(int site, const Sample& a, const Sample& b, int depth, Pieces& pieces) const;
    double equalAt(int site, const Sample& a, const Sample& b) const;
    bool lookUpOneSided(std::vector<Pieces>& all) const;
    bool lookUp(int from, const Piece& seen, double share, std::vector<Pieces>& all) const;
    void splitAtExtrema(int site, Pieces& pieces) const;

    SiteTree tree_;
    std::vector<Piece> pieces_;
    std::vector<std::size_t> first_;
};

}  // namespace stepmill::clearance
