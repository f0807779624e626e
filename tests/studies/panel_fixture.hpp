// What the tests of boards share: words in four languages, random texts of them, and what a tidy board is.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/random.hpp"
#include "paths.hpp"
#include "studies/boards/panel_layout.hpp"
#include "studies/texts/text_layout.hpp"

namespace deixis::tests {

using namespace deixis::studies;

inline LanguageTable languageTable(const std::string& code) {
    auto table =
        LanguageTable::load(deixis::tests::sourceDir() / ("assets/data/languages/" + code + ".toml"));
    REQUIRE_MESSAGE(table.has_value(), (table ? std::string() : table.error().text()));
    return *std::move(table);
}

inline const std::vector<std::string>& languageCodes() {
    static const std::vector<std::string> codes{"en", "de", "sv", "ko"};
    return codes;
}

/// Texts of a language, made of the words of its table.
class RandomTexts {
  public:
    RandomTexts(const LanguageTable& table, std::uint64_t seed) : random_(seed) {
        for (const auto& [key, english] : languageKeys()) {
            const std::string& text = table(key);
            for (std::size_t from = 0; from < text.size();) {
                const std::size_t to = std::min(text.find(' ', from), text.size());
                if (to > from) words_.push_back(text.substr(from, to - from));
                from = to + 1;
            }
        }
    }

    std::string operator()(int min_words, int max_words) {
        std::string text;
        const int count = between(min_words, max_words);
        for (int i = 0; i < count; ++i) {
            if (i > 0) text += random_.below(20) == 0 ? "\n\n" : " ";
            text += words_[random_.below(words_.size())];
        }
        return text;
    }
    int between(int min, int max) {
        return min + static_cast<int>(random_.below(static_cast<std::uint64_t>(max - min + 1)));
    }
    bool flip() { return random_.below(2) == 0; }

  private:
    Random random_;
    std::vector<std::string> words_;
};

inline bool overlap(const PanelRect& a, const PanelRect& b) {
    constexpr double touch_m = 1e-9;
    return a.x + touch_m < b.x + b.width && b.x + touch_m < a.x + a.width && a.y + touch_m < b.y + b.height &&
           b.y + touch_m < a.y + a.height;
}

/// Whether the laid-out lines of a text fit its box: words stay whole unless they are very long.
inline void checkLines(const std::string& text, double size_m, bool bold, const PanelRect& box) {
    int lines = 0;
    int too_wide = 0;
    for (std::size_t from = 0; from <= text.size(); ++lines) {
        const std::size_t to = std::min(text.find('\n', from), text.size());
        if (textWidth(std::string_view(text).substr(from, to - from), size_m, bold) > box.width + 1e-6)
            ++too_wide;
        from = to + 1;
    }
    CHECK_MESSAGE(too_wide == 0, text);
    CHECK_MESSAGE(lines * size_m <= box.height + 1e-9, text);
}

/// Everything inside the panel and its margin, nothing on top of anything else, nothing too small to be read
/// or hit, and room for every text.
inline void checkTidy(const Panel& panel, double min_button_m) {
    std::vector<PanelRect> boxes;
    for (const PanelText& text : panel.texts) {
        boxes.push_back(text.box);
        CHECK(text.size_m >= 0.75 * 0.036 - 1e-9);
        checkLines(text.text, text.size_m, text.bold, text.box);
    }
    for (const PanelButton& button : panel.buttons) {
        boxes.push_back(button.box);
        CHECK(button.box.width >= min_button_m - 1e-9);
        CHECK(button.box.height >= min_button_m - 1e-9);
        // The label on one line, at no less than 0.7 of its size.
        CHECK(textWidth(button.label, 0.7 * 0.05, true) <= button.box.width - 0.02);
    }
    for (const PanelSlider& slider : panel.sliders) {
        boxes.push_back(slider.box);
        CHECK(slider.box.height >= 0.11 - 1e-9);
        const PanelRect track = slider.track();
        CHECK(track.width >= 0.35);
        CHECK(track.x >= slider.box.x);
        CHECK(track.x + track.width <= slider.box.x + slider.box.width);
        CHECK(track.y > slider.box.y);
        const double pitch_m = track.width / std::max(1.0, static_cast<double>(slider.labels.size()) - 1.0);
        for (std::size_t i = 0; i < slider.labels.size(); ++i) {
            const double tick = track.x + static_cast<double>(i) * pitch_m;
            const double left = std::max(slider.box.x, tick - 0.49 * pitch_m);
            const double right = std::min(slider.box.x + slider.box.width, tick + 0.49 * pitch_m);
            checkLines(slider.labels[i], slider.label_size_m, false,
                       {left, slider.box.y, right - left, track.y - slider.box.y - 0.028});
        }
        CHECK(track.y + track.height < slider.box.y + slider.box.height);
    }
    for (const PanelField& field : panel.fields) {
        boxes.push_back(field.box);
        CHECK(field.box.width >= 0.3);
        CHECK(field.box.height >= 0.1);
    }
    CHECK(panel.width_m <= 1.6 + 1e-9);
    constexpr double margin_m = 0.05;
    int outside = 0;
    int overlaps = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const PanelRect& box = boxes[i];
        if (box.x < margin_m || box.y < margin_m || box.x + box.width > panel.width_m - margin_m ||
            box.y + box.height > panel.height_m - margin_m)
            ++outside;
        for (std::size_t j = 0; j < i; ++j)
            if (overlap(box, boxes[j])) ++overlaps;
    }
    CHECK(outside == 0);
    CHECK(overlaps == 0);
}

inline const PanelButton* findButton(const Panel& panel, int id) {
    for (const PanelButton& button : panel.buttons)
        if (button.id == id) return &button;
    return nullptr;
}

inline std::vector<int> idsOf(const Panel& panel, ButtonRole role) {
    std::vector<int> ids;
    for (const PanelButton& button : panel.buttons)
        if (button.role == role) ids.push_back(button.id);
    return ids;
}

}  // namespace deixis::tests
