// The kinds of stages that a study may have. Each stands in a folder of studies/trials, and nowhere else:
//
// - declaration.cpp (compiled with studies/study_file): its keys, its stimuli, its questions and measures
//   (stage_kind.hpp);
// - reading.cpp (likewise): how its stages are read from a study file;
// - plan.cpp (studies/design), where more is planned than the declaration says;
// - unit.cpp (studies/session): how it is presented and answered (session_unit.hpp).
//
// A new kind is a folder, and a line here. Lists of kinds, as in messages, keep this order.
#pragma once

#include <cstddef>
#include <initializer_list>

#define DEIXIS_STAGE_KINDS(KIND)                                                              \
    KIND(instructions)    /* page: to be read */                                              \
    KIND(consent)         /* consent */                                                       \
    KIND(questionnaire)   /* questionnaire */                                                 \
    KIND(rating)          /* rating: a single stimulus */                                     \
    KIND(parallel_rating) /* parallel_rating: 2 to 6 stimuli of one item on a page */         \
    KIND(pairwise)        /* preference: two stimuli of one item, which is better */          \
    KIND(game)            /* game: the referential game */                                    \
    KIND(placement)       /* placement: a ball is put where the avatar points */              \
    KIND(authoring)       /* authoring: gestures to a speech are made in the studio's page */ \
    KIND(rest)            /* page: a break */

namespace deixis::studies {

enum class StageKind : unsigned char {
#define DEIXIS_KIND(name) name,
    DEIXIS_STAGE_KINDS(DEIXIS_KIND)
#undef DEIXIS_KIND
};

#define DEIXIS_KIND(name) StageKind::name,
inline constexpr std::size_t stage_kinds =
    std::initializer_list<StageKind>{DEIXIS_STAGE_KINDS(DEIXIS_KIND)}.size();
#undef DEIXIS_KIND

}  // namespace deixis::studies
