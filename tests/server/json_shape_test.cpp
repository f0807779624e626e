// The strict reader of requests: its errors name the field; its schema is what it checks.
#include "server/http/json_shape.hpp"

#include <doctest/doctest.h>

#include <string>

#include "core/error.hpp"
#include "server/http/json_text.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::server;
using deixis::tests::contains;
using nlohmann::json;

namespace {

Shape exampleShape() {
    Shape shape = objectShape(
        "",
        {mayField("text", textShape("", 1, 5)), mayField("speech_id", textShape("")),
         mayField("seed", integerShape("", 0, 1e300), 0),
         mayField("format", choiceShape("", {"bvh", "csv"}), "bvh"), mayField("mirror", booleanShape("")),
         mayField("controls",
                  listShape("", objectShape("", {mustField("time_s", numberShape("", 0.0, 60.0))}), 0, 3))});
    shape.exactly_one = {"text", "speech_id"};
    return shape;
}

/// "FIELD: MESSAGE", or nothing where it is right.
std::string problemOf(const std::string& text) {
    const auto value = parseJsonText(text);
    if (!value) return value.error().where + ": " + value.error().message;
    const auto checked = checkShape(exampleShape(), *value);
    return checked ? "" : checked.error().text();
}

}  // namespace

TEST_SUITE("server/json_shape") {
    TEST_CASE("What is right passes, and what is left out is filled in") {
        CHECK(problemOf(R"({"text":"hello"})") == "");
        CHECK(problemOf(R"({"text":"a\tb\n", "seed":9007199254740991, "format":"csv", "mirror":false})") ==
              "");
        CHECK(problemOf(R"({"speech_id":"x", "controls":[{"time_s":0},{"time_s":59.5}]})") == "");
        json value{{"text", "hello"}};
        fillIn(exampleShape(), value);
        CHECK(value["seed"] == 0);
        CHECK(value["format"] == "bvh");
        CHECK(!value.contains("mirror"));
    }

    TEST_CASE("Each mistake names its field") {
        CHECK(problemOf(R"({"text":"hello", "sed":1})") == "sed: there is no such field. Did you mean seed?");
        CHECK(problemOf(R"({"text":5})") == "text: found 5, expected a text");
        CHECK(problemOf(R"({"text":null})") == "text: found null, expected a text");
        CHECK(problemOf(R"({"text":"hello!"})") == "text: found 6 characters, expected 1 to 5 characters");
        CHECK(problemOf(R"({"text":""})") == "text: found 0 characters, expected 1 to 5 characters");
        CHECK(problemOf(R"({"text":"ééééé"})") == "");  // characters, not bytes
        CHECK(contains(problemOf(R"({"text":"a\u0000b"})"), "text: found a control character"));
        CHECK(contains(problemOf(R"({"text":"a\u001bb"})"), "text: found a control character"));
        CHECK(problemOf(R"({"text":"a", "seed":-1})")
                  .starts_with("seed: found -1, expected a whole number from 0 to"));
        CHECK(
            problemOf(R"({"text":"a", "seed":1.5})").starts_with("seed: found 1.5, expected a whole number"));
        CHECK(problemOf(R"({"text":"a", "seed":9007199254740992})")
                  .starts_with("seed: found 9007199254740992"));
        CHECK(problemOf(R"({"text":"a", "seed":"1"})") == "seed: found a text, expected a whole number");
        CHECK(problemOf(R"({"text":"a", "seed":true})") == "seed: found true, expected a whole number");
        CHECK(problemOf(R"({"text":"a", "format":"fbx"})") ==
              "format: found 'fbx', expected one of bvh, csv");
        CHECK(problemOf(R"({"text":"a", "mirror":1})") == "mirror: found 1, expected true or false");
        CHECK(problemOf(R"({"text":"a", "controls":{}})") == "controls: found an object, expected a list");
        CHECK(problemOf(R"({"text":"a", "controls":[{"time_s":1},{"time_s":61}]})") ==
              "controls[1].time_s: found 61, expected a number from 0 to 60");
        CHECK(problemOf(R"({"text":"a", "controls":[{}]})") == "controls[0].time_s: is missing");
        CHECK(problemOf(R"({"text":"a", "controls":[{"time_s":1,"x":2}]})") ==
              "controls[0].x: there is no such field");
        CHECK(problemOf(R"({"text":"a", "controls":[1,2,3,4]})") ==
              "controls: found 4 items, expected at most 3 items");
        CHECK(problemOf("{}") == "text: found 0 of text and speech_id, expected exactly one of them");
        CHECK(problemOf(R"({"text":"a","speech_id":"x"})") ==
              "text: found 2 of text and speech_id, expected exactly one of them");
        CHECK(problemOf("[]") == "found a list, expected an object");
    }

    TEST_CASE("Text that is no JSON, ambiguous or deep is refused") {
        CHECK(problemOf("") == ": the request has no body, expected JSON");
        CHECK(problemOf("{").starts_with(": is no JSON: parse error"));
        CHECK(problemOf("{} {}").starts_with(": is no JSON"));
        CHECK(problemOf("{\"text\":\"\xff\"}").starts_with(": is no JSON"));
        CHECK(problemOf(R"({"text":"\ud800"})").starts_with(": is no JSON"));
        CHECK(problemOf("NaN").starts_with(": is no JSON"));
        CHECK(problemOf(R"({"seed":1e999})").starts_with(": is no JSON"));
        CHECK(problemOf(R"({"text":"a","text":"b"})") == "text: stands twice in an object");
        CHECK(problemOf(R"({"text":"a","controls":[{"time_s":1,"time_s":2}]})") ==
              "time_s: stands twice in an object");
        const std::string deep(max_json_depth, '[');
        CHECK(parseJsonText(deep + std::string(max_json_depth, ']')).has_value());
        CHECK(contains(problemOf("[" + deep + std::string(max_json_depth + 1, ']')), "deep"));
        CHECK(contains(problemOf(std::string(1'000'000, '[')), "deep"));
    }

    TEST_CASE("The schema says what is checked") {
        const json schema = schemaOf(exampleShape());
        CHECK(schema["additionalProperties"] == false);
        CHECK(schema["properties"]["text"]["maxLength"] == 5);
        CHECK(schema["properties"]["seed"]["type"] == "integer");
        CHECK(schema["properties"]["seed"]["maximum"] == 9007199254740991);
        CHECK(schema["properties"]["seed"]["default"] == 0);
        CHECK(schema["properties"]["format"]["enum"] == json{"bvh", "csv"});
        CHECK(schema["properties"]["controls"]["items"]["required"] == json{"time_s"});
        CHECK(schema["oneOf"].size() == 2);
        CHECK(!schema.contains("required"));
    }
}
