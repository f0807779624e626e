#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "oracles.hpp"
#include "results/statistics/bootstrap.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/statistics/holm.hpp"
#include "results/statistics/proportion.hpp"

using namespace deixis::results;
using namespace deixis::tests;

TEST_SUITE("results/rational") {
    TEST_CASE("Cells are read exactly") {
        const auto read = [](const char* text) { return Rational::parse(text).value().text(); };
        CHECK(read("7/3") == "7/3");
        CHECK(read(" -0.125 ") == "-1/8");
        CHECK(read("1e-3") == "1/1000");
        CHECK(read("+.5") == "1/2");
        CHECK(read("5.") == "5");
        CHECK(read("1.5/2") == "3/4");
        CHECK(read("-14 / 6") == "-7/3");
        CHECK(read("2.50E2") == "250");
        CHECK(read("-0") == "0");
        CHECK(read("0.000/7") == "0");
        CHECK(read("123456789012345678901234567890") == "123456789012345678901234567890");
        CHECK(read("1e-30") == "1/1000000000000000000000000000000");
        CHECK(read("9223372036854775807") == "9223372036854775807");
    }

    TEST_CASE("What is no number is rejected, saying why") {
        const std::vector<std::string> wrong{"",     "-",   "1,5",  "abc",   "1e",  "1e+-3",
                                             "1//2", "/2",  "1/",   "--1",   "1 2", "0x1p3",
                                             "inf",  "nan", "1/-2", "1.2.3", "5-",  "1%"};
        for (const std::string& text : wrong) {
            CAPTURE(text);
            const auto read = Rational::parse(text);
            REQUIRE(!read);
            CHECK(read.error().find("is not a number") != std::string::npos);
        }
        CHECK(Rational::parse("1/0").error().find("divides by zero") != std::string::npos);
        CHECK(Rational::parse("1e2000").error().find("too long") != std::string::npos);
        CHECK(!Rational::parse("1" + std::string(5000, '0')));
    }

    TEST_CASE("Sums, products and order are exact beyond machine words") {
        deixis::Random random(5, "rationals");
        for (int i = 0; i < 300; ++i) {
            const auto draw = [&] {
                const auto top = static_cast<std::int64_t>(random.next() >> (1 + random.below(60)));
                const auto bottom = 1 + static_cast<std::int64_t>(random.next() >> (2 + random.below(60)));
                return Rational(random.uniform() < 0.5 ? -top : top, bottom);
            };
            const Rational a = draw();
            const Rational b = draw();
            CHECK((a + b) - b == a);
            CHECK((a - b).sign() == (a < b ? -1 : a == b ? 0 : 1));
            if (b.sign() != 0) CHECK(a * b / b == a);
            CHECK(Rational::parse((a * b).text()).value() == a * b);
            CHECK(a + b == b + a);
        }
    }

    TEST_CASE("The nearest double is found, and doubles go there and back") {
        deixis::Random random(6, "doubles");
        for (int i = 0; i < 500; ++i) {
            const double value =
                std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.below(400)) - 200);
            CHECK(Rational::fromShortestDecimal(value).toDouble() == value);
            CHECK(Rational::fromBinary(value).toDouble() == value);
        }
        CHECK(Rational::fromShortestDecimal(0.1) == Rational(1, 10));
        CHECK(Rational(1, 3).toDouble() == 1.0 / 3.0);
        // Halfway between two doubles goes to the even one, a hair above it to the upper one.
        CHECK(Rational::parse("9007199254740993").value().toDouble() == 9007199254740992.0);
        CHECK(Rational::parse("9007199254740993.0000000000000000000000000001").value().toDouble() ==
              9007199254740994.0);
        CHECK(Rational::parse("1e400").value().toDouble() == std::numeric_limits<double>::infinity());
    }
}

TEST_SUITE("results/holm") {
    TEST_CASE("R's p.adjust and the definition agree; missing p values stay missing and do not count") {
        const auto cases = oracles("holm");
        REQUIRE(cases.size() >= 30);
        for (const auto& expected : cases) {
            std::vector<double> p;
            for (const auto& value : expected["p"])
                p.push_back(value.is_null() ? std::nan("") : value.get<double>());
            const auto found = holm(p);
            REQUIRE(found.size() == p.size());
            for (std::size_t i = 0; i < p.size(); ++i) {
                // R writes a single number without brackets, and NA as null or text.
                const auto& list = expected["r"]["adjusted"];
                const auto& r = list.is_array() ? list[i] : list;
                if (std::isnan(p[i])) {
                    CHECK(std::isnan(found[i]));
                    CHECK(!r.is_number());
                } else {
                    CHECK(close(found[i], r.get<double>(), 1e-14));
                    CHECK(close(found[i], expected["adjusted"][i].get<double>(), 1e-14));
                }
            }
        }
    }
}

