#include "planar/clearance/profile.h"

#include <numbers>

#include <tbb/task_arena.h>

#include "stepmill/core/parallel.h"

namespace stepmill::clearance {

namespace {

/// Clearances that differ by no more than this share of 1 mm + themselves are the same: what is left of the
/// sixteen digits after the divisions in meetingOf().
constexpr double kSameClearance = 1e-10;
/// Points of a site closer than this are one [mm].
constexpr double kSamePointMm = 1e-11;
constexpr int kDeepest = 200;
/// Two clearances at one place that differ by more than this share of 1 mm + themselves are a jump, no
/// rounding.
constexpr double kJump = 1e-3;
/// Beyond this clearances rise so steeply that they differ by that at any step [mm].
constexpr double kFarMm = 1e3;
constexpr int kRounds = 100;
/// Rounds of look-ups: the first finds nearly all there is; where rounding makes two sites contradict each
/// other, no number of them would be enough.
constexpr int kLookUpRounds = 12;
/// A site has about as many pieces as there are sites at most. More come of sites that contradict each other:
/// every look-up then adds some, and none of them is the last.
constexpr std::size_t kMostPiecesPerSite = 4;
constexpr std::size_t kFewPieces = 64;
/// Fewer are done before another thread has woken up.
constexpr std::size_t kSitesPerTask = 128;

bool same(double a, double b) {
    return std::abs(a - b) <= kSameClearance * (1 + std::min(std::abs(a), std::abs(b)));
}

/// The smallest step of u that moves a point.
double smallestStep(const Site& site) {
    return site.round() ? std::max(kSamePointMm / std::max(site.radius, 1.0), 1e-14) : kSamePointMm;
}

/// Where `rising`, negative at low and not so at high, changes sign: false position with halvings between,
/// so that jumps are found as well.
template <typename Function>
double signChange(const Function& rising, double low, double high, double step) {
    double at_low = rising(low), at_high = rising(high);
    for (int round = 0; round < kRounds && high - low > step; ++round) {
        double u = (low + high) / 2;
        if (round % 3 != 2 && std::isfinite(at_low) && std::isfinite(at_high) && at_high > at_low) {
            const double margin = (high - low) / 1000;
            const double secant = low - at_low * (high - low) / (at_high - at_low);
            u = std::clamp(secant, low + margin, high - margin);
        }
        const double value = rising(u);
        if (value == 0) return u;
        (value < 0 ? low : high) = u;
        (value < 0 ? at_low : at_high) = value;
    }
    return (low + high) / 2;
}

}  // namespace

Profile::Profile(const Region& region, bool outside) : tree_(region, outside) {
    std::vector<Pieces> all(sites().size());
    const auto work = [&](std::size_t begin, std::size_t end) {
        int hint = kNone;
        for (std::size_t i = begin; i < end; ++i) {
            all[i] = envelope(static_cast<int>(i), hint);
            hint = all[i].back().stop;
        }
    };
    if (all.size() <= 2 * kSitesPerTask)
        work(0, all.size());
    else
        // Isolated: a thread that waits here must not take up a task that asks for this very profile.
        tbb::this_task_arena::isolate([&] { parallelForParts(all.size(), kSitesPerTask, work); });
    for (int round = 0; round < kLookUpRounds && lookUpOneSided(all); ++round) {
    }
    first_.push_back(0);
    for (std::size_t i = 0; i < all.size(); ++i) {
        splitAtExtrema(static_cast<int>(i), all[i]);
        pieces_.insert(pieces_.end(), all[i].begin(), all[i].end());
        first_.push_back(pieces_.size());
    }
}

double Profile::clearanceAt(int site, double u, int stop) const {
    return clearanceAt(site, contactAt(sites()[site], u), stop);
}

double Profile::clearanceAt(int site, const Contact& contact, int stop) const {
    if (stop == kUnbounded) return kOpenMm;
    if (stop == kOwnCentre) return sites()[site].radius;
    return tree_.stoppedBySite(site, contact, stop);
}

Vec2 Profile::centreAt(int site, double u, double clearance) const {
    return contactAt(sites()[site], u).centreAt(clearance);
}

double Profile::crossing(int site, const Piece& piece, double clearance) const {
    const double sign = piece.at_from < piece.at_to ? 1 : -1;
    const auto over = [&](double u) { return sign * (clearanceAt(site, u, piece.stop) - clearance); };
    return signChange(over, piece.from, piece.to, smallestStep(sites()[site]));
}

/// Clearance below which the stop at a contact is found if `hint` or a neighbour of it stops the disc there
/// too; at most `limit`. It lies a little above theirs: which of equal stops comes first does not depend on
/// the hint.
double Profile::soughtBelow(int site, const Contact& contact, int hint, double limit) const {
    if (hint < 0) return limit;
    double least = limit;
    for (const int near : {hint, sites()[hint].previous, sites()[hint].next})
        least = std::min(least, tree_.stoppedBySite(site, contact, near));
    return std::min(limit, least + kSameClearance * (1 + least));
}

Profile::Sample Profile::sample(int index, double u, int hint) const {
    const Site& site = sites()[index];
    const bool concave = site.kind == SiteKind::Concave;
    const double limit = concave ? site.radius : kOpenMm;
    const Contact contact = contactAt(site, u);
    const double sought = soughtBelow(index, contact, hint, limit);
    Stop stop = tree_.firstStop(index, contact, sought);
    if (stop.site == kNone && sought < limit) stop = tree_.firstStop(index, contact, limit);
    if (stop.site == kNone) return {u, concave ? kOwnCentre : kUnbounded, stop.clearance};
    return {u, stop.site, stop.clearance};
}

Profile::Pieces Profile::envelope(int index, int hint) const {
    const Site& site = sites()[index];
    const Sample first = site.sharp_start ? Sample{0, site.previous, 0} : sample(index, 0, hint);
    const Sample last =
        site.sharp_end ? Sample{site.extent, site.next, 0} : sample(index, site.extent, first.stop);
    Pieces pieces;
    between(index, first, last, 0, pieces);
    return pieces;
}

/// Parameter at which both samples' stops limit the disc alike.
double Profile::equalAt(int site, const Sample& a, const Sample& b) const {
    const auto difference = [&](double u) {
        const Contact contact = contactAt(sites()[site], u);
        const double of_a = clearanceAt(site, contact, a.stop), of_b = clearanceAt(site, contact, b.stop);
        return of_a == kNever && of_b == kNever ? 0 : of_a - of_b;
    };
    return signChange(difference, a.u, b.u, smallestStep(sites()[site]));
}

/// The stop of the disc below `limit`; without one kNone and the limit itself.
Profile::Sample Profile::nearerAt(int site, double u, double limit) const {
    const Contact contact = contactAt(sites()[site], u);
    const Stop nearer = tree_.firstStop(site, contact, limit - kSameClearance * (1 + limit));
    return nearer.site == kNone ? Sample{u, kNone, limit} : Sample{u, nearer.site, nearer.clearance};
}

/// Round the far side of an arc the ends' stop is far off: discs at the ends close in the arc itself, not
/// what lies before its middle.
std::optional<Profile::Sample> Profile::hiddenBetween(int index, const Sample& a, const Sample& b) const {
    const Site& site = sites()[index];
    if (!site.round() || a.stop < 0 || b.u - a.u <= 16 * smallestStep(site)) return std::nullopt;
    const double middle = (a.u + b.u) / 2;
    const double believed = clearanceAt(index, middle, a.stop);
    if (believed <= std::max(a.clearance, b.clearance)) return std::nullopt;
    const Sample truth = sample(index, middle, a.stop);
    const bool hidden =
        truth.stop != a.stop && truth.clearance < believed && !same(truth.clearance, believed);
    return hidden ? std::optional(truth) : std::nullopt;
}

void Profile::between(int index, const Sample& a, const Sample& b, int depth, Pieces& pieces) const {
    const auto append = [&](const Piece& piece) {
        Piece* last = pieces.empty() ? nullptr : &pieces.back();
        if (last && last->stop == piece.stop) {
            last->to = piece.to;
            last->at_to = piece.at_to;
        } else {
            pieces.push_back(piece);
        }
    };
    if (a.stop == b.stop) {
        if (const auto hidden = hiddenBetween(index, a, b)) {
            between(index, a, *hidden, depth + 1, pieces);
            between(index, *hidden, b, depth + 1, pieces);
        } else {
            append({a.u, b.u, a.stop, a.clearance, b.clearance});
        }
        return;
    }
    const double step = smallestStep(sites()[index]);
    double u = equalAt(index, a, b);
    const double of_a = clearanceAt(index, u, a.stop), of_b = clearanceAt(index, u, b.stop);
    const double least = std::min(of_a, of_b);
    const bool narrow = b.u - a.u <= 16 * step || depth >= kDeepest;
    // Where one of the two drops out of sight instead, a third one stands beside that place. Far away both
    // rise so steeply that they differ at any step; there halving finds it.
    if (least >= kFarMm && std::max(of_a, of_b) == kNever && !narrow) {
        const Sample middle = sample(index, (a.u + b.u) / 2, a.stop);
        between(index, a, middle, depth + 1, pieces);
        between(index, middle, b, depth + 1, pieces);
        return;
    }
    const bool jumps = least < kFarMm && std::max(of_a, of_b) - least > kJump * (1 + least);
    if (jumps && of_a < kNever && of_b < kNever)
        u = of_a < of_b ? std::min(u + 4 * step, b.u) : std::max(u - 4 * step, a.u);
    const Sample third = jumps || least == kNever ? sample(index, u, a.stop) : nearerAt(index, u, least);
    const bool known = third.stop == kNone || third.stop == a.stop || third.stop == b.stop;
    if (narrow || known) {
        const double there = std::min(least, third.clearance);
        append({a.u, u, a.stop, a.clearance, there});
        append({u, b.u, b.stop, there, b.clearance});
        return;
    }
    between(index, a, third, depth + 1, pieces);
    between(index, third, b, depth + 1, pieces);
}

bool Profile::lookUpOneSided(std::vector<Pieces>& all) const {
    bool changed = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
        // A look-up may change the pieces of any site, this one too; those it adds wait for the next round.
        const Pieces pieces = all[i];
        for (const Piece& piece : pieces) {
            if (piece.stop < 0) continue;
            // Two places, lest one is where they touch.
            for (const double share : {0.38, 0.81})
                if (lookUp(static_cast<int>(i), piece, share, all)) changed = true;
        }
    }
    return changed;
}

