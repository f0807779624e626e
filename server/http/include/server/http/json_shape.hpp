// What a JSON value must be, declared once: requests are checked by it, and the OpenAPI document shows it.
#pragma once

#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace deixis::server {

struct ShapeField;

/// Made by the functions below.
struct Shape {
    enum class Kind { text, number, integer, boolean, list, object };

    Kind kind = Kind::object;
    std::string about{};
    /// Of a text: characters; of a list: items.
    std::size_t min_count = 0;
    std::size_t max_count = std::numeric_limits<std::size_t>::max();
    std::vector<std::string> choices{};  ///< of a text; empty: any
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    std::vector<Shape> item;         ///< of a list: the one shape of all its items
    std::vector<ShapeField> fields;  ///< of an object: no others may stand in it
    std::vector<std::string>
        exactly_one{};  ///< of an object: one of these fields must stand in it, and only one
    bool open = false;  ///< an object in which any other fields may stand, too
    bool nullable = false;
};

struct ShapeField {
    std::string name;
    Shape shape;
    bool required = true;
    nlohmann::json otherwise{};  ///< what counts where it is left out; null: nothing
};

/// A text of UTF-8 without control characters but tab and line ends.
[[nodiscard]] Shape textShape(std::string about, std::size_t min_characters = 0,
                              std::size_t max_characters = std::numeric_limits<std::size_t>::max());
[[nodiscard]] Shape choiceShape(std::string about, std::vector<std::string> choices);
/// Both ends are allowed.
[[nodiscard]] Shape numberShape(std::string about, double min = -std::numeric_limits<double>::infinity(),
                                double max = std::numeric_limits<double>::infinity());
/// Whole numbers, less than 2^53 from 0 so that JavaScript can hold them.
[[nodiscard]] Shape integerShape(std::string about, double min, double max);
[[nodiscard]] Shape booleanShape(std::string about);
[[nodiscard]] Shape listShape(std::string about, Shape item, std::size_t min_items = 0,
                              std::size_t max_items = std::numeric_limits<std::size_t>::max());
[[nodiscard]] Shape objectShape(std::string about, std::vector<ShapeField> fields);
/// With any others beside these.
[[nodiscard]] Shape openObjectShape(std::string about, std::vector<ShapeField> fields);

[[nodiscard]] ShapeField mustField(std::string name, Shape shape);
[[nodiscard]] ShapeField mayField(std::string name, Shape shape, nlohmann::json otherwise = {});

/// Fails at the first thing that is wrong; the error's `where` is the field, such as "controls[2].time_s",
/// and empty for the value as a whole.
[[nodiscard]] Result<void> checkShape(const Shape& shape, const nlohmann::json& value);

/// Puts in what counts for fields that are left out; of a value that was checked.
void fillIn(const Shape& shape, nlohmann::json& value);

/// As JSON Schema (draft 2020-12), the dialect of OpenAPI 3.1.
[[nodiscard]] nlohmann::ordered_json schemaOf(const Shape& shape);

}  // namespace deixis::server
