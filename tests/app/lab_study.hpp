// A lab's small study in a folder: clips of its own for one system, and a built-in one.
#pragma once

#include "program.hpp"

namespace deixis::tests {

inline const char* const lab_study = R"([study]
name = "lab"
title = "Lab"
seed = 7

[targets]
count = 6
height_m = [0.5, 1.5]
arc_deg = [-60, 60]
radius_m = [1.5, 2.0]

[[distances]]
name = "near"
distance_m = [0.2, 0.4]
distractors = 2

[[layouts]]
name = "across"
viewer_m = [0, 3]
heading_deg = 180

[[systems]]
name = "ours"
manifest = "clips/manifest.csv"

[[systems]]
name = "builtin"
generator = "stiff"

[[stages]]
name = "natural"
kind = "rating"
items = 2
layouts = ["across"]
question = "How natural?"
scale = {low = 1, high = 5}

[[stages]]
name = "game"
kind = "referential-game"
items = 3
layouts = ["across"]
distances = ["near"]
question = "Which?"
)";

/// study.toml, clips/manifest.csv and its six clips.
class LabFolder {
  public:
    LabFolder() {
        write("study.toml", lab_study);
        const auto targets = program("targets " + path("study.toml") + " --no-picture");
        REQUIRE_MESSAGE(targets.status == 0, targets.err);
        write("targets.csv", targets.out);
        const auto made =
            program("generate direct --targets " + path("targets.csv") + " --out " + path("clips"));
        REQUIRE_MESSAGE(made.status == 0, made.err);
    }
    [[nodiscard]] std::string path(const std::string& name) const { return scratch_ / name; }
    [[nodiscard]] std::string read(const std::string& name) const { return slurp(path(name)); }
    void write(const std::string& name, const std::string& text) const { spill(path(name), text); }
    void change(const std::string& name, const std::string& from, const std::string& to) const {
        write(name, replaced(read(name), from, to));
    }
    /// Simulated participants into study.sqlite.
    [[nodiscard]] Finished simulate(int participants = 1) const {
        return program("simulate " + path("study.toml") + " --participants " + std::to_string(participants) +
                       " --db " + path("study.sqlite"));
    }
    /// One session of a simulated participant, drawn; `study` may be empty.
    [[nodiscard]] Finished run(const std::string& participant, const std::string& more = "",
                               const std::string& study = "study.toml") const {
        return program("run " + (study.empty() ? "" : path(study)) + " --station simulated --participant " +
                       participant + " --db " + path("study.sqlite") + " " + more);
    }

  private:
    Scratch scratch_;
};

}  // namespace deixis::tests