/// `from` says that `seen.stop` stops its discs: does that site say the same?
bool Profile::lookUp(int from, const Piece& seen, double share, std::vector<Pieces>& all) const {
    const double u = seen.from + share * (seen.to - seen.from);
    const double clearance = clearanceAt(from, u, seen.stop);
    if (clearance == kNever || clearance < kTouchMm) return false;
    const int index = seen.stop;
    const double v = parameterOf(sites()[index], centreAt(from, u, clearance));
    Pieces& pieces = all[index];
    if (pieces.size() > kFewPieces + kMostPiecesPerSite * sites().size()) return false;
    const auto at = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& p) { return v <= p.to; });
    if (at == pieces.end() || at->stop == from) return false;
    const double believed = clearanceAt(index, v, at->stop);
    if (believed <= clearance || same(believed, clearance)) return false;
    const Sample truth = sample(index, v, from);
    if (truth.stop == at->stop || truth.clearance >= believed || same(truth.clearance, believed))
        return false;
    Pieces found;
    between(index, {at->from, at->stop, at->at_from}, truth, 0, found);
    between(index, truth, {at->to, at->stop, at->at_to}, 0, found);
    const auto next = pieces.erase(at);
    pieces.insert(next, found.begin(), found.end());
    return true;
}

/// The clearance between two sites has an extremum where their normals oppose each other.
void Profile::splitAtExtrema(int index, Pieces& pieces) const {
    const Site& site = sites()[index];
    Pieces split;
    for (const Piece& piece : pieces) {
        std::vector<double> at;
        const auto consider = [&](double u) {
            const double margin = 4 * smallestStep(site);
            if (u > piece.from + margin && u < piece.to - margin) at.push_back(u);
        };
        const auto considerRay = [&](const Vec2& v) {
            const double turned = turnedTo(site, v);
            consider(turned < 0 ? turned + 2 * std::numbers::pi : turned);
        };
        if (piece.stop >= 0) {
            const Site& other = sites()[piece.stop];
            if (!site.round() && other.round()) consider((other.centre - site.start).dot(site.direction));
            if (site.round() && !other.round())
                considerRay(site.kind == SiteKind::Concave ? other.normal : Vec2(-other.normal));
            if (site.round() && other.round()) {
                considerRay(other.centre - site.centre);
                considerRay(site.centre - other.centre);
            }
        }
        std::sort(at.begin(), at.end());
        Piece rest = piece;
        for (const double u : at) {
            const double clearance = clearanceAt(index, u, piece.stop);
            if (clearance == kNever) continue;
            split.push_back({rest.from, u, rest.stop, rest.at_from, clearance});
            rest.from = u;
            rest.at_from = clearance;
        }
        split.push_back(rest);
    }
    pieces = std::move(split);
}

}  // namespace stepmill::clearance
