// One model of a table: its columns are declared once, with how they are read from a result, and rendered
// as CSV, JSON and LaTeX here, and as HTML by the pages.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "results/tables/table_unit.hpp"

namespace deixis::results {

using Json = nlohmann::ordered_json;

/// Two ends, none if they are not known, and what they may be the interval of.
struct Interval {
    std::optional<double> lower{};
    std::optional<double> upper{};
    bool lower_included = true;
    bool upper_included = true;
    std::optional<double> estimate{};
    std::optional<double> level{};
    const char* mark = "";  ///< behind it, on a page

    [[nodiscard]] bool operator==(const Interval&) const = default;
};

/// Of JSON alone; behind a pointer, as GCC 12 warns falsely where a variant has it.
using JsonValue = std::shared_ptr<const Json>;

/// A value of a table, made of what a result has; monostate: nothing is known.
class Cell {
  public:
    using Value = std::variant<std::monostate, std::string, double, long long, bool, Interval, JsonValue>;

    Cell() = default;
    template <typename T>
    requires(!std::same_as<std::remove_cvref_t<T>, Cell>)
        // NOLINTNEXTLINE(google-explicit-constructor)
        Cell(const T& value)
        : value_(valueOf(value)) {}

    [[nodiscard]] const Value& value() const { return value_; }
    [[nodiscard]] bool empty() const { return std::holds_alternative<std::monostate>(value_); }
    template <typename T>
    [[nodiscard]] const T* as() const {
        return std::get_if<T>(&value_);
    }
    /// Empty if it is not text.
    [[nodiscard]] std::string text() const {
        return as<std::string>() != nullptr ? *as<std::string>() : std::string();
    }

  private:
    template <typename T>
    static Value valueOf(const T& value) {
        if constexpr (requires { value.has_value(); })
            return value ? valueOf(*value) : Value();
        else if constexpr (std::same_as<T, bool> || std::same_as<T, Interval>)
            return value;
        else if constexpr (std::same_as<T, Json>)
            return std::make_shared<const Json>(value);
        else if constexpr (std::integral<T>)
            return static_cast<long long>(value);
        else if constexpr (std::floating_point<T>)
            return static_cast<double>(value);
        else
            return std::string(std::string_view(value));
    }

    Value value_{};
};

/// Nothing if it is not `known`.
template <typename T>
[[nodiscard]] Cell known(bool known, const T& value) {
    return known ? Cell(value) : Cell();
}

/// How values look to people. In LaTeX numbers with decimals have three of them where nothing else is said.
enum class Format : unsigned char {
    plain,      ///< whole numbers and texts as they are, others with two decimals
    title,      ///< a text that begins with a capital letter on a page
    score,      ///< percent where the row is of an accuracy (Table::Row::percent), else two decimals
    percent,    ///< of a share
    p_value,    ///< "<0.001" or three decimals
    rank,       ///< sums of ranks: as few digits as there are
    magnitude,  ///< without its sign
    key,        ///< a text whose underscores stand for spaces
    one_decimal,
    three_decimals
};

enum In : unsigned char { in_csv = 1, in_json = 2, in_print = 4, in_data = 3, everywhere = 7, page_only = 0 };

/// What a column says of itself where its name alone does not (columnWords()).
struct Show {
    const char* label = nullptr;  ///< on a page; else as the name is known
    const char* latex = nullptr;  ///< in print, LaTeX; likewise
    std::optional<Format> format{};
    unsigned in = everywhere;    ///< a page shows what it asks for
    const char* json = nullptr;  ///< its key where it is not the name; "a/b": b of the object a
    int place = 0;               ///< in JSON columns stand by their place, then as they are declared
    bool sparse = false;         ///< left out of JSON where it is empty
    bool heading = false;        ///< in print a line above the rows that have it in common
    bool marked = false;         ///< on a page set off where the row is significant
    bool right = false;          ///< a text that stands as numbers do
    bool estimate = false;       ///< an Interval's all, not its ends alone
};

enum class ColumnKind : unsigned char {
    text,
    number,
    range,    ///< of an Interval its ends: two columns in CSV, an object or null in JSON
    estimate  ///< of an Interval all: six columns in CSV, an object in JSON, two columns in print
};

struct Column {
    std::string name;  ///< in CSV and JSON
    ColumnKind kind = ColumnKind::number;
    std::string label{};
    std::string latex{};  ///< LaTeX
    Format format = Format::plain;
    unsigned in = everywhere;
    std::string json{};
    int place = 0;
    bool sparse = false;
    bool heading = false;
    bool marked = false;
    bool right = false;
    bool ends_in_print = true;  ///< of an estimate

