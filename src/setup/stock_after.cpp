// The stock a setup leaves to the next one.

#include <fmt/format.h>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopTools_DataMapIteratorOfDataMapOfShapeInteger.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_ListOfShape.hxx>

#include "setup/prism_solid.h"
#include "setup/solid_stock.h"
#include "setup/upright_stacks.h"
#include "stepmill/core/error.h"
#include "stepmill/part/part_shape.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/setup/in_process.h"

namespace stepmill {

double volumeOf(const std::vector<Prism>& prisms) {
    double volume_mm3 = 0;
    for (const Prism& prism : prisms)
        volume_mm3 += prism.volume_mm3();
    return volume_mm3;
}

namespace {

/// Planar regions lie on a nanometre grid and snap within Tolerances::linear_mm: faces nearer than that are
/// one face.
constexpr double kFuzzyMm = 1e-5;
constexpr double kWideFuzzyMm = 2e-4;

/// Volumes of solid and prisms may differ by this share of what is removed ...
constexpr double kVolumeShare = 1e-4;
/// ... and by a film of this thickness over the prisms' walls.
constexpr double kFilmMm = 1e-4;

/// Facets for a trial: about as fine as slicing makes them on a part of common size.
constexpr double kFacetMm = 0.05;
constexpr double kFacetRad = 0.4;

/// Less than this removed is nothing [mm3].
constexpr double kNothingMm3 = 1e-3;

/// All prisms are cut in one operation up to this number of edges: its time grows with about the square, of
/// prisms in turn in proportion.
constexpr std::size_t kEdgesAtOnce = 300;

/// How far prisms reach over a top or below a bottom of the stock: no coinciding faces there.
constexpr double kBeyondMm = 1;

TopTools_ListOfShape solidsOf(const TopoDS_Shape& shape) {
    TopTools_ListOfShape solids;
    for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next())
        solids.Append(it.Current());
    return solids;
}

TopoDS_Shape compoundOf(const TopTools_ListOfShape& shapes) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes)
        builder.Add(compound, shape);
    return compound;
}

/// Do faces use every edge as often one way as the other? The volume says the rest; OCCT's own check takes
/// minutes on faces of thousands of edges, and is asked only where this one doubts.
bool isClosed(const TopoDS_Shape& shape) {
    TopTools_DataMapOfShapeInteger uses;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        for (TopExp_Explorer it(face.Current(), TopAbs_EDGE); it.More(); it.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
            const bool bounds = edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
            if (!bounds || BRep_Tool::Degenerated(edge)) continue;
            const int way = edge.Orientation() == TopAbs_FORWARD ? 1 : -1;
            if (int* sum = uses.ChangeSeek(edge))
                *sum += way;
            else
                uses.Bind(edge, way);
        }
    }
    for (TopTools_DataMapIteratorOfDataMapOfShapeInteger it(uses); it.More(); it.Next())
        if (it.Value() != 0) return false;
    return !uses.IsEmpty();
}

/// Can every face be turned into facets, as slicing will have to?
bool hasFacetsEverywhere(const TopoDS_Shape& shape) {
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape).Shape();
    BRepMesh_IncrementalMesh(copy, kFacetMm, false, kFacetRad, false);
    for (TopExp_Explorer it(copy, TopAbs_FACE); it.More(); it.Next()) {
        TopLoc_Location location;
        if (BRep_Tool::Triangulation(TopoDS::Face(it.Current()), location).IsNull()) return false;
    }
    return true;
}

/// Faces stay split where the operation split them: OCCT's joining of faces of one surface (7.6) never ends
/// on some sound shapes.
template <typename Operation>
std::optional<TopoDS_Shape> combine(const TopTools_ListOfShape& arguments, const TopTools_ListOfShape& tools,
                                    double fuzzy_mm) {
    Operation operation;
    operation.SetArguments(arguments);
    operation.SetTools(tools);
    operation.SetFuzzyValue(fuzzy_mm);
    operation.SetNonDestructive(true);
    operation.SetToFillHistory(false);
    operation.Build();
    if (!operation.IsDone() || operation.HasErrors()) return std::nullopt;
    return compoundOf(solidsOf(operation.Shape()));
}