TEST_SUITE("results/descriptive") {
    TEST_CASE("R agrees on means, standard deviations, type-7 quantiles and the MAD") {
        const auto cases = oracles("describe");
        REQUIRE(cases.size() >= 30);
        for (const auto& expected : cases) {
            const auto found = describe(rationals(expected["x"]));
            const auto& r = expected["r"];
            const double size = std::max(1.0, std::abs(found.max.value()));
            const auto near = [&](const std::optional<double>& a, const nlohmann::json& b) {
                return a.has_value() && std::abs(*a - b.get<double>()) <= 1e-12 * size;
            };
            CHECK(found.n == static_cast<int>(expected["x"].size()));
            CHECK(near(found.mean, r["mean"]));
            CHECK(near(found.min, r["min"]));
            CHECK(near(found.q05, r["q"][0]));
            CHECK(near(found.q25, r["q"][1]));
            CHECK(near(found.median, r["q"][2]));
            CHECK(near(found.q75, r["q"][3]));
            CHECK(near(found.q95, r["q"][4]));
            CHECK(near(found.max, r["max"]));
            CHECK(near(found.mad, r["mad"]));
            if (found.n == 1) {
                CHECK(!found.sd);
                continue;
            }
            CHECK(near(found.sd, r["sd"]));
            CHECK(close(found.se.value(), *found.sd / std::sqrt(found.n), 1e-14));
        }
        CHECK(!describe({}).mean);
    }

    TEST_CASE("Large offsets cost no digits, and squares neither overflow nor vanish") {
        std::vector<Rational> x;
        for (const char* cell : {"1e15", "1000000000000000.1", "1000000000000000.2"})
            x.push_back(Rational::parse(cell).value());
        CHECK(describe(x).sd == 0.1);
        for (const char* unit : {"1e200", "1e-200"}) {
            const Rational one = Rational::parse(unit).value();
            const auto found = describe(std::vector<Rational>{one, one * Rational(3)});
            CHECK(close(found.sd, std::sqrt(2.0) * one.toDouble(), 1e-15));
            CHECK(close(found.se, one.toDouble(), 1e-15));
        }
    }

    TEST_CASE("The helpers on doubles agree with R, too") {
        for (const auto& expected : oracles("describe")) {
            std::vector<double> x;
            for (const Rational& value : rationals(expected["x"])) x.push_back(value.toDouble());
            const auto& r = expected["r"];
            CHECK(close(mean(x), r["mean"].get<double>(), 1e-12));
            if (x.size() > 1) CHECK(std::abs(sampleSd(x) - r["sd"].get<double>()) < 1e-12 * (1.0 + mean(x)));
            CHECK(close(quantile(x, 0.25), r["q"][1].get<double>(), 1e-12));
        }
        CHECK(sampleSd(std::vector<double>{3.0}) == 0.0);
    }

    TEST_CASE("What a box plot draws are R's type-7 quantiles, and McGill's notch of them") {
        for (const auto& expected : oracles("describe")) {
            std::vector<double> x;
            for (const Rational& value : rationals(expected["x"])) x.push_back(value.toDouble());
            const auto box = boxSummary(x);
            REQUIRE(box);
            std::vector<double> q;
            for (const auto& value : expected["r"]["q"]) q.push_back(value.get<double>());
            CHECK(box->n == static_cast<int>(x.size()));
            CHECK(close(box->mean, expected["r"]["mean"].get<double>(), 1e-12));
            CHECK(close(box->q05, q[0], 1e-12));
            CHECK(close(box->q25, q[1], 1e-12));
            CHECK(close(box->median, q[2], 1e-12));
            CHECK(close(box->q75, q[3], 1e-12));
            CHECK(close(box->q95, q[4], 1e-12));
        }
        // By hand: quartiles 2 and 4 of five values, so 3 -+ 1.57 * 2 / sqrt(5).
        const auto five = boxSummary({5.0, 1.0, 4.0, 2.0, 3.0});
        CHECK(five->notch_low == doctest::Approx(3.0 - 1.4042507));
        CHECK(five->notch_high == doctest::Approx(3.0 + 1.4042507));
        CHECK(five->q05 == doctest::Approx(1.2));
        CHECK(!boxSummary({}));
    }
}

