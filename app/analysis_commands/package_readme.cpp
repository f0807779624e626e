#include "package_readme.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace deixis::app {

namespace {

std::string counted(long n, const std::string& one, const std::string& many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string whoTookPart(const PackageFacts& facts) {
    const auto& rows = facts.people.rows;
    const auto count = [&](auto is) {
        return static_cast<long>(std::count_if(rows.begin(), rows.end(), is));
    };
    const long synthetic = count([](const auto& one) { return one.synthetic; });
    const long left = count([](const auto& one) { return one.status != results::ParticipantStatus::active; });
    std::string out = counted(static_cast<long>(rows.size()), "participant", "participants");
    if (left > 0) out += fmt::format(", {} of them excluded or dropped out", left);
    if (facts.counts.declined > 0)
        out += fmt::format("; {} declined consent: this is recorded here, but none of their answers",
                           facts.counts.declined);
    if (facts.people.withdrawn > 0)
        out += fmt::format("; {} withdrew, and none of their data is here", facts.people.withdrawn);
    out += ".\n\n";
    if (synthetic == 0) return out + "All answers were given by people.\n";
    return out +
           fmt::format(
               "**Synthetic**: {} simulated participants gave answers (`synthetic` is 1 in every table). "
               "They are no evidence about people.\n",
               synthetic == static_cast<long>(rows.size()) ? "only" : fmt::format("{}", synthetic));
}

std::string leftOut(const PackageFacts& facts) {
    std::string out =
        R"(- Participants have other ids and numbers, in an order unrelated to anything in the package.
- Times are counted from each session's start; days and times of day are left out.
- Computers, graphics cards and drivers, paths of files, participants' tokens and eye distances are left out;
  the kind of headset and its runtime are kept.
- Clips' authors, if the study names them, are called "author 1" and so on.
)";
    out += fmt::format(
        "- {} left out: reasons, remarks, why a study was changed.\n",
        counted(facts.counts.reasons, "text by the experimenter is", "texts by the experimenter are"));
    if (facts.free_text)
        out += "- **What participants typed is kept**, as requested. It may name people.\n";
    else
        out += fmt::format("- What participants typed is left out ({}).\n",
                           counted(facts.counts.free_texts, "answer", "answers"));
    if (!facts.tracking)
        out += "- Tracked movements of head and hands are left out.\n";
    else if (facts.tracked)
        out += "- Tracked movements of head and hands are kept. People can be recognised by them.\n";
    out +=
        R"(- Kept unchanged: every answer, choice and response time, the head and the ray at each answer, what participants said
  about themselves by number or choice (such as age), their language.

What this does not hide: anyone who knows that a person took part, and their age or height, may find them. The order of a
participant's trials follows from the study's seed and their number at enrolment; with the study file, which is here,
that number can be found by trying. It identifies a person only to those who have the lab's list of ids. Keep that list
separately, or destroy it.
)";
    return out;
}

}  // namespace

std::string packageReadme(const PackageFacts& facts) {
    const results::ResponseTable& answers = facts.answers;
    std::string out = fmt::format(
        "# {}\n\nReplication package of the study `{}` (SHA-256 of its file with its questionnaires, as it "
        "was run: {}).\n\n",
        answers.study_title, answers.study_name, answers.study_hash);
    out += whoTookPart(facts);
    out += fmt::format("\nRecorded by {}. Packaged and analysed by {}.\n",
                       fmt::join(answers.program_versions, ", "), facts.program);
    out += R"(
## What is here

| file | what |
|---|---|
| `study.sqlite` | the database: plans, answers, events, tracked movements |
| `study.locked/` | what participants were shown: study file, texts, targets, clips, avatar, with hashes |
| `report.html`, `analysis.json` | the report, and its numbers; `analysis.schema.json` describes them |
| `tables/` | the report's tables as CSV, and `analysis.R`, which recomputes them in R |
| `latex/` | the report's tables as LaTeX |
| `data/` | the answers as CSV tables; `codebook.json` describes every column |
| `SHA256SUMS` | of all files |

If answers come from several kinds of station, there is a report, an analysis and a folder of tables for each.
Clips of the built-in systems (`generator` in the study file) are synthetic: made by formulas, not recorded.

## How to use it

    sha256sum -c SHA256SUMS

Without Deixis: open `report.html`; read `data/responses.csv`; run `Rscript tables/analysis.R`.

With Deixis (the version above; the numbers of `analysis.json` are those of its build), in this folder:

    deixis report study.sqlite -o again.html --json again.json
    deixis participants list study.sqlite
    deixis replay study.sqlite --participant ID
    deixis replay study.sqlite --participant ID --choices

`again.json` equals `analysis.json`, byte for byte with the same build of the program. To run your own participants through
the study as it was, use a copy, since sessions change it:

    cp study.sqlite mine.sqlite; cp -r study.locked mine.locked
    deixis run --db mine.sqlite --participant ID

## What was changed or left out

)";
    return out + leftOut(facts);
}

}  // namespace deixis::app
