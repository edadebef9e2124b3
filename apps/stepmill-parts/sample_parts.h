#pragma once

#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>

namespace stepmill {

/// A part of our own: its geometry is known by construction, so tests can compare areas and volumes with
/// values worked out by hand. Lengths in mm, the lower left bottom corner of the block at the origin, +z up.
struct SamplePart {
    std::string name;    ///< also the file name, without ".step"
    std::string about;   ///< one line: what is in it, dimensions, why
    TopoDS_Shape solid;  ///< one valid solid
};

SamplePart roundedPocket();
SamplePart butterflyPocket();
SamplePart bossedPocket();
SamplePart pocketWithoutBosses();
SamplePart openSlots();
SamplePart nestedPockets();
SamplePart plateWithHoles();
SamplePart fourSetups();
SamplePart dieCavity();
SamplePart dieWithIslands();
SamplePart moldCore();
SamplePart shoulderBlock();

/// All of them, in the order above.
std::vector<SamplePart> allSampleParts();

/// The part as an AP214 file in mm with named faces. Header and entity numbers are fixed: the same part
/// gives the same bytes, whatever was written before and whenever it is.
/// \throws Error(GeometryKernel)
std::string sampleStepText(const SamplePart& part);

/// README.md of the folder the parts are written to.
std::string sampleReadme(const std::vector<SamplePart>& parts);

}  // namespace stepmill
