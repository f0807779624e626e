// The JSON Schemas that ship, and what the program writes by them.
#include "schema_check.hpp"
#include "text.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

const std::vector<std::string> names{"analysis", "plan", "evaluation", "trace"};

/// The unit that a name's ending tells; empty where it tells none.
std::string unitOf(const std::string& name) {
    const std::vector<std::pair<std::string, std::string>> units{{"_m_s", "metres per second"},
                                                                 {"_deg", "degree"},
                                                                 {"_min", "minute"},
                                                                 {"_m", "metre"},
                                                                 {"_s", "second"}};
    for (const auto& [ending, unit] : units)
        if (name.ends_with(ending)) return unit;
    return "";
}

/// Walks a schema: each property tells what it is and in which unit, and objects take no key that they do not
/// describe. `part` of an object with further keys is closed where it is used.
int check(const json& schema, const std::string& path, bool part = false) {
    int properties = 0;
    INFO(path);
    if (schema.contains("properties") && !part) {
        const bool closed = schema.contains("additionalProperties")
                                ? schema["additionalProperties"] != true
                                : schema.contains("unevaluatedProperties");
        CHECK_MESSAGE(closed, path);
    }
    if (schema.contains("properties"))
        for (const auto& property : schema["properties"].items()) {
            const std::string& name = property.key();
            const auto& one = property.value();
            CHECK_MESSAGE(one.value("description", "").size() > 2, path << "/" << name);
            CHECK_MESSAGE(contains(one.value("description", "") + one.value("items", json()).dump() +
                                       one.value("additionalProperties", json()).dump(),
                                   unitOf(name)),
                          path << "/" << name << ": no unit");
            properties += 1 + check(one, path + "/" + name);
        }
    for (const char* key : {"items", "additionalProperties"})
        if (schema.contains(key) && schema[key].is_object())
            properties += check(schema[key], path + "/" + key);
    if (schema.contains("$defs"))
        for (const auto& [name, one] : schema["$defs"].items())
            properties +=
                check(one, "$defs/" + name, name == "test" || name == "group_test" || name == "level");
    return properties;
}

}  // namespace

TEST_SUITE("app/schemas") {
    TEST_CASE("each schema says what it is, and of each property what it is and in which unit") {
        for (const std::string& name : names) {
            const json schema = json::parse(slurp(shippedSchema(name)));
            CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
            CHECK(contains(schema["$id"].get<std::string>(), "urn:deixis:schema:" + name + ":"));
            CHECK(contains(schema["title"].get<std::string>(), "Deixis"));
            CHECK(schema["description"].get<std::string>().size() > 30);
            CHECK(check(schema, name, name == "analysis") > 15);
        }
    }

    TEST_CASE("the program prints its schemas, and where they lie") {
        const auto list = program("schema");
        CHECK(list.status == 0);
        for (const std::string& name : names) {
            CHECK(contains(list.out, "/schemas/" + name + ".schema.json\n"));
            CHECK(program("schema " + name).out == slurp(shippedSchema(name)));
        }
        CHECK(program("schema plans").status == 2);
    }

    TEST_CASE("the plan of every study that ships is as its schema says, and what is not is rejected") {
        const Scratch scratch;
        for (const auto& study : fs::directory_iterator(sourceDir() / "assets/data/studies")) {
            const auto plan = program("plan " + study.path().stem().string() + " --participant P03 --json");
            REQUIRE(plan.status == 0);
            spill(scratch / "plan.json", plan.out);
            CHECK_MESSAGE(schemaProblems("plan", scratch / "plan.json") == "", study.path());
        }
        if (shell("/usr/bin/python3 -c 'import jsonschema' || python3 -c 'import jsonschema'").status != 0) {
            tellSkipped("there is no Python with jsonschema");
            return;
        }
        const json plan = json::parse(program("plan pointing2023 --participant P03 --json").out);
        const auto problems = [&](const json& document) {
            spill(scratch / "wrong.json", document.dump());
            return schemaProblems("plan", scratch / "wrong.json");
        };
        CHECK(problems(plan) == "");
        json further = plan;
        further["trials"][0]["mood"] = 1;
        CHECK(contains(problems(further), "'mood' was unexpected"));
        json less = plan;
        less.erase("seed");
        CHECK(contains(problems(less), "'seed' is a required property"));
        json other = plan;
        other["trials"][20]["target"][1] = "high";
        CHECK(contains(problems(other), "trials/*/target/*: 'high' is not of type 'number'"));
    }

    TEST_CASE("a key of an analysis that its schema does not describe is rejected, within tests too") {
        if (shell("/usr/bin/python3 -c 'import jsonschema' || python3 -c 'import jsonschema'").status != 0) {
            tellSkipped("there is no Python with jsonschema");
            return;
        }
        const Scratch scratch;
        std::string answers = "participant,system,stage,rating\n";
        for (int person = 1; person <= 6; ++person)
            answers += "A" + std::to_string(person) + ",x,naturalness," + std::to_string(1 + person % 5) +
                       "\nA" + std::to_string(person) + ",y,naturalness," + std::to_string(1 + person % 3) +
                       "\n";
        spill(scratch / "answers.csv", answers);
        REQUIRE(program("report " + (scratch / "answers.csv") + " -o " + (scratch / "r.html") + " --json " +
                        (scratch / "r.json"))
                    .status == 0);
        CHECK(schemaProblems("analysis", scratch / "r.json") == "");
        json analysis = json::parse(slurp(scratch / "r.json"));
        analysis["pairwise"][0]["mood"] = 1;
        spill(scratch / "wrong.json", analysis.dump());
        CHECK(contains(schemaProblems("analysis", scratch / "wrong.json"), "mood"));
        analysis = json::parse(slurp(scratch / "r.json"));
        analysis["mood"] = 1;
        analysis["pairwise"][0]["p"] = 1.5;
        spill(scratch / "wrong.json", analysis.dump());
        CHECK(contains(schemaProblems("analysis", scratch / "wrong.json"), "'mood' was unexpected"));
        CHECK(contains(schemaProblems("analysis", scratch / "wrong.json"), "pairwise/*/p: 1.5 is greater"));
    }
}
