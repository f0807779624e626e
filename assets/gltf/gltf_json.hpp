// The JSON of a glTF file, read with every type checked; each error names the file and the place in it.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "assets/gltf/gltf_rejection.hpp"

namespace deixis::assets::gltf {

/// Parses JSON. Text that nests deeper than 64 levels or holds more than three million values is rejected
/// before anything is built from it.
[[nodiscard]] nlohmann::json parseJson(std::string_view text, const std::string& file);

/// A JSON value and the path to it, such as "/nodes/3/children/0". The file's name and the value must outlive
/// it.
class Cursor {
  public:
    Cursor(const nlohmann::json& value, const std::string& file, std::string path = {})
        : value_(&value), file_(&file), path_(std::move(path)) {}

    [[nodiscard]] bool has(const char* key) const;  ///< rejects what is no object
    [[nodiscard]] Cursor at(const char* key) const;
    [[nodiscard]] Cursor at(std::size_t element) const;
    [[nodiscard]] std::size_t size() const;  ///< elements of an array; rejects what is none
    [[nodiscard]] std::vector<Cursor> elements(const char* key) const;  ///< none where the key is absent
    [[nodiscard]] std::size_t count(const char* key) const;             ///< of such elements; 0 where absent
    [[nodiscard]] std::vector<std::string> keys() const;  ///< of an object; rejects what is none
    [[nodiscard]] const nlohmann::json& json() const { return *value_; }

    [[nodiscard]] std::size_t whole() const;  ///< a whole number from 0 to 2^53
    /// An index below `count`; `what` names the things that it counts, such as "node".
    [[nodiscard]] int index(std::size_t count, const char* what) const;
    [[nodiscard]] double number() const;
    [[nodiscard]] bool flag() const;
    [[nodiscard]] const std::string& text() const;

    [[nodiscard]] std::size_t whole(const char* key, std::size_t otherwise) const;
    [[nodiscard]] int index(const char* key, std::size_t count, const char* what) const;  ///< -1 where absent
    [[nodiscard]] std::string text(const char* key, const std::string& otherwise) const;

    [[nodiscard]] const std::string& path() const { return path_; }
    [[noreturn]] void reject(std::string message) const;
    [[noreturn]] void expected(const char* what) const;

  private:
    const nlohmann::json* value_;
    const std::string* file_;
    std::string path_;
};

}  // namespace deixis::assets::gltf
