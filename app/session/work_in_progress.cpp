#include "app/session/work_in_progress.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <variant>

#include "core/files.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

constexpr double work_every_s = 1.0;  ///< where it has changed,
constexpr double time_every_s = 2.0;  ///< and where only time has passed

nlohmann::json workJson(int trial, const studies::AuthoringTask& task) {
    const studies::AuthoredProject& work = task.so_far;
    return {{"trial", trial},
            {"used_s", task.limit_s - task.left_s},
            {"project", work.project},
            {"edits", work.edits},
            {"poses", work.poses},
            {"styles", work.styles},
            {"generated", work.generated}};
}

bool differ(const studies::AuthoredProject& a, const studies::AuthoredProject& b) {
    return a.edits != b.edits || a.generated != b.generated || a.project != b.project;
}

}  // namespace

Result<std::optional<studies::UnfinishedWork>> readUnfinishedWork(const fs::path& file,
                                                                  const studies::Resume& resume) {
    std::error_code code;
    if (!fs::exists(file, code)) return std::nullopt;
    const auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    try {
        const auto kept = nlohmann::json::parse(*bytes);
        studies::UnfinishedWork work;
        work.trial_index = kept.at("trial").get<int>();
        work.used_s = kept.at("used_s").get<double>();
        work.project.project = kept.at("project").get<std::string>();
        work.project.edits = kept.at("edits").get<int>();
        work.project.poses = kept.at("poses").get<int>();
        work.project.styles = kept.at("styles").get<int>();
        work.project.generated = kept.at("generated").get<int>();
        if (resume.answered.count(work.trial_index) > 0) return std::nullopt;
        return work;
    } catch (const nlohmann::json::exception& problem) {
        return fail(file.string(), fmt::format("found no work in progress: {}", problem.what()),
                    "Move the file away, and the trial begins anew");
    }
}

void WorkInProgress::record(const studies::SessionEvent& event) {
    if (const auto* const response = std::get_if<studies::Response>(&event))
        answered_ = answered_ || response->trial_index == trial_;
    kept_by_.record(event);
}

void WorkInProgress::presented(const studies::InputFrame& input, const studies::PresentedFrame& frame) {
    kept_by_.presented(input, frame);
    if (answered_) {
        if (kept_by_.answersKept() && kept_by_.failure().empty()) remove();
        return;
    }
    if (!frame.authoring) return;
    now_ = frame.authoring;
    trial_ = session_.trialUnderWay();
    const double since_s = input.time_s - written_s_;
    const bool changed = !last_ || last_->trial != now_->trial || differ(last_->so_far, now_->so_far);
    const bool passed = last_ && last_->left_s != now_->left_s;
    if ((changed && since_s >= work_every_s) || (passed && since_s >= time_every_s)) {
        written_s_ = input.time_s;
        write();
    }
}

void WorkInProgress::write() {
    last_ = now_;
    const auto written = writeFileUnsynced(file_, workJson(trial_, *now_).dump());
    if (!written && failure_.empty()) failure_ = written.error().text();
}

void WorkInProgress::remove() {
    std::error_code gone;
    fs::remove(file_, gone);
    trial_ = -1;
    answered_ = false;
    last_.reset();
    now_.reset();
}

void WorkInProgress::finish() {
    kept_by_.finish();
    if (answered_)
        remove();
    else if (now_)
        write();  // the session was ended: nothing of it is lost
    if (!failure_.empty()) throw std::runtime_error(failure_);
}

}  // namespace deixis::app
