// JSON documents of the kept folder.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "server/http/route.hpp"
#include "server/kept/kept_folder.hpp"

namespace deixis::server {

/// Of that format, with these fields; those that are left out are filled in. Errors say what is wrong, among
/// that that a newer program wrote it.
[[nodiscard]] Result<nlohmann::json> readKeptJson(const KeptFolder& folder, const std::string& file,
                                                  std::size_t max_bytes, const char* format,
                                                  std::vector<ShapeField> fields);
[[nodiscard]] Result<void> writeKeptJson(const KeptFolder& folder, const std::string& file,
                                         const char* format, const nlohmann::json& fields);

/// With `format` and `version`, which readKeptJson() expects.
[[nodiscard]] nlohmann::json withFormat(const char* format, nlohmann::json fields);
/// The same of a text in memory; `fields` without these two.
[[nodiscard]] Result<nlohmann::json> parseKeptJson(std::string_view text, const char* format,
                                                   std::vector<ShapeField> fields);

/// Of content: half a hash is enough.
[[nodiscard]] std::string revisionOf(std::string_view content);

/// Of a change that the disk did not take.
[[nodiscard]] tl::unexpected<Refusal> notWritten(const Error& error);
/// 409: the server has no folder.
[[nodiscard]] tl::unexpected<Refusal> noFolder();
/// 412: what was asked to be changed is another one by now.
[[nodiscard]] tl::unexpected<Refusal> otherRevision();
/// As `damaged` of a list, and what it looks like.
[[nodiscard]] nlohmann::json damagedJson(const std::vector<DamagedFile>& files);
[[nodiscard]] ShapeField damagedField();

}  // namespace deixis::server
