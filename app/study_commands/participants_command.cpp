// deixis participants: who is in a database, and what becomes of them.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "app/study_commands/study_commands.hpp"
#include "core/utc.hpp"
#include "results/participants/participants.hpp"

namespace deixis::app {

namespace {

struct ParticipantsArguments {
    std::string database;
    std::string participant;
    std::string reason;
    bool yes = false;
    bool json = false;
};

std::string day(double utc_s) {
    if (utc_s <= 0.0) return "-";
    const auto seconds = static_cast<std::time_t>(utc_s);
    return fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(seconds));
}

std::string orDash(const std::string& text) {
    return text.empty() ? "-" : text;
}

using Json = nlohmann::ordered_json;

/// Null where nothing is known.
Json jsonOf(const results::ParticipantRow& row) {
    Json out{{"participant", row.id},
             {"number", row.number},
             {"status", results::participantStatusName(row.status)},
             {"reason", row.reason.empty() ? Json() : Json(row.reason)},
             {"language", row.language},
             {"groups", row.groups},
             {"simulated", row.synthetic},
             {"consent",
              row.consent == results::Consent::not_asked ? "not asked" : results::consentName(row.consent)},
             {"sessions", row.sessions},
             {"answered", row.answered},
             {"planned", row.planned},
             {"checks_failed", row.checks_failed}};
    out["last_seen_utc"] = row.last_utc_s > 0.0
                               ? Json(fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                                                  fmt::gmtime(static_cast<std::time_t>(row.last_utc_s))))
                               : Json();
    return out;
}

Result<void> list(const ParticipantsArguments& options) {
    const auto found = results::listParticipants(options.database);
    if (!found) return tl::unexpected(found.error());
    if (options.json) {
        Json rows = Json::array();
        for (const auto& row : found->rows) rows.push_back(jsonOf(row));
        printAsJson({{"participants", rows},
                     {"withdrawn", found->withdrawn},
                     {"interrupted_withdrawals", found->uncleared}});
        return {};
    }
    fmt::print("{:<16} {:>6}  {:<9} {:<8} {:>8} {:>12} {:>13}  {:<9} {:<16}  {}\n", "participant", "number",
               "status", "language", "sessions", "answered", "checks failed", "consent", "last seen (UTC)",
               "groups, remarks");
    for (const auto& row : found->rows) {
        std::string remarks;
        for (const auto& [factor, level] : row.groups) remarks += fmt::format("{}={} ", factor, level);
        if (row.synthetic) remarks += "simulated ";
        if (!row.reason.empty()) remarks += fmt::format("({})", row.reason);
        fmt::print("{:<16} {:>6}  {:<9} {:<8} {:>8} {:>12} {:>13}  {:<9} {:<16}  {}\n", row.id, row.number,
                   results::participantStatusName(row.status), row.language, row.sessions,
                   fmt::format("{}/{}", row.answered, row.planned), row.checks_failed,
                   orDash(std::string(results::consentName(row.consent))), day(row.last_utc_s), remarks);
    }
    int answered = 0;
    int planned = 0;
    for (const auto& row : found->rows) {
        answered += row.answered;
        planned += row.planned;
    }
    fmt::print("{} {}, {} of {} trials and pages answered, {} withdrawn\n", found->rows.size(),
               found->rows.size() == 1 ? "participant" : "participants", answered, planned, found->withdrawn);
    if (found->uncleared > 0)
        fmt::print(
            "A withdrawal was interrupted: run 'deixis participants withdraw' with the same id again, to "
            "clear the traces in free pages of the file\n");
    return {};
}

Result<void> show(const ParticipantsArguments& options) {
    const auto found = results::showParticipant(options.database, options.participant);
    if (!found) return tl::unexpected(found.error());
    const auto& row = found->row;
    if (options.json) {
        Json out = jsonOf(row);
        out["fields"] = Json::object();
        for (const auto& [name, value] : found->fields) out["fields"][name] = value;
        out["session_lines"] = found->sessions;
        out["event_lines"] = found->events;
        printAsJson(out);
        return {};
    }
    fmt::print("{}: number {}, {}{}\n", row.id, row.number, results::participantStatusName(row.status),
               row.reason.empty() ? "" : fmt::format(" ({})", row.reason));
    fmt::print("language {}, consent {}, {} of {} trials and pages answered, {} attention checks failed{}\n",
               row.language,
               row.consent == results::Consent::not_asked ? "not asked" : results::consentName(row.consent),
               row.answered, row.planned, row.checks_failed, row.synthetic ? ", simulated" : "");
    for (const auto& [factor, level] : row.groups) fmt::print("group {}: {}\n", factor, level);
    for (const auto& [name, value] : found->fields) fmt::print("{}: {}\n", name, value);
    for (const auto& session : found->sessions) fmt::print("session {}\n", session);
    for (const auto& event : found->events) fmt::print("  {}\n", event);
    return {};
}

