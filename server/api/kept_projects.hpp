// Projects of the studio's page, as files of the kept folder. What is in one is the page's business.
//
// A file has two lines of JSON: what a list of projects says of it, and the project, so that a list reads no
// whole files.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/http/route.hpp"
#include "server/kept/kept_folder.hpp"

namespace deixis::server {

inline constexpr std::size_t largest_project = std::size_t{16} << 20U;  ///< bytes of JSON
inline constexpr std::size_t max_projects = 1000;

struct KeptProject {
    std::string id;
    std::string name;
    std::string saved;      ///< UTC, "2026-11-28T17:30:12.345Z"
    std::size_t bytes = 0;  ///< of its JSON
    std::string revision;   ///< of name and content
    std::string content{};  ///< JSON; empty in a list
};

struct KeptProjects {
    std::vector<KeptProject> projects;  ///< newest first
    std::vector<DamagedFile> damaged;
};

[[nodiscard]] KeptProjects keptProjects(const KeptFolder& folder);

/// Refusals: an id that no file has (404), a file that cannot be read (422, named), one too many (409), a
/// project that is too large (413), another revision (412), no revision where one must be named (428).
using ProjectOutcome = tl::expected<KeptProject, Refusal>;
[[nodiscard]] ProjectOutcome readProject(const KeptFolder& folder, const std::string& id);
[[nodiscard]] ProjectOutcome addProject(const KeptFolder& folder, const std::string& name,
                                        const nlohmann::json& project);
[[nodiscard]] ProjectOutcome replaceProject(const KeptFolder& folder, const std::string& id,
                                            const std::string& name, const nlohmann::json& project,
                                            const std::optional<std::string>& revision);
/// Whatever it is, where no revision is named; one that cannot be read, too.
[[nodiscard]] tl::expected<void, Refusal> removeProject(const KeptFolder& folder, const std::string& id,
                                                        const std::optional<std::string>& revision);

}  // namespace deixis::server
