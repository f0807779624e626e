#include "package_sets.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "app/study/locked_set.hpp"
#include "assets/tables/manifest.hpp"
#include "core/files.hpp"
#include "results/copies/anonymous_copy.hpp"
#include "results/copies/data_export.hpp"
#include "results/store/locked_sets.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

bool isManifest(const std::string& name) {
    return name.starts_with("clips/") && name.ends_with("/manifest.csv");
}

Result<std::set<std::string>> authorsIn(const fs::path& set, const LockedFiles& files) {
    std::set<std::string> out;
    for (const auto& [name, hash] : files) {
        if (!isManifest(name)) continue;
        const auto manifest = assets::readManifest(set / name);
        if (!manifest) return tl::unexpected(manifest.error());
        for (const auto& row : manifest->rows)
            if (!row.author.empty()) out.insert(row.author);
    }
    return out;
}

/// A file as it goes into the copy.
Result<std::string> packagedBytes(const fs::path& set, const std::string& name,
                                  const std::map<std::string, std::string>& authors) {
    auto bytes = readFile(set / name);
    if (!bytes) return bytes;
    if (name == "study.text.toml") return results::withoutWholePaths(*bytes);
    if (name == "set.json") {
        auto json = nlohmann::ordered_json::parse(*bytes, nullptr, false);
        if (json.is_discarded()) return tl::unexpected(damaged(set, "set.json is no JSON"));
        json["lab_files"] = nlohmann::ordered_json::array();
        return json.dump(1) + "\n";
    }
    if (!isManifest(name) || authors.empty()) return bytes;
    auto manifest = assets::parseManifest(*bytes, set / name);
    if (!manifest) return tl::unexpected(manifest.error());
    for (auto& row : manifest->rows)
        if (!row.author.empty()) row.author = authors.at(row.author);
    return assets::manifestCsv(manifest->rows);
}

}  // namespace

Result<PackagedSets> packageSets(const fs::path& database, const fs::path& copy) {
    const auto hashes = results::lockedSets(database);
    if (!hashes) return tl::unexpected(hashes.error());
    if (hashes->empty())
        return fail(database.string(),
                    "nothing of the study is locked, so its clips and avatar are not known for certain",
                    fmt::format("'deixis run STUDY --db {}' locks them, with the next session; for simulated "
                                "participants, simulate again",
                                database.string()));
    std::map<std::string, LockedFiles> sets;
    std::set<std::string> authors;
    for (const std::string& hash : *hashes) {
        auto files = verifyLocked(database, hash);
        if (!files) return tl::unexpected(files.error());
        const auto more = authorsIn(lockedSet(database, hash), *files);
        if (!more) return tl::unexpected(more.error());
        authors.insert(more->begin(), more->end());
        sets.emplace(hash, std::move(*files));
    }
    auto names = results::anonymousAuthors(database, authors);
    if (!names) return tl::unexpected(names.error());
    PackagedSets out{{}, {}, std::move(*names)};
    for (const auto& [hash, files] : sets) {
        auto writer = LockedSetWriter::begin(copy);
        if (!writer) return tl::unexpected(writer.error());
        for (const auto& file : files) {
            const auto bytes = packagedBytes(lockedSet(database, hash), file.first, out.authors);
            if (!bytes) return tl::unexpected(bytes.error());
            if (auto added = writer->add(file.first, *bytes); !added) return tl::unexpected(added.error());
            out.files.insert(file.first);
        }
        auto made = writer->finish(false);
        if (!made) return tl::unexpected(made.error());
        out.hashes.emplace(hash, std::move(*made));
    }
    return out;
}

}  // namespace deixis::app
