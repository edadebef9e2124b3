#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/catalog/thread.h"

namespace stepmill {

enum class ToolType { Flat, Ball, Bull, Drill, Face, Chamfer, Tap, Spot, Reamer, Boring, Countersink };

/// A cylinder of shank or holder over the cutter: anything as wide as `diameter_mm` between two heights
/// over the tool tip.
struct HolderCylinder {
    double diameter_mm = 0;
    double bottom_mm = 0;
    double top_mm = 0;
};

enum class Coolant { Off, Mist, Flood };
std::string toString(Coolant coolant);
/// The reverse; nothing for another word.
std::optional<Coolant> coolantFrom(std::string_view word);

/// A second set of cutting data, for roughing deep and narrow at constant engagement. Zero means as in the
/// first.
struct AdaptiveData {
    double step_over_mm = 0;
    double step_down_mm = 0;
    double feed_mm_per_min = 0;
    double speed_rpm = 0;
    double lift_mm = 0;  ///< ways over cleared ground go so far over it
};

/// What one cutter does in one material. Zero means not given.
struct CuttingData {
    std::string material;
    double step_over_mm = 0;       ///< Woc, radial engagement
    double step_down_mm = 0;       ///< Doc, axial engagement
    double slot_step_down_mm = 0;  ///< deepest cut as wide as the cutter at the full feed
    /// No cut removes more [mm3/min]; not given: step-over x step-down x feed.
    double rated_removal_mm3_per_min = 0;
    double feed_mm_per_min = 0;
    double plunge_feed_mm_per_min = 0;
    double slot_feed_mm_per_min = 0;  ///< in cuts wider than the step-over; not given: the feed
    double ramp_angle_deg = 0;        ///< steepest descent along a helix or ramp
    double speed_rpm = 0;
    Coolant coolant = Coolant::Flood;
    double dwell_s = 0;                    ///< at the bottom of a drilled hole
    std::optional<AdaptiveData> adaptive;  ///< nothing: derived from these [toolpath/adaptive_cutting.h]
};

/// What the cutting part of a tool is made of.
enum class CutterMaterial { Carbide, Hss };
std::string toString(CutterMaterial material);
/// The reverse; nothing for another word.
std::optional<CutterMaterial> cutterMaterialFrom(std::string_view word);

/// Of a tap whose library does not say: so many threads its lead is long, as of a plug tap.
inline constexpr double kUsualLeadThreads = 4;

/// Points as blunt as this centre themselves; drills with sharper ones wander where nothing was spotted
/// [deg].
inline constexpr double kSelfCentringPointDeg = 130;
/// Of spot drills whose library does not say [deg].
inline constexpr double kUsualSpotPointDeg = 90;
/// How long the tapered start of a reamer is whose library does not say, as a share of its diameter.
inline constexpr double kUsualLeadShare = 0.1;

/// How far a cutter may be set out of its holder.
struct StickOutRange {
    double shortest_mm = 0;
    double longest_mm = 0;
};

/// A cutter in its holder, as it stands in the magazine. Heights are measured from the tip.
struct ToolAssembly {
    std::string id;
    int number = 0;  ///< T word and tool-table number
    ToolType type = ToolType::Flat;
    double diameter_mm = 0;
    double corner_radius_mm = 0;    ///< diameter / 2 for a ball, 0 for a flat end mill
    double tip_diameter_mm = 0;     ///< of a cone (hasFlanks()): where it ends below
    double included_angle_deg = 0;  ///< of a cone: between its flanks, 90 for chamfers of 45 degrees
    double point_angle_deg = 118;   ///< of a drill or a spot drill: between the flanks of its point
    bool self_centring = false;     ///< of a drill: it starts true where nothing was spotted
    std::optional<Thread> thread;   ///< of a tap: what it cuts, right-hand
    double lead_mm = 0;  ///< of a tap: from its tip to its first full tooth; of what sizes: to its full width
    double flute_length_mm = 0;
    int flutes = 0;
    CutterMaterial cutter_material = CutterMaterial::Carbide;
    bool centre_cutting = false;  ///< has edges down to its axis
    /// It may go straight down into solid material by so much at a time; of a mill.
    double max_plunge_mm = 0;
    double stick_out_mm = 0;  ///< tip to the lowest holder face; of a range the longest until a
                              ///< plan sets it shorter
    std::optional<StickOutRange> stick_out_range;
    HolderCylinder shank;                ///< from the end of the flutes to the stick-out
    std::vector<HolderCylinder> holder;  ///< from below to above
    double holder_clearance_mm = 0;      ///< how far the holder is kept off all that stands, a machine's rule
    std::vector<CuttingData> cutting;
    double price = 0;
    double life_min = 0;  ///< cutting minutes a tool lasts; 0: not given, wear not counted
    std::string description;
    std::string vendor;
    std::string product_id;

    double radius_mm() const { return diameter_mm / 2; }
    bool isDrill() const { return type == ToolType::Drill; }
    bool isTap() const { return type == ToolType::Tap; }
    bool isSpot() const { return type == ToolType::Spot; }
    /// Does it bring a bore that is nearly as wide to its fit?
    bool isSizer() const { return type == ToolType::Reamer || type == ToolType::Boring; }
    bool isCountersink() const { return type == ToolType::Countersink; }
    /// Does it go straight down into holes, and nowhere else?
    bool isForHoles() const { return isDrill() || isTap() || isSpot() || isSizer() || isCountersink(); }
    /// Is it a cone, with an angle between its flanks and a tip?
    bool hasFlanks() const { return type == ToolType::Chamfer || isCountersink(); }
    /// Does it cut forms that flat layers leave: walls that lean, fillets, chamfers?
    bool isForm() const { return type == ToolType::Ball || type == ToolType::Bull || hasFlanks(); }
    /// Cutting data for a material, or nothing when the library has none for it.
    const CuttingData* cuttingFor(const std::string& material_name) const;
};

/// The cutting data's slot step-down or, where they name none, half the diameter; no more than the step-down.
double slotStepDownMm(const ToolAssembly& tool, const CuttingData& cutting);
/// What the tool may remove at most in a minute: as rated or, where that is not given, what its step-over,
/// step-down and feed make [mm3/min].
double ratedRemovalMm3PerMin(const CuttingData& cutting);

/// How deep a mill may plunge where its library does not say: half its diameter up to 6 mm, wider ones and
/// those without edges at the axis not at all.
double usualPlungeMm(const ToolAssembly& tool);

/// The tool with its cutter set out that far: the holder moves with it, flutes and the shank's start stay.
ToolAssembly setTo(ToolAssembly tool, double stick_out_mm);

/// The holder as it is kept off what stands: by its clearance wider all round and lower.
std::vector<HolderCylinder> keptOffHolder(const ToolAssembly& tool);
/// For words about such a cylinder: ", with 1 mm of clearance"; empty where there is none.
std::string clearanceWords(const ToolAssembly& tool);

/// A checked tool library in mm, tools in the file's order.
struct ToolLibrary {
    std::string file;  ///< name without folder
    std::string sha256;
    std::string unit;  ///< "mm" or "inch", as in the file
    std::vector<ToolAssembly> tools;
    std::vector<std::string> unknown_fields;  ///< JSON pointers of fields Stepmill does not know, kept aside

    const ToolAssembly& tool(const std::string& id) const;  ///< \throws Error(Internal) if absent
    std::vector<std::string> materials() const;             ///< sorted, each once
};

std::string toString(ToolType type);
/// The reverse; nothing for another word.
std::optional<ToolType> toolTypeFrom(std::string_view word);

}  // namespace stepmill
