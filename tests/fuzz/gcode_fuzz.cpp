// The reader of programs, over any text in any dialect: it reads or refuses, it never dies, and what it reads
// is finite and stands in order.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "stepmill/core/error.h"
#include "stepmill/post/read_program.h"

namespace {

using namespace stepmill;

void check(bool holds) {
    if (!holds) std::abort();
}

void checkMoves(const ReadProgram& program) {
    for (const ReadOperation& operation : program.operations) {
        check(operation.start.allFinite());
        for (const ReadMove& move : operation.moves) {
            check(move.fed.move.to.allFinite() && std::isfinite(move.fed.feed_mm_per_min));
            check(move.line > 0 && move.state < program.states.size());
            check(move.fed.move.kind == MoveKind::Rapid || move.fed.feed_mm_per_min >= 0);
        }
    }
    for (const ReadLeap& leap : program.leaps)
        check(leap.line > 0 && leap.state < program.states.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const Dialect dialect : {Dialect::LinuxCnc, Dialect::Fanuc, Dialect::Grbl}) {
        try {
            checkMoves(readProgram(text, "fuzz.ngc", dialect));
        } catch (const Error& error) {
            check(error.code() == ErrorCode::InvalidCatalog);
        }
    }
    return 0;
}