    Column(std::string name, ColumnKind kind, const Show& show = {});
};

struct Table {
    struct Row {
        std::vector<Cell> cells;
        bool percent = false;                                      ///< its scores are shares
        bool significant = false;                                  ///< sets off what is marked
        bool all = false;                                          ///< stands for several of the others
        std::vector<std::pair<std::size_t, const char*>> marks{};  ///< on a page: columns that stand out, how
    };
    std::string name;  ///< of the file, without its ending
    TableUnit unit;    ///< in CSV a column behind the others, in LaTeX the caption's end
    std::string caption{};
    std::vector<Column> columns{};
    std::vector<Row> rows{};

    /// The place of a column, which there must be.
    [[nodiscard]] std::size_t at(std::string_view column) const;
    /// The first row's.
    [[nodiscard]] Column& column(std::string_view called) { return columns[at(called)]; }
    /// With the rows that have `value` there.
    [[nodiscard]] Table where(std::string_view column, const std::string& value) const;
};

/// A column, and how it is read from a result.
template <typename Row>
struct Field {
    Column column;
    std::function<Cell(const Row&)> read;

    template <typename Read>
    Field(const char* name, Read how, const Show& show = {})
        : column(name, kindOf<std::remove_cvref_t<std::invoke_result_t<Read, const Row&>>>(), show),
          read([how](const Row& row) { return Cell(std::invoke(how, row)); }) {}
    /// Of what a result is derived from.
    template <typename Base>
    requires std::derived_from<Row, Base> Field(
        const Field<Base>& other)  // NOLINT(google-explicit-constructor)
        : column(other.column), read(other.read) {}

  private:
    template <typename T>
    static constexpr ColumnKind kindOf() {
        if constexpr (std::same_as<T, Interval>)
            return ColumnKind::range;
        else
            return std::convertible_to<T, std::string_view> ? ColumnKind::text : ColumnKind::number;
    }
};

template <typename Row>
using Fields = std::vector<Field<Row>>;

/// Behind each other.
template <typename Row, typename Base>
[[nodiscard]] Fields<Row> joined(Fields<Row> first, const Fields<Base>& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

template <typename Row>
[[nodiscard]] std::vector<Column> columnsOf(const Fields<Row>& fields) {
    std::vector<Column> out;
    for (const Field<Row>& field : fields) out.push_back(field.column);
    return out;
}

template <typename Row>
[[nodiscard]] std::vector<Cell> cellsOf(const Fields<Row>& fields, const Row& one) {
    std::vector<Cell> out;
    for (const Field<Row>& field : fields) out.push_back(field.read(one));
    return out;
}

/// Adds a row for each of the results.
template <typename Row, typename Results>
void addRows(Table& table, const Fields<Row>& fields, const Results& results) {
    for (const Row& one : results) {
        Table::Row& row = table.rows.emplace_back(Table::Row{cellsOf(fields, one)});
        if constexpr (requires { one.significant; }) row.significant = one.significant;
    }
}

template <typename Row, typename Results = std::vector<Row>>
[[nodiscard]] Table tableOf(const char* name, TableUnit unit, std::string caption, const Fields<Row>& fields,
                            const Results& results) {
    Table out{name, unit, std::move(caption), columnsOf(fields)};
    addRows(out, fields, results);
    return out;
}

/// With the unit's column, whose numbers have as few digits as bring them back.
[[nodiscard]] std::string csvText(const Table& table);

/// None as null.
[[nodiscard]] inline Json jsonOf(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}
/// An object for each row.
[[nodiscard]] Json tableJson(const Table& table);
[[nodiscard]] Json rowJson(const std::vector<Column>& columns, const std::vector<Cell>& cells);

/// A table environment with \toprule, \midrule and \bottomrule, or a longtable where a page cannot hold it;
/// texts are escaped. Smaller, and scaled where it must be, to fit a page of 345 pt (article on A4 or
/// letter).
[[nodiscard]] std::string latexText(const Table& table);

/// "not_said" -> "not said".
[[nodiscard]] std::string inWords(std::string key);

}  // namespace deixis::results
