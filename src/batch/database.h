#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace stepmill::batch {

/// A statement of SQL with values for its question marks, in their order.
///
///     Statement insert(database, "INSERT INTO jobs(key, tries) VALUES(?, ?)");
///     insert.bind(key).bind(1).run();
class Statement {
  public:
    Statement& bind(std::string_view text);
    Statement& bindBytes(std::string_view bytes);
    Statement& bind(std::int64_t number);
    Statement& bind(double number);

    /// To the next row; false behind the last.
    /// \throws Error as Database does
    bool step();
    /// Runs a statement that gives no rows, and makes it ready for other values.
    void run();

    /// A column of the row it stands on, from 0.
    std::string text(int column) const;
    std::int64_t number(int column) const;
    double real(int column) const;

  private:
    friend class Database;
    Statement(sqlite3* database, std::string_view sql, const std::string& file);
    void require(int result) const;

    sqlite3* database_;
    std::string file_;
    std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_;
    int bound_ = 0;
};

/// An SQLite file that is open.
class Database {
  public:
    enum class Mode { ReadAndWrite, ReadAlone };

    /// \param mode  ReadAndWrite makes a file that is not there
    /// \throws Error(OutputUnwritable), Error(FileUnreadable) naming the file, as do all calls
    Database(const std::filesystem::path& file, Mode mode);

    Statement prepare(std::string_view sql) const;
    /// Statements without values and rows.
    void execute(const std::string& sql) const;

  private:
    std::string file_;
    std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_;
};

/// Several statements that take effect together, with commit(), or not at all.
class Transaction {
  public:
    explicit Transaction(const Database& database);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void commit();

  private:
    const Database& database_;
    bool open_ = true;
};

}  // namespace stepmill::batch
