#include "results/database/views.hpp"

#include <fmt/core.h>

#include "results/database/schema.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::results {

namespace {

using studies::KeptField;
using studies::KeptFields;

std::string columnOf(const KeptField& field, const char* table, const char* row) {
    return fmt::format(", {} AS {}", keptValueSql(field, table, row), field.name);
}

std::string viewsOfKinds(const char* create) {
    std::string sql;
    for (const studies::StageDeclaration* kind : studies::allDeclarations()) {
        const KeptFields& planned = kind->trial_values;
        if (!planned.view.empty()) {
            sql += fmt::format("{} {} AS SELECT t.participant, t.trial_index", create, planned.view);
            for (const KeptField& field : planned.fields)
                sql += columnOf(field, "trial_values",
                                "v.participant = t.participant AND v.trial_index = t.trial_index");
            sql += fmt::format(" FROM trials AS t WHERE t.kind = '{}';\n", kind->name);
        }
        const KeptFields& given = kind->response_values;
        if (given.view.empty()) continue;
        sql +=
            fmt::format("{} {} AS SELECT r.id AS response, r.participant, r.trial_index", create, given.view);
        for (const KeptField& field : given.fields)
            sql += columnOf(field, "response_values", "v.response = r.id");
        sql += fmt::format(
            " FROM responses AS r JOIN trials AS t ON t.participant = r.participant AND t.trial_index = "
            "r.trial_index WHERE t.kind = '{}';\n",
            kind->name);
    }
    return sql;
}

}  // namespace

std::string keptValueSql(const KeptField& field, const char* table, const char* row) {
    using enum studies::KeptType;
    const char* value = field.type == text                           ? "v.text"
                        : field.type == whole || field.type == truth ? "CAST(v.value AS INTEGER)"
                                                                     : "v.value";
    return fmt::format("(SELECT {} FROM {} AS v WHERE {} AND v.name = '{}')", value, table, row, field.name);
}

std::string createViews() {
    return newest_views + viewsOfKinds("CREATE VIEW");
}

std::string createMissingViews() {
    return viewsOfKinds("CREATE VIEW IF NOT EXISTS");
}

std::string dropViews() {
    std::string sql = "DROP VIEW IF EXISTS responses_flat;\n";
    for (const studies::StageDeclaration* kind : studies::allDeclarations())
        for (const std::string_view view : {kind->trial_values.view, kind->response_values.view})
            if (!view.empty()) sql += fmt::format("DROP VIEW IF EXISTS {};\n", view);
    return sql;
}

}  // namespace deixis::results
