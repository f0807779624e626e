#include "gltf_json.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/json_size.hpp"

namespace deixis::assets::gltf {

namespace {

constexpr int deepest = 64;
constexpr std::size_t max_values = 3'000'000;

/// Refuses text whose tree would be too deep or too large.
void checkSize(std::string_view text, const std::string& file) {
    const JsonSize size = jsonSize(text);
    if (size.values > max_values)
        reject(file, fmt::format("has more than {} values, more than any clip or figure needs", max_values),
               "Export the armature with its animation or its meshes alone");
    if (size.depth > deepest)
        reject(file, fmt::format("nests deeper than {} levels, expected a glTF file", deepest));
}

}  // namespace

nlohmann::json parseJson(std::string_view text, const std::string& file) {
    checkSize(text, file);
    try {
        nlohmann::json json = nlohmann::json::parse(text.begin(), text.end());
        if (!json.is_object()) reject(file, "its JSON is not an object, expected a glTF file");
        return json;
    } catch (const nlohmann::json::exception& problem) {
        reject(file, fmt::format("no readable JSON, expected a glTF file ({})", problem.what()));
    }
}

bool Cursor::has(const char* key) const {
    if (!value_->is_object()) expected("an object");
    return value_->contains(key);
}

Cursor Cursor::at(const char* key) const {
    if (!has(key)) reject(fmt::format("has no \"{}\", which is required", key));
    return {(*value_)[key], *file_, path_ + "/" + key};
}

Cursor Cursor::at(std::size_t element) const {
    if (element >= size()) reject(fmt::format("has {} elements, expected more", size()));
    return {(*value_)[element], *file_, fmt::format("{}/{}", path_, element)};
}

std::size_t Cursor::size() const {
    if (!value_->is_array()) expected("an array");
    return value_->size();
}

std::vector<Cursor> Cursor::elements(const char* key) const {
    std::vector<Cursor> elements;
    for (std::size_t i = 0; i < count(key); ++i) elements.push_back(at(key).at(i));
    return elements;
}

std::size_t Cursor::count(const char* key) const {
    return has(key) ? at(key).size() : 0;
}

std::vector<std::string> Cursor::keys() const {
    if (!value_->is_object()) expected("an object");
    std::vector<std::string> keys;
    for (const auto& [key, value] : value_->items()) keys.push_back(key);
    return keys;
}

std::size_t Cursor::whole() const {
    constexpr double max = 9007199254740992.0;
    const double found = value_->is_number() ? value_->get<double>() : -1.0;
    if (!(found >= 0.0 && found <= max && found == std::floor(found))) expected("a whole number, 0 or more");
    return static_cast<std::size_t>(found);
}

int Cursor::index(std::size_t count, const char* what) const {
    const std::size_t found = whole();
    if (found >= count)
        reject(fmt::format("{} {} does not exist; the file has {} (counted from 0)", what, found, count));
    return static_cast<int>(found);
}

double Cursor::number() const {
    if (!value_->is_number()) expected("a number");
    const auto found = value_->get<double>();
    if (!std::isfinite(found)) expected("a finite number");
    return found;
}

bool Cursor::flag() const {
    if (!value_->is_boolean()) expected("true or false");
    return value_->get<bool>();
}

const std::string& Cursor::text() const {
    if (!value_->is_string()) expected("a string");
    return value_->get_ref<const std::string&>();
}

std::size_t Cursor::whole(const char* key, std::size_t otherwise) const {
    return has(key) ? at(key).whole() : otherwise;
}

int Cursor::index(const char* key, std::size_t count, const char* what) const {
    return has(key) ? at(key).index(count, what) : -1;
}

std::string Cursor::text(const char* key, const std::string& otherwise) const {
    return has(key) ? at(key).text() : otherwise;
}

void Cursor::reject(std::string message) const {
    gltf::reject(*file_ + ": " + (path_.empty() ? "/" : path_), std::move(message));
}

void Cursor::expected(const char* what) const {
    std::string found(value_->type_name());
    if (value_->is_number()) found = value_->dump();
    reject(fmt::format("found {}, expected {}", found, what));
}

}  // namespace deixis::assets::gltf
