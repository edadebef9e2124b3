#include "stepmill/part/part_shape.h"

#include <new>

#include <Standard_OutOfMemory.hxx>
#include <TopoDS.hxx>

#include "part/measure.h"

namespace stepmill {

void guardOcct(ErrorCode code, const std::string& subject, const std::function<void()>& work) {
    try {
        work();
    } catch (const Standard_OutOfMemory&) {
        throw std::bad_alloc();  // says nothing about the shape
    } catch (const Standard_Failure& failure) {
        const char* text = failure.GetMessageString();
        const std::string kind = failure.DynamicType()->Name();
        throw Error(code, subject,
                    "the geometry kernel failed: " + kind + (text && *text ? std::string(": ") + text : ""));
    }
}

Part makePart(const TopoDS_Shape& solid, const std::string& name) {
    Part part;
    guardOcct(ErrorCode::InvalidSolid, name, [&] {
        const TopoDS_Shape single = singleSolid(solid, name);
        requireValid(single, volumeOf(single), name);
        part.name = name;
        part.unit_in_file = "mm";
        describeShape(part, single);
    });
    return part;
}

}  // namespace stepmill
