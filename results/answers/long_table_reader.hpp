// The lines of a long table, one after the other; private to its reader.
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "core/csv.hpp"
#include "long_table_cells.hpp"
#include "long_table_head.hpp"

namespace deixis::results {

/// Levels in the order in which they first stand.
class LevelsSeen {
  public:
    void add(Name level, std::vector<std::string>& levels) {
        if (level.empty() || std::find(last_.begin(), last_.end(), level) != last_.end()) return;
        last_[next_++ % last_.size()] = level;
        if (seen_.insert(level).second) levels.push_back(level);
    }

  private:
    std::unordered_set<Name> seen_{};
    std::array<Name, 8> last_{};  ///< added last: mostly there are no more
    std::size_t next_ = 0;
};

/// What is told of a participant, in the same way in all lines.
struct Person {
    std::optional<Name> excluded{};              ///< why, or "no"
    std::vector<std::optional<Name>> between{};  ///< levels
    bool counts = false;                         ///< has lines to be analysed
};

/// What a column "response" holds in one stage: right and wrong, or ratings.
struct StageResponses {
    std::vector<std::size_t> rows;  ///< of ResponseTable::rows
    bool only_truth = true;
    int missing = 0;
};

/// Reads a whole file, or a part of one which is then appended to what was read of the part before.
class LongTableReader {
  public:
    using enum LongColumn;

    /// `text` and `options` must outlive this.
    LongTableReader(const std::filesystem::path& file, std::string_view text, CsvForm form,
                    const LongTableOptions& options);
    /// Of a part of the file that follows the first one, whose columns are those of `first`; its line numbers
    /// begin anew.
    LongTableReader(const LongTableReader& first, std::string_view text);

    [[nodiscard]] Result<void> readHead();
    /// Whether the head is that of responses.csv.
    [[nodiscard]] bool isExport() const { return head_.exported.has_value(); }
    /// `lines`: how many are expected, for the memory.
    [[nodiscard]] Result<void> readRows(std::size_t lines);
    /// Takes what was read of the part that follows. Where they do not agree, an error without a line.
    [[nodiscard]] Result<void> append(LongTableReader& next);
    /// The table, whose reader is of no further use. Fails where it holds no answers.
    [[nodiscard]] Result<ResponseTable> finish();

  private:
    void setUp(const LongHead& head);

    [[nodiscard]] const std::string& cell(LongColumn column) const;
    [[nodiscard]] Name name(LongColumn column);
    [[nodiscard]] const TruthCell& truth(LongColumn column);
    [[nodiscard]] NumberCell number(LongColumn column);
    [[nodiscard]] std::string where(LongColumn column) const;
    [[nodiscard]] tl::unexpected<Error> bad(LongColumn column, const char* expected) const;
    /// What holds of a participant stands alike in all of the participant's lines.
    [[nodiscard]] Result<void> agree(std::optional<Name>& known, Name value, Name who,
                                     std::string_view column) const;

    [[nodiscard]] Result<void> readRow();
    [[nodiscard]] Result<void> readDetails(ResponseRow& row);
    [[nodiscard]] Result<void> readFactors(Person& person, ResponseRow& row);
    [[nodiscard]] Result<void> readAnswers(const ResponseRow& row);
    /// A line of an export's responses.csv in a long table's terms; false where it is no answer to be
    /// analysed.
    [[nodiscard]] bool takeExportLine();
    void countExportedCheck();
    [[nodiscard]] const std::string& cell(ExportColumnOf column) const;
    [[nodiscard]] bool declines(Name who) const;
    /// One of two systems is preferred.
    [[nodiscard]] Result<void> readPreference(const ResponseRow& row, LongColumn column);
    /// A choice that was not made.
    [[nodiscard]] Result<void> readUnanswered(const ResponseRow& row);
    [[nodiscard]] Result<void> addRow(const ResponseRow& answer, Name name, MeasureKind kind, double value);
    void countCheck(const std::string& stage_name, const std::string& kind, Attention result);
    /// Who is left out has no say in what was planned and in the scale.
    static void count(Measure& of, const ResponseRow& row);
    [[nodiscard]] Name ratingName();
    /// With the scale that the line gives: on different scales one measure is several.
    [[nodiscard]] Result<Name> nameOnScale(Name name);
    [[nodiscard]] Result<void> checkScale(Name name, double value, LongColumn column) const;

    // Made where they are new.
    Person& personOf(Name who);
    CheckCount& checksOf(const std::string& stage_name, const std::string& kind);
    Measure& measureNamed(const std::string& name, MeasureKind kind);

    [[nodiscard]] Result<void> nameResponses();
    void nameScales();
    [[nodiscard]] Result<void> finishMeasures();
    void takePeople();
    void partLeftOut();

    std::string file_;
    CsvForm form_;
    CsvReader reader_;
    CsvRecord record_;
    const LongTableOptions& options_;
    LongHead head_;
    const Name accuracy_{"accuracy"};
    const Name rating_{"rating"};
    const Name preference_{"preference"};
    const Name not_excluded_{"no"};
    // What has been read of each column.
    std::array<NameCells, long_column_count> names_;
    std::array<LastCell<TruthCell>, long_column_count> truths_;
    LastCell<std::optional<Attention>> attention_;
    LastCell<Name> excluded_, marked_;
    std::vector<LastCell<Name>> within_cells_;
    LevelsSeen systems_, layouts_, distances_;
    std::vector<LevelsSeen> between_seen_, within_seen_;
    std::unordered_map<Name, Person> people_;
    Person* person_ = nullptr;  ///< of the line before
    Name person_name_;
    ResponseTable table_;
    std::map<Name, StageResponses> responses_;
    /// A measure with its scale in its name.
    struct OnScale {
        Name measure;
        studies::Range scale;
    };
    std::map<std::string, OnScale> scaled_;  ///< by that name
    Name preference_of_;                     ///< what the preferences are called in the file
    /// Places and texts of the first numbers that are written so; empty: none is.
    std::string decimal_comma_, decimal_point_;
    std::map<Name, bool> declined_;  ///< whether consent was refused when last asked, in responses.csv
    Name exported_participant_;      ///< of the line before in responses.csv
    std::string exported_trial_;
    int balls_ = 0;
    int fewest_balls_ = std::numeric_limits<int>::max();
    int empty_ = 0;
    int unscored_checks_ = 0;
};

}  // namespace deixis::results
