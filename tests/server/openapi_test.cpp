// The document against the routes: every documented route is asked as its schema says, and its answer is what
// its schema says; each of its fields is refused by its name where it is wrong; and there is no route beside
// those.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "app/program.hpp"
#include "core/text.hpp"
#include "played_session.hpp"
#include "studio_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

/// A value that the schema allows, with its required fields.
json exampleOf(const json& schema) {
    if (schema.contains("enum")) return schema["enum"].back();
    const json& type = schema["type"];
    if (type == "boolean") return true;
    if (type == "integer") return schema.value("minimum", 1);
    if (type == "number") return schema.value("minimum", 0.0) > 0.0 ? schema["minimum"] : json(0.5);
    if (type == "string") return "Hello there, this is a long river.";
    if (type == "array") {
        json out = json::array();
        for (int i = 0; i < schema.value("minItems", 1); ++i) out.push_back(exampleOf(schema["items"]));
        return out;
    }
    json out = json::object();
    std::set<std::string> names;
    for (const json& name : schema.value("required", json::array())) names.insert(name);
    if (schema.contains("oneOf"))
        for (const json& name : schema["oneOf"][0]["required"]) names.insert(name);
    for (const std::string& name : names) out[name] = exampleOf(schema["properties"][name]);
    return out;
}

/// Values that the schema of a field forbids.
std::vector<json> wrongValues(const json& schema) {
    std::vector<json> out{nullptr};
    const json& type = schema["type"];
    out.push_back(type == "string" ? json(5) : json("text"));
    if (type == "integer") out.push_back(1.5);
    if (schema.contains("minimum")) out.push_back(schema["minimum"].get<double>() - 1.0);
    if (schema.contains("maximum")) out.push_back(schema["maximum"].get<double>() * 2.0 + 1.0);
    if (schema.contains("enum")) out.push_back("no such choice");
    if (schema.contains("maxLength"))
        out.push_back(std::string(schema["maxLength"].get<std::size_t>() + 1, 'a'));
    if (schema.value("minLength", 0) > 0) out.push_back("");
    if (schema.value("minItems", 0) > 0) out.push_back(json::array());
    return out;
}

struct Operation {
    std::string method, path;
    json declared;
    [[nodiscard]] const json& body() const { return declared["requestBody"]["content"]; }
    [[nodiscard]] bool takesJson() const {
        return declared.contains("requestBody") && body().contains("application/json");
    }
    /// The status of what was done.
    [[nodiscard]] int done() const {
        for (const auto& [status, answer] : declared["responses"].items())
            if (status.starts_with('2')) return std::stoi(status);
        return 0;
    }
    [[nodiscard]] bool takesForm() const {
        return declared.contains("requestBody") && body().contains("multipart/form-data");
    }
};

std::vector<Operation> operationsOf(const json& document) {
    std::vector<Operation> out;
    for (const auto& [path, methods] : document["paths"].items())
        for (const auto& [method, declared] : methods.items()) {
            std::string upper = method;
            std::transform(upper.begin(), upper.end(), upper.begin(),
                           [](char c) { return static_cast<char>(c - 32); });
            out.push_back({upper, path, declared});
        }
    return out;
}

/// Answers and their schemas, to be checked together.
class Checks {
  public:
    explicit Checks(const Scratch& folder) : file_(folder / "answers.jsonl"), out_(file_) {}
    void add(const Operation& operation, const httplib::Response& answer) {
        CAPTURE(operation.path);
        REQUIRE_MESSAGE(answer.status == operation.done(), answer.body);
        const json& response = operation.declared["responses"][std::to_string(answer.status)];
        if (!response.contains("content")) {
            CHECK(answer.body.empty());
            return;
        }
        const json& content = response["content"];
        const std::string type = answer.get_header_value("Content-Type");
        CHECK_MESSAGE(content.contains(type), type);
        if (!content.contains(type) || !content[type].contains("schema")) return;
        const auto tag = answer.get_header_value("ETag");
        if (operation.path.starts_with("/v1/projects") || operation.path == "/v1/rules")
            CHECK((tag.empty() || contains(answer.body, tag)));
        addValue(operation.method + " " + operation.path, content[type]["schema"], json::parse(answer.body));
    }
    void addValue(const std::string& name, const json& schema, const json& value) {
        out_ << json{{"name", name}, {"schema", schema}, {"value", value}} << "\n";
    }
    /// What is wrong; empty: nothing.
    std::string problems() {
        out_.close();
        for (const std::string python : {"/usr/bin/python3", "python3"}) {
            if (shell(python + " -c 'import jsonschema'").status != 0) continue;
            const auto done =
                shell(python + " " + sourceDir().string() + "/tests/server/check_answers.py " + file_);
            return done.out + (done.status == 0 ? "" : done.err + "failed");
        }
        tellSkipped("there is no Python with jsonschema");
        return "";
    }

  private:
    std::string file_;
    std::ofstream out_;
};

