// The installed program: moved, with sources and build out of sight, with its manual page and completion.
#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "lab_study.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis::tests;

namespace {

/// An installation that was moved after it was made.
class Installed {
  public:
    Installed() {
        const auto made =
            shell("cmake --install " + buildDir().string() + " --strip --prefix " + (scratch_ / "first"));
        REQUIRE_MESSAGE(made.status == 0, made.err);
        fs::rename(scratch_ / "first", scratch_ / "moved");
        if (shell(alone("true")).status == 0) return;
        tellSkipped("the sources are not hidden: this system lets nobody mount over them (unshare)");
        hides_ = false;
    }
    [[nodiscard]] fs::path file(const std::string& name) const { return scratch_.path() / "moved" / name; }
    [[nodiscard]] std::string operator/(const std::string& name) const { return scratch_ / name; }
    /// The program, told nothing by the environment, in a folder that holds nothing of it.
    [[nodiscard]] Finished operator()(const std::string& arguments) const {
        const std::string command = "cd " + scratch_.path().string() +
                                    " && env -i PATH=/usr/bin:/bin "
                                    "ASAN_OPTIONS=detect_leaks=0:intercept_tls_get_addr=0 moved/bin/deixis " +
                                    arguments;
        return shell(hides_ ? alone(command) : command);
    }

  private:
    /// A command for which nothing lies where sources and build are.
    static std::string alone(const std::string& command) {
        const std::string hide = "mount -t tmpfs none " + sourceDir().string() + " && { [ ! -d " +
                                 buildDir().string() + " ] || mount -t tmpfs none " + buildDir().string() +
                                 "; } && [ ! -e " + sourceDir().string() + "/assets ] && ";
        return std::string("unshare ") + (geteuid() == 0 ? "-m" : "-rm") + " sh -c '" + hide + command + "'";
    }

    Scratch scratch_;
    bool hides_ = true;
};

/// Options that help tells, "--" and all.
std::set<std::string> optionsIn(const std::string& help) {
    std::set<std::string> out;
    const std::regex line("\n  (-[^ ,]+(?:, --[^ ]+)?)"), name("--[a-z0-9-]+");
    for (std::sregex_iterator at(help.begin(), help.end(), line), end; at != end; ++at) {
        const std::string names = (*at)[1];
        for (std::sregex_iterator one(names.begin(), names.end(), name); one != end; ++one)
            out.insert(one->str());
    }
    return out;
}

/// The help of every command below `path`, by the command as it is typed: " clips info".
std::map<std::string, std::string> helpOfAll(const std::string& path = "") {
    std::map<std::string, std::string> out{{path, program(path + " --help").out}};
    const std::string help = out[path];
    const auto at = std::min(help.find("\nCommands "), help.find("\nSubcommands:\n"));
    if (at == std::string::npos) return out;
    const std::string list = help.substr(at, help.find("\nWrites: ") - at);
    const std::regex line("\n  ([a-z-]+) ");
    for (std::sregex_iterator one(list.begin(), list.end(), line), end; one != end; ++one)
        out.merge(helpOfAll(path + " " + (*one)[1].str()));
    return out;
}

/// What bash offers after the words; the last of them is begun.
std::set<std::string> offered(const std::string& words) {
    const auto done =
        shell("cd " + sourceDir().string() + " && bash --norc -c '. " + buildDir().string() +
              "/share/bash-completion/completions/deixis; COMP_WORDS=(deixis " + words +
              "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _deixis; printf \"%s\\n\" \"${COMPREPLY[@]}\"'");
    CHECK_MESSAGE(done.err.empty(), done.err);
    std::set<std::string> out;
    std::istringstream lines(done.out);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) out.insert(line);
    return out;
}

using Words = std::set<std::string>;

}  // namespace

