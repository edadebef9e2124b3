#include "output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "stepmill/core/error.h"
#include "stepmill/core/plain_text.h"

namespace stepmill {

namespace {

[[noreturn]] void fail(int error_number) {
    throw Error(ErrorCode::OutputUnwritable, "standard output", std::strerror(error_number));
}

}  // namespace

void printOut(std::string_view text) {
    printData(plainText(text));
}

void printData(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail(errno);
}

void flushOut() {
    const bool failed = std::ferror(stdout) != 0;
    if (std::fflush(stdout) != 0) fail(errno);
    if (failed) fail(EIO);
}

void printErr(std::string_view text) {
    const std::string plain = plainText(text);
    std::fwrite(plain.data(), 1, plain.size(), stderr);
}

}  // namespace stepmill
