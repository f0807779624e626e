// The lines of an export's responses.csv as those of a long table.
#include <fmt/core.h>

#include <algorithm>

#include "long_table_reader.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::results {

const std::string& LongTableReader::cell(ExportColumnOf column) const {
    return record_.fields[head_.place(column)];
}

bool LongTableReader::declines(const std::string& who) const {
    const auto found = declined_.find(who);
    return found != declined_.end() && found->second;
}

void LongTableReader::countExportedCheck() {
    const std::string& passed = cell(ExportColumnOf::check_passed);
    if (passed.empty()) return;
    countCheck(name(stage), cell(ExportColumnOf::check_kind),
               passed == "1" ? Attention::passed : Attention::failed);
    if (passed != "1" && cell(ExportColumnOf::participant_status) == "active")
        table_.failed_checks.insert(name(participant));
}

bool LongTableReader::takeExportLine() {
    using enum ExportColumnOf;
    // Answers to one trial stand in lines that follow each other.
    const std::string who = name(LongColumn::participant);
    const bool first_of_trial =
        who != exported_participant_ || this->cell(LongColumn::trial) != exported_trial_;
    exported_participant_ = who;
    exported_trial_ = this->cell(LongColumn::trial);
    const studies::StageDeclaration* declared = studies::findDeclaration(cell(kind));
    if (declared != nullptr && declared->asks_consent) {
        if (!cell(value).empty()) declined_[who] = cell(value) == "0";
        return false;
    }
    if (first_of_trial && !cell(check_kind).empty()) countExportedCheck();
    const std::string asked = cell(question);
    const auto measures =
        declared != nullptr ? declared->measures : std::span<const studies::DeclaredMeasure>{};
    const auto measured =
        std::find_if(measures.begin(), measures.end(),
                     [&](const studies::DeclaredMeasure& one) { return one.question == asked; });
    const bool surveyed = declared != nullptr && declared->in_pages && !cell(ExportColumnOf::measure).empty();
    const bool rated = surveyed || (!asked.empty() && measured != measures.end());
    const bool choice = declared != nullptr && declared->balls && first_of_trial;
    if (cell(scored) != "1" || this->cell(LongColumn::practice) == "1" || !(rated || choice)) return false;

    const std::string answer = rated ? cell(value) : "";
    const bool chosen = !cell(chosen_place).empty();
    const std::string is_right = choice && chosen ? cell(ExportColumnOf::correct) : "";
    const std::string unanswered = choice && !chosen ? cell(ExportColumnOf::status) : "";
    const std::string standing = cell(participant_status);
    const std::string of = rated ? cell(ExportColumnOf::measure) : asked;
    const std::string left_out =
        standing == "active" ? "" : fmt::format("{}: for a reason in participants.csv", standing);
    // In the order of the places that the head gives them.
    for (const std::string& made : {of, is_right, answer, unanswered, left_out})
        record_.fields.push_back(made);
    return true;
}

}  // namespace deixis::results
