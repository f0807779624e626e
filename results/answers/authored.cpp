#include "results/answers/authored.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/core.h>

#include <map>
#include <utility>

#include "results/database/counted_participants.hpp"
#include "results/database/database_open.hpp"

namespace deixis::results {

Result<std::vector<AuthoredClip>> readAuthored(const std::filesystem::path& database) {
    auto read = readDatabase(database, [](SQLite::Database& opened) -> Result<std::vector<AuthoredClip>> {
        SQLite::Statement query(
            opened,
            fmt::format(
                "SELECT r.participant, s.system, s.item, v.text, e.synthetic FROM responses AS r JOIN {} "
                "AS p ON p.id = r.participant JOIN trials AS t ON t.participant = r.participant AND "
                "t.trial_index = r.trial_index JOIN trial_stimuli AS s ON s.participant = t.participant "
                "AND s.trial_index = t.trial_index JOIN sessions AS e ON e.id = r.session JOIN "
                "response_values AS v ON v.response = r.id AND v.name = 'project' WHERE p.status = "
                "'active' AND r.superseded IS NULL AND s.scored AND t.kind = 'authoring' ORDER BY "
                "p.number, r.participant, r.trial_index",
                effectiveParticipants()));
        std::vector<AuthoredClip> out;
        std::map<std::pair<std::string, std::string>, int> trials;
        while (query.executeStep()) {
            AuthoredClip clip;
            clip.author = query.getColumn(0).getString();
            clip.system = query.getColumn(1).getString();
            clip.item = query.getColumn(2).getString();
            clip.project = query.getColumn(3).getString();
            clip.synthetic = query.getColumn(4).getInt() != 0;
            clip.trial = ++trials[{clip.author, clip.system}];
            out.push_back(std::move(clip));
        }
        return out;
    });
    if (read && read->empty())
        return fail(database.string(),
                    "nothing was authored, expected answers of a stage of kind \"authoring\"",
                    "Practice, and who is excluded or dropped out, do not count");
    return read;
}

}  // namespace deixis::results
