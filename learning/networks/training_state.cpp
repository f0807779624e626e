#include "learning/networks/training_state.hpp"

#include <fmt/format.h>

#include <exception>
#include <system_error>
#include <utility>

#include "core/files.hpp"
#include "learning/networks/tensors.hpp"

namespace deixis::learning {

namespace fs = std::filesystem;

TrainingState::TrainingState(const fs::path& weights, std::string data)
    : file_(weights.string() + ".training"), data_(std::move(data)) {}

Result<bool> TrainingState::load(const std::string& identity,
                                 const std::function<void(torch::serialize::InputArchive&)>& read) const {
    if (!fs::exists(file_)) return false;
    try {
        torch::serialize::InputArchive archive;
        archive.load_from(file_.string());
        c10::IValue value;
        archive.read("identity", value);
        if (value.toStringRef() != identity)
            return fail(file_.string(), "this is of a training with other settings or " + data_,
                        "Remove it to begin anew, or use the settings it was begun with");
        read(archive);
    } catch (const std::exception&) {
        return fail(file_.string(), "this is no state of a training, or damaged", "Remove it to begin anew");
    }
    return true;
}

Result<void> TrainingState::save(const std::string& identity,
                                 const std::function<void(torch::serialize::OutputArchive&)>& write) const {
    torch::serialize::OutputArchive archive;
    archive.write("identity", c10::IValue(identity));
    write(archive);
    return writeFile(file_, bytesOf(archive));
}

void TrainingState::remove() const {
    std::error_code ignored;
    fs::remove(file_, ignored);
}

Error hasDiverged(const fs::path& weights, int update, const std::string& loss, const std::string& kept) {
    return {weights.string(),
            fmt::format("the training has diverged at update {}: its loss is {}", update, loss),
            (kept.empty() ? std::string("No weights were written yet")
                          : fmt::format("The weights of {} are kept", kept)) +
                "; a lower learning rate may help"};
}

}  // namespace deixis::learning
