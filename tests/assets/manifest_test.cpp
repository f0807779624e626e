#include "assets/tables/manifest.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/random.hpp"

using namespace deixis;
using namespace deixis::assets;

namespace {

const std::string header =
    "clip,system,target_id,target_x,target_y,target_z,hand,onset,peak,hold,end,fps,seed\n";
const std::string good = "a.bvh,direct,T001,0.5,1.25,-2,left,9,33,60,90,30,7\n";

std::string errorOf(const std::string& text) {
    const auto read = parseManifest(text, "m.csv");
    REQUIRE_FALSE(read.has_value());
    return read.error().text();
}

bool says(const std::string& text, const std::string& part) {
    CAPTURE(text);
    return text.find(part) != std::string::npos;
}

/// The good row with one field replaced.
std::string with(int column, const std::string& value) {
    std::string out;
    int at = 0;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1, ++at) {
        end = good.find(',', begin);
        const std::string field = good.substr(begin, end == std::string::npos ? end : end - begin);
        out += (at > 0 ? "," : "") + (at == column ? value + (at == 12 ? "\n" : "") : field);
    }
    return header + out;
}

}  // namespace

TEST_SUITE("assets/manifest") {
    TEST_CASE("errors of retargeted clips are kept in columns of their own, which may lack") {
        const std::string wide = header.substr(0, header.size() - 1) + ",source_error_deg,avatar_error_deg\n";
        const std::string row = good.substr(0, good.size() - 1);
        const auto read = parseManifest(wide + row + ",3.5,3.25\n" + row + ",,\n", "m.csv");
        REQUIRE(read.has_value());
        CHECK(read->rows[0].source_error_deg == 3.5);
        CHECK(read->rows[0].avatar_error_deg == 3.25);
        CHECK_FALSE(read->rows[1].source_error_deg.has_value());
        CHECK(manifestCsv(read->rows) == wide + row + ",3.5,3.25\n" + row + ",,\n");
        CHECK_FALSE(parseManifest(header + good, "m.csv")->rows[0].avatar_error_deg.has_value());
        CHECK(manifestCsv(parseManifest(header + good, "m.csv")->rows) == header + good);
        CHECK(
            says(errorOf(wide + row + ",181,3\n"), "m.csv:2: source_error_deg: found 181, expected degrees"));
        CHECK(says(errorOf(wide + row + ",3,x\n"), "m.csv:2: avatar_error_deg: found 'x'"));
    }

    TEST_CASE("what was done to a clip is kept in a column of its own, which may lack") {
        const std::string wide = header.substr(0, header.size() - 1) + ",processing\n";
        const std::string row = good.substr(0, good.size() - 1);
        const auto read = parseManifest(wide + row + ",physics-projected\n" + row + ",\n", "m.csv");
        REQUIRE(read.has_value());
        CHECK(read->rows[0].processing == physics_projected);
        CHECK(read->rows[1].processing.empty());
        CHECK(manifestCsv(read->rows) == wide + row + ",physics-projected\n" + row + ",\n");
        CHECK(manifestCsv({read->rows[1]}) == header + good);
    }

    TEST_CASE("bad rows are rejected with file, line and column") {
        CHECK(says(errorOf(with(0, "")), "m.csv:2: clip: is empty"));
        CHECK(says(errorOf(with(3, "nan")), "m.csv:2: target_x: found 'nan', expected a finite number"));
        CHECK(
            says(errorOf(with(3, "1e308")), "m.csv:2: target_x: found 1e+308, expected at most 1000 metres"));
        CHECK(says(errorOf(with(4, "inf")), "m.csv:2: target_y"));
        CHECK(says(errorOf(with(5, "1.0m")), "m.csv:2: target_z: found '1.0m'"));
        CHECK(says(errorOf(with(5, "")), "m.csv:2: target_z"));
        CHECK(says(errorOf(with(6, "Left")), "m.csv:2: hand: found 'Left', expected left or right"));
        CHECK(says(errorOf(with(7, "-1")), "m.csv:2: onset: found -1"));
        CHECK(says(errorOf(with(8, "9")), "m.csv:2: peak: found 9, expected a frame after the onset (9)"));
        CHECK(says(errorOf(with(8, "33.5")), "m.csv:2: peak: found '33.5'"));
        CHECK(says(errorOf(with(9, "32")), "m.csv:2: hold: found 32, expected the peak (33) or later"));
        CHECK(says(errorOf(with(10, "60")), "m.csv:2: end: found 60, expected a frame after the hold (60)"));
        CHECK(says(errorOf(with(11, "0")), "m.csv:2: fps"));
        CHECK(says(errorOf(with(12, "-3")), "m.csv:2: seed"));
        CHECK(says(errorOf(header + good + "a.bvh,direct\n"), "m.csv:3: found 2 fields, expected 13"));
    }

    TEST_CASE("a gesture that points at nothing has no target and none of the phases, all or nothing") {
        const auto read = parseManifest(header + "a.bvh,lab,G1,,,,,,,,,30,7\n", "m.csv");
        REQUIRE(read.has_value());
        CHECK_FALSE(read->rows[0].target.has_value());
        CHECK_FALSE(read->rows[0].phases.has_value());
        CHECK(says(errorOf(header + "a.bvh,lab,G1,0.5,,,,,,,,30,7\n"), "m.csv:2: target_y"));
        CHECK(says(errorOf(header + "a.bvh,lab,G1,,,,left,,,,,30,7\n"), "m.csv:2: onset"));
    }

    TEST_CASE("a header without a column, or with one twice, is rejected by the column's name") {
        CHECK(says(errorOf(""), "m.csv: the manifest is empty"));
        CHECK(says(errorOf("clip,system\n"), "m.csv:1: the column 'target_id' is missing"));
        CHECK(
            says(errorOf("clip," + header + "b.bvh," + good), "m.csv:1: the column 'clip' is in the header"));
    }

    TEST_CASE("broken quoting is rejected with its line") {
        CHECK(says(errorOf(header + "\"a.bvh,direct\n" + good),
                   "m.csv:2: a quoted field has no closing quote"));
        CHECK(says(errorOf(header + "\"a\"b,direct\n"), "m.csv:2: text follows a closing quote"));
        CHECK(says(errorOf(header + "a\"b,direct\n"), "m.csv:2: a quote is inside"));
    }

    TEST_CASE("a file that is not there is an error that names it") {
        const auto read = readManifest("no/such/manifest.csv");
        REQUIRE_FALSE(read.has_value());
        CHECK(says(read.error().text(), "no/such/manifest.csv"));
    }

    TEST_CASE("columns may stand in any order beside unknown ones, with CRLF, quotes and a UTF-8 mark") {
        const auto read = parseManifest(
            "\xEF\xBB\xBFseed,note,clip,system,target_id,target_x,target_y,target_z,hand,onset,peak,hold,end,"
            "fps\r\n"
            "18446744073709551615,\"two\r\nlines\",\"a, "
            "\"\"b\"\".bvh\",lab,T9,-1e-1,+.5,3,right,0,1,1,2,29.97\r\n",
            "m.csv");
        // from_chars takes no plus sign: the row is rejected, and the line counts the one inside the quotes.
        REQUIRE_FALSE(read.has_value());
        CHECK(says(read.error().text(), "m.csv:2: target_y: found '+.5'"));
        const auto mended = parseManifest(
            "\xEF\xBB\xBFseed,note,clip,system,target_id,target_x,target_y,target_z,hand,onset,peak,hold,end,"
            "fps\r\n"
            "18446744073709551615,\"two\r\nlines\",\"a, "
            "\"\"b\"\".bvh\",lab,T9,-1e-1,.5,3,right,0,1,1,2,29.97\r\n"
            "\r\n"
            "1,x,c.bvh,lab,T9,0,0,zero,right,0,1,1,2,30\r\n",
            "m.csv");
        REQUIRE_FALSE(mended.has_value());
        CHECK(says(mended.error().text(), "m.csv:5: target_z"));
        const auto whole = parseManifest(
            "seed,note,clip,system,target_id,target_x,target_y,target_z,hand,onset,peak,hold,end,fps\n"
            "18446744073709551615,\"two\nlines\",\"a, \"\"b\"\".bvh\",lab,T9,-1e-1,.5,3,right,0,1,1,2,29.97",
            "m.csv");
        REQUIRE(whole.has_value());
        REQUIRE(whole->rows.size() == 1);
        const ManifestRow& row = whole->rows[0];
        CHECK(row.clip == "a, \"b\".bvh");
        CHECK(row.system == "lab");
        CHECK(row.target == Vec3(-0.1, 0.5, 3.0));
        REQUIRE(row.phases.has_value());
        CHECK(row.phases->hand == motion::Side::right);
        CHECK(row.phases->end_frame == 2);
        CHECK(row.fps == 29.97);
        CHECK(row.seed == 18446744073709551615ULL);
        CHECK(whole->file == "m.csv");
    }

    TEST_CASE("what is written reads back the same, whatever the numbers and names") {
        Random random(5);
        std::vector<ManifestRow> rows;
        for (int i = 0; i < 50; ++i) {
            ManifestRow row;
            row.clip = i % 3 == 0 ? "odd, \"name\"\n.bvh" : "clip.bvh";
            row.system = "s" + std::to_string(i);
            row.target_id = "T,1";
            if (i % 5 > 0) row.target = {random.normal(), random.normal() * 1e-9, random.normal() * 100.0};
            if (i % 7 > 0) {
                motion::GesturePhases& phases = row.phases.emplace();
                phases.hand = i % 2 == 0 ? motion::Side::left : motion::Side::right;
                phases.onset_frame = static_cast<int>(random.below(100));
                phases.peak_frame = phases.onset_frame + 1 + static_cast<int>(random.below(100));
                phases.hold_frame = phases.peak_frame + static_cast<int>(random.below(100));
                phases.end_frame = phases.hold_frame + 1 + static_cast<int>(random.below(100));
            }
            row.fps = random.uniform(1.0, 240.0);
            row.seed = random.next();
            rows.push_back(row);
        }
        const std::string text = manifestCsv(rows);
        CHECK(text.substr(0, header.size()) == header);
        const auto read = parseManifest(text, "m.csv");
        REQUIRE(read.has_value());
        REQUIRE(read->rows.size() == rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            CHECK(read->rows[i].clip == rows[i].clip);
            CHECK(read->rows[i].system == rows[i].system);
            CHECK(read->rows[i].target_id == rows[i].target_id);
            CHECK(read->rows[i].target == rows[i].target);
            REQUIRE(read->rows[i].phases.has_value() == rows[i].phases.has_value());
            if (rows[i].phases) {
                CHECK(read->rows[i].phases->hand == rows[i].phases->hand);
                CHECK(read->rows[i].phases->onset_frame == rows[i].phases->onset_frame);
                CHECK(read->rows[i].phases->peak_frame == rows[i].phases->peak_frame);
                CHECK(read->rows[i].phases->hold_frame == rows[i].phases->hold_frame);
                CHECK(read->rows[i].phases->end_frame == rows[i].phases->end_frame);
            }
            CHECK(read->rows[i].fps == rows[i].fps);
            CHECK(read->rows[i].seed == rows[i].seed);
        }
        CHECK(manifestCsv(read->rows) == text);
    }
}
