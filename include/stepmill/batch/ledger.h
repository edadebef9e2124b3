#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "stepmill/batch/outcome.h"

namespace stepmill {

/// What makes a plan of a batch the plan it is: with the same key it has the same bytes.
struct JobKey {
    std::string part_sha256;
    std::string options_sha256;  ///< of all that plan was told, files that it was told of included
    std::string program;         ///< version and build

    /// 64 hexadecimal digits.
    std::string text() const;
};

/// One plan of a batch, for all parts of the list that have its key.
struct BatchJob {
    JobKey key;
    std::string folder;  ///< its name below jobs/
    Outcome outcome = Outcome::Waiting;
    int exit_code = 0;
    std::string message;  ///< what it told on standard error
    std::string figures;  ///< figuresJson() of its plan; empty without one
    int tries = 0;
    std::string started;  ///< of the last try: date and time in UTC
    double seconds = 0;   ///< that the last try took
};

/// A part of the list as the batch read it.
struct LedgerPart {
    std::string name;
    int quantity = 1;
    std::string due;
    std::string options;  ///< its own
    std::string key;      ///< of its job; empty where the file could not be read
    std::string trouble;  ///< why
};

/// The book of a batch, ledger.sqlite: what is to be planned, and what came of it [docs/batch.md]. What a
/// call has written stays written whatever ends the program after it.
class Ledger {
  public:
    /// Opens the book, or begins it.
    /// \throws Error(OutputUnwritable), Error(FileUnreadable) naming the file, as do all calls
    explicit Ledger(const std::filesystem::path& file);
    /// To read alone what a batch writes, perhaps just now.
    static Ledger forReading(const std::filesystem::path& file);
    ~Ledger();
    Ledger(Ledger&&) noexcept;
    Ledger& operator=(Ledger&&) noexcept;

    /// Puts the list of an earlier run out and this one in.
    void setParts(const std::vector<LedgerPart>& parts);
    std::vector<LedgerPart> parts() const;

    /// By key.
    std::map<std::string, BatchJob> jobs() const;
    /// A job's turn has come: it has no outcome from now on. Other jobs that had its folder are forgotten,
    /// since their plan goes.
    void begin(const BatchJob& job);
    /// Its turn is over.
    void finish(const BatchJob& job);
    /// Several whose turn is over, all or none.
    void finish(const std::vector<BatchJob>& jobs);
    /// The file alone holds all from now on, without a log beside it, and readers make none: it may be
    /// copied.
    void settle();
    /// The same for a ledger that nobody has open.
    static void settle(const std::filesystem::path& file);

  private:
    struct State;
    explicit Ledger(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace stepmill
