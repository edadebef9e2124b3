#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/plan/plan.h"
#include "stepmill/sequence/advice/sensitivity.h"

namespace stepmill {

/// What a shop adds to a plan to make a price of it. Money is in the machine's currency.
struct QuoteTerms {
    /// To make ready for a clamping, once a lot [min]; nothing: as the machine's file says.
    std::optional<double> setup_min;
    /// To clamp and release a piece, in each clamping [s]; nothing: as the machine's file says.
    std::optional<double> load_s;
    double programming_min = 30;     ///< to look through plan and programs, once [min]
    double programming_rate = 0;     ///< money an hour of that; 0: the machine's
    std::vector<int> quantities{1};  ///< lots to be quoted, in this order
};

/// From the least to the most.
struct Range {
    double low = 0;
    double high = 0;
};

/// A lot of some pieces.
struct QuotedLot {
    int quantity = 1;
    Range time_min;     ///< of the machine: setting up, loading, cutting
    Range price;        ///< of all pieces, programming included
    Range piece_price;  ///< a piece
};

/// A change of the part that makes a feature cheaper, found by sequencing the changed feature.
struct CheaperChange {
    enum class Kind {
        LargerCorners,  ///< inner corners of this radius let a tool be left out
        LessDepth       ///< the floor lies higher
    };
    Kind kind = Kind::LargerCorners;
    double from_mm = 0;  ///< radius that the plan's smallest tool leaves; depth
    double to_mm = 0;
    double saves_s = 0;              ///< of machining, a piece
    double saves_cost = 0;           ///< with the tools' wear
    std::vector<std::string> tools;  ///< in the order of use, after the change
};
std::string toString(CheaperChange::Kind kind);

/// Values of a parameter at which another sequence of tools becomes the cheapest for a feature.
struct FeatureBreakEven {
    Parameter parameter = Parameter::ToolChange;
    double now = 0;
    std::optional<double> below;  ///< the next one below; nothing: none down to 0
    std::optional<double> above;  ///< the next one above; nothing: none
};

/// One of the features that cost most.
struct CostlyFeature {
    std::string id;
    FeatureClass feature_class = FeatureClass::ClosedPocket;
    double depth_mm = 0;
    double time_s = 0;
    double cost = 0;                     ///< with the tools' wear
    std::vector<CheaperChange> changes;  ///< the one that saves most first
    std::vector<FeatureBreakEven> break_evens;
};

/// What a part costs.
struct Quote {
    std::string part_file;
    std::string material;
    std::string currency;
    double hourly_rate = 0;
    QuoteTerms terms;
    int setups = 0;             ///< in which something is cut
    bool complete = false;      ///< else it is of what the plan cuts, and something stays
    bool acceleration = false;  ///< the machine's is known; else the high times are those of feeds alone
    Range machining_s;          ///< a piece: feeds alone, and with the machine's acceleration
    double load_s = 0;          ///< a piece
    double wear = 0;            ///< money of tools' lives used, a piece
    double setup_min = 0;       ///< once a lot
    double once = 0;            ///< money of setting up and programming, once a lot
    Range running;              ///< money of a further piece
    std::vector<QuotedLot> lots;
    /// Least quantity from which setting up and programming cost no more than the pieces themselves; nothing
    /// where a piece costs nothing.
    std::optional<int> pays_off_at;
    std::vector<CostlyFeature> costly;  ///< three at most, the costliest first
};

/// Quotes a plan.
/// \param progress  told of each stage
/// \note  sequences each of the three costliest features some ten times
Quote quotePlan(const Plan& plan, const QuoteTerms& terms, const Tolerances& tol,
                const Progress& progress = {});

}  // namespace stepmill