/// Something of each kind that paths name, made anew each time.
class Things {
  public:
    explicit Things(const StudioServer& server) : server_(server) {
        speech_ = server.post("/v1/speech", {{"text", "Hello there, this is a long river."}}).body;
    }
    [[nodiscard]] const json& speech() const { return speech_; }
    [[nodiscard]] std::string pathOf(const std::string& pattern) {
        if (!contains(pattern, "{id}")) return pattern;
        std::string id = speech_["speech_id"];
        if (pattern.starts_with("/v1/projects"))
            id = server_.post("/v1/projects", {{"name", "x"}, {"project", {{"version", 1}}}}).body["id"];
        if (pattern.starts_with("/v1/motions")) id = addMotion(nextName())["id"];
        return replaced(pattern, "{id}", id);
    }
    /// The request again, where a second one like it would be refused.
    [[nodiscard]] json anew(const Operation& operation, json request) {
        if (operation.declared["operationId"] == "add_motion") request["name"] = nextName();
        if (operation.declared["operationId"] == "replace_rules" && !request["rules"].empty())
            request["rules"][0] = {{"word", "river"}, {"motions", {"point_right"}}};
        if (operation.declared["operationId"] == "replace_rules" && request.contains("revision"))
            request["revision"] = server_.get("/v1/rules")["revision"];
        return request;
    }

  private:
    [[nodiscard]] std::string nextName() { return "motion " + std::to_string(++count_); }
    [[nodiscard]] json addMotion(const std::string& name) const {
        const json pose{0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0};
        return server_.post("/v1/motions", {{"name", name}, {"frames", json::array({pose})}}).body;
    }

    const StudioServer& server_;
    json speech_;
    int count_ = 0;
};

/// Sends it; what changes something, to whatever revision it has.
httplib::Result send(const StudioServer& server, const Operation& operation, const std::string& path,
                     const json& body = nullptr) {
    auto client = server.client();
    const httplib::Headers any{{"If-Match", "*"}};
    if (operation.method == "GET") return client.Get(path);
    if (operation.method == "DELETE") return client.Delete(path, any);
    if (operation.method == "PUT") return client.Put(path, any, body.dump(), "application/json");
    return client.Post(path, body.dump(), "application/json");
}

}  // namespace

