#include "learning/ranks/ranks.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <torch/csrc/distributed/c10d/ProcessGroupGloo.hpp>
#include <torch/csrc/distributed/c10d/TCPStore.hpp>

namespace deixis::learning {

namespace {

using torch::Tensor;

/// Debian's LibTorch is built without libuv, which later versions ask for.
void goWithoutLibuv(auto& options) {
    if constexpr (requires { options.useLibUV; }) options.useLibUV = false;
}

auto notTogether(const RankPlace& place, const char* why) {
    return fail(
        fmt::format("rank {} of {} at {}, port {}", place.rank, place.count, place.address, place.port),
        fmt::format("the ranks of this training have not come together: {}", why));
}

}  // namespace

struct Ranks::Group {
    c10::intrusive_ptr<c10d::ProcessGroupGloo> gloo;
};

Ranks::Ranks(int rank, int count) : rank_(rank), count_(count) {}
Ranks::~Ranks() = default;

Result<std::shared_ptr<Ranks>> Ranks::join(const std::optional<RankPlace>& place) {
    if (!place) return std::shared_ptr<Ranks>(new Ranks(0, 1));
    std::shared_ptr<Ranks> out(new Ranks(place->rank, place->count));
    if (place->count == 1) return out;
    constexpr std::chrono::minutes patience(5);
    try {
        c10d::TCPStoreOptions options;
        options.port = place->port;
        options.isServer = place->rank == 0;
        options.numWorkers = static_cast<std::size_t>(place->count);
        options.timeout = patience;
        goWithoutLibuv(options);
        auto store = c10::make_intrusive<c10d::TCPStore>(place->address, options);
        auto gloo_options = c10d::ProcessGroupGloo::Options::create();
        gloo_options->threads = 1;
        // A rank is as slow as its longest pause: rank 0 generates clips while the others wait.
        gloo_options->timeout = std::chrono::minutes(30);
        // As PyTorch does: where a PC's name is its loopback's, other machines do not find it by that.
        const char* const network = std::getenv("GLOO_SOCKET_IFNAME");
        gloo_options->devices.push_back(network == nullptr || *network == '\0'
                                            ? c10d::ProcessGroupGloo::createDefaultDevice()
                                            : c10d::ProcessGroupGloo::createDeviceForInterface(network));
        out->group_ = std::make_unique<Group>();
        out->group_->gloo =
            c10::make_intrusive<c10d::ProcessGroupGloo>(store, place->rank, place->count, gloo_options);
    } catch (const c10::Error& problem) {
        return notTogether(*place, problem.what_without_backtrace());
    } catch (const std::exception& problem) {
        return notTogether(*place, problem.what());
    }
    return out;
}

void Ranks::average(std::vector<Tensor> tensors) {
    if (count_ == 1) return;
    // One message for all.
    std::vector<Tensor> flat;
    for (const Tensor& one : tensors) flat.push_back(one.reshape({-1}));
    std::vector<Tensor> message{torch::cat(flat)};
    group_->gloo->allreduce(message)->wait();
    std::int64_t at = 0;
    for (const Tensor& one : tensors) {
        one.copy_((message[0].narrow(0, at, one.numel()) / static_cast<double>(count_)).view_as(one));
        at += one.numel();
    }
}

void Ranks::averageGradients(const std::vector<Tensor>& parameters) {
    if (count_ == 1) return;
    std::vector<Tensor> gradients;
    for (const Tensor& one : parameters)
        if (one.grad().defined()) gradients.push_back(one.grad());
    average(std::move(gradients));
}

void Ranks::takeFirst(std::vector<Tensor> tensors) {
    if (count_ == 1) return;
    torch::NoGradGuard no_gradient;
    for (const Tensor& one : tensors) {
        std::vector<Tensor> message{one.detach().clone().contiguous()};
        group_->gloo->broadcast(message)->wait();
        one.copy_(message[0]);
    }
}

bool Ranks::any(bool here) {
    if (count_ == 1) return here;
    const Tensor told = torch::full({1}, here ? 1.0 : 0.0);
    average({told});
    return told.item<double>() > 0.0;
}

std::string Ranks::firstText(const std::string& here) {
    if (count_ == 1) return here;
    const Tensor size = torch::full({1}, static_cast<std::int64_t>(here.size()), torch::kInt64);
    takeFirst({size});
    Tensor bytes = torch::zeros({size.item<std::int64_t>()}, torch::kUInt8);
    if (rank_ == 0 && !here.empty()) std::memcpy(bytes.data_ptr(), here.data(), here.size());
    if (bytes.numel() > 0) takeFirst({bytes});
    return {static_cast<const char*>(bytes.data_ptr()), static_cast<std::size_t>(bytes.numel())};
}

}  // namespace deixis::learning
