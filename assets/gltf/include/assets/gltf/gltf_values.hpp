// The bytes and numbers that a glTF document refers to, with every index and range checked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/gltf/gltf_document.hpp"

namespace deixis::assets::gltf {

/// Reads each buffer once, when it is first asked for. The document must outlive it. All throw Refusal;
/// `what` names an accessor in it, such as "POSITION".
class Values {
  public:
    /// `folder`: where the files that the document names lie; without it they are rejected.
    Values(const Document& document, std::optional<std::filesystem::path> folder)
        : document_(document), folder_(std::move(folder)) {}

    /// All elements in a row, integers of normalised accessors as fractions (section 3.6.2.2), sparse ones
    /// put in place. Numbers are finite.
    [[nodiscard]] std::vector<double> numbers(int accessor, const std::string& what) const;
    /// The same, kept: an accessor is read once.
    [[nodiscard]] const std::vector<double>& read(int accessor, const std::string& what);
    /// Elements of an accessor of unsigned integers.
    [[nodiscard]] std::vector<std::uint32_t> integers(int accessor, const std::string& what) const;
    /// An image's file as it is, not decoded; empty if the document gives it none.
    [[nodiscard]] std::string image(std::size_t index) const;

    /// A file that buffers or images name.
    struct Neighbour {
        std::filesystem::path path;
        std::string_view bytes;
    };
    /// All of them, as often as they are named: the buffers' first.
    [[nodiscard]] std::vector<Neighbour> neighbours() const;

  private:
    [[nodiscard]] std::string_view outside(const Outside& from, std::size_t min_bytes,
                                           const std::string& place) const;
    [[nodiscard]] std::string_view buffer(int index, const std::string& where) const;
    [[nodiscard]] std::string_view view(int index, const std::string& where) const;
    /// The bytes of `count` elements in a view, from `offset` on, at `stride`.
    [[nodiscard]] std::string_view bytes(int view, std::size_t offset, std::size_t count, std::size_t element,
                                         std::size_t stride, const std::string& where) const;
    [[nodiscard]] std::vector<double> decode(const Accessor& accessor, const std::string& where) const;
    void replaceSparse(const Accessor& accessor, const std::string& where, std::vector<double>& values) const;
    [[nodiscard]] std::vector<std::size_t> sparseIndices(const Accessor& accessor,
                                                         const std::string& where) const;
    [[nodiscard]] std::string place(int accessor, const std::string& what) const;

    const Document& document_;
    std::optional<std::filesystem::path> folder_;
    mutable std::map<std::string, std::string> outside_;  ///< by place
    std::map<int, std::vector<double>> read_;
};

}  // namespace deixis::assets::gltf
