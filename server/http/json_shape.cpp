#include "server/http/json_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/nearest_name.hpp"
#include "core/text.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr double largest_whole = 9007199254740991.0;  // 2^53 - 1
constexpr std::size_t no_maximum = std::numeric_limits<std::size_t>::max();

const char* kindText(Shape::Kind kind) {
    switch (kind) {
        case Shape::Kind::text:
            return "a text";
        case Shape::Kind::number:
            return "a number";
        case Shape::Kind::integer:
            return "a whole number";
        case Shape::Kind::boolean:
            return "true or false";
        case Shape::Kind::list:
            return "a list";
        case Shape::Kind::object:
            return "an object";
    }
    return "";
}

std::string foundText(const json& value) {
    switch (value.type()) {
        case json::value_t::null:
            return "null";
        case json::value_t::boolean:
            return value.get<bool>() ? "true" : "false";
        case json::value_t::string:
            return "a text";
        case json::value_t::array:
            return "a list";
        case json::value_t::object:
            return "an object";
        default:
            return value.dump();
    }
}

tl::unexpected<Error> notExpected(const std::string& where, const std::string& found,
                                  const std::string& expected) {
    return fail(where, fmt::format("found {}, expected {}", found, expected));
}

std::string countText(const Shape& shape, const char* what) {
    if (shape.max_count == no_maximum) return fmt::format("at least {} {}", shape.min_count, what);
    if (shape.min_count == shape.max_count) return fmt::format("{} {}", shape.min_count, what);
    if (shape.min_count == 0) return fmt::format("at most {} {}", shape.max_count, what);
    return fmt::format("{} to {} {}", shape.min_count, shape.max_count, what);
}

std::string shortened(const std::string& text) {
    constexpr std::size_t longest = 60;
    return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

bool isControl(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte == 0x7FU || (byte < 0x20U && c != '\t' && c != '\n' && c != '\r');
}

Result<void> checkText(const Shape& shape, const std::string& text, const std::string& where) {
    if (!shape.choices.empty() &&
        std::find(shape.choices.begin(), shape.choices.end(), text) == shape.choices.end())
        return notExpected(where, "'" + shortened(text) + "'",
                           "one of " + fmt::format("{}", fmt::join(shape.choices, ", ")));
    if (std::any_of(text.begin(), text.end(), isControl))
        return notExpected(where, "a control character", "letters, tabs and line ends");
    const auto characters = static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !continuesCharacter(c); }));
    if (characters < shape.min_count || characters > shape.max_count)
        return notExpected(where, fmt::format("{} characters", characters), countText(shape, "characters"));
    return {};
}

std::string rangeText(const Shape& shape) {
    const std::string kind = kindText(shape.kind);
    if (std::isinf(shape.min) && std::isinf(shape.max)) return kind;
    if (std::isinf(shape.max)) return fmt::format("{} from {} on", kind, shape.min);
    if (std::isinf(shape.min)) return fmt::format("{} up to {}", kind, shape.max);
    return fmt::format("{} from {} to {}", kind, shape.min, shape.max);
}

Result<void> checkNumber(const Shape& shape, const json& value, const std::string& where) {
    const double number = value.get<double>();
    const bool whole = value.is_number_integer();
    if ((shape.kind == Shape::Kind::integer && !whole) || !(number >= shape.min && number <= shape.max))
        return notExpected(where, value.dump(), rangeText(shape));
    return {};
}

Result<void> checkAt(const Shape& shape, const json& value, const std::string& where);

Result<void> checkList(const Shape& shape, const json& value, const std::string& where) {
    if (value.size() < shape.min_count || value.size() > shape.max_count)
        return notExpected(where, fmt::format("{} items", value.size()), countText(shape, "items"));
    for (std::size_t i = 0; i < value.size(); ++i)
        if (auto checked = checkAt(shape.item.front(), value[i], fmt::format("{}[{}]", where, i)); !checked)
            return checked;
    return {};
}

