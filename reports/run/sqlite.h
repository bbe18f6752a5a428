#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

// This is the little of SQLite that the store needs, with its errors as plumb::Error naming the file.
namespace plumb::reports::sqlite {

[[noreturn]] void fail(const std::filesystem::path& file, int code, const char* message);

/// An open database and the file it lives in.
class Database {
public:
    /// `flags` as sqlite3_open_v2() takes them; `patience` in milliseconds is how long to wait for a lock.
    Database(std::filesystem::path file, int flags, int patience);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] sqlite3* handle() const { return handle_; }
    void execute(const std::string& sql) const;
    [[nodiscard]] std::int64_t pragma(std::string_view name) const;

private:
    std::filesystem::path file_;
    sqlite3* handle_ = nullptr;
};

/// A prepared statement: with() binds all values in order, step() goes to the next row.
class Statement {
public:
    Statement(const Database& database, std::string_view sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    template <class... Values>
    Statement& with(const Values&... values) {
        reset();
        int index = 0;
        (bind(++index, values), ...);
        return *this;
    }
    /// Goes to the next row; false after the last one.
    bool step();

    [[nodiscard]] const Database& database() const { return database_; }
    [[nodiscard]] std::int64_t integer(int column) const;
    /// The number in a column. NULL reads as NaN, the only number that SQLite cannot hold.
    [[nodiscard]] double real(int column) const;
    [[nodiscard]] std::string text(int column) const;

private:
    void reset();
    void bind(int index, double value);
    void bind(int index, std::int64_t value);
    void bind(int index, const std::string& value);

    const Database& database_;
    sqlite3_stmt* statement_ = nullptr;
};

/// A transaction, all or nothing: what was not committed is rolled back.
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

}  // namespace plumb::reports::sqlite
