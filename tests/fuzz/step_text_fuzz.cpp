// The STEP screen on any bytes: it takes them or throws Error, and says so within its time and memory.

#include <cstdint>
#include <cstdlib>

#include "part/step/text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const stepmill::StepText read = stepmill::screenStep(text, "fuzz.step");
        if (read.entities <= 0) std::abort();
        for (const stepmill::StepBody& body : read.bodies)
            if (body.faces < 0 || body.edges < 0) std::abort();
    } catch (const stepmill::Error& error) {
        if (!stepmill::isInputError(error.code())) std::abort();
    }
    return 0;
}
