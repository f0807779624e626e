#include "assets/data/unit_gestures.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "core/files.hpp"

namespace deixis::assets {

namespace {

using motion::Channel;
using motion::ChannelValues;
using motion::UnitGesture;
using motion::UnitKey;

/// Reads one gesture and notes the first problem.
class GestureReader {
  public:
    GestureReader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

    Result<UnitGesture> read() {
        UnitGesture gesture;
        gesture.id = text("id");
        id_ = gesture.id;
        rejectOthers(table_, {"id", "name", "class", "meaning", "blended", "keys"});
        gesture.name = text("name");
        gesture.meaning = text("meaning");
        const std::string class_name = text("class");
        if (const auto found = motion::gestureClassFromName(class_name))
            gesture.gesture_class = *found;
        else
            note(table_, "class",
                 fmt::format("found '{}', expected iconic, metaphoric, deictic, beat or emblem", class_name));
        if (const auto* blended = table_.get("blended")) gesture.blended = truth(*blended, "blended");
        const auto* keys = table_["keys"].as_array();
        if (keys == nullptr)
            note(table_, "keys", "expected a list of keys");
        else
            for (const auto& key : *keys) {
                if (const auto* row = key.as_table())
                    gesture.keys.push_back(readKey(*row));
                else
                    note(key, "keys", "expected {t = ..., ...}");
            }
        if (problem_) return tl::unexpected(*problem_);
        if (const auto checked = motion::checkGesture(gesture); !checked) {
            note(table_, checked.error().where, checked.error().message);
            return tl::unexpected(*problem_);
        }
        return gesture;
    }

  private:
    UnitKey readKey(const toml::table& row) {
        UnitKey key;
        rejectOthers(row, {"t", "phase", "through", "right", "left", "both", "head", "trunk", "shoulders"});
        double time_s = -1.0;
        if (const auto* node = row.get("t"); node != nullptr && node->is_number())
            time_s = node->value_or(-1.0);
        else
            note(row, "t", "expected a time in seconds");
        key.time_s = time_s;
        if (const auto* node = row.get("phase")) {
            const std::string name = node->value_or(std::string());
            if (const auto phase = motion::gesturePhaseFromName(name))
                key.phase = *phase;
            else
                note(*node, "phase",
                     fmt::format("found '{}', expected preparation, stroke, hold or retraction", name));
        }
        if (const auto* node = row.get("through")) key.through = truth(*node, "through");
        const auto into = [&](Channel channel) -> std::optional<ChannelValues>& {
            return key.channels[motion::indexOf(channel)];
        };
        if (row.contains("right")) into(Channel::right_hand) = numbers<4>(row, "right");
        if (row.contains("left")) into(Channel::left_hand) = numbers<4>(row, "left");
        if (row.contains("both")) {
            if (row.contains("right") || row.contains("left"))
                note(row, "both", "found it beside right or left, expected one or the other");
            into(Channel::right_hand) = into(Channel::left_hand) = numbers<4>(row, "both");
        }
        if (row.contains("head")) into(Channel::head) = numbers<3>(row, "head");
        if (row.contains("trunk")) into(Channel::trunk) = numbers<3>(row, "trunk");
        if (const auto* node = row.get("shoulders")) {
            auto& trunk = into(Channel::trunk);
            if (!trunk) trunk = ChannelValues{};
            if (!node->is_number()) note(*node, "shoulders", "expected degrees");
            (*trunk)[3] = node->value_or(0.0);
        }
        return key;
    }

    template <std::size_t count>
    ChannelValues numbers(const toml::table& row, std::string_view name) {
        ChannelValues values{};
        const auto* list = row.get(name)->as_array();
        if (list == nullptr || list->size() != count) {
            note(*row.get(name), name, fmt::format("expected a list of {} numbers", count));
            return values;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const auto* node = list->get(i);
            if (!node->is_number()) note(*node, name, "expected numbers");
            values[i] = node->value_or(0.0);
        }
        return values;
    }

    bool truth(const toml::node& node, std::string_view name) {
        if (!node.is_boolean()) note(node, name, "expected true or false");
        return node.value_or(false);
    }

    std::string text(std::string_view name) {
        const auto value = table_[name].value<std::string>();
        if (!value || value->empty() || value->find('\n') != std::string::npos)
            note(table_, name, "expected one line of text");
        return value.value_or(std::string());
    }

    void rejectOthers(const toml::table& table, std::initializer_list<std::string_view> known) {
        for (const auto& [key, node] : table)
            if (std::find(known.begin(), known.end(), key.str()) == known.end())
                note(node, key.str(), fmt::format("unknown key; known here: {}", fmt::join(known, ", ")));
    }

    void note(const toml::node& at, std::string_view name, const std::string& message) {
        if (problem_) return;
        std::string where = fmt::format("{}:{}", file_, at.source().begin.line);
        if (!id_.empty()) where += ": " + id_;
        if (!name.empty()) where += fmt::format(": {}", name);
        problem_ = Error{std::move(where), message, {}};
    }

    const toml::table& table_;
    std::string file_;
    std::string id_;
    std::optional<Error> problem_;
};

}  // namespace

Result<motion::GestureLibrary> parseUnitGestures(std::string_view text, const std::string& name) {
    toml::table file;
    try {
        file = toml::parse(text, name);
    } catch (const toml::parse_error& error) {
        return fail(fmt::format("{}:{}", name, error.source().begin.line),
                    fmt::format("this is not valid TOML: {}", error.description()));
    }
    for (const auto& [key, node] : file)
        if (key.str() != "gesture")
            return fail(fmt::format("{}:{}: {}", name, key.source().begin.line, key.str()),
                        "unknown key; known here: gesture");
    const auto* rows = file["gesture"].as_array();
    if (rows == nullptr || rows->empty()) return fail(name, "found no [[gesture]], expected at least one");
    motion::GestureLibrary library;
    for (const auto& row : *rows) {
        const auto* table = row.as_table();
        if (table == nullptr) return fail(name, "found no table of a gesture, expected [[gesture]]");
        auto gesture = GestureReader(*table, name).read();
        if (!gesture) return tl::unexpected(gesture.error());
        if (motion::findGesture(library, gesture->id) != nullptr)
            return fail(fmt::format("{}:{}: {}", name, table->source().begin.line, gesture->id),
                        "found this id twice, expected ids of their own");
        library.push_back(std::move(*gesture));
    }
    return library;
}

Result<motion::GestureLibrary> loadUnitGestures(const std::filesystem::path& path) {
    const auto text = readFile(path);
    if (!text) return tl::unexpected(text.error());
    return parseUnitGestures(*text, path.string());
}

}  // namespace deixis::assets
