#include "openapi.hpp"

#include "core/text.hpp"

namespace deixis::server {

namespace {

using nlohmann::ordered_json;

ordered_json parametersOf(const Route& route) {
    auto out = ordered_json::array();
    for (const auto& [name, about] : route.path_parts)
        out.push_back({{"name", name},
                       {"in", "path"},
                       {"required", true},
                       {"description", about},
                       {"schema", {{"type", "string"}, {"pattern", "^[A-Za-z0-9_-]{1,64}$"}}}});
    for (const ShapeField& field : route.query)
        out.push_back({{"name", field.name},
                       {"in", "query"},
                       {"required", field.required},
                       {"description", field.shape.about},
                       {"schema", schemaOf(field.shape)}});
    if (route.takes_revision)
        out.push_back(
            {{"name", "If-Match"},
             {"in", "header"},
             {"required", false},
             {"description", "The revision that is changed, in double quotes, or *: another one is 412"},
             {"schema", {{"type", "string"}}}});
    return out;
}

ordered_json formSchema(const Route& route) {
    ordered_json schema{{"type", "object"}, {"properties", ordered_json::object()}};
    for (const FormPart& part : route.form) {
        if (part.file)
            schema["properties"][part.name] = {{"type", "string"},
                                               {"description", part.shape.about},
                                               {"contentMediaType", part.content_type}};
        else
            schema["properties"][part.name] = schemaOf(part.shape);
        if (part.required) schema["required"].push_back(part.name);
    }
    schema["additionalProperties"] = false;
    return schema;
}

ordered_json requestBody(const Route& route) {
    ordered_json content;
    if (route.body) content["application/json"]["schema"] = schemaOf(*route.body);
    if (!route.form.empty()) content["multipart/form-data"]["schema"] = formSchema(route);
    return {{"required", true}, {"content", content}};
}

ordered_json answers(const Route& route) {
    ordered_json out;
    for (const Outcome& outcome : route.outcomes) {
        ordered_json& answer = out[std::to_string(outcome.status)];
        answer["description"] = outcome.about;
        if (outcome.content_type.empty()) continue;
        answer["content"][outcome.content_type] = ordered_json::object();
        if (outcome.shape) answer["content"][outcome.content_type]["schema"] = schemaOf(*outcome.shape);
    }
    out["default"] = {{"$ref", "#/components/responses/Refusal"}};
    return out;
}

ordered_json operation(const Route& route) {
    ordered_json out{{"operationId", route.name}, {"description", route.about}};
    if (auto parameters = parametersOf(route); !parameters.empty()) out["parameters"] = std::move(parameters);
    if (route.body || !route.form.empty()) out["requestBody"] = requestBody(route);
    out["responses"] = answers(route);
    return out;
}

}  // namespace

ordered_json openApiDocument(const std::vector<Route>& routes, const std::string& version) {
    ordered_json document;
    document["openapi"] = "3.1.0";
    document["info"] = {
        {"title", "Deixis studio"},
        {"version", version},
        {"description",
         "Speech in, gestures out. Gestures are made by rules or trained on them: synthetic. Every "
         "request carries the token; a field that is not listed is refused by its name."}};
    document["servers"].push_back({{"url", "/"}});
    document["security"] = ordered_json::array();
    for (const char* scheme : {"bearer", "cookie"})
        document["security"].push_back({{scheme, ordered_json::array()}});
    for (const Route& route : routes)
        document["paths"][route.path][lowerCase(route.method)] = operation(route);
    document["components"]["securitySchemes"]["bearer"] = {{"type", "http"}, {"scheme", "bearer"}};
    document["components"]["securitySchemes"]["cookie"] = {
        {"type", "apiKey"}, {"in", "cookie"}, {"name", "deixis_token"}};
    document["components"]["responses"]["Refusal"] = {
        {"description", "Not done: status 400 and above"},
        {"content", {{"application/json", {{"schema", schemaOf(refusalShape())}}}}}};
    return document;
}

}  // namespace deixis::server
