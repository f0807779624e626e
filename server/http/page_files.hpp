// The page's files: those of one folder, read when the server starts. What was not read then is not served,
// so that no path can leave the folder.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace deixis::server {

struct PageFile {
    std::shared_ptr<const std::string> bytes;
    std::string content_type;
    std::string etag;  ///< with its quotes
    /// The same compressed; none where that is no smaller.
    std::shared_ptr<const std::string> gzip{};
    std::shared_ptr<const std::string> brotli{};
};

/// By path from "/" on; a folder's index.html also stands for the folder. Links, files whose names begin with
/// a dot and those whose names have other letters than a-z, A-Z, 0-9 and "._-" are left out.
using PageFiles = std::map<std::string, PageFile, std::less<>>;

/// At most 256 MiB, with `others` and `contents`, which are served at these paths, the later in place of the
/// earlier. The folder may be empty: none. Errors name the folder or file.
[[nodiscard]] Result<PageFiles> loadPageFiles(const std::filesystem::path& folder,
                                              const std::map<std::string, std::filesystem::path>& others = {},
                                              const std::map<std::string, std::string>& contents = {});

}  // namespace deixis::server
