// The synthetic demonstrations against people: Schuetz & Fiehler (2024), "Object center of mass predicts
// pointing endpoints in virtual reality"; 25 people, 18 pointings at a wall of nine targets in each of six
// runs.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "assets/data/demonstrations.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/synthesis/demonstration_library.hpp"
#include "shared_data.hpp"

using namespace deixis;
namespace fs = std::filesystem;

namespace {

struct Pointing {
    std::string person;
    double eccentricity_deg = 0.0;  ///< of the target from straight ahead, seen from the eyes
    double eye_error_deg = 0.0;     ///< at the fingertip, between the eye's ray and the target
};

std::string unpacked(const fs::path& path) {
    gzFile file = gzopen(path.c_str(), "rb");
    REQUIRE(file != nullptr);
    std::string out;
    std::array<char, 65536> part{};
    for (int n = 0; (n = gzread(file, part.data(), part.size())) > 0;)
        out.append(part.data(), static_cast<std::size_t>(n));
    gzclose(file);
    return out;
}

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> out;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, '\t');) out.push_back(cell);
    return out;
}

/// The pointings at targets of known place ("cal"); the recorded ray is the one from between the eyes through
/// the fingertip. The eyes themselves are not recorded: an arm's length of 0.62 m behind the fingertip is
/// taken.
void readRun(const fs::path& path, std::vector<Pointing>& out) {
    std::istringstream lines(unpacked(path));
    std::string line;
    std::getline(lines, line);
    std::map<std::string, std::size_t> column;
    const auto header = cells(line);
    for (std::size_t i = 0; i < header.size(); ++i) column[header[i]] = i;
    const std::string name = path.filename().string();  // VRpoint_PERSON_RUN_...
    const std::string person = name.substr(8, name.find('_', 8) - 8);
    while (std::getline(lines, line)) {
        const auto row = cells(line);
        if (row.at(column.at("type")) != "cal") continue;
        const auto value = [&](const std::string& key) { return std::stod(row.at(column.at(key))); };
        const Vec3 tip(value("index_x"), value("index_y"), value("index_z"));
        const Vec3 ray(value("efrc_dir_x"), value("efrc_dir_y"), value("efrc_dir_z"));
        const Vec3 target(value("tar_x"), value("tar_y"), 2.0);
        const Vec3 eye = tip - 0.62 * glm::normalize(ray);
        out.push_back({person, degreesFromRadians(angleBetween(target - eye, Vec3(0, 0, 1))),
                       degreesFromRadians(angleBetween(ray, target - tip))});
    }
}

const std::vector<Pointing>& people() {
    static const std::vector<Pointing> read = [] {
        std::vector<Pointing> out;
        for (const auto& entry :
             fs::directory_iterator(tests::sharedData("pointing/schuetz2024_vr_pointing/data")))
            if (entry.path().string().find(".tsv.gz") != std::string::npos) readRun(entry.path(), out);
        // The authors leave participant 17 out.
        out.erase(std::remove_if(out.begin(), out.end(), [](const Pointing& p) { return p.person == "17"; }),
                  out.end());
        return out;
    }();
    return read;
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

std::vector<double> errors(const std::vector<Pointing>& pointings, double from_deg, double to_deg) {
    std::vector<double> out;
    for (const Pointing& p : pointings)
        if (p.eccentricity_deg >= from_deg && p.eccentricity_deg < to_deg) out.push_back(p.eye_error_deg);
    return out;
}

/// Demonstrations of eight imagined actors at targets like those on the people's wall, 3.5 m away.
std::vector<Pointing> demonstrations() {
    auto parameters =
        assets::loadDemonstrationParameters(deixis::tests::sourceDir() / "assets/data/demonstrations.toml")
            .value();
    parameters.targets = {{-18.0, 18.0}, {3.3, 3.7}, {0.8, 2.8}, 30.0};
    const auto& avatar = motion::referenceHumanoid();
    const auto map = motion::mapByVrmNames(avatar);
    std::vector<Pointing> out;
    for (std::uint64_t actor = 1; actor <= 8; ++actor) {
        parameters.library_seed = actor;
        const auto library = motion::makeDemonstrations(avatar, parameters);
        REQUIRE(library.has_value());
        for (const motion::Demonstration& d : *library) {
            const auto& g = d.gesture;
            const auto middle = static_cast<std::size_t>((g.peak_frame + g.hold_frame) / 2);
            const auto world = motion::worldPose(avatar, g.clip.frames[middle]);
            const Ray ray =
                motion::pointingRay(avatar, map, world, g.hand, motion::PointingRay::eye_fingertip);
            const Vec3 sight = d.target - motion::eyePosition(map, world);
            out.push_back({fmt::format("actor {}", actor),
                           degreesFromRadians(angleBetween(sight, Vec3(0, 0, 1))),
                           degreesFromRadians(motion::angularError(ray, d.target))});
        }
    }
    return out;
}

std::vector<double> personMedians(const std::vector<Pointing>& pointings) {
    std::map<std::string, std::vector<double>> by_person;
    for (const Pointing& p : pointings) by_person[p.person].push_back(p.eye_error_deg);
    std::vector<double> out;
    for (const auto& [person, values] : by_person) out.push_back(quantile(values, 0.5));
    return out;
}

}  // namespace

