// The lines of a long table, one after the other; private to its reader.
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/csv.hpp"
#include "long_table_cells.hpp"
#include "long_table_head.hpp"

namespace deixis::results {

/// What is told of a participant, in the same way in all lines.
struct Person {
    std::optional<std::string> excluded{};              ///< why, or "no"
    std::vector<std::optional<std::string>> between{};  ///< levels
    bool counts = false;                                ///< has lines to be analysed
};

/// What a column "response" holds in one stage: right and wrong, or ratings.
struct StageResponses {
    std::vector<std::size_t> rows;  ///< of ResponseTable::rows
    bool only_truth = true;
    int missing = 0;
};

/// Reads a whole file.
class LongTableReader {
  public:
    using enum LongColumn;

    /// `text` and `options` must outlive this.
    LongTableReader(const std::filesystem::path& file, std::string_view text, CsvForm form,
                    const LongTableOptions& options);

    [[nodiscard]] Result<void> readHead();
    [[nodiscard]] Result<void> readRows();
    /// The table, whose reader is of no further use. Fails where it holds no answers.
    [[nodiscard]] Result<ResponseTable> finish();

  private:
    [[nodiscard]] const std::string& cell(LongColumn column) const;
    [[nodiscard]] std::string name(LongColumn column) const;
    [[nodiscard]] TruthCell truth(LongColumn column) const;
    [[nodiscard]] NumberCell number(LongColumn column);
    [[nodiscard]] std::string where(LongColumn column) const;
    [[nodiscard]] tl::unexpected<Error> bad(LongColumn column, const char* expected) const;
    /// What holds of a participant stands alike in all of the participant's lines.
    [[nodiscard]] Result<void> agree(std::optional<std::string>& known, const std::string& value,
                                     const std::string& who, std::string_view column) const;

    [[nodiscard]] Result<void> readRow();
    [[nodiscard]] Result<void> readDetails(ResponseRow& row);
    [[nodiscard]] Result<void> readFactors(Person& person, ResponseRow& row);
    [[nodiscard]] Result<void> readAnswers(const ResponseRow& row);
    /// A line of an export's responses.csv in a long table's terms; false where it is no answer to be
    /// analysed.
    [[nodiscard]] bool takeExportLine();
    void countExportedCheck();
    [[nodiscard]] const std::string& cell(ExportColumnOf column) const;
    [[nodiscard]] bool declines(const std::string& who) const;
    /// One of two systems is preferred.
    [[nodiscard]] Result<void> readPreference(const ResponseRow& row, LongColumn column);
    /// A choice that was not made.
    [[nodiscard]] Result<void> readUnanswered(const ResponseRow& row);
    [[nodiscard]] Result<void> addRow(const ResponseRow& answer, const std::string& name, MeasureKind kind,
                                      double value);
    void countCheck(const std::string& stage_name, const std::string& kind, Attention result);
    /// Who is left out has no say in what was planned and in the scale.
    static void count(Measure& of, const ResponseRow& row);
    [[nodiscard]] std::string ratingName();
    /// With the scale that the line gives: on different scales one measure is several.
    [[nodiscard]] Result<std::string> nameOnScale(const std::string& name);
    [[nodiscard]] Result<void> checkScale(const std::string& name, double value, LongColumn column) const;

    // Made where they are new.
    Person& personOf(const std::string& who);
    CheckCount& checksOf(const std::string& stage_name, const std::string& kind);
    Measure& measureNamed(const std::string& name, MeasureKind kind);

    [[nodiscard]] Result<void> nameResponses();
    void nameScales();
    [[nodiscard]] Result<void> finishMeasures();
    void takeParticipants();
    void partLeftOut();

    std::string file_;
    CsvForm form_;
    CsvReader reader_;
    CsvRecord record_;
    const LongTableOptions& options_;
    LongHead head_;
    const std::string accuracy_{"accuracy"};
    const std::string rating_{"rating"};
    const std::string preference_{"preference"};
    const std::string not_excluded_{"no"};
    std::map<std::string, Person> people_;
    ResponseTable table_;
    std::map<std::string, StageResponses> responses_;
    /// A measure with its scale in its name.
    struct OnScale {
        std::string measure;
        studies::Range scale;
    };
    std::map<std::string, OnScale> scaled_;  ///< by that name
    std::string preference_of_;              ///< what the preferences are called in the file
    /// Places and texts of the first numbers that are written so; empty: none is.
    std::string decimal_comma_, decimal_point_;
    std::map<std::string, bool>
        declined_;                      ///< whether consent was declined when last asked, in responses.csv
    std::string exported_participant_;  ///< of the line before in responses.csv
    std::string exported_trial_;
    int balls_ = 0;
    int min_balls_ = std::numeric_limits<int>::max();
    int empty_ = 0;
    int unscored_checks_ = 0;
};

}  // namespace deixis::results
