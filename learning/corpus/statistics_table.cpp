#include <fmt/format.h>

#include <algorithm>

#include "core/csv.hpp"
#include "learning/corpus/corpus_statistics.hpp"

namespace deixis::learning {

namespace {

std::string percent(double share) {
    return fmt::format("{:.1f} %", 100.0 * share);
}
std::string meanSd(const MeanAndSd& values, int digits) {
    if (values.count == 0) return "-";
    return fmt::format("{:.{}f} (SD {:.{}f})", values.mean, digits, values.sd, digits);
}

}  // namespace

std::vector<StatisticsRow> statisticsTable(std::span<const StatisticsColumn> columns) {
    std::vector<StatisticsRow> rows;
    const auto add = [&](std::string what, std::string published, std::string source, const auto& text,
                         bool of_strokes = true) {
        StatisticsRow row{std::move(what), std::move(published), std::move(source), {}};
        for (const StatisticsColumn& column : columns) {
            const CorpusStatistics& s = column.statistics;
            row.found.push_back(of_strokes && s.strokes.strokes == 0 ? "-" : text(s));
        }
        rows.push_back(std::move(row));
    };
    using S = CorpusStatistics;
    const motion::PublishedGestures published;
    add(
        "takes", "-", "", [](const S& s) { return fmt::format("{}", s.takes); }, false);
    add(
        "minutes", "-", "", [](const S& s) { return fmt::format("{:.1f}", s.minutes); }, false);
    add(
        "words", "-", "", [](const S& s) { return fmt::format("{}", s.words); }, false);
    add(
        "word forms", "-", "", [](const S& s) { return fmt::format("{}", s.word_forms); }, false);
    add(
        "accents a minute", "-", "", [](const S& s) { return fmt::format("{:.1f}", s.accents_per_minute); },
        false);
    add("strokes a minute", fmt::format("{:.0f}", published.strokes_per_minute),
        "Shattuck-Hufnagel & Ren 2018, lectures",
        [](const S& s) { return fmt::format("{:.1f}", s.strokes.strokes_per_minute); });
    add("strokes with an accent", percent(published.with_accent), "JASA 2004, one speaker",
        [](const S& s) { return percent(s.strokes.with_accent); });
    add("apices of beats on the accented syllable", percent(published.beats_on_syllable),
        "Interspeech 2023, 107-111", [](const S& s) { return percent(s.strokes.beats_on_syllable); });
    add("apex after the accent's middle, s",
        fmt::format("{:.3f} (SD {:.3f})", published.apex_mean_s, published.apex_sd_s),
        "Loehr 2004, 2012 (from memory)", [](const S& s) {
            return fmt::format("{:.3f} (SD {:.3f})", s.strokes.apex_mean_s, s.strokes.apex_sd_s);
        });
    add("stroke begins before the accent, s", "0.36", "Ebert 2011, sentence accents",
        [](const S& s) { return meanSd(s.before_accent_s, 2); });
    add("stroke's duration, s", "-", "", [](const S& s) { return meanSd(s.stroke_s, 2); });
    add("hold's duration, s", "-", "no figure was found", [](const S& s) { return meanSd(s.hold_s, 2); });
    add("right hand, of strokes by one", percent(published.right_hand), "Nicoladis & Shirazi 2021",
        [](const S& s) { return percent(s.strokes.right_hand); });
    add("both hands", "-", "", [](const S& s) { return percent(s.both_hands); });
    for (std::size_t c = 0; c < motion::gesture_class_count; ++c) {
        const std::string name(motion::gestureClassName(static_cast<motion::GestureClass>(c)));
        add(name + " strokes", published.classes[c] > 0.0 ? percent(published.classes[c]) : "-",
            published.classes[c] > 0.0 ? "McNeill 1992, narratives (from memory)" : "",
            [c](const S& s) { return percent(s.strokes.classes[c]); });
    }
    for (std::size_t c = 0; c < motion::gesture_class_count; ++c) {
        const std::string name(motion::gestureClassName(static_cast<motion::GestureClass>(c)));
        const std::string told = c == 0 ? "centre" : c == 1 ? "lower" : c == 2 ? "periphery" : "-";
        add(name + ": hands above shoulders, m", told, c < 3 ? "McNeill 1992 (from memory)" : "",
            [c](const S& s) { return meanSd(s.places[c].height_m, 2); });
        add(name + ": hand outwards from the middle, m", told, c < 3 ? "McNeill 1992 (from memory)" : "",
            [c](const S& s) { return meanSd(s.places[c].outward_m, 2); });
    }
    add(
        "frames in which both hands are still", "-", "", [](const S& s) { return percent(s.still); }, false);
    add(
        "wrist's speed, 99th percentile, m/s", "-", "",
        [](const S& s) { return fmt::format("{:.2f}", s.wrist_p99_m_s); }, false);
    add(
        "wrist's speed, highest, m/s", "-", "",
        [](const S& s) { return fmt::format("{:.2f}", s.wrist_most_m_s); }, false);
    return rows;
}

std::string statisticsText(std::span<const StatisticsColumn> columns) {
    std::vector<std::vector<std::string>> lines{{"", "published", "source"}};
    for (const StatisticsColumn& column : columns) lines.front().insert(lines.front().end() - 2, column.name);
    for (const StatisticsRow& row : statisticsTable(columns)) {
        lines.push_back({row.what});
        lines.back().insert(lines.back().end(), row.found.begin(), row.found.end());
        lines.back().push_back(row.published);
        lines.back().push_back(row.source);
    }
    std::string out;
    for (const auto& line : lines) {
        std::string text;
        for (std::size_t c = 0; c < line.size(); ++c) {
            std::size_t width = 0;
            for (const auto& other : lines) width = std::max(width, other[c].size());
            text += fmt::format("{:<{}}  ", line[c], width);
        }
        text.resize(text.find_last_not_of(' ') + 1);
        out += text + '\n';
    }
    return out;
}

std::string statisticsCsv(std::span<const StatisticsColumn> columns) {
    std::string out = "what";
    for (const StatisticsColumn& column : columns) out += "," + csvField(column.name);
    out += ",published,source\n";
    for (const StatisticsRow& row : statisticsTable(columns)) {
        out += csvField(row.what);
        for (const std::string& found : row.found) out += "," + csvField(found);
        out += "," + csvField(row.published) + "," + csvField(row.source) + "\n";
    }
    return out;
}

}  // namespace deixis::learning
