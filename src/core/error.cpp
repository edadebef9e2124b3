#include "stepmill/core/error.h"

#include <utility>

namespace stepmill {

Error::Error(ErrorCode code, std::string subject, const std::string& message)
    : std::runtime_error(subject + ": " + message), code_(code), subject_(std::move(subject)) {}

bool isInputError(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::InvalidRegion:
        case ErrorCode::GeometryKernel:
        case ErrorCode::Internal:
            return false;
        default:
            return true;
    }
}

namespace detail {
void checkFailed(const char* condition, const char* file, int line, const std::string& why) {
    throw Error(ErrorCode::Internal, std::string(file) + ":" + std::to_string(line),
                why + " (expected " + condition + ")");
}
}  // namespace detail

}  // namespace stepmill
