#include "learning/networks/tensors.hpp"

#include <algorithm>

namespace deixis::learning {

motion::NamedArray arrayOf(const std::string& name, const torch::Tensor& tensor) {
    const torch::Tensor plain = tensor.detach().to(torch::kFloat32).contiguous();
    motion::NamedArray out{name, {}, {}};
    for (const std::int64_t size : plain.sizes()) out.shape.push_back(static_cast<std::size_t>(size));
    out.values.assign(plain.data_ptr<float>(), plain.data_ptr<float>() + plain.numel());
    return out;
}

void appendLinear(const torch::nn::Linear& layer, const std::string& name,
                  std::vector<motion::NamedArray>& out) {
    out.push_back(arrayOf(name + ".weight", layer->weight));
    out.push_back(arrayOf(name + ".bias", layer->bias));
}

bool fitFloat16(const std::vector<torch::Tensor>& tensors) {
    constexpr double largest = 65504.0;
    return std::ranges::all_of(tensors, [](const torch::Tensor& one) {
        return (one.abs() <= largest).all().item<bool>();  // not a number is not less, either
    });
}

std::string bytesOf(torch::serialize::OutputArchive& archive) {
    std::string out;
    archive.save_to([&out](const void* data, std::size_t size) {
        out.append(static_cast<const char*>(data), size);
        return size;
    });
    return out;
}

}  // namespace deixis::learning
