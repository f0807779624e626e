// A value copied from one database to another, which may be changed on the way.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <string>
#include <utility>

namespace deixis::results {

struct CopiedValue {
    enum class Kind : unsigned char { nothing, whole, number, text, bytes } kind = Kind::nothing;
    std::int64_t whole = 0;
    double number = 0.0;
    std::string text{};

    explicit CopiedValue(const SQLite::Column& column) {
        if (column.isInteger()) {
            kind = Kind::whole;
            whole = column.getInt64();
        } else if (column.isFloat()) {
            kind = Kind::number;
            number = column.getDouble();
        } else if (!column.isNull()) {
            kind = column.isBlob() ? Kind::bytes : Kind::text;
            text = column.getString();
        }
    }
    CopiedValue() = default;
    explicit CopiedValue(std::int64_t value) : kind(Kind::whole), whole(value) {}
    explicit CopiedValue(double value) : kind(Kind::number), number(value) {}
    explicit CopiedValue(std::string value) : kind(Kind::text), text(std::move(value)) {}

    [[nodiscard]] bool isNull() const { return kind == Kind::nothing; }
    void bind(SQLite::Statement& to, int place) const {
        switch (kind) {
            case Kind::nothing:
                return to.bind(place);
            case Kind::whole:
                return to.bind(place, whole);
            case Kind::number:
                return to.bind(place, number);
            case Kind::text:
                return to.bind(place, text);
            case Kind::bytes:
                return to.bind(place, text.data(), static_cast<int>(text.size()));
        }
    }
};

}  // namespace deixis::results
