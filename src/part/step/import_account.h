#pragma once

#include <string>
#include <vector>

#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <TopoDS_Shape.hxx>

namespace stepmill {

/// What OCCT made of one solid entity, face by face.
struct BodyAccount {
    int id = 0;
    TopoDS_Shape shape;               ///< null where nothing came of it
    int faces = 0;                    ///< of the solid OCCT built
    std::vector<std::string> losses;  ///< what was dropped, split or is no solid any more, with the entity
    std::vector<std::string> turned;  ///< faces that look to the other side than the file says
};

/// "#17 ADVANCED_FACE".
std::string entityName(const Handle(Interface_InterfaceModel) & model,
                       const Handle(Standard_Transient) & entity);

/// Every MANIFOLD_SOLID_BREP and its kin in the file against the shape it became.
/// \pre the reader has transferred its roots
std::vector<BodyAccount> accountBodies(STEPControl_Reader& reader);

}  // namespace stepmill