TEST_SUITE("results/proportion") {
    TEST_CASE("R's and SciPy's exact binomial tests agree: intervals, and p against chance") {
        const auto cases = oracles("proportion");
        REQUIRE(cases.size() >= 30);
        for (const auto& expected : cases) {
            CAPTURE(expected["successes"].get<int>());
            CAPTURE(expected["n"].get<int>());
            const auto found = proportion(expected["successes"], expected["n"], expected["level"],
                                          expected["chance"].get<double>());
            const auto& r = expected["r"];
            CHECK(close(found.lower, r["lower"], 1e-9));
            CHECK(close(found.upper, r["upper"], 1e-9));
            CHECK(close(found.p_chance, r["p_chance"], 1e-8));
            CHECK(close(found.p_greater, r["p_greater"], 1e-8));
            CHECK(close(found.p_less, r["p_less"], 1e-8));
            CHECK(close(found.p_chance, expected["scipy"]["p_chance"], 1e-8));
            CHECK(std::abs(found.lower.value() - expected["scipy"]["lower"].get<double>()) < 1e-9);
            CHECK(std::abs(found.upper.value() - expected["scipy"]["upper"].get<double>()) < 1e-9);
        }
        CHECK(!proportion(0, 0, 0.95, 0.5).estimate);
        CHECK(!proportion(1, 2, 0.95, std::nullopt).p_chance);
    }
}

