#include "stepmill/batch/ledger.h"

#include <fmt/format.h>

#include "batch/database.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill {

using batch::Database;
using batch::Statement;
using batch::Transaction;

struct Ledger::State {
    Database database;
};

namespace {

/// Of the tables below; stands in the file as its user_version.
constexpr int kFormat = 1;

constexpr const char* kWithoutLog = "PRAGMA journal_mode = DELETE";

constexpr const char* kTables = R"(
CREATE TABLE jobs(key TEXT PRIMARY KEY, part_sha256 TEXT NOT NULL, options_sha256 TEXT NOT NULL, program TEXT NOT NULL,
  folder TEXT NOT NULL, outcome TEXT NOT NULL, exit_code INTEGER NOT NULL, message TEXT NOT NULL, figures TEXT NOT NULL,
  tries INTEGER NOT NULL, started TEXT NOT NULL, seconds REAL NOT NULL) WITHOUT ROWID;
CREATE TABLE parts(position INTEGER PRIMARY KEY, name BLOB NOT NULL, quantity INTEGER NOT NULL, due TEXT NOT NULL,
  options TEXT NOT NULL, key TEXT NOT NULL, trouble TEXT NOT NULL);
)";

int formatOf(const Database& database) {
    Statement read = database.prepare("PRAGMA user_version");
    read.step();
    return static_cast<int>(read.number(0));
}

void requireFormat(const Database& database, const std::filesystem::path& file) {
    if (formatOf(database) == kFormat) return;
    throw Error(ErrorCode::FileUnreadable, file.string(), "is no ledger of this version of Stepmill");
}

void makeTables(const Database& database) {
    Transaction together(database);
    database.execute(kTables);
    database.execute(fmt::format("PRAGMA user_version = {}", kFormat));
    together.commit();
}

bool isEmpty(const Database& database) {
    Statement count = database.prepare("SELECT count(*) FROM sqlite_master");
    count.step();
    return count.number(0) == 0;
}

BatchJob jobFrom(const Statement& row) {
    BatchJob job;
    job.key = {row.text(0), row.text(1), row.text(2)};
    job.folder = row.text(3);
    job.outcome = outcomeFrom(row.text(4)).value_or(Outcome::Waiting);
    job.exit_code = static_cast<int>(row.number(5));
    job.message = row.text(6);
    job.figures = row.text(7);
    job.tries = static_cast<int>(row.number(8));
    job.started = row.text(9);
    job.seconds = row.real(10);
    return job;
}

void store(const Database& database, const BatchJob& job) {
    database
        .prepare(
            "INSERT OR REPLACE INTO jobs(key, part_sha256, options_sha256, program, folder, outcome, "
            "exit_code, message, figures, tries, started, seconds) VALUES(?,?,?,?,?,?,?,?,?,?,?,?)")
        .bind(job.key.text())
        .bind(job.key.part_sha256)
        .bind(job.key.options_sha256)
        .bind(job.key.program)
        .bind(job.folder)
        .bind(toString(job.outcome))
        .bind(std::int64_t{job.exit_code})
        .bind(job.message)
        .bind(job.figures)
        .bind(std::int64_t{job.tries})
        .bind(job.started)
        .bind(job.seconds)
        .run();
}

}  // namespace

std::string JobKey::text() const {
    return sha256(part_sha256 + " " + options_sha256 + " " + program);
}

Ledger::Ledger(std::unique_ptr<State> state) : state_(std::move(state)) {}
Ledger::~Ledger() = default;
Ledger::Ledger(Ledger&&) noexcept = default;
Ledger& Ledger::operator=(Ledger&&) noexcept = default;

Ledger::Ledger(const std::filesystem::path& file)
    : state_(std::make_unique<State>(State{Database(file, Database::Mode::ReadAndWrite)})) {
    const Database& database = state_->database;
    // A killed program loses nothing; after a power cut the last jobs may have to be done again.
    database.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
    if (isEmpty(database)) makeTables(database);
    requireFormat(database, file);
}

Ledger Ledger::forReading(const std::filesystem::path& file) {
    auto state = std::make_unique<State>(State{Database(file, Database::Mode::ReadAlone)});
    requireFormat(state->database, file);
    return Ledger(std::move(state));
}

void Ledger::setParts(const std::vector<LedgerPart>& parts) {
    const Database& database = state_->database;
    Transaction together(database);
    database.execute("DELETE FROM parts");
    Statement insert = database.prepare(
        "INSERT INTO parts(position, name, quantity, due, options, key, trouble) VALUES(?,?,?,?,?,?,?)");
    std::int64_t position = 0;
    for (const LedgerPart& part : parts)
        insert.bind(++position)
            .bindBytes(part.name)
            .bind(std::int64_t{part.quantity})
            .bind(part.due)
            .bind(part.options)
            .bind(part.key)
            .bind(part.trouble)
            .run();
    together.commit();
}

std::vector<LedgerPart> Ledger::parts() const {
    Statement row = state_->database.prepare(
        "SELECT name, quantity, due, options, key, trouble FROM parts ORDER BY position");
    std::vector<LedgerPart> parts;
    while (row.step())
        parts.push_back({row.text(0), static_cast<int>(row.number(1)), row.text(2), row.text(3), row.text(4),
                         row.text(5)});
    return parts;
}

std::map<std::string, BatchJob> Ledger::jobs() const {
    Statement row = state_->database.prepare(
        "SELECT part_sha256, options_sha256, program, folder, outcome, exit_code, message, figures, tries, "
        "started, seconds FROM jobs");
    std::map<std::string, BatchJob> jobs;
    while (row.step()) {
        BatchJob job = jobFrom(row);
        jobs.emplace(job.key.text(), std::move(job));
    }
    return jobs;
}

void Ledger::begin(const BatchJob& job) {
    const Database& database = state_->database;
    BatchJob begun = job;
    begun.outcome = Outcome::Waiting;
    begun.exit_code = 0;
    begun.message.clear();
    begun.figures.clear();
    Transaction together(database);
    database.prepare("DELETE FROM jobs WHERE folder = ? AND key != ?")
        .bind(job.folder)
        .bind(job.key.text())
        .run();
    store(database, begun);
    together.commit();
}

void Ledger::finish(const BatchJob& job) {
    store(state_->database, job);
}

void Ledger::finish(const std::vector<BatchJob>& jobs) {
    Transaction together(state_->database);
    for (const BatchJob& job : jobs)
        store(state_->database, job);
    together.commit();
}

void Ledger::settle() {
    state_->database.execute(kWithoutLog);
}

void Ledger::settle(const std::filesystem::path& file) {
    Database(file, Database::Mode::ReadAndWrite).execute(kWithoutLog);
}

}  // namespace stepmill
