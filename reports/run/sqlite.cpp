#include "reports/run/sqlite.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <limits>

#include "core/error.h"

namespace plumb::reports::sqlite {
namespace {

void check(const Database& database, int code) {
    if (code != SQLITE_OK) fail(database.file(), code, sqlite3_errmsg(database.handle()));
}

std::string explained(int code, const char* message) {
    switch (code & 0xff) {  // the primary code; the rest says more than a user needs
        case SQLITE_BUSY:
        case SQLITE_LOCKED: return "locked by another process";
        case SQLITE_NOTADB:
        case SQLITE_CORRUPT: return fmt::format("not a results store, or damaged ({})", message);
        case SQLITE_CANTOPEN: return fmt::format("cannot be opened or made ({})", message);
        case SQLITE_READONLY:
        case SQLITE_FULL:
        case SQLITE_IOERR: return fmt::format("cannot be written ({})", message);
        default: return message;
    }
}

}  // namespace

void fail(const std::filesystem::path& file, int code, const char* message) {
    const std::string journal = file.string() + "-journal";
    std::error_code ignored;
    if (code == SQLITE_READONLY_ROLLBACK ||
        ((code & 0xff) == SQLITE_CANTOPEN && std::filesystem::exists(journal, ignored)))
        throw Error(
            fmt::format("{}: its last write was cut off, and {} has what undoes it: that needs leave to write "
                        "to both and to their folder; copy the two to where you have it",
                        file.string(), journal));
    throw Error(fmt::format("{}: {}", file.string(), explained(code, message)));
}

Database::Database(std::filesystem::path file, int flags, int patience) : file_(std::move(file)) {
    const int code = sqlite3_open_v2(file_.c_str(), &handle_, flags, nullptr);
    if (code != SQLITE_OK) {
        const std::string message = sqlite3_errmsg(handle_);
        sqlite3_close(handle_);
        fail(file_, code, message.c_str());
    }
    sqlite3_extended_result_codes(handle_, 1);
    sqlite3_busy_timeout(handle_, patience);
}

Database::~Database() {
    sqlite3_close(handle_);
}

void Database::execute(const std::string& sql) const {
    check(*this, sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr));
}

std::int64_t Database::pragma(std::string_view name) const {
    Statement statement(*this, fmt::format("PRAGMA {}", name));
    return statement.step() ? statement.integer(0) : 0;
}

Statement::Statement(const Database& database, std::string_view sql) : database_(database) {
    check(database,
          sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()), &statement_, nullptr));
}

Statement::~Statement() {
    sqlite3_finalize(statement_);
}

bool Statement::step() {
    const int code = sqlite3_step(statement_);
    if (code != SQLITE_ROW && code != SQLITE_DONE) fail(database_.file(), code, sqlite3_errmsg(database_.handle()));
    return code == SQLITE_ROW;
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(statement_, column);
}

double Statement::real(int column) const {
    if (sqlite3_column_type(statement_, column) == SQLITE_NULL) return std::numeric_limits<double>::quiet_NaN();
    return sqlite3_column_double(statement_, column);
}

std::string Statement::text(int column) const {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
    return bytes ? std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))) : "";
}

void Statement::reset() {
    check(database_, sqlite3_reset(statement_));
}

void Statement::bind(int index, double value) {
    check(database_, sqlite3_bind_double(statement_, index, value));
}

void Statement::bind(int index, std::int64_t value) {
    check(database_, sqlite3_bind_int64(statement_, index, value));
}

void Statement::bind(int index, const std::string& value) {
    check(database_,
          sqlite3_bind_text(statement_, index, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT));
}

Transaction::Transaction(const Database& database) : database_(database) {
    database.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    if (open_) sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
    database_.execute("COMMIT");
    open_ = false;
}

}  // namespace plumb::reports::sqlite