TEST_SUITE("results/bootstrap") {
    TEST_CASE("SciPy's and R's percentile and BCa intervals agree within the error of resampling") {
        const auto cases = oracles("bootstrap");
        REQUIRE(cases.size() >= 30);
        for (const auto& expected : cases) {
            std::vector<std::vector<double>> rows;
            for (const auto& value : expected["x"]) rows.push_back({value.get<double>()});
            const double level = expected["level"];
            CAPTURE(expected["x"].dump());
            CAPTURE(level);
            const auto found = bootstrapMeans(rows, {.resamples = 100000, .seed = 5, .level = level})[0];
            const double se = expected["se"];
            CHECK(close(found.estimate, expected["mean"], 1e-12));
            CHECK(close(found.se, expected["se"], 0.02));
            // Far out a quantile of resampled means is the less certain. Both sides are drawn.
            const double allowed = (level > 0.95 ? 0.1 : 0.08) * se;
            for (const auto* by : {&expected, &expected["r"]}) {
                const auto& percentile = (*by)["percentile"];
                const auto& bca = (*by)["bca"];
                CHECK(std::abs(found.percentile->lower - percentile[0].get<double>()) < allowed);
                CHECK(std::abs(found.percentile->upper - percentile[1].get<double>()) < allowed);
                CHECK(std::abs(found.bca->lower - bca[0].get<double>()) < allowed);
                CHECK(std::abs(found.bca->upper - bca[1].get<double>()) < allowed);
            }
        }
    }

    TEST_CASE(
        "Intervals do not hang on the order of the participants, which follows from how they are called") {
        const double none = std::nan("");
        const std::vector<std::vector<double>> rows{{3.5, 0.25, none}, {1.0, 0.5, 2.0}, {4.25, none, 1.0},
                                                    {2.0, 0.75, 5.0},  {2.5, 1.0, 3.0}, {5.0, 0.0, none}};
        const BootstrapOptions options{.resamples = 2000, .seed = 1, .level = 0.95};
        const auto expected = bootstrapMeans(rows, options);
        for (const std::vector<std::size_t>& order :
             {std::vector<std::size_t>{5, 4, 3, 2, 1, 0}, std::vector<std::size_t>{2, 0, 5, 1, 4, 3}}) {
            std::vector<std::vector<double>> other;
            for (const std::size_t i : order) other.push_back(rows[i]);
            const auto found = bootstrapMeans(other, options);
            for (std::size_t c = 0; c < 3; ++c) {
                CHECK(found[c].percentile->lower == expected[c].percentile->lower);
                CHECK(found[c].percentile->upper == expected[c].percentile->upper);
                CHECK(found[c].bca->lower == expected[c].bca->lower);
                CHECK(found[c].bca->upper == expected[c].bca->upper);
                CHECK(found[c].se == expected[c].se);
            }
        }
    }

    TEST_CASE("Resampled means of few values are spread as those of all n^n resamples") {
        const std::vector<double> x{0.0, 0.25, 1.0, 1.5, 4.0};
        std::vector<double> all;
        for (int pattern = 0; pattern < 3125; ++pattern) {
            double sum = 0.0;
            for (int rest = pattern, i = 0; i < 5; ++i, rest /= 5)
                sum += x[static_cast<std::size_t>(rest % 5)];
            all.push_back(sum / 5.0);
        }
        const auto share = [&](double limit) {
            return static_cast<double>(
                       std::count_if(all.begin(), all.end(), [&](double m) { return m <= limit; })) /
                   3125.0;
        };
        std::vector<std::vector<double>> rows;
        for (const double value : x) rows.push_back({value});
        const auto found = bootstrapMeans(rows, {.resamples = 200000, .seed = 2, .level = 0.9})[0];
        double squares = 0.0;
        for (const double value : x) squares += (value - 1.35) * (value - 1.35);
        CHECK(close(found.estimate, 1.35, 1e-15));
        CHECK(close(found.se, std::sqrt(squares / 25.0), 0.01));
        // Steps of the distribution: the end of an interval has its share at or below it, and less right
        // below.
        for (const auto& [end, tail] :
             {std::pair{found.percentile->lower, 0.05}, std::pair{found.percentile->upper, 0.95}}) {
            CHECK(share(end + 1e-9) > tail - 0.003);
            CHECK(share(end - 1e-9) < tail + 0.003);
        }
    }

    TEST_CASE("Intervals do not depend on the unit, and sums beyond a double leave them undefined") {
        std::vector<std::vector<double>> rows;
        for (const double value : {1.0, 2.0, 2.0, 3.0, 9.0, 17.0})
            rows.push_back({value, std::ldexp(value, 900), std::ldexp(value, -900), value * 1e307, 0.1});
        const auto found = bootstrapMeans(rows, {.resamples = 2000, .seed = 3, .level = 0.95});
        for (const int power : {900, -900}) {
            const auto& scaled = found[power > 0 ? 1 : 2];
            CHECK(scaled.bca->lower == std::ldexp(found[0].bca->lower, power));
            CHECK(scaled.bca->upper == std::ldexp(found[0].bca->upper, power));
        }
        CHECK(found[3].n == 6);
        CHECK(!found[3].percentile);
        CHECK(!found[3].bca);
        CHECK(found[4].bca->upper == doctest::Approx(0.1).epsilon(1e-14));
    }

    TEST_CASE("A seed gives the same intervals again, in whichever company a column stands") {
        std::vector<std::vector<double>> one;
        std::vector<std::vector<double>> two;
        for (int i = 0; i < 15; ++i) {
            one.push_back({0.3 * i});
            two.push_back({0.3 * i, i % 4 == 0 ? std::nan("") : 1.0 * i});
        }
        const BootstrapOptions options{.resamples = 500, .seed = 9, .level = 0.9};
        const auto alone = bootstrapMeans(one, options);
        const auto beside = bootstrapMeans(two, options);
        CHECK(alone[0].percentile->lower == beside[0].percentile->lower);
        CHECK(alone[0].bca->upper == beside[0].bca->upper);
        CHECK(beside[1].n == 11);
        CHECK(bootstrapMeans(one, {.resamples = 500, .seed = 10, .level = 0.9})[0].se != alone[0].se);
    }

    TEST_CASE("Equal values, a single participant and no values at all") {
        const std::vector<std::vector<double>> equal(6, {2.5, std::nan("")});
        const auto found = bootstrapMeans(equal, {.resamples = 100, .seed = 1, .level = 0.95});
        CHECK(found[0].se == 0.0);
        CHECK(found[0].bca->lower == 2.5);
        CHECK(found[0].percentile->upper == 2.5);
        CHECK(!found[1].estimate);
        CHECK(bootstrapMeans(std::vector<std::vector<double>>{{4.0}}, {})[0].bca->upper == 4.0);
        CHECK(bootstrapMeans({}, {}).empty());
    }
}
