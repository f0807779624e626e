// Several studies analysed together: each is a group of participants. Yoon et al. 2021, section 7.2.3.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/answers/response_table.hpp"

namespace deixis::results {

/// The between-participants factor that the studies are.
inline constexpr const char* study_factor = "study";
/// What stands for all studies together where a study's name would stand.
inline constexpr const char* pooled_studies = "pooled";

struct JoinChoice {
    bool by_study = false;                ///< studies are to be compared, and each CSV file is one
    std::optional<double> alpha{};        ///< level of significance; none: the studies'
    std::vector<std::string> measures{};  ///< these alone; empty: all
};

/// One table of all data: of one study as joinTables(). Databases of studies of different names are compared
/// by study, with or without `by_study`: the study is a between-participants factor, participants and items
/// are called "STUDY/ID" (P01 of one study is not P01 of another), and systems that not all studies have are
/// left out. The order of the tables changes nothing. Fails, with the reason, where the studies do not share
/// their measures and scales or any system, and where there is nothing to compare by study.
[[nodiscard]] Result<ResponseTable> joinData(std::vector<ResponseTable> tables,
                                             const JoinChoice& choice = {});

/// The studies that have answers, in order; empty if the table is of one study.
[[nodiscard]] std::vector<std::string> studiesIn(const ResponseTable& table);

/// Those answers of one study that tests of its systems need; without factors.
[[nodiscard]] ResponseTable onlyStudy(const ResponseTable& table, const std::string& study);

/// Studies without answers go, as where answers of one station alone are kept; of a single one left the
/// factor, too.
void dropEmptyStudies(ResponseTable& table);

/// Fails if no two studies have answers that are analysed together: people's at one kind of station (at
/// any, where `stations_together`), or simulated participants'.
[[nodiscard]] Result<void> checkStudiesMeet(const ResponseTable& table, bool stations_together);

}  // namespace deixis::results
