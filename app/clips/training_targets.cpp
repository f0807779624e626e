#include "app/clips/training_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "app/clips/synthetic_demonstrations.hpp"
#include "app/clips/systems.hpp"
#include "assets/tables/manifest.hpp"
#include "assets/tables/target_list.hpp"
#include "core/csv_sheet.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"

namespace deixis::app {

namespace {

Result<TrainingTargets> syntheticLibrary() {
    const auto library = syntheticDemonstrations();
    if (!library) return tl::unexpected(library.error());
    TrainingTargets out;
    for (const auto& demonstration : library->made) out.targets.push_back(demonstration.target);
    for (const auto& demonstration : library->made)
        out.targets.push_back(demonstration.target * Vec3(-1.0, 1.0, 1.0));
    out.source = "synthetic demonstrations and their mirror images";
    out.synthetic = true;
    // Only the name: where the program is installed says nothing about the numbers.
    out.file = {library->parameters.filename().string(), library->sha256};
    return out;
}

Result<TrainingTargets> fromManifest(const std::string& bytes, const std::string& file) {
    const auto manifest = assets::parseManifest(bytes, file);
    if (!manifest) return tl::unexpected(manifest.error());
    TrainingTargets out;
    out.source = file;
    std::set<std::tuple<double, double, double>> seen;
    for (const auto& row : manifest->rows) {
        if (!row.target || !seen.emplace(row.target->x, row.target->y, row.target->z).second) continue;
        out.targets.push_back(*row.target);
        out.synthetic = out.synthetic || isSynthetic(row);
    }
    if (out.targets.empty())
        return fail(file, "names no targets", "Training targets need target_x, target_y and target_z");
    return out;
}

}  // namespace

Result<TrainingTargets> loadTrainingTargets(const std::string& file) {
    if (file.empty()) return syntheticLibrary();
    const auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    CsvReader reader(*bytes, file);
    const auto sheet = readCsvHeader(reader, file);
    if (!sheet) return tl::unexpected(sheet.error());
    Result<TrainingTargets> out;
    if (sheet->find("clip")) {
        out = fromManifest(*bytes, file);
    } else {
        const auto list = assets::parseTargetList(*bytes, file);
        if (!list) return tl::unexpected(list.error());
        out->source = file;
        for (const auto& target : *list) out->targets.push_back(target.position);
    }
    if (out) out->file = {file, sha256Hex(*bytes)};
    return out;
}

}  // namespace deixis::app
