// What a session goes through in order: pages to read and trials to do.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "studies/plan.hpp"
#include "studies/study.hpp"

namespace deixis::studies {

enum class PageKind : unsigned char {
    welcome,
    welcome_back,
    instructions,
    practice,
    begin,  ///< practice is over, now it counts
    rest,
    goodbye
};

/// "welcome", "welcome-back", "instructions", ... as notes and frames name it.
[[nodiscard]] std::string_view pageName(PageKind kind);

struct AgendaPage {
    PageKind kind = PageKind::welcome;
    std::string title;
    std::string body;
    std::string emphasis{};  ///< a line under the body, such as the question
    std::string button = "Continue";
};

/// A trial, or a page where `trial` is null.
struct AgendaItem {
    const Trial* trial = nullptr;
    AgendaPage page{};
    const Layout* layout =
        nullptr;                 ///< where the participant stands; of a page: where the next trial needs it
    std::string status{};        ///< for the operator
    std::string starts_stage{};  ///< detail of the note that a stage starts here; empty: none does
};

/// The agenda of what `answered` leaves. Throws std::invalid_argument where the plan names a layout that the
/// study does not have. Pointers go into `study` and `plan`.
[[nodiscard]] std::vector<AgendaItem> buildAgenda(const Study& study, const StudyPlan& plan,
                                                  const std::set<int>& answered);

}  // namespace deixis::studies