TEST_SUITE("server/openapi") {
    TEST_CASE("Every documented route takes and answers what the document says") {
        const Scratch scratch;
        const PlayedSession session;
        const StudioServer server{session.in(studioPartsIn(scratch / "kept"))};
        const json document = server.get("/v1/openapi.json");
        CHECK(document["openapi"] == "3.1.0");
        CHECK(document["info"]["version"] == "1.2.3");
        Checks checks(scratch);
        Things things(server);
        auto client = server.client();
        const json& speech = things.speech();
        for (const Operation& operation : operationsOf(document)) {
            CAPTURE(operation.method);
            CAPTURE(operation.path);
            CHECK(!operation.declared["operationId"].get<std::string>().empty());
            CHECK(!operation.declared["description"].get<std::string>().empty());
            const auto ask = [&](const json& request) {
                const json fresh = things.anew(operation, request);
                CAPTURE(fresh.dump().substr(0, 300));
                const auto answer = send(server, operation, things.pathOf(operation.path), fresh);
                REQUIRE(answer);
                checks.add(operation, *answer);
            };
            if (operation.method == "GET" || operation.method == "DELETE") ask(nullptr);
            const std::string path = operation.path;
            if (operation.takesJson()) {
                json request = exampleOf(operation.body()["application/json"]["schema"]);
                ask(request);
                // Each optional field by itself, at a value of its schema.
                const json& fields = operation.body()["application/json"]["schema"]["properties"];
                for (const auto& [name, schema] : fields.items())
                    for (const json& value : schema.value("enum", json::array({exampleOf(schema)}))) {
                        json with = request;
                        if (name == "keep") {  // must have as many frames as the speech
                            const double frames = speech["duration_s"].get<double>() * 15.0;
                            with[name] = value;
                            with[name]["frames"] =
                                json(static_cast<std::size_t>(std::ceil(frames)), value["frames"][0]);
                        } else if (name == "speech_id") {
                            with.erase("text");
                            with.erase("frames");
                            with[name] = speech["speech_id"];
                            if (operation.path == "/v1/export") with["format"] = "wav";
                        } else if (value == "wav") {  // of a speech
                            continue;
                        } else {
                            with[name] = value;
                        }
                        if (name == "duration_s") continue;  // of so many frames
                        if (name == "variety") continue;     // of the model, which is not there
                        ask(with);
                    }
            }
            if (operation.path == "/v1/motions/read") {
                const auto clip = client.Post(
                    "/v1/export", json{{"frames", server.get("/v1/motions")["motions"][0]["frames"]}}.dump(),
                    "application/json");
                REQUIRE(clip->status == 200);
                const auto answer = client.Post(
                    path, httplib::MultipartFormDataItems{{"name", "a.bvh", "", ""},
                                                          {"clip", clip->body, "a.bvh", "text/plain"}});
                checks.add(operation, *answer);
            } else if (operation.takesForm()) {
                const auto wav = client.Get(speech["sound"].get<std::string>());
                REQUIRE(wav->status == 200);
                const auto answer = client.Post(
                    path,
                    httplib::MultipartFormDataItems{{"text", "Hello there, this is a long river.", "", ""},
                                                    {"sound", wav->body, "a.wav", "audio/wav"}});
                checks.add(operation, *answer);
            }
        }
        CHECK(checks.problems() == "");
    }

    TEST_CASE("Each documented field is refused by its name where it is wrong") {
        const Scratch scratch;
        const PlayedSession session;
        const StudioServer server{session.in(studioPartsIn(scratch / "kept"))};
        const json document = server.get("/v1/openapi.json");
        const json refusal =
            document["components"]["responses"]["Refusal"]["content"]["application/json"]["schema"];
        Things things(server);
        Checks checks(scratch);
        int fields_tried = 0;
        for (const Operation& operation : operationsOf(document)) {
            if (!operation.takesJson()) continue;
            CAPTURE(operation.path);
            const json& schema = operation.body()["application/json"]["schema"];
            const json good = exampleOf(schema);
            const std::string path = things.pathOf(operation.path);
            const auto refused = [&](const json& request, const std::string& field) {
                CAPTURE(request.dump().substr(0, 300));
                const auto answer = send(server, operation, path, request);
                REQUIRE(answer);
                CHECK(answer->status == 400);
                const json body = json::parse(answer->body);
                CHECK(body["error"]["field"].get<std::string>().substr(0, field.size()) == field);
                checks.addValue(operation.path, refusal, body);
            };
            json with_more = good;
            with_more["colour"] = "red";
            refused(with_more, "colour");
            for (const json& name : schema.value("required", json::array())) {
                json without = good;
                without.erase(name.get<std::string>());
                refused(without, name);
            }
            for (const auto& [name, field] : schema["properties"].items()) {
                ++fields_tried;
                for (const json& value : wrongValues(field)) {
                    json wrong = good;
                    wrong[name] = value;
                    refused(wrong, name);
                }
            }
        }
        CHECK(fields_tried >= 12);
        CHECK(checks.problems() == "");
    }

    TEST_CASE("No route is undocumented") {
        const StudioServer server;
        const json document = server.get("/v1/openapi.json");
        std::set<std::string> documented, there;
        for (const Operation& operation : operationsOf(document))
            documented.insert(operation.method + " " + operation.path);
        for (const server::Route& route : server::studioRoutes(studioParts()))
            there.insert(route.method + " " + route.path);
        CHECK(documented == there);
        CHECK(documented.count("GET /v1/health") == 1);
        auto client = server.client();
        for (const char* path : {"/v1", "/v1/", "/v1/project", "/v2/health", "/health", "/openapi.json", "/"})
            CHECK_MESSAGE(client.Get(path)->status == 404, path);
        CHECK(client.Delete("/v1/motions")->status == 405);
        CHECK(client.Delete("/v1/motions")->get_header_value("Allow") == "GET, POST");
    }

    TEST_CASE("Health") {
        const StudioServer server;
        const json health = server.get("/v1/health");
        CHECK(health["status"] == "ok");
        CHECK(health["version"] == "1.2.3");
        CHECK(health["commit"] == "0123abc");
        CHECK(health["synthetic"] == true);
        const json quick{{"name", quick_voice}, {"language", "en"}};
        CHECK(std::count(health["voices"].begin(), health["voices"].end(), quick) == 1);
        CHECK(health["other_languages"] == false);
        CHECK_FALSE(health.contains("session"));
        const PlayedSession session;
        const StudioServer in_session{session.in(studioParts())};
        CHECK(in_session.get("/v1/health")["session"] ==
              json{{"participant", "P01"}, {"study", "a-study"}, {"language", "en"}});
    }

    TEST_CASE("What stands behind the path is checked as it is declared") {
        const PlayedSession session;
        const StudioServer server{session.in(studioParts())};
        const json document = server.get("/v1/openapi.json");
        CHECK(document["paths"]["/v1/session"]["get"]["parameters"][0]["name"] == "after");
        CHECK(document["paths"]["/v1/session"]["get"]["parameters"][0]["in"] == "query");
        CHECK(server.get("/v1/session?after=0")["revision"] == 1);
        CHECK(server.ask("/v1/session?after=x").field() == "after");
        CHECK(server.ask("/v1/session?after=-1").field() == "after");
        CHECK(server.ask("/v1/session?before=1").field() == "before");
        CHECK(server.ask("/v1/session?after=1&after=2").field() == "after");
        CHECK(server.ask("/v1/health?after=1").status == 400);
    }
}
