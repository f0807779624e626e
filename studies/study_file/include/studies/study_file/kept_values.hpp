// Values that only one kind of trial has: named values of a planned trial, and of a response, beside its
// typed answers. A kind declares them (stage_kind.hpp); the store, copies and views know none in
// particular.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace deixis::studies {

enum class KeptType : unsigned char {
    whole,
    truth,  ///< 0 or 1
    number,
    text  ///< never what a participant or experimenter typed: anonymous copies keep it
};

struct KeptField {
    std::string_view name;
    KeptType type = KeptType::number;
    std::string_view about;      ///< for codebooks
    std::string_view unit = {};  ///< likewise: "m", "degrees"; empty: none
};

/// The fields, and the view of the database in which they stand as columns; no name: none are kept.
struct KeptFields {
    std::string_view view{};
    std::span<const KeptField> fields{};
};

/// Exactly one of `value` and `text`; a truth is 0 or 1.
struct KeptValue {
    std::string name;
    std::optional<double> value{};
    std::string text{};
};

/// The number of that name; none if it is not kept.
[[nodiscard]] std::optional<double> keptNumber(const std::vector<KeptValue>& values, std::string_view name);
/// A place, counted from 0; -1 where none is kept.
[[nodiscard]] int keptPlace(const std::vector<KeptValue>& values, std::string_view name);

}  // namespace deixis::studies