double filmVolume(const std::vector<Prism>& prisms) {
    double skin_mm2 = 0;
    for (const Prism& prism : prisms)
        skin_mm2 += perimeter(prism.region) * (prism.top_z_mm - prism.bottom_z_mm) + 2 * area(prism.region);
    return kFilmMm * skin_mm2;
}

std::size_t edgesOf(const std::vector<Prism>& prisms) {
    std::size_t count = 0;
    for (const Prism& prism : prisms)
        for (const Loop& loop : prism.region.loops)
            count += loop.segments.size();
    return count;
}

class StockCutter {
  public:
    StockCutter(const Setup& setup, const std::vector<Prism>& removed, const std::vector<Prism>& arriving,
                const Tolerances& tol)
        : setup_(setup), removed_(removed), arriving_(arriving), tol_(tol) {
        removed_mm3_ = volumeOf(removed);
        air_mm3_ = std::max(0.0, volumeOf(arriving) - setup.stock.volume_mm3);
        slack_mm3_ = kVolumeShare * removed_mm3_ + filmVolume(removed);
    }

    StockAfter run() {
        using Try = std::function<std::optional<TopoDS_Shape>()>;
        const Try at_once = [&] { return cutAtOnce(kFuzzyMm); };
        const Try with_slack = [&] { return cutAtOnce(kWideFuzzyMm); };
        const Try in_turn = [&] { return cutInTurn(kFuzzyMm); };
        std::vector<std::pair<std::string, Try>> tries;
        if (edgesOf(removed_) <= kEdgesAtOnce) {
            tries = {{"", at_once},
                     {fmt::format("cut with {} mm of slack", kWideFuzzyMm), with_slack},
                     {"cut one prism after another", in_turn}};
        } else {
            tries = {{"", in_turn}};
        }
        tries.emplace_back("rebuilt from slabs", [&] { return rebuilt(true); });
        tries.emplace_back("rebuilt from slabs, not joined", [&] { return rebuilt(false); });
        StockAfter after;
        for (const auto& [how, work] : tries) {
            const std::optional<Stock> made = attempt(work, after.remarks);
            if (!made) continue;
            if (!how.empty()) after.remarks.push_back("the stock after this setup was " + how);
            after.stock = *made;
            after.removed_mm3 = setup_.stock.volume_mm3 - made->volume_mm3;
            return after;
        }
        throw Error(ErrorCode::GeometryKernel, "stock after " + setup_.id,
                    "cannot be made: " + after.remarks.back());
    }

  private:
    std::optional<Stock> attempt(const std::function<std::optional<TopoDS_Shape>()>& work,
                                 std::vector<std::string>& remarks) const {
        std::optional<Stock> made;
        try {
            const std::optional<TopoDS_Shape> shape = work();
            if (!shape || solidsOf(*shape).IsEmpty()) {
                remarks.push_back("a Boolean operation failed");
                return std::nullopt;
            }
            if (!isClosed(*shape) && !BRepCheck_Analyzer(*shape).IsValid()) {
                remarks.push_back("a Boolean operation gave a solid that is not closed");
                return std::nullopt;
            }
            if (!hasFacetsEverywhere(*shape)) {
                remarks.push_back("a Boolean operation gave a face that cannot be cut");
                return std::nullopt;
            }
            made = setup::inProcessStock(*shape);
        } catch (const Standard_Failure& failure) {
            remarks.push_back(fmt::format("a Boolean operation stopped: {}", failure.GetMessageString()));
            return std::nullopt;
        }
        const double gone_mm3 = setup_.stock.volume_mm3 - made->volume_mm3;
        if (gone_mm3 < std::max(0.0, removed_mm3_ - air_mm3_) - slack_mm3_ ||
            gone_mm3 > removed_mm3_ + slack_mm3_) {
            remarks.push_back(
                fmt::format("a Boolean operation removed {:.6g} mm3 where the prisms hold {:.6g}", gone_mm3,
                            removed_mm3_));
            return std::nullopt;
        }
        return made;
    }

    /// Prisms that end at the stock's top or bottom reach beyond it.
    TopoDS_Shape tool(Prism prism) const {
        if (prism.top_z_mm >= setup_.stock_bbox_mm.max().z() - tol_.linear_mm) prism.top_z_mm += kBeyondMm;
        if (prism.bottom_z_mm <= setup_.stock_bbox_mm.min().z() + tol_.linear_mm)
            prism.bottom_z_mm -= kBeyondMm;
        return setup::prismSolid(prism, setup_.part_to_setup);
    }

