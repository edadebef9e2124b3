#pragma once

#include <map>
#include <string>
#include <vector>

namespace stepmill {

struct Part;

/// What stands in a file beside its solids: annotations mostly.
struct ImportStrays {
    int shells = 0;
    int faces = 0;  ///< outside shells
    int edges = 0;  ///< outside faces
    int points = 0;
};

/// A solid at one step of the import.
struct ImportedShape {
    int faces = 0;
    int edges = 0;  ///< each once; a closed face may have gained a seam
    double volume_mm3 = 0;
    double area_mm2 = 0;
};

/// What the file holds, what the geometry reader made of it and what healing changed.
struct ImportReport {
    std::map<std::string, int> kinds;  ///< entities of the shape by keyword
    std::vector<std::string> units;    ///< length units as the file names them
    std::string entity;                ///< "#15 MANIFOLD_SOLID_BREP"
    int shells_in_file = 0;
    int faces_in_file = 0;
    int edges_in_file = 0;
    ImportedShape built;       ///< by the geometry reader
    ImportedShape healed;      ///< as planned, before a --unit override
    double vertex_gap_mm = 0;  ///< worst distance of a vertex from the end of an edge
    double edge_gap_mm = 0;    ///< worst distance of an edge from a face
    ImportStrays strays;
};

/// The report of a part with its remarks as lines of text; a line that says so for a part not read from a
/// file.
std::string importText(const Part& part);

}  // namespace stepmill
