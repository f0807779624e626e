#include <doctest/doctest.h>

#include <chrono>

#include "core/files.hpp"
#include "learning/word_vectors/wink_embeddings.hpp"
#include "paths.hpp"
#include "skipping.hpp"

using namespace deixis;

namespace {

namespace fs = std::filesystem;

fs::path written(const std::string& name, const std::string& text) {
    const fs::path path = tests::buildDir() / "word_vectors_test" / name;
    REQUIRE(writeFile(path, text).has_value());
    return path;
}

std::string problemOf(const std::string& text, int most = 2) {
    const auto read = learning::readWinkEmbeddings(written("some.json", text), most);
    return read ? "none" : read.error().text();
}

const std::string good =
    R"({"precision":8,"l2NormIndex":3,"wordIndex":4,"size":4,"dimensions":3,"words":["the",",","big","dog"],)"
    R"("vectors":{"the":[1,0.5,-2,2.3,0],",":[9,9,9,9,1],"big":[0.25,0,1,1.0,2],"dog":[7,8,9,10,3]},"unkVector":[0,0,0,0,-1]})";

}  // namespace

TEST_SUITE("corpus/word_vectors") {
    TEST_CASE("The commonest words are read with their vectors, marks are passed over") {
        const auto read = learning::readWinkEmbeddings(written("good.json", good), 2);
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        CHECK(read->count() == 2);
        CHECK(read->size() == 3);
        CHECK(read->vectorOf("the") == Eigen::Vector3f(1.0F, 0.5F, -2.0F));
        CHECK(read->vectorOf("Big") == Eigen::Vector3f(0.25F, 0.0F, 1.0F));
        CHECK_FALSE(read->knows("dog"));
        // What stands behind the last vector that is needed is not looked at.
        CHECK(problemOf(good.substr(0, good.find("\"dog\":["))) == "none");
    }

    TEST_CASE("A file that is not there, damaged or of another form is told") {
        const auto missing = learning::readWinkEmbeddings(tests::buildDir() / "nowhere");
        REQUIRE_FALSE(missing.has_value());
        CHECK(missing.error().text().find("scripts/fetch_word_vectors.sh") != std::string::npos);
        CHECK(problemOf("hello").find("found no JSON at byte") != std::string::npos);
        CHECK(problemOf("[1,2]").find("expected the form of wink-embeddings") != std::string::npos);
        CHECK(problemOf("{}").find("expected the form of wink-embeddings") != std::string::npos);
        CHECK(problemOf(R"({"dimensions":3,"vectors":{}})").find("expected the form") != std::string::npos);
        CHECK(problemOf(good, 5).find("found 3 words, expected 5 or more") != std::string::npos);
        CHECK(problemOf(R"({"dimensions":3,"words":["the","big"],"vectors":{"the":[1,2]}})")
                  .find("found 2 numbers for \"the\", expected 3") != std::string::npos);
        CHECK(problemOf(R"({"dimensions":1,"words":["the","big"],"vectors":{"the":[1,2]}})")
                  .find("found vectors of 1 words, but 2 names") != std::string::npos);
        CHECK(problemOf(good.substr(0, good.find("0.25"))).find("found no JSON at byte") !=
              std::string::npos);
    }

    TEST_CASE("The real file: GloVe's vectors, read in a second or two") {
        const fs::path file = learning::winkEmbeddingsFile(tests::sourceDir() / "build/word_vectors");
        if (!fs::is_regular_file(file)) {
            tests::tellSkipped("scripts/fetch_word_vectors.sh was not run");
            return;
        }
        const auto read = learning::readWinkEmbeddings(file);
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        CHECK(read->count() == learning::common_words);
        CHECK(read->size() == 100);
        const auto near = [&](const char* a, const char* b) {
            return read->vectorOf(a).normalized().dot(read->vectorOf(b).normalized());
        };
        CHECK(near("left", "right") > 0.6);
        CHECK(near("big", "huge") > 0.6);
        CHECK(near("kitchen", "bedroom") > 0.6);
        CHECK(near("big", "parliament") < 0.4);
    }
}