TEST_SUITE("app/install") {
    TEST_CASE("an installed program that was moved runs studies and reports with the sources out of sight") {
        const Installed installed;
        spill(installed / "lab.toml",
              replaced(lab_study, "manifest = \"clips/manifest.csv\"", "generator = \"direct\""));
        const auto checked = installed("check pointing2023");
        CHECK_MESSAGE(checked.status == 0, checked.err);
        const auto simulated = installed("simulate lab.toml --participants 2 --db s.sqlite");
        REQUIRE_MESSAGE(simulated.status == 0, simulated.err);
        const std::string counted =
            "sqlite3 -readonly " + (installed / "s.sqlite") + " 'select count(*) from responses'";
        // Two systems, two ratings and three choices each.
        CHECK(shell(counted).out == "20\n");
#ifdef DEIXIS_IMMERSIVE
        const auto drawn =
            installed("run lab.toml --station simulated --participant P01 --db s.sqlite --size 320x180");
        REQUIRE_MESSAGE(drawn.status == 0, drawn.err);
        CHECK(shell(counted).out == "30\n");
#endif
        const auto reported = installed("report s.sqlite -o r.html --json r.json");
        REQUIRE_MESSAGE(reported.status == 0, reported.err);
        CHECK(XmlDocument(slurp(installed / "r.html")).count("/h:html/h:body") == 1);
        const auto schemas = installed("schema");
        CHECK(contains(schemas.out, installed.file("share/deixis/schemas/analysis.schema.json").string()));
        // Nowhere else does it look.
        fs::remove(installed.file("share/deixis/avatar.glb"));
        CHECK_FAILS_SAYING(installed("simulate lab.toml --participants 1 --db t.sqlite"),
                           installed.file("share/deixis/avatar.glb").string());
    }

    TEST_CASE(
        "no installed file names a folder of the sources or the build, and the licence and documents are "
        "there") {
        const Installed installed;
        std::vector<std::string> folders{buildDir().string()};
        for (const char* name : {"/app", "/assets", "/build", "/core", "/results"})
            folders.push_back(sourceDir().string() + name);
        // Sanitizers tell where in the sources something went wrong.
        const bool sanitized = isSanitized();
        int files = 0;
        for (const auto& entry : fs::recursive_directory_iterator(installed.file(""))) {
            if (!entry.is_regular_file() || (sanitized && entry.path().filename() == "deixis")) continue;
            const std::string bytes = slurp(entry.path());
            for (const std::string& folder : folders) {
                INFO(entry.path().string() << " names " << folder);
                CHECK(!contains(bytes, folder));
            }
            ++files;
        }
        CHECK(files > 40);
        for (const char* name : {"share/doc/deixis/LICENSE", "share/doc/deixis/quick-start.md",
                                 "share/deixis/studies/pointing2023.toml", "share/man/man1/deixis.1"})
            CHECK(fs::is_regular_file(installed.file(name)));
        CHECK(!fs::exists(installed.file("bin/deixis_make_avatar")));
    }

    TEST_CASE("the manual page and the completion know every command and option that help tells") {
        const std::string manual = buildDir().string() + "/share/man/man1/deixis.1";
        if (shell("command -v groff").status != 0) {
            tellSkipped("groff is not installed");
            return;
        }
        const auto printed = shell("LC_ALL=C.UTF-8 groff -man -ww -Tutf8 -P-cbou -rLL=500n " + manual);
        CHECK_MESSAGE(printed.err.empty(), printed.err);
        const auto helps = helpOfAll();
        CHECK(helps.size() > 40);
        for (const auto& help : helps) {
            const std::string& command = help.first;
            if (command.empty()) continue;
            INFO("deixis" << command);
            const auto at = printed.out.find("\n   deixis" + command + "\n");
            REQUIRE(at != std::string::npos);
            const std::string section = printed.out.substr(at, printed.out.find("\n   deixis", at + 1) - at);
            const std::set<std::string> told = optionsIn(help.second);
            for (const std::string& option : told) {
                INFO(option);
                CHECK((option == "--help" || contains(section, option)));
            }
            CHECK(offered(command + " --") == told);
        }
    }

    TEST_CASE("bash completes commands, options, choices, studies that ship, and files") {
        CHECK(offered("re") == Words{"replay", "report", "reproduction"});
        CHECK(offered("clips re") == Words{"resample", "retarget"});
        CHECK(offered("run --st") == Words{"--station", "--stimuli"});
        CHECK(offered("run --station s") == Words{"simulated", "studio"});
        CHECK(offered("run --station = d") == Words{"desktop"});
        CHECK(offered("run --station =") == Words{"desktop", "headset", "simulated", "studio"});
        CHECK(offered("simulate pointing2") == Words{"pointing2023", "pointing2023-stand-ins"});
        CHECK(offered("simulate --participants 2 genea") == Words{"genea-pairwise"});
        CHECK(offered("simulate --participants \"\"").empty());
        CHECK(offered("run --language s") == Words{"sv"});
        CHECK(offered("schema tr") == Words{"trace"});
        CHECK(offered("report READ") == Words{"README.md"});
        CHECK(offered("run P01 assets/data/stud") == Words{"assets/data/studies"});
    }
}