Result<void> checkObject(const Shape& shape, const json& value, const std::string& where) {
    const std::string inside = where.empty() ? "" : where + ".";
    for (const auto& [name, part] : value.items()) {
        const auto field = std::find_if(shape.fields.begin(), shape.fields.end(),
                                        [&name = name](const ShapeField& one) { return one.name == name; });
        if (field == shape.fields.end()) {
            if (shape.open) continue;
            std::vector<std::string_view> names;
            for (const ShapeField& one : shape.fields) names.push_back(one.name);
            const std::string_view nearest = nearestName(name, names);
            return fail(inside + name, "there is no such field",
                        nearest.empty() ? "" : fmt::format("Did you mean {}?", nearest));
        }
        if (auto checked = checkAt(field->shape, part, inside + name); !checked) return checked;
    }
    for (const ShapeField& field : shape.fields)
        if (field.required && !value.contains(field.name)) return fail(inside + field.name, "is missing");
    if (!shape.exactly_one.empty()) {
        const auto given = std::count_if(shape.exactly_one.begin(), shape.exactly_one.end(),
                                         [&](const std::string& name) { return value.contains(name); });
        if (given != 1)
            return fail(inside + shape.exactly_one.front(),
                        fmt::format("found {} of {}, expected exactly one of them", given,
                                    fmt::join(shape.exactly_one, " and ")));
    }
    return {};
}

bool isOfKind(const json& value, Shape::Kind kind) {
    switch (kind) {
        case Shape::Kind::text:
            return value.is_string();
        case Shape::Kind::number:
        case Shape::Kind::integer:
            return value.is_number();
        case Shape::Kind::boolean:
            return value.is_boolean();
        case Shape::Kind::list:
            return value.is_array();
        case Shape::Kind::object:
            return value.is_object();
    }
    return false;
}

Result<void> checkAt(const Shape& shape, const json& value, const std::string& where) {
    if (value.is_null() && shape.nullable) return {};
    if (!isOfKind(value, shape.kind)) return notExpected(where, foundText(value), kindText(shape.kind));
    switch (shape.kind) {
        case Shape::Kind::text:
            return checkText(shape, value.get_ref<const std::string&>(), where);
        case Shape::Kind::number:
        case Shape::Kind::integer:
            return checkNumber(shape, value, where);
        case Shape::Kind::boolean:
            return {};
        case Shape::Kind::list:
            return checkList(shape, value, where);
        case Shape::Kind::object:
            return checkObject(shape, value, where);
    }
    return {};
}

/// Whole limits as whole numbers.
json limit(double number) {
    if (number == std::floor(number) && std::abs(number) <= largest_whole)
        return static_cast<std::int64_t>(number);
    return number;
}

void addCounts(nlohmann::ordered_json& schema, const Shape& shape, const char* min, const char* max) {
    if (shape.min_count > 0) schema[min] = shape.min_count;
    if (shape.max_count != no_maximum) schema[max] = shape.max_count;
}

void addFields(nlohmann::ordered_json& schema, const Shape& shape) {
    auto properties = nlohmann::ordered_json::object();
    auto required = nlohmann::ordered_json::array();
    for (const ShapeField& field : shape.fields) {
        properties[field.name] = schemaOf(field.shape);
        if (!field.otherwise.is_null()) properties[field.name]["default"] = field.otherwise;
        if (field.required) required.push_back(field.name);
    }
    schema["properties"] = properties;
    if (!required.empty()) schema["required"] = required;
    schema["additionalProperties"] = shape.open;
    for (const std::string& name : shape.exactly_one) {
        auto one = nlohmann::ordered_json::object();
        one["required"] = {name};
        schema["oneOf"].push_back(one);
    }
}

