#include "kept_projects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <tuple>
#include <utility>

#include "kept_json.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr const char* projects_kind = "projects";
constexpr const char* project_format = "deixis studio project";
constexpr std::size_t longest_head = 4096;
constexpr std::size_t longest_project_name = 120;

std::string projectFile(const std::string& id) {
    return fmt::format("{}/{}.json", projects_kind, id);
}

std::string utcText() {
    using namespace std::chrono;
    const auto now = floor<milliseconds>(system_clock::now());
    const auto day = floor<days>(now);
    const year_month_day date(day);
    const hh_mm_ss time(now - day);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                       time.hours().count(), time.minutes().count(), time.seconds().count(),
                       time.subseconds().count());
}

/// `beginning`: the file's, `bytes` all of it.
Result<KeptProject> projectHead(const std::string& id, std::string_view beginning, std::uintmax_t bytes) {
    const std::size_t end = beginning.substr(0, longest_head).find('\n');
    if (end == std::string_view::npos) return fail("", "has no first line that tells what it is");
    const auto head =
        parseKeptJson(beginning.substr(0, end), project_format,
                      {mustField("name", textShape("", 1, longest_project_name)),
                       mustField("saved", textShape("", 1, 40)), mustField("revision", textShape("", 1, 64)),
                       mustField("bytes", integerShape("", 1, largest_project))});
    if (!head) return tl::unexpected(head.error());
    KeptProject out{id, (*head)["name"], (*head)["saved"], (*head)["bytes"], (*head)["revision"]};
    if (const std::size_t expected = end + 1 + out.bytes + 1; bytes != expected)
        return fail("", fmt::format("found {} bytes, expected {}", bytes, expected));
    return out;
}

std::string revisionOfProject(const std::string& name, const std::string& content) {
    return revisionOf(name + "\n" + content);
}

Result<KeptProject> readWhole(const KeptFolder& folder, const std::string& id) {
    auto bytes = folder.read(projectFile(id), longest_head + largest_project + 2);
    if (!bytes) return fail("", bytes.error().message);
    auto out = projectHead(id, *bytes, bytes->size());
    if (!out) return out;
    bytes->pop_back();
    out->content = bytes->substr(bytes->size() - out->bytes);
    if (revisionOfProject(out->name, out->content) != out->revision || !json::accept(out->content))
        return fail("", "its second line is not what its first line says");
    return out;
}

tl::unexpected<Refusal> absent() {
    return tl::unexpected(Refusal{404, "there is no project of this id"});
}

tl::expected<std::string, Refusal> contentOf(const json& project) {
    std::string out = project.dump();
    if (out.size() > largest_project)
        return tl::unexpected(Refusal{
            413, fmt::format("found a project of {} bytes, expected at most {}", out.size(), largest_project),
            "project"});
    return out;
}

ProjectOutcome writeProject(const KeptFolder& folder, std::string id, const std::string& name,
                            std::string content) {
    KeptProject out{std::move(id),     name, utcText(), content.size(), revisionOfProject(name, content),
                    std::move(content)};
    const json head = withFormat(
        project_format,
        {{"name", out.name}, {"saved", out.saved}, {"revision", out.revision}, {"bytes", out.bytes}});
    const auto written = folder.write(projectFile(out.id), head.dump() + "\n" + out.content + "\n");
    if (!written) return notWritten(written.error());
    return out;
}

bool isThere(const KeptFolder& folder, const std::string& id) {
    return isKeptId(id) && folder.has(projectFile(id));
}

}  // namespace

KeptProjects keptProjects(const KeptFolder& folder) {
    KeptProjects out;
    for (const std::string& id : folder.ids(projects_kind)) {
        const std::string file = projectFile(id);
        const auto beginning = folder.readBeginning(file, longest_head);
        auto one = beginning ? projectHead(id, *beginning, folder.bytesOf(file))
                             : Result<KeptProject>(fail("", beginning.error().message));
        if (one)
            out.projects.push_back(std::move(*one));
        else if (folder.has(file))  // and not deleted meanwhile
            out.damaged.push_back({file, one.error().text()});
    }
    std::sort(out.projects.begin(), out.projects.end(), [](const KeptProject& a, const KeptProject& b) {
        return std::tie(a.saved, a.id) > std::tie(b.saved, b.id);
    });
    return out;
}

ProjectOutcome readProject(const KeptFolder& folder, const std::string& id) {
    if (!isThere(folder, id)) return absent();
    auto out = readWhole(folder, id);
    if (!out && !folder.has(projectFile(id))) return absent();
    if (!out)
        return tl::unexpected(Refusal{422, fmt::format("{} in the server's folder is damaged: {}",
                                                       projectFile(id), out.error().text())});
    return std::move(*out);
}

ProjectOutcome addProject(const KeptFolder& folder, const std::string& name, const json& project) {
    auto content = contentOf(project);
    if (!content) return tl::unexpected(content.error());
    const auto turn = folder.turn();
    if (!turn) return notWritten(turn.error());
    if (folder.ids(projects_kind).size() >= max_projects)
        return tl::unexpected(
            Refusal{409, fmt::format("{} projects are kept, the most that are: delete one", max_projects)});
    return writeProject(folder, newKeptId(), name, std::move(*content));
}

ProjectOutcome replaceProject(const KeptFolder& folder, const std::string& id, const std::string& name,
                              const json& project, const std::optional<std::string>& revision) {
    constexpr int precondition_required = 428;
    if (!isThere(folder, id)) return absent();
    if (!revision)
        return tl::unexpected(
            Refusal{precondition_required, "expected If-Match with the revision that is replaced"});
    auto content = contentOf(project);
    if (!content) return tl::unexpected(content.error());
    const auto turn = folder.turn();
    if (!turn) return notWritten(turn.error());
    if (!isThere(folder, id)) return absent();
    if (*revision != "*") {
        const auto now = readProject(folder, id);
        if (!now) return now;
        if (now->revision != *revision) return otherRevision();
    }
    return writeProject(folder, id, name, std::move(*content));
}

tl::expected<void, Refusal> removeProject(const KeptFolder& folder, const std::string& id,
                                          const std::optional<std::string>& revision) {
    if (!isThere(folder, id)) return absent();
    const auto turn = folder.turn();
    if (!turn) return notWritten(turn.error());
    if (!isThere(folder, id)) return absent();
    if (revision && *revision != "*") {
        const auto now = readProject(folder, id);
        if (!now) return tl::unexpected(now.error());
        if (now->revision != *revision) return otherRevision();
    }
    if (const auto removed = folder.remove(projectFile(id)); !removed) return notWritten(removed.error());
    return {};
}

}  // namespace deixis::server
