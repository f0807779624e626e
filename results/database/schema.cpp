// The files of results/schema stand in the program as they are, taken in by the assembler, each with a zero
// byte at its end.
#include "results/database/schema.hpp"

#define DEIXIS_SCHEMA_TEXT(name)                    \
    __asm__(                                        \
        ".pushsection .rodata\n"                    \
        ".global deixis_schema_" #name              \
        "\n"                                        \
        "deixis_schema_" #name                      \
        ":\n"                                       \
        ".incbin \"" DEIXIS_SCHEMA_FOLDER "/" #name \
        ".sql\"\n"                                  \
        ".byte 0\n"                                 \
        ".popsection\n");                           \
    extern "C" const char deixis_schema_##name[]

DEIXIS_SCHEMA_TEXT(step_2);
DEIXIS_SCHEMA_TEXT(step_3_tables);
DEIXIS_SCHEMA_TEXT(step_3_rows);
DEIXIS_SCHEMA_TEXT(step_4);
DEIXIS_SCHEMA_TEXT(step_5);
DEIXIS_SCHEMA_TEXT(step_6);
DEIXIS_SCHEMA_TEXT(step_6_trials);
DEIXIS_SCHEMA_TEXT(newest_tables);
DEIXIS_SCHEMA_TEXT(newest_views);

namespace deixis::results {

const char* const step_2 = deixis_schema_step_2;
const char* const step_3_tables = deixis_schema_step_3_tables;
const char* const step_3_rows = deixis_schema_step_3_rows;
const char* const step_4 = deixis_schema_step_4;
const char* const step_5 = deixis_schema_step_5;
const char* const step_6 = deixis_schema_step_6;
const char* const step_6_trials = deixis_schema_step_6_trials;
const char* const newest_tables = deixis_schema_newest_tables;
const char* const newest_views = deixis_schema_newest_views;

}  // namespace deixis::results