const char* typeName(Shape::Kind kind) {
    switch (kind) {
        case Shape::Kind::text:
            return "string";
        case Shape::Kind::number:
            return "number";
        case Shape::Kind::integer:
            return "integer";
        case Shape::Kind::boolean:
            return "boolean";
        case Shape::Kind::list:
            return "array";
        case Shape::Kind::object:
            return "object";
    }
    return "";
}

Shape ofKind(Shape::Kind kind, std::string about) {
    Shape shape;
    shape.kind = kind;
    shape.about = std::move(about);
    return shape;
}

}  // namespace

Shape textShape(std::string about, std::size_t min_characters, std::size_t max_characters) {
    Shape shape = ofKind(Shape::Kind::text, std::move(about));
    shape.min_count = min_characters;
    shape.max_count = max_characters;
    return shape;
}

Shape choiceShape(std::string about, std::vector<std::string> choices) {
    Shape shape = ofKind(Shape::Kind::text, std::move(about));
    shape.choices = std::move(choices);
    return shape;
}

Shape numberShape(std::string about, double min, double max) {
    Shape shape = ofKind(Shape::Kind::number, std::move(about));
    shape.min = min;
    shape.max = max;
    return shape;
}

Shape integerShape(std::string about, double min, double max) {
    Shape shape = numberShape(std::move(about), std::max(min, -largest_whole), std::min(max, largest_whole));
    shape.kind = Shape::Kind::integer;
    return shape;
}

Shape booleanShape(std::string about) {
    return ofKind(Shape::Kind::boolean, std::move(about));
}

Shape listShape(std::string about, Shape item, std::size_t min_items, std::size_t max_items) {
    Shape shape = ofKind(Shape::Kind::list, std::move(about));
    shape.item.push_back(std::move(item));
    shape.min_count = min_items;
    shape.max_count = max_items;
    return shape;
}

Shape objectShape(std::string about, std::vector<ShapeField> fields) {
    Shape shape = ofKind(Shape::Kind::object, std::move(about));
    shape.fields = std::move(fields);
    return shape;
}

Shape openObjectShape(std::string about, std::vector<ShapeField> fields) {
    Shape shape = objectShape(std::move(about), std::move(fields));
    shape.open = true;
    return shape;
}

ShapeField mustField(std::string name, Shape shape) {
    return {std::move(name), std::move(shape), true, {}};
}

ShapeField mayField(std::string name, Shape shape, json otherwise) {
    return {std::move(name), std::move(shape), false, std::move(otherwise)};
}

Result<void> checkShape(const Shape& shape, const json& value) {
    return checkAt(shape, value, "");
}

void fillIn(const Shape& shape, json& value) {
    if (value.is_array())
        for (json& item : value) fillIn(shape.item.front(), item);
    if (!value.is_object()) return;
    for (const ShapeField& field : shape.fields) {
        if (value.contains(field.name))
            fillIn(field.shape, value[field.name]);
        else if (!field.otherwise.is_null())
            value[field.name] = field.otherwise;
    }
}

nlohmann::ordered_json schemaOf(const Shape& shape) {
    auto schema = nlohmann::ordered_json::object();
    if (shape.nullable)
        schema["type"] = {typeName(shape.kind), "null"};
    else
        schema["type"] = typeName(shape.kind);
    if (!shape.about.empty()) schema["description"] = shape.about;
    if (!shape.choices.empty()) schema["enum"] = shape.choices;
    if (!std::isinf(shape.min)) schema["minimum"] = limit(shape.min);
    if (!std::isinf(shape.max)) schema["maximum"] = limit(shape.max);
    if (shape.kind == Shape::Kind::text) addCounts(schema, shape, "minLength", "maxLength");
    if (shape.kind == Shape::Kind::list) {
        addCounts(schema, shape, "minItems", "maxItems");
        schema["items"] = schemaOf(shape.item.front());
    }
    if (shape.kind == Shape::Kind::object) addFields(schema, shape);
    return schema;
}

}  // namespace deixis::server
