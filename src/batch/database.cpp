#include "batch/database.h"

#include <sqlite3.h>

#include "stepmill/core/error.h"

namespace stepmill::batch {
namespace {

/// How long a write waits for another program that reads or writes the file just then [ms].
constexpr int kBusyTimeoutMs = 10000;

[[noreturn]] void fail(const std::string& file, sqlite3* database, int result) {
    const std::string why = database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(result);
    const int kind = result & 0xFF;
    if (kind == SQLITE_NOTADB || kind == SQLITE_CORRUPT)
        throw Error(ErrorCode::FileUnreadable, file, "is no ledger of a batch, or is damaged: " + why);
    throw Error(ErrorCode::OutputUnwritable, file, why);
}

}  // namespace

Statement::Statement(sqlite3* database, std::string_view sql, const std::string& file)
    : database_(database), file_(file), statement_(nullptr, sqlite3_finalize) {
    sqlite3_stmt* statement = nullptr;
    const int result =
        sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    statement_.reset(statement);
    require(result);
}

void Statement::require(int result) const {
    if (result != SQLITE_OK && result != SQLITE_ROW && result != SQLITE_DONE) fail(file_, database_, result);
}

Statement& Statement::bind(std::string_view text) {
    require(sqlite3_bind_text(statement_.get(), ++bound_, text.data(), static_cast<int>(text.size()),
                              SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bindBytes(std::string_view bytes) {
    require(sqlite3_bind_blob(statement_.get(), ++bound_, bytes.data(), static_cast<int>(bytes.size()),
                              SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bind(std::int64_t number) {
    require(sqlite3_bind_int64(statement_.get(), ++bound_, number));
    return *this;
}

Statement& Statement::bind(double number) {
    require(sqlite3_bind_double(statement_.get(), ++bound_, number));
    return *this;
}

bool Statement::step() {
    const int result = sqlite3_step(statement_.get());
    require(result);
    return result == SQLITE_ROW;
}

void Statement::run() {
    step();
    sqlite3_reset(statement_.get());
    bound_ = 0;
}

std::string Statement::text(int column) const {
    const void* bytes = sqlite3_column_blob(statement_.get(), column);
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return bytes == nullptr ? std::string()
                            : std::string(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

std::int64_t Statement::number(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const {
    return sqlite3_column_double(statement_.get(), column);
}

Database::Database(const std::filesystem::path& file, Mode mode)
    : file_(file.string()), database_(nullptr, sqlite3_close) {
    const int flags =
        mode == Mode::ReadAlone ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    sqlite3* opened = nullptr;
    const int result = sqlite3_open_v2(file_.c_str(), &opened, flags, nullptr);
    database_.reset(opened);
    if (result != SQLITE_OK) fail(file_, opened, result);
    sqlite3_busy_timeout(opened, kBusyTimeoutMs);
}

Statement Database::prepare(std::string_view sql) const {
    return {database_.get(), sql, file_};
}

void Database::execute(const std::string& sql) const {
    const int result = sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr);
    if (result != SQLITE_OK) fail(file_, database_.get(), result);
}

Transaction::Transaction(const Database& database) : database_(database) {
    database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    if (!open_) return;
    try {
        database_.execute("ROLLBACK");
    } catch (const Error&) {
        // A failed write has rolled it back already.
    }
}

void Transaction::commit() {
    database_.execute("COMMIT");
    open_ = false;
}

}  // namespace stepmill::batch
