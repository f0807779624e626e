// The numbers behind glTF accessors.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gltf_document.hpp"

namespace deixis::assets::gltf {

/// Reads each accessor and each buffer once, when it is first asked for; every range is checked then. The
/// document must outlive it.
class Values {
  public:
    /// `folder`: where the files that the document names lie; without it they are refused.
    Values(const Document& document, std::optional<std::filesystem::path> folder)
        : document_(document), folder_(std::move(folder)) {}

    /// All elements in a row, integers of normalised accessors as fractions (section 3.6.2.2), sparse ones
    /// put in place. Numbers are finite. `what` names the accessor in refusals. Throws Refusal.
    [[nodiscard]] const std::vector<double>& read(int accessor, const std::string& what);

  private:
    [[nodiscard]] std::string_view buffer(int index, const std::string& where);
    /// The bytes of `count` elements in a view, from `offset` on, at `stride`.
    [[nodiscard]] std::string_view bytes(int view, std::size_t offset, std::size_t count, std::size_t element,
                                         std::size_t stride, const std::string& where);
    [[nodiscard]] std::vector<double> decode(const Accessor& accessor, const std::string& where);
    void replaceSparse(const Accessor& accessor, const std::string& where, std::vector<double>& values);

    const Document& document_;
    std::optional<std::filesystem::path> folder_;
    std::map<int, std::string> buffers_;
    std::map<int, std::vector<double>> read_;
};

}  // namespace deixis::assets::gltf