TEST_SUITE("assets/human_pointing") {
    TEST_CASE(
        "The recorded people miss by a median of 4.0 degrees along the eye's line, at any eccentricity") {
        DEIXIS_SKIP_WITHOUT(tests::sharedData("pointing/schuetz2024_vr_pointing/data"));
        CHECK(people().size() == 2592);  // 24 people x 6 runs x 18
        const auto all = errors(people(), 0, 90);
        CHECK(quantile(all, 0.5) == doctest::Approx(4.03).epsilon(0.005));
        CHECK(quantile(all, 0.1) == doctest::Approx(1.4).epsilon(0.05));
        CHECK(quantile(all, 0.9) == doctest::Approx(10.2).epsilon(0.05));
        // The table of docs/systems.md.
        CHECK(quantile(errors(people(), 0, 8), 0.5) == doctest::Approx(3.64).epsilon(0.02));
        CHECK(quantile(errors(people(), 8, 16), 0.5) == doctest::Approx(4.05).epsilon(0.02));
        CHECK(quantile(errors(people(), 16, 22), 0.5) == doctest::Approx(4.08).epsilon(0.02));
        CHECK(quantile(errors(people(), 22, 90), 0.5) == doctest::Approx(4.08).epsilon(0.02));
        const auto medians = personMedians(people());
        CHECK(medians.size() == 24);
        CHECK(quantile(medians, 0.0) == doctest::Approx(1.88).epsilon(0.02));
        CHECK(quantile(medians, 1.0) == doctest::Approx(8.27).epsilon(0.02));
    }

    TEST_CASE("The synthetic demonstrations' error stands within the people's, at every eccentricity") {
        DEIXIS_SKIP_WITHOUT(tests::sharedData("pointing/schuetz2024_vr_pointing/data"));
        const auto made = demonstrations();
        for (const auto& range : {std::pair{0.0, 8.0}, {8.0, 16.0}, {16.0, 22.0}}) {
            const double from = range.first;
            const double to = range.second;
            CAPTURE(from);
            const auto human = errors(people(), from, to);
            const double median = quantile(errors(made, from, to), 0.5);
            // Nearer to the people's median than half of the people's errors are.
            CHECK(median > quantile(human, 0.25));
            CHECK(median < quantile(human, 0.75));
            CHECK(std::abs(median - quantile(human, 0.5)) < 1.0);
            CHECK(quantile(errors(made, from, to), 0.9) < quantile(human, 0.95));
        }
        const auto actors = personMedians(made);
        const auto persons = personMedians(people());
        CHECK(quantile(actors, 0.0) >= quantile(persons, 0.0));
        CHECK(quantile(actors, 1.0) <= quantile(persons, 1.0));
    }
}