    TopTools_ListOfShape stockSolids() const {
        return solidsOf(BRepBuilderAPI_Copy(setup_.stock.shape->solid).Shape());
    }

    std::optional<TopoDS_Shape> cutAtOnce(double fuzzy_mm) const {
        TopTools_ListOfShape tools;
        for (const Prism& prism : setup::uprightStacks(removed_, tol_))
            for (const TopoDS_Shape& solid : solidsOf(tool(prism)))
                tools.Append(solid);
        return combine<BRepAlgoAPI_Cut>(stockSolids(), tools, fuzzy_mm);
    }

    std::optional<TopoDS_Shape> cutInTurn(double fuzzy_mm) const {
        std::vector<const Prism*> from_above;
        for (const Prism& prism : removed_)
            from_above.push_back(&prism);
        std::stable_sort(from_above.begin(), from_above.end(),
                         [](const Prism* a, const Prism* b) { return a->top_z_mm > b->top_z_mm; });
        std::optional<TopoDS_Shape> left = compoundOf(stockSolids());
        for (const Prism* prism : from_above) {
            const TopTools_ListOfShape tools = solidsOf(tool(*prism));
            std::optional<TopoDS_Shape> next = combine<BRepAlgoAPI_Cut>(solidsOf(*left), tools, fuzzy_mm);
            if (!next) next = combine<BRepAlgoAPI_Cut>(solidsOf(*left), tools, kWideFuzzyMm);
            if (!next) return std::nullopt;
            left = std::move(next);
        }
        return left;
    }

    /// Slabs between all heights at which arriving stock or prisms change, less the prisms.
    std::vector<Prism> standing() const {
        std::set<double> heights;
        for (const std::vector<Prism>* prisms : {&arriving_, &removed_})
            for (const Prism& prism : *prisms)
                heights.insert({prism.top_z_mm, prism.bottom_z_mm});
        std::vector<Prism> slabs;
        for (auto low = heights.begin(); std::next(low) != heights.end(); ++low) {
            const double middle = (*low + *std::next(low)) / 2;
            const auto spans = [&](const Prism& prism) {
                return prism.bottom_z_mm < middle && middle < prism.top_z_mm;
            };
            const auto slab = std::find_if(arriving_.begin(), arriving_.end(), spans);
            if (slab == arriving_.end()) continue;
            std::vector<Region> gone;
            for (const Prism& prism : removed_)
                if (spans(prism)) gone.push_back(prism.region);
            Region left = gone.empty() ? slab->region : subtract(slab->region, unite(gone, tol_), tol_);
            if (area(left) > tol_.area_mm2) slabs.push_back({std::move(left), *std::next(low), *low});
        }
        return slabs;
    }

    std::optional<TopoDS_Shape> rebuilt(bool joined) const {
        TopTools_ListOfShape solids;
        for (const Prism& slab : standing())
            for (const TopoDS_Shape& solid : solidsOf(setup::prismSolid(slab, setup_.part_to_setup)))
                solids.Append(solid);
        if (!joined || solids.Extent() < 2) return compoundOf(solids);
        TopTools_ListOfShape first;
        first.Append(solids.First());
        solids.RemoveFirst();
        return combine<BRepAlgoAPI_Fuse>(first, solids, kFuzzyMm);
    }

    const Setup& setup_;
    const std::vector<Prism>& removed_;
    const std::vector<Prism>& arriving_;
    const Tolerances& tol_;
    double removed_mm3_ = 0;
    double air_mm3_ = 0;
    double slack_mm3_ = 0;
};

}  // namespace

StockAfter stockAfter(const Setup& setup, const std::vector<Prism>& removed,
                      const std::vector<Prism>& arriving, const Tolerances& tol) {
    if (volumeOf(removed) < kNothingMm3) return {setup.stock, 0, {}};
    STEPMILL_CHECK(setup.stock.shape, "a stock to cut has a shape");
    return StockCutter(setup, removed, arriving, tol).run();
}

}  // namespace stepmill