Result<void> exclude(const ParticipantsArguments& options) {
    auto done = results::excludeParticipant(options.database, options.participant, options.reason);
    if (done) fmt::print("{} is excluded from the analysis; the answers are kept\n", options.participant);
    return done;
}

Result<void> include(const ParticipantsArguments& options) {
    const auto done = results::includeParticipant(options.database, options.participant, utcNow_s());
    if (!done) return tl::unexpected(done.error());
    if (done->consent_asked_anew)
        fmt::print(
            "{0} did not give consent: the next session asks for it first, and nothing of {0} counts until "
            "it is given\n",
            options.participant);
    else
        fmt::print("{} takes part again\n", options.participant);
    for (const std::string& stage : done->practice)
        fmt::print("practice {} was failed: it starts again, and its answers so far are kept\n", stage);
    if (const int forgiven = done->failed_checks_forgiven; forgiven > 0)
        fmt::print("{} failed {} no longer {} towards a rule\n", forgiven,
                   forgiven == 1 ? "attention check" : "attention checks",
                   forgiven == 1 ? "counts" : "count");
    return {};
}

Result<void> withdraw(const ParticipantsArguments& options) {
    if (!options.yes)
        return fail("--yes",
                    fmt::format("is missing: all data of {} would be erased for good", options.participant),
                    "Give --yes to confirm; reports and exports made before are yours to delete");
    auto done = results::withdrawParticipant(options.database, options.participant, utcNow_s());
    if (!done) return tl::unexpected(done.error());
    if (*done == results::Withdrawn::erased)
        fmt::print("{} is withdrawn: all data in {} is erased, and counted as one withdrawal\n",
                   options.participant, options.database);
    else
        fmt::print("The interrupted withdrawal is finished: nothing of the person is left in {}\n",
                   options.database);
    return {};
}

}  // namespace

void addParticipantsCommand(Parser cli, Command& chosen) {
    Parser group = cli.addCommand("participants", "List, show, exclude or withdraw participants");
    group.requireCommand();
    describe(group, {.writes = "nothing, or to the database, as each command says.",
                     .example = "deixis participants list study.sqlite",
                     .page = "docs/running-a-study.md"});
    const auto add = [&](const char* name, const char* what, const CommandText& text, bool one,
                         Result<void> (*act)(const ParticipantsArguments&)) {
        auto options = std::make_shared<ParticipantsArguments>();
        Parser command = group.addCommand(name, what);
        describe(command, text);
        command.addOption("DB", options->database, "Database of a study").required();
        if (one) command.addOption("PARTICIPANT", options->participant, "Pseudonymous id").required();
        command.callback([options, act, &chosen] { chosen = [options, act] { return act(*options); }; });
        return std::make_pair(command, options);
    };
    const auto addJsonTo = [](const auto& added) { addJson(added.first, added.second->json, "Print JSON"); };
    addJsonTo(add("list", "List all participants of a database",
                  {.writes = "nothing; it prints the list.",
                   .example = "deixis participants list study.sqlite",
                   .page = "docs/running-a-study.md"},
                  false, list));
    addJsonTo(add("show", "Show one participant: fields, sessions, events",
                  {.writes = "nothing; it prints what is stored.",
                   .example = "deixis participants show study.sqlite P07",
                   .page = "docs/running-a-study.md"},
                  true, show));
    const auto [exclude_command, excluded] =
        add("exclude", "Take a participant's answers out of the analysis; they are kept",
            {.writes = "to the database, with the reason.",
             .example = "deixis participants exclude study.sqlite P07 --reason 'fell asleep'",
             .page = "docs/running-a-study.md"},
            true, exclude);
    exclude_command.addOption("--reason", excluded->reason, "Why; kept and reported").required();
    add("include", "Include a participant again; consent that was declined is asked for again",
        {.writes = "to the database.",
         .example = "deixis participants include study.sqlite P07",
         .page = "docs/running-a-study.md"},
        true, include);
    const auto [withdraw_command, withdrawn] =
        add("withdraw", "Erase all data of a participant",
            {.writes = "to the database: all data of the participant are erased for good.",
             .example = "deixis participants withdraw study.sqlite P07 --yes",
             .page = "docs/running-a-study.md"},
            true, withdraw);
    withdraw_command.addFlag("--yes", withdrawn->yes, "Really erase: it cannot be undone");
}

}  // namespace deixis::app
